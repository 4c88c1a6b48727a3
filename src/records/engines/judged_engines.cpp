#include "records/engines/judged_engines.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "base/input/text_file.hpp"
#include "base/input/toml.hpp"
#include "base/number/binary64.hpp"
#include "base/parallel/in_parallel.hpp"
#include "contact/problem/tolerance.hpp"
#include "records/judging/exact_judge.hpp"
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

EngineVerdict verdict_of(const RecordJudgement& found) {
  if (found.verdict == RecordVerdict::undecided) return EngineVerdict::undecided;
  if (!found.distance || *found.distance > contact_near) return EngineVerdict::wrong;
  return *found.distance > engine_right ? EngineVerdict::near : EngineVerdict::right;
}

/// Judges all answers to a scene: by its motions, or by the outcomes of one law of impact.
class SceneJudge {
 public:
  explicit SceneJudge(MechanismScene scene)
      : scene_(std::move(scene)),
        judge_(CertifiedMechanism(scene_), {.tolerance = engine_right, .near = contact_near}),
        exact_(judge_.exact()) {  // all answers are at one point
    const Mechanism& m = scene_.mechanism;
    if (m.impact) energy_.emplace(m, ProblemMaker(m), scene_.values, scene_.load);
  }

  void operator()(JudgedEngineAnswer& judged) {
    const EngineAnswer& answer = judged.answer;
    if (!answer.refused.empty()) judged.verdict = EngineVerdict::refused;
    if (answer.motion.empty()) return;
    const Record record = judge_.record(answer.motion);
    const std::string missing = incomplete(record.present, judge_.fields(), judge_.certified());
    if (!missing.empty()) throw std::invalid_argument(missing);
    const RecordJudgement found = exact_(record);
    const EngineVerdict verdict = verdict_of(found);
    const bool nearer = found.distance && (!judged.distance || *found.distance < *judged.distance);
    if (verdict < judged.verdict || (verdict == judged.verdict && nearer)) {  // at first it has failed
      judged.verdict = verdict, judged.distance = found.distance;
    }
    if (!energy_) return;
    if (verdict == EngineVerdict::right) judged.laws.push_back(scene_.mechanism.impact->law);
    judged.energy_gained = gained(record);
  }

 private:
  std::optional<double> gained(const Record& record) const {
    if (energy_->before().is_zero()) return std::nullopt;
    return nearest_binary64(energy_gained(*energy_, record, judge_.fields().first_answer()) / energy_->before());
  }

  const MechanismScene scene_;
  const RecordJudge judge_;
  ExactJudge exact_;
  std::optional<ImpactEnergy> energy_;
};

void judge_answers(EngineScene& scene, MechanismScene by) {
  SceneJudge judge(std::move(by));
  for (JudgedEngineAnswer& answer : scene.answers) {
    try {
      judge(answer);
    } catch (const std::invalid_argument& error) {  // a name that the mechanism has not
      throw InputError({{scene.file.string(), 0, 0, answer.answer.engine + ": " + error.what()}});
    }
  }
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
      result.scenes[scene->second].answers.push_back({std::move(answer), EngineVerdict::failed, {}, {}, {}});
    }
    mistakes.refuse_if_any();
  }
  std::sort(result.engines.begin(), result.engines.end());
  result.engines.erase(std::unique(result.engines.begin(), result.engines.end()), result.engines.end());
  in_parallel(0, result.scenes.size(), [&](std::size_t i) {
    EngineScene& scene = result.scenes[i];
    if (!scene.scene.mechanism.impact) return judge_answers(scene, scene.scene);
    for (const ImpactLaw law : judged_laws) {
      judge_answers(scene, read_scene(scene.file, {Dimensions::any, ImpactRequest{law}}));
    }
  });
  return result;
}

}  // namespace slipproof
