// The program, started alone or as one rank of many.
#pragma once

#include "base/crew/transport.hpp"

namespace slipproof::cli {

/// What main() does. Of many ranks the others of 0 print nothing, and end when rank 0 does.
int run_program(int argc, char** argv, Transport& transport);

}  // namespace slipproof::cli
