// The modes of a mechanism as code that runs over blocks of points.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/rounding/shared_range.hpp"
#include "floating/program/tape_code.hpp"
#include "floating/tape/mode_programs.hpp"

namespace slipproof {

/// A form of at most two unknowns: places of the constant, and of the coefficients.
struct BlockForm {
  std::uint32_t constant = 0;
  std::array<std::uint32_t, 2> core{};
};

/// One mode: the code that computes it, the equations of its core, and the conditions on the solution.
struct BlockMode {
  TapeCode code;
  std::vector<BlockForm> equations, conditions;
  std::vector<std::uint32_t> pivots;  ///< other numbers that must not be 0
  bool only_refuted = false;  ///< the code can only refute the mode: it has free numbers, or numbers that must vanish
};

/// The code of a mechanism for points at which some inputs are constant. May be shared by threads.
struct BlockCode {
  /// The programs must outlive it. `constant`: for each input, whether it is the same at all points.
  BlockCode(const ModePrograms& programs, std::vector<bool> constant);

  const ModePrograms* programs;
  std::vector<bool> constant;
  TapeCode of_constants;  ///< runs once for all points
  TapeCode domain;        ///< runs for each block, before the modes in their order; they use its places again
  std::vector<std::uint32_t> domain_numbers;  ///< the numbers that the domain compares with 0, then the divisors
  std::vector<BlockMode> modes;
  std::vector<std::pair<std::uint32_t, SharedRange>> literals;
  std::vector<std::uint32_t> constant_places;  ///< places of all results that do not vary
  std::size_t places = 0;
  std::vector<bool> divisors;  ///< by step of the domain and of all modes: whether something is divided by its result
};

}  // namespace slipproof
