// A kernel over vectors, compiled for each width of registers; which one runs is decided at each call.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "filter/vector_clones.hpp"

namespace slipproof {

/// Vector registers, by how many binary64 one holds: 2, 4 (AVX2) and 8 (AVX-512).
enum class Registers : std::uint8_t { two, four, eight };

/// Whether this machine has them, and the compiler could compile for them.
inline bool available(Registers registers) {
#if defined(SLIPPROOF_HAS_VECTOR_CLONES)
  switch (registers) {
    case Registers::eight:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
    case Registers::four:
      return __builtin_cpu_supports("avx2");
    case Registers::two:
      break;
  }
#endif
  return registers == Registers::two;
}

inline Registers widest_registers() {
  return available(Registers::eight) ? Registers::eight : available(Registers::four) ? Registers::four : Registers::two;
}

/// Kernel::run<width>(arguments...) in registers of that width, which have to be available. Everything it calls is
/// inlined.
template <class Kernel>
class VectorKernel {
 public:
  template <class... Arguments>
  static void run(Registers registers, Arguments&&... arguments) {
    switch (registers) {
      case Registers::eight:
        return eight(arguments...);
      case Registers::four:
        return four(arguments...);
      case Registers::two:
        return two(arguments...);
    }
  }

 private:
#if defined(SLIPPROOF_HAS_VECTOR_CLONES)
  template <class... Arguments>
  [[gnu::target("avx512f,avx512dq"), gnu::noinline]] SLIPPROOF_FLATTEN static void eight(Arguments&... arguments) {
    Kernel::template run<8>(arguments...);
  }
  template <class... Arguments>
  [[gnu::target("avx2"), gnu::noinline]] SLIPPROOF_FLATTEN static void four(Arguments&... arguments) {
    Kernel::template run<4>(arguments...);
  }
#else
  template <class... Arguments>
  static void eight(Arguments&... arguments) {
    two(arguments...);
  }
  template <class... Arguments>
  static void four(Arguments&... arguments) {
    two(arguments...);
  }
#endif
  template <class... Arguments>
  SLIPPROOF_FLATTEN static void two(Arguments&... arguments) {
    Kernel::template run<2>(arguments...);
  }
};

}  // namespace slipproof
