#include <fstream>
#include <thread>

#include "floating/trade/trade.hpp"

namespace slipproof {

Machine this_machine() {
  Machine machine {
    .processor = "unknown processor",
#if defined(__clang__)
    .compiler = "clang " __clang_version__,
#else
    .compiler = "g++ " __VERSION__,
#endif
    .flags = SLIPPROOF_COMPILER_FLAGS, .cores = std::thread::hardware_concurrency()
  };
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    machine.processor = line.substr(line.find(':') + 2);
    break;
  }
  return machine;
}

}  // namespace slipproof
