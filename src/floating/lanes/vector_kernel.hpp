// Kernels over vectors, compiled for each width of registers; each call chooses which one runs.
#pragma once

#include "base/os/registers.hpp"

// Not for AddressSanitizer, under which it would take minutes to compile. Not for Clang 14, which does not inline
// functions that are compiled for other registers.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SLIPPROOF_COMPILED_FOR(registers) gnu::target(registers), gnu::noinline
#define SLIPPROOF_HAS_VECTOR_KERNELS
#else
#define SLIPPROOF_COMPILED_FOR(registers) gnu::noinline
#endif

// Every function called is inlined, so that it is compiled for those registers too.
#if defined(__SANITIZE_ADDRESS__)
#define SLIPPROOF_FLATTEN
#else
#define SLIPPROOF_FLATTEN [[gnu::flatten]]
#endif

namespace slipproof {

/// The widest registers that this machine has, that the user allows (`machine_registers`), and that kernels are
/// compiled for.
inline Registers widest_registers() {
#if defined(SLIPPROOF_HAS_VECTOR_KERNELS)
  return machine_registers();
#else
  return Registers::two;
#endif
}

/// Calls `f()`, with everything in it compiled for the registers in the name.
struct CompiledFor {
  template <class F>
  [[SLIPPROOF_COMPILED_FOR("avx512f,avx512dq")]] SLIPPROOF_FLATTEN static auto eight(const F& f) {
    return f();
  }
  template <class F>
  [[SLIPPROOF_COMPILED_FOR("avx2")]] SLIPPROOF_FLATTEN static auto four(const F& f) {
    return f();
  }
  template <class F>
  [[gnu::noinline]] SLIPPROOF_FLATTEN static auto two(const F& f) {
    return f();
  }
};

/// Kernel::run<width>(arguments...) in registers of that width, which have to be available. Everything it calls is
/// inlined.
template <class Kernel>
class VectorKernel {
 public:
  template <class... Arguments>
  static void run(Registers registers, Arguments&&... arguments) {
    switch (registers) {
      case Registers::eight:
        return CompiledFor::eight([&] { Kernel::template run<8>(arguments...); });
      case Registers::four:
        return CompiledFor::four([&] { Kernel::template run<4>(arguments...); });
      case Registers::two:
        return CompiledFor::two([&] { Kernel::template run<2>(arguments...); });
    }
  }
};

}  // namespace slipproof
