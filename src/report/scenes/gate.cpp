#include "report/scenes/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "base/output/percent.hpp"
#include "report/markup/element.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

namespace {

constexpr std::string_view eps_solution = "eps-solution";

std::string case_name(const GateFailure& failure) {
  return "record " + std::to_string(failure.record);
}

/// The title of its problem, if it has one.
std::string titled(const GateFailure& failure, const std::string& file) {
  const std::string title = Json::parse(failure.line).value("problem", std::string());
  return title.empty() || title == file ? case_name(failure) : title + " (" + case_name(failure) + ")";
}

/// The reason in a line of output, where it has one.
std::string message_of(const GateFailure& failure) {
  const Json line = Json::parse(failure.line);
  std::string text = line.value("verdict", failure.verdict);
  if (line.contains("others")) text += ": others " + line["others"].get<std::string>();
  if (line.contains("reason")) text += ": " + line["reason"].get<std::string>();
  if (line.contains("violated") && line["violated"].is_string()) {
    text += ": violates " + line["violated"].get<std::string>() + ", margin " + line.value("margin", std::string());
  }
  if (line.contains("worst") && line["worst"].is_array() && !line["worst"].empty()) {
    const Json& worst = line["worst"][0];
    const std::string place =
        worst.contains("contact") ? "contact " + worst["contact"].dump() : "row " + worst["row"].dump();
    text +=
        ": " + place + " violates " + worst["violates"].get<std::string>() + " by " + worst["by"].get<std::string>();
  }
  return text;
}

}  // namespace

FailingVerdicts::FailingVerdicts(const std::vector<std::string>& names) {
  fails_[static_cast<std::size_t>(RecordVerdict::invalid)] = true;
  eps_ = std::ranges::find(names, eps_solution) != names.end();
  for (const std::string& wanted : names) {
    bool known = wanted == eps_solution;
    for (std::size_t i = 0; i < record_verdict_count; ++i) {
      if (name(static_cast<RecordVerdict>(i)) != wanted) continue;
      fails_[i] = known = true;
    }
    if (!known) throw std::invalid_argument(wanted);
    only_ = only_ || wanted == name(RecordVerdict::ambiguous);
  }
}

bool FailingVerdicts::operator()(const CertifySummary& summary) const {
  for (std::size_t i = 0; i < record_verdict_count; ++i) {
    const auto verdict = static_cast<RecordVerdict>(i);
    const std::uint64_t eps = verdict == RecordVerdict::inaccurate ? summary.eps_solutions : 0;
    if (fails_[i] && summary.count(verdict) > eps) return true;
  }
  return (eps_ && summary.eps_solutions > 0) || (only_ && summary.others_possible > 0);
}

void GateRun::add(std::uint64_t record, const RecordJudgement& judgement, const FailingVerdicts& fails) {
  ++records;
  if (!fails(judgement)) return;
  ++failed;
  if (listed.size() == most_listed) return;
  std::string line;
  append_line(line, record, judgement);
  const bool certified = judgement.verdict == RecordVerdict::certified;  // and perhaps not the only one
  const std::string_view word = judgement.eps_solution ? eps_solution
                                : certified            ? name(RecordVerdict::ambiguous)
                                                       : name(judgement.verdict);
  listed.push_back({record, std::string(word), std::move(line)});
}

std::string gate_text(const GateRun& run) {
  constexpr std::size_t most = 10;
  std::string text = fmt::format("{} of {} fail\n", run.failed, counted(run.records, "record"));
  for (std::size_t i = 0; i < std::min(most, run.listed.size()); ++i) {
    text += fmt::format("  {}: {}: {}\n", run.file, case_name(run.listed[i]), message_of(run.listed[i]));
  }
  if (run.failed > most) text += fmt::format("  and {} more\n", run.failed - most);
  return text;
}

std::string junit(const GateRun& run) {
  const ElementTree tree("testsuites");
  const Element suite = tree.root().add("testsuite").set("name", run.file);
  suite.set("tests", std::to_string(run.listed.size() + 1)).set("failures", std::to_string(run.listed.size()));
  suite.add("testcase")
      .set("classname", run.file)
      .set("name",
           counted(run.records - run.failed, "record") + " of " + std::to_string(run.records) + " that do not fail");
  for (const GateFailure& failure : run.listed) {
    const Element own = suite.add("testcase").set("classname", run.file).set("name", titled(failure, run.file));
    own.add("failure").set("type", failure.verdict).set("message", message_of(failure)).text(failure.line);
  }
  if (run.failed > run.listed.size()) {
    suite.add("system-out")
        .text(counted(run.failed, "record") + " fail; the first " + std::to_string(run.listed.size()) + " are listed");
  }
  return tree.xml();
}

std::string sarif(const GateRun& run) {
  Json rules = Json::array(), results = Json::array();
  for (std::size_t i = 0; i < record_verdict_count; ++i) {
    rules.push_back(Json{{"id", name(static_cast<RecordVerdict>(i))}});
  }
  rules.push_back(Json{{"id", eps_solution}});
  for (const GateFailure& failure : run.listed) {
    Json result, location;
    result["ruleId"] = failure.verdict;
    result["level"] = failure.verdict == name(RecordVerdict::undecided) ? "warning" : "error";
    result["message"]["text"] = case_name(failure) + ": " + message_of(failure);
    location["physicalLocation"]["artifactLocation"]["uri"] = percent_encoded(run.file, "/");
    result["locations"] = Json::array({std::move(location)});
    result["properties"]["record"] = failure.record;
    results.push_back(std::move(result));
  }
  Json own, document;
  own["tool"]["driver"]["name"] = "slipproof";
  own["tool"]["driver"]["rules"] = std::move(rules);
  own["results"] = std::move(results);
  own["properties"] = Json{{"records", run.records}, {"failed", run.failed}};
  document["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  document["version"] = "2.1.0";
  document["runs"] = Json::array({std::move(own)});
  return dump(document);
}

}  // namespace slipproof
