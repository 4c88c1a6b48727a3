#include "base/os/registers.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

namespace slipproof {

namespace {

Registers of_this_processor() {
#if defined(__x86_64__) && defined(__GNUC__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") || !__builtin_cpu_supports("popcnt") ||
      !__builtin_cpu_supports("bmi")) {
    return Registers::two;
  }
#if !defined(__clang__)  // Clang 14 cannot ask for it; every processor with AVX2 and BMI has it
  if (!__builtin_cpu_supports("lzcnt")) return Registers::two;
#endif
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  return avx512 ? Registers::eight : Registers::four;
#else
  return Registers::two;
#endif
}

Registers allowed() {
  const char* const text = std::getenv("SLIPPROOF_REGISTERS");
  if (text == nullptr || std::string_view(text) == "avx512") return Registers::eight;
  if (std::string_view(text) == "avx2") return Registers::four;
  if (std::string_view(text) == "sse2") return Registers::two;
  throw std::invalid_argument("SLIPPROOF_REGISTERS: found \"" + std::string(text) +
                              "\", expected sse2, avx2 or avx512");
}

}  // namespace

Registers machine_registers() {
  static const Registers registers = std::min(of_this_processor(), allowed());
  return registers;
}

}  // namespace slipproof
