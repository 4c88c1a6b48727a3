// A kernel over vectors, compiled for each width of registers; which one runs is decided at each call.
#pragma once

#include <span>

#include "base/os/registers.hpp"

// Not for AddressSanitizer, under which it would take minutes to compile; Clang 14 inlines no function of other
// registers.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SLIPPROOF_COMPILED_FOR(registers) gnu::target(registers), gnu::noinline
#define SLIPPROOF_HAS_VECTOR_KERNELS
#else
#define SLIPPROOF_COMPILED_FOR(registers) gnu::noinline
#endif

// Everything called is inlined, so that it is compiled for those registers too.
#if defined(__SANITIZE_ADDRESS__)
#define SLIPPROOF_FLATTEN
#else
#define SLIPPROOF_FLATTEN [[gnu::flatten]]
#endif

namespace slipproof {

/// The widest registers that this machine has, the user allows (`machine_registers`), and kernels are compiled for.
inline Registers widest_registers() {
#if defined(SLIPPROOF_HAS_VECTOR_KERNELS)
  return machine_registers();
#else
  return Registers::two;
#endif
}

inline bool available(Registers registers) {
  return registers <= widest_registers();
}

/// Calls of `f()`, all of it compiled for the registers that the name says.
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

/// f() in registers of four where they are available: for what has one number at a time, and gains by AVX's
/// instructions of three operands. What it returns is the same either way.
template <class F>
auto in_registers_of_four(const F& f) {
  return available(Registers::four) ? CompiledFor::four(f) : CompiledFor::two(f);
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
        return CompiledFor::eight([&] { Kernel::template run<8>(arguments...); });
      case Registers::four:
        return CompiledFor::four([&] { Kernel::template run<4>(arguments...); });
      case Registers::two:
        return CompiledFor::two([&] { Kernel::template run<2>(arguments...); });
    }
  }
};

}  // namespace slipproof
