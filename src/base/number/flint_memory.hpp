// The memory that FLINT keeps for each thread.
#pragma once

#include <flint/flint.h>

namespace slipproof {

/// For where a thread begins, or numbers come into being in one of whoever calls: it gives its memory back when it
/// ends.
inline void give_back_flint_memory_at_end() {
  struct Memory {
    ~Memory() { flint_cleanup(); }
  };
  [[maybe_unused]] thread_local const Memory at_end;
}

}  // namespace slipproof
