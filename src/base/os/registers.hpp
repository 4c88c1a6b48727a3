// Which vector registers this machine has, and how many of their kinds the user allows.
#pragma once

#include <cstdint>

namespace slipproof {

/// Kinds of vector registers, by the number of binary64 in one: 2 (SSE2, or the compiler's target), 4 (AVX2 with FMA,
/// LZCNT, POPCNT and BMI) and 8 (also AVX-512F and DQ).
enum class Registers : std::uint8_t { two, four, eight };

/// The widest kind that this processor has and that the environment variable SLIPPROOF_REGISTERS (`sse2`, `avx2` or
/// `avx512`) allows. No answer depends on it, only the speed. Throws std::invalid_argument for any other value of the
/// variable.
Registers machine_registers();

}  // namespace slipproof
