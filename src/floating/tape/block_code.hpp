// The modes of a mechanism as code that runs over blocks of points.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "floating/program/tape_code.hpp"
#include "floating/tape/mode_programs.hpp"
#include "floating/tape/shared_range.hpp"

namespace slipproof {

/// A form of at most two unknowns: places of the constant, and of the coefficients.
struct BlockForm {
  std::uint32_t constant = 0;
  std::array<std::uint32_t, 2> core{};
};

/// One mode: what is computed for it, the equations of its core, and what is asked of the solution.
struct BlockMode {
  TapeCode code;
  std::vector<BlockForm> equations, conditions;
  std::vector<std::uint32_t> pivots;  ///< what else must not be 0
  bool only_refuted = false;          ///< what is free, or has to vanish, is left to others
};

/// The code of a mechanism where some inputs are the same for all points. Shared by threads.
struct BlockCode {
  /// The programs must outlive it. `constant`: of each input, whether it is the same for all points.
  BlockCode(const ModePrograms& programs, std::vector<bool> constant);

  const ModePrograms* programs;
  std::vector<bool> constant;
  TapeCode of_constants;                      ///< once for all points
  TapeCode domain;                            ///< then this, and the modes in their order: places are used again
  std::vector<std::uint32_t> domain_numbers;  ///< what the conditions of the domain compare with 0, then divisors
  std::vector<BlockMode> modes;
  std::vector<std::pair<std::uint32_t, SharedRange>> literals;
  std::vector<std::uint32_t> constant_places;  ///< of all that does not vary
  std::size_t places = 0;
};

}  // namespace slipproof
