// The program, started alone or as one of many ranks.
#pragma once

#include <functional>

namespace slipproof::cli {

/// Does the work of main(). Ranks other than 0 print nothing, and end when rank 0 does.
int run_program(int argc, char** argv);

/// What work() returns; if it throws, says so on standard error, and returns the exit code of such a failure.
int exit_code_of(const std::function<int()>& work);

}  // namespace slipproof::cli
