#include "faces/explorer/pasted.hpp"

#include <memory>

#include "base/input/diagnostic.hpp"
#include "contact/formats/json_problem.hpp"
#include "mechanics/checks/kinds.hpp"
#include "records/certify/certify.hpp"
#include "records/judging/exact_judge.hpp"
#include "records/judging/space_judge.hpp"
#include "records/problems/problem_judge.hpp"
#include "records/problems/problem_reader.hpp"
#include "records/reading/chunk_reader.hpp"
#include "records/reading/record_reader.hpp"
#include "records/record/bicycle_records.hpp"

namespace slipproof {

namespace {

constexpr const char* pasted_file = "the pasted text";

[[noreturn]] void refuse_pasted(const std::string& message) {
  throw InputError({{pasted_file, 0, 0, message}});
}

Json line_json(std::uint64_t record, const RecordJudgement& judgement) {
  std::string line;
  append_line(line, record, judgement);
  return Json::parse(line);
}

RecordJudgement judge_pasted_problem(std::string_view text, const JsonProblem& json) {
  if (json.is_large()) {
    refuse_pasted(
        "found a contact problem in space, of a law, sparse or in the global form, expected one in the plane with a "
        "dense W; `slipproof certify FILE` judges the others");
  }
  const ProblemRecord record = read_problem(json, text, false, true);
  if (record.not_finite) return invalid_judgement(record.not_finite->reason);
  JudgeOptions options;
  options.tolerance = contact_tolerance;
  return judge_problem(record.problem, record.answer, options);
}

CertifyOptions options_for(const std::string& scene, bool csv) {
  CertifyOptions options;
  options.format = csv ? RecordFormat::csv : RecordFormat::json_lines;
  options.file = pasted_file;
  options.mechanism = records_of_scene(scene, "scene.toml");
  options.ignore_unknown = true;
  return options;
}

/// The records of a scene.
class PastedRecords {
 public:
  PastedRecords(const std::string& scene, bool csv, std::string_view header)
      : options_(options_for(scene, csv)),
        fields_(*options_.mechanism),
        maker_(options_.mechanism->mechanism),
        kinds_(options_.mechanism->mechanism),
        reader_(options_, *options_.mechanism, fields_, header),
        judge_({*options_.mechanism, fields_, maker_, kinds_}, options_.judge, in_space_) {}

  RecordJudgement judge(std::string_view line, std::uint64_t at) {
    try {
      reader_.read(line, record_);
      const auto& found = record_.not_finite;
      return found ? invalid_judgement(place_text(at, found->column) + found->reason) : judge_(record_);
    } catch (const BrokenRecord& broken) {
      return invalid_judgement(place_text(at, broken.column) + broken.message);
    }
  }

 private:
  CertifyOptions options_;
  RecordFields fields_;
  ProblemMaker maker_;
  MechanismKinds kinds_;
  SpaceMemory in_space_;
  RecordReader reader_;
  ExactJudge judge_;
  Record record_;
};

}  // namespace

Json judge_pasted(std::string_view text, const std::string& scene) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos)
    refuse_pasted("found nothing, expected a contact problem with its answer, or records");
  text.remove_prefix(begin);
  const bool csv = text.front() != '{', lists = text.find('[') != std::string_view::npos;  // a record has none
  if (csv && lists) {
    refuse_pasted(R"(found lists, expected a contact problem as JSON, {"W": [[1, 0], [0, 1]], "q": [-9.81, 0.5], )"
                  R"("mu": 0.3, "r": [9.81, -0.5]}, or records: a line of names, and below it lines of numbers)");
  }
  if (lists) {
    const JsonProblem json(text, pasted_file);
    if (!json.is_problem()) refuse_pasted("found lists without W and q, expected both in a contact problem");
    return Json::array({line_json(1, judge_pasted_problem(text, json))});
  }
  Json lines = Json::array();
  std::unique_ptr<PastedRecords> records;
  std::uint64_t at = 0;
  each_line(text, [&](std::string_view line) {
    ++at;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (blank(line)) return;
    const bool header = csv && !records;
    if (!records) records = std::make_unique<PastedRecords>(scene, csv, line);
    if (!header) lines.push_back(line_json(lines.size() + 1, records->judge(line, at)));
  });
  if (lines.empty()) refuse_pasted("found a header alone, expected records below it");
  return lines;
}

}  // namespace slipproof
