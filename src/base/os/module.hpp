// Parts of slipproof that are loaded when they are needed, since the libraries behind them would lengthen every start.
#pragma once

#include <string>

namespace slipproof {

/// The function that the module exports under this name. Loads the module at the first call and keeps it. Null, with
/// the reason in `why`, if it is not installed or cannot be loaded. It is looked for beside the program, in the folder
/// of libraries that belongs to the program, and where it was built. `module` is a file name, such as
/// "slipproof-png.so".
void* function_of_module(const std::string& module, const char* function, std::string& why);

}  // namespace slipproof
