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

/// For where numbers come into being: whatever thread this is, it gives its memory back when it ends.
inline void give_back_flint_memory_at_end() {
  [[maybe_unused]] thread_local const FlintMemory at_end;
}

}  // namespace slipproof
