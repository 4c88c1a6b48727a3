#include "records/engines/judged_engines.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "base/input/text_file.hpp"
#include "base/input/toml.hpp"
#include "base/parallel/in_parallel.hpp"
#include "contact/problem/tolerance.hpp"
#include "records/judging/record_judge.hpp"

namespace slipproof {

namespace {

namespace fs = std::filesystem;

/// The files of a folder with an extension, by name, with those in folders below.
std::vector<fs::path> files_in(const fs::path& folder, std::string_view extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

EngineScene scene_of(const fs::path& file, const fs::path& scenes) {
  return {fs::relative(file, scenes).replace_extension().generic_string(),
          file,
          read_scene(file.string(), Dimensions::any),
          {}};
}

void judge(const RecordJudge& judge, ExactJudge& exact, JudgedEngineAnswer& judged) {
  const EngineAnswer& answer = judged.answer;
  if (!answer.refused.empty()) judged.verdict = EngineVerdict::refused;
  if (answer.motion.empty()) return;
  const Record record = judge.record(answer.motion);
  const std::string missing = incomplete(record.present, judge.fields(), judge.certified());
  if (!missing.empty()) throw std::invalid_argument(missing);
  const RecordJudgement found = exact(record);
  judged.distance = found.distance;
  judged.verdict = found.verdict == RecordVerdict::undecided           ? EngineVerdict::undecided
                   : !found.distance || *found.distance > contact_near ? EngineVerdict::wrong
                   : *found.distance > engine_right                    ? EngineVerdict::near
                                                                       : EngineVerdict::right;
}

}  // namespace

std::string_view name(EngineVerdict verdict) {
  constexpr std::array<std::string_view, engine_verdict_count> names{"right",     "near",    "wrong",
                                                                     "undecided", "refused", "failed"};
  return names[static_cast<std::size_t>(verdict)];
}

bool is_engines_folder(const fs::path& folder) {
  return fs::is_directory(folder / "scenes") && fs::is_directory(folder / "answers");
}

std::map<std::string, std::string> engine_designs(const fs::path& file) {
  std::map<std::string, std::string> designs;
  if (!fs::exists(file)) return designs;
  const std::string text = read_text_file(file);
  Mistakes mistakes(file.string());
  if (const auto root = parse_toml(text, mistakes)) {
    for (const TomlEntry& engine : root->entries) {
      const TomlEntry* design = engine.value.find("design");
      if (design == nullptr) continue;
      if (design->value.kind == TomlValue::Kind::string) {
        designs.emplace(engine.key, design->value.text.text());
      } else {
        mistakes.add(design->value.place,
                     "design: found " + std::string(kind_name(design->value.kind)) + ", expected a string");
      }
    }
  }
  mistakes.refuse_if_any();
  return designs;
}

JudgedEngines judge_engines(const fs::path& folder) {
  JudgedEngines result;
  result.designs = engine_designs(folder / "engines.toml");
  std::map<std::string, std::size_t> by_name;
  for (const fs::path& file : files_in(folder / "scenes", ".toml")) {
    result.scenes.push_back(scene_of(file, folder / "scenes"));
    by_name.emplace(result.scenes.back().name, by_name.size());
  }
  for (const fs::path& file : files_in(folder / "answers", ".jsonl")) {
    Mistakes mistakes(file.string());
    for (EngineAnswer& answer : read_engine_answers(file)) {
      const auto scene = by_name.find(answer.scene);
      if (scene == by_name.end()) {
        mistakes.add(answer.place, "found the scene " + in_quotes(answer.scene) + ", expected one of " +
                                       (folder / "scenes").generic_string());
        continue;
      }
      result.engines.push_back(answer.engine);
      result.scenes[scene->second].answers.push_back({std::move(answer), EngineVerdict::failed, std::nullopt});
    }
    mistakes.refuse_if_any();
  }
  std::sort(result.engines.begin(), result.engines.end());
  result.engines.erase(std::unique(result.engines.begin(), result.engines.end()), result.engines.end());
  in_parallel(0, result.scenes.size(), [&](std::size_t i) {
    EngineScene& scene = result.scenes[i];
    const RecordJudge judge_of_scene(CertifiedMechanism(scene.scene),
                                     {.tolerance = engine_right, .near = contact_near});
    ExactJudge exact = judge_of_scene.exact();  // all answers are at one point
    for (JudgedEngineAnswer& answer : scene.answers) {
      try {
        judge(judge_of_scene, exact, answer);
      } catch (const std::exception& error) {  // a name that the mechanism has not
        throw InputError({{scene.file.string(), 0, 0, answer.answer.engine + ": " + error.what()}});
      }
    }
  });
  return result;
}

}  // namespace slipproof
