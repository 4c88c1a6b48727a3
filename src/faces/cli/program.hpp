// The program, started alone or as one of many ranks.
#pragma once

#include "base/crew/transport.hpp"

namespace slipproof::cli {

/// Does the work of main(). Ranks other than 0 print nothing, and end when rank 0 does.
int run_program(int argc, char** argv, Transport& transport);

}  // namespace slipproof::cli
