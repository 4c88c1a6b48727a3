#include "mechanics/bicycle_modes/delassus.hpp"

#include "base/algebra/bareiss.hpp"
#include "mechanics/bicycle/linear_form.hpp"

namespace slipproof {

namespace {

/// Columns of the elimination: the seven unknowns that are no contact forces, then lambda, 1 and F. Indices into
/// Unknowns: a, a_y, phi, eps1, eps2, eps3, T, S2, S3, N2, N3, and F.
constexpr std::size_t inner_count = 7;
constexpr std::array<std::size_t, 4> lambda{9, 7, 10, 8};

}  // namespace

std::optional<DelassusForm> delassus(const Bicycle<Rational>& p, const Road<Rational>& road, ForceKind kind) {
  if (!p.J) return std::nullopt;
  const auto x = [](std::size_t i) { return LinearForm<Rational>::variable(i); };
  Unknowns<LinearForm<Rational>> u{x(0), x(1), x(2), x(3), x(4), x(5), x(6), x(7), x(8), x(9), x(10)};
  IntegerMatrix rows;
  for (const auto& form : equations_of_motion(p, road, kind, u, x(unknown_count))) {
    std::vector<Rational> row(form.coefficients.begin(), form.coefficients.begin() + inner_count);
    for (const std::size_t i : lambda) row.push_back(-form.coefficients[i]);
    row.push_back(-form.constant);
    row.push_back(-form.coefficients[unknown_count]);
    rows.push_back(clear_denominators(row));
  }
  const Echelon echelon = eliminate(std::move(rows), inner_count);
  if (echelon.rank() < inner_count) return std::nullopt;

  // gap and slip evaluated on the solution's column for each of lambda, 1 and F.
  DelassusForm result;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto at = [&](std::size_t i) { return Rational(echelon.rows[i][inner_count + k], echelon.pivot); };
    const Unknowns<Rational> v{at(0), at(1), at(2), at(3), at(4), at(5), at(6), 0, 0, 0, 0};
    const std::array<Rational, 4> column{gap(p, v, Wheel::rear), slip(p, v, Wheel::rear), gap(p, v, Wheel::front),
                                         slip(p, v, Wheel::front)};
    for (std::size_t i = 0; i < 4; ++i)
      (k < 4 ? result.W[i][k] : k == 4 ? result.free[i] : result.per_force[i]) = column[i];
  }
  return result;
}

}  // namespace slipproof
