// The memory that FLINT keeps for each thread.
#pragma once

#include <flint/flint.h>

namespace slipproof {

/// Gives back what this thread has of it, at the latest where the thread ends.
class FlintMemory {
 public:
  FlintMemory() = default;
  FlintMemory(const FlintMemory&) = delete;
  FlintMemory& operator=(const FlintMemory&) = delete;
  ~FlintMemory() { flint_cleanup(); }
};

}  // namespace slipproof
