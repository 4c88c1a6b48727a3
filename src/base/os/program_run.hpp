// Another program, run to its end.
#pragma once

#include <string>
#include <vector>

namespace slipproof {

struct ProgramRun {
  std::string output;  ///< its standard output
  int exit_code = 0;   ///< exit code; 128 + the signal's number if a signal ended it, as in shells
};

/// Runs arguments[0], which is looked up in PATH where it has no slash, with the others, without a shell; standard
/// input is empty, standard error is this program's. Throws std::system_error if it cannot be run.
ProgramRun run_program(const std::vector<std::string>& arguments);

}  // namespace slipproof
