#include "check/files.hpp"

#include <fstream>

#include "check/theorem.hpp"

namespace slipproof::check {

FileResult check_file(const std::filesystem::path& certificate) {
  FileResult result{certificate, "unreadable", {}, {}};
  const std::filesystem::path statement_path = std::filesystem::path(certificate).replace_extension(".statement");
  std::ifstream statement_file(statement_path, std::ios::binary), certificate_file(certificate, std::ios::binary);
  FormulaReader statement_reader(statement_file, statement_path), certificate_reader(certificate_file, certificate);
  const Reader* reader = &statement_reader;
  try {
    require(statement_file.is_open(), "the file cannot be read");
    const Statement statement(statement_reader);
    result.theorem = statement.theorem;
    reader = &certificate_reader;
    require(certificate_file.is_open(), "the file cannot be read");
    result.verdict = "rejected";
    Proof(statement, certificate_reader);
    result.verdict = "accepted";
  } catch (const Rejection& rejection) {
    result.message = reader->place() + rejection.what();
  }
  return result;
}

std::vector<std::filesystem::path> certificates_in(const std::filesystem::path& argument) {
  if (!std::filesystem::is_directory(argument)) return {argument};
  std::set<std::filesystem::path> result;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(argument)) {
    std::filesystem::path path = entry.path();
    if (path.extension() == ".statement") result.insert(path.replace_extension(".cert"));
  }
  return {result.begin(), result.end()};
}

Report check_files(const std::vector<std::string>& arguments) {
  Report report;
  for (const std::string& argument : arguments) {
    const auto certificates = certificates_in(argument);
    if (certificates.empty()) report.results.push_back({argument, "unreadable", {}, argument + ": no statements here"});
    for (const auto& certificate : certificates) report.results.push_back(check_file(certificate));
  }
  std::map<std::string, int> count;
  for (const FileResult& result : report.results) {
    ++count[result.verdict];
    report.text += result.verdict + " " + (result.verdict == "accepted" ? result.theorem : result.message) + "\n";
  }
  const int rejected = count["rejected"], unreadable = count["unreadable"];
  report.exit_code = rejected > 0 ? 5 : unreadable > 0 ? 3 : 0;
  const char* verdict = rejected > 0 ? "s REJECTED " : unreadable > 0 ? "s UNREADABLE " : "s ACCEPTED ";
  report.summary = verdict + std::to_string(count["accepted"]) + " accepted, " + std::to_string(rejected) +
                   " rejected, " + std::to_string(unreadable) + " unreadable\n";
  return report;
}

}  // namespace slipproof::check
