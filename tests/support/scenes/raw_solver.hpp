// An independent solver: Eigen's full-pivoting LU on the eleven raw equations of proofs/MODEL.md.
#pragma once

#include <optional>

#include "support/bicycle/linear_form.hpp"
#include "support/eigen_rational.hpp"

namespace slipproof::test {

using RationalMatrix = Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic>;

/// The mode's motion as a function of F; nothing if the raw system is singular.
inline std::optional<Motion<Affine<Rational>>> solve_raw(const Bicycle<Rational>& p, const Road<Rational>& road,
                                                         ForceKind kind, ContactMode mode) {
  constexpr int n = static_cast<int>(unknown_count);
  RationalMatrix A(n, n), b(n, 2);
  const auto system = raw_system(p, road, kind, mode);
  for (int i = 0; i < n; ++i) {
    const auto& form = system[static_cast<std::size_t>(i)];
    for (int j = 0; j < n; ++j) A(i, j) = form.coefficients[static_cast<std::size_t>(j)];
    b(i, 0) = -form.constant;
    b(i, 1) = -form.coefficients[unknown_count];
  }
  Eigen::FullPivLU<RationalMatrix> lu(A);
  lu.setThreshold(Rational(0));
  if (lu.rank() < n) return std::nullopt;
  const RationalMatrix x = lu.solve(b);
  const auto at = [&](int i) { return Affine<Rational>(x(i, 0), x(i, 1)); };
  return motion_of(
      p, Unknowns<Affine<Rational>>{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9), at(10)});
}

}  // namespace slipproof::test
