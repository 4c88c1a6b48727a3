#include "report/html/solvers.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "base/input/text_file.hpp"
#include "records/certify/certify.hpp"

namespace slipproof {

namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> all;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) all.push_back(cell);
  if (!all.empty() && all.back().ends_with('\r')) all.back().pop_back();
  return all;
}

}  // namespace

SolverVerdicts certify_solver(const std::filesystem::path& path) {
  constexpr std::size_t longest_recording = 1U << 26U;
  const std::string text = read_text_file(path, longest_recording);
  CertifyOptions options;
  options.ignore_unknown = true;
  options.file = path.string();
  std::vector<RecordVerdict> verdicts;
  options.judged = [&](std::uint64_t, const RecordJudgement& judgement) { verdicts.push_back(judgement.verdict); };
  std::istringstream input(text);
  const CertifySummary summary = certify(
      input, [](std::string_view) {}, options);

  SolverVerdicts result;
  result.name = path.stem().string();
  result.records = summary.records;
  result.verdicts = summary.verdicts;
  std::istringstream records(text);
  std::string record;
  std::getline(records, record);
  const auto header = cells(record);
  const auto info = std::find(header.begin(), header.end(), "info");
  if (info == header.end()) return result;
  const auto column = static_cast<std::size_t>(info - header.begin());
  result.unfounded = 0;
  for (auto verdict = verdicts.begin(); verdict != verdicts.end() && std::getline(records, record);) {
    if (record.find_first_not_of(" \t\r") == record.npos) continue;
    const auto values = cells(record);
    const bool unfounded = *verdict == RecordVerdict::wrong || *verdict == RecordVerdict::invalid;
    if (column < values.size() && values[column] == "0" && unfounded) ++*result.unfounded;
    ++verdict;
  }
  return result;
}

}  // namespace slipproof
