// Another program, run to its end.
#pragma once

#include <string>
#include <vector>

namespace slipproof {

struct ProgramRun {
  std::string output;  ///< what it wrote to standard output
  int exit_code = 0;   ///< for a program ended by a signal, the signal's number + 128, as in shells
};

/// Runs arguments[0], which is looked up in PATH where it has no slash, with the others, without a shell; standard
/// input is empty, standard error is this program's. Throws std::system_error if it cannot be run.
ProgramRun run_program(const std::vector<std::string>& arguments);

}  // namespace slipproof
