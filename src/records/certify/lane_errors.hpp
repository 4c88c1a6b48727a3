// Errors of answers against exact numbers that are known within bounds, several records side by side: upper bounds on
// what contact/yardstick.hpp calls relative errors.
#pragma once

#include <limits>
#include <vector>

#include "floating/tape/mode_run.hpp"

namespace slipproof {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// A lower bound on the size of what is known only by its bounds.
inline Lanes least(const RunningError& x) {
  return absolute(x.value) * (1 - 0x1p-50) - x.error;
}

inline Lanes larger(const Lanes& x, const Lanes& y) {
  return chosen(y > x, y, x);
}

/// Upper bound on the relative error of an answer; `scale` is a lower bound on the yardstick of its kind without it.
/// What varies is held against the answer where it is surely left open, and against the smaller of both where that is
/// unsure.
inline Lanes relative_error(const RunningError& answer, const RunningError& exact, const Lanes& scale, bool varies,
                            const LaneBits& open) {
  constexpr double up = 1 + 0x1p-48;
  const RunningError difference = answer - exact;
  const Lanes distance = (absolute(difference.value) + difference.error) * up;
  Lanes unit = least(exact);
  if (varies) {
    const Lanes own = least(answer);
    unit = chosen(open, larger(own, scale), chosen(own < unit, own, unit));
  } else {
    unit = chosen(surely_zero(exact), scale, unit);
  }
  const LaneBits both_zero = surely_zero(answer) & surely_zero(exact);
  const Lanes relative = chosen(unit > 0, distance / unit * up, Lanes{} + infinite);
  return chosen(both_zero, Lanes{}, relative);
}

/// The larger one; NaN where one of them is.
inline Lanes worse(const Lanes& x, const Lanes& y) {
  return chosen((x == x) & (y == y), larger(x, y), Lanes{} + infinite);
}

/// Lower bounds on the yardsticks of all kinds, by what is known without a solution; 0 where nothing is sure.
inline std::vector<Lanes> least_yardsticks(const ModeRun& run, const ModePrograms& programs) {
  const MechanismKinds& kinds = programs.kinds;
  std::vector<Lanes> sizes(kinds.count);
  // Of coefficients the sum, which is not below the largest, and NaN where one is not known.
  const auto over = [&](const Lanes& x, const std::vector<TapeRef>& coefficients) {
    Lanes sum{};
    for (const TapeRef ref : coefficients) sum += absolute(run.at(ref).value) + run.at(ref).error;
    const Lanes quotient = x / (sum * (1 + 0x1p-40)) * (1 - 0x1p-50);
    return chosen((sum > 0) & (quotient > 0x1p-900), quotient, Lanes{});  // far from where it would lose digits
  };
  const auto constant = [&](std::size_t line) { return least(run.at(programs.line_constants[line])); };
  for (std::size_t i = 0; i < kinds.lines.size(); ++i) {
    sizes[kinds.lines[i]] = larger(sizes[kinds.lines[i]], constant(i));
  }
  for (std::size_t i = 0; i < kinds.inertias.size(); ++i) {
    Lanes& size = sizes[kinds.inertias[i].kind];
    for (const auto& place : kinds.inertias[i].places) {
      size = larger(size, over(constant(place.first), programs.inertias[i]));
    }
  }
  std::vector<Lanes> result = sizes;
  for (std::size_t i = 0; i < kinds.levers.size(); ++i) {
    Lanes& size = result[kinds.levers[i].kind];
    size = larger(size, over(sizes[kinds.levers[i].of], programs.levers[i]));
  }
  return result;
}

}  // namespace slipproof
