// The memory that FLINT keeps for each thread.
#pragma once

#include <flint/flint.h>

namespace slipproof {

/// Call this at the start of a thread, or where numbers are created in a caller's thread: the thread then gives FLINT's
/// memory back when it ends.
inline void give_back_flint_memory_at_end() {
  struct Memory {
    ~Memory() { flint_cleanup(); }
  };
  [[maybe_unused]] thread_local const Memory at_end;
}

}  // namespace slipproof
