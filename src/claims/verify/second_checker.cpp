#include "claims/verify/second_checker.hpp"

#include <sstream>
#include <system_error>

#include "base/input/diagnostic.hpp"
#include "base/os/program_run.hpp"
#include "proofs/check/files.hpp"

namespace slipproof {

namespace {

[[noreturn]] void refuse_checker(const std::string& program, const std::string& found) {
  throw InputError({{program, 0, 0, found + ", expected a checker such as slipproof-check-verified"}});
}

ProgramRun run_checker(const std::string& program, const std::filesystem::path& folder) {
  try {
    return run_program({program, folder.string()});
  } catch (const std::system_error& error) {
    refuse_checker(program, "found that it cannot be run: " + error.code().message());
  }
}

}  // namespace

std::map<std::filesystem::path, std::string> ask_second_checker(const std::string& program,
                                                                const std::filesystem::path& folder) {
  const ProgramRun run = run_checker(program, folder);
  if (run.exit_code != 0 && run.exit_code != 3 && run.exit_code != 4 && run.exit_code != 5) {
    refuse_checker(program, "found exit code " + std::to_string(run.exit_code) + " for " + in_quotes(folder.string()));
  }
  std::map<std::filesystem::path, std::string> verdicts;
  const std::string beginning = check::printable(folder);
  std::istringstream lines(run.output);
  std::string line;
  while (std::getline(lines, line) && !line.starts_with("s ")) {
    const std::size_t blank = line.find(' ');
    if (blank == std::string::npos) refuse_checker(program, "found the line " + in_quotes(line));
    const std::string path = line.substr(blank + 1);
    if (!path.starts_with(beginning)) refuse_checker(program, "found a verdict about " + in_quotes(path));
    verdicts.emplace(std::filesystem::path(path).lexically_normal(), line.substr(0, blank));
  }
  if (!line.starts_with("s ")) refuse_checker(program, "found no last line that begins with 's '");
  return verdicts;
}

}  // namespace slipproof
