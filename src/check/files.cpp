#include "check/files.hpp"

#include <algorithm>
#include <fstream>
#include <new>
#include <system_error>

#include "check/certificate.hpp"

namespace slipproof::check {

FileResult check_file(const std::filesystem::path& certificate) {
  FileResult result{certificate, {}, Verdict::unreadable, {}};
  std::filesystem::path current = certificate;
  current.replace_extension(".statement");
  const auto failed = [&](Verdict verdict, const std::string& message) {
    result.verdict = verdict;
    result.message = current.string() + ":" + message;
    return result;
  };
  const auto open = [&] {
    std::error_code error;
    std::ifstream file(current, std::ios::binary);
    if (!std::filesystem::is_regular_file(current, error)) file.setstate(std::ios::failbit);
    return file;
  };
  try {
    std::ifstream statement_file = open();
    if (!statement_file) return failed(Verdict::unreadable, " the statement cannot be read");
    const Statement statement(statement_file);
    result.theorem = statement.theorem();
    current = certificate;
    std::ifstream certificate_file = open();
    if (!certificate_file) return failed(Verdict::unreadable, " the certificate cannot be read");
    check_certificate(statement, certificate_file);
    result.verdict = Verdict::accepted;
    return result;
  } catch (const Failure& failure) {
    return failed(current == certificate ? Verdict::rejected : Verdict::unreadable,
                  std::to_string(failure.line) + ": " + failure.rule + ": " + failure.what());
  } catch (const std::bad_alloc&) {
    return failed(Verdict::rejected, " not enough memory");
  }
}

std::vector<std::filesystem::path> certificates_in(const std::filesystem::path& argument) {
  std::error_code error;
  if (!std::filesystem::is_directory(argument, error)) return {argument};
  std::vector<std::filesystem::path> result;
  for (std::filesystem::recursive_directory_iterator entry(argument, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".statement") result.push_back(entry->path());
  }
  for (std::filesystem::path& path : result) path.replace_extension(".cert");
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace slipproof::check
