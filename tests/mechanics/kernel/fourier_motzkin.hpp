// Systems of linear equations and inequalities, by Fourier and Motzkin: slow, short, and nothing of
// src/mechanics/kernel in it.
#pragma once

#include <optional>
#include <vector>

#include "base/algebra/linear_program.hpp"
#include "mechanics/elements/force_interval.hpp"

namespace slipproof::test {

struct RawSystem {
  struct Inequality {
    AffineForm form;
    bool strict = false;  ///< form > 0, not only >= 0
  };
  std::vector<AffineForm> equations;  ///< form = 0
  std::vector<Inequality> inequalities;
};

/// The values that a variable takes on the solutions; nothing() if there is no solution.
ForceInterval shadow(const RawSystem& system, std::size_t variable);
/// Those that a form takes.
ForceInterval shadow(const RawSystem& system, const AffineForm& form);
bool is_solvable(const RawSystem& system);

}  // namespace slipproof::test
