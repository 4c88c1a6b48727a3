#include "contact/complete/solve_near.hpp"

#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof {

Rational nearest_multiple(double x, int bits) {
  return to_rational(std::nearbyint(std::ldexp(x, bits))) * power_of_two(-bits);
}

Rational rounded_down(const Rational& x, int bits) {
  const Rational scaled = x * power_of_two(bits);
  Integer quotient;
  fmpz_fdiv_q(quotient.flint(), numerator(scaled).flint(), denominator(scaled).flint());
  return Rational(quotient) * power_of_two(-bits);
}

std::optional<NearSolution> solve_near(const RationalMatrix& system, std::span<const double> near, int bits) {
  const std::size_t n = near.size();
  NearSolution result{std::vector<Rational>(n), n};
  if (system.empty()) {
    for (std::size_t j = 0; j < n; ++j) result.x[j] = nearest_multiple(near[j], bits);
    return result;
  }
  const Echelon echelon = eliminate(system);
  if (echelon.rank(n) != echelon.rank()) return std::nullopt;
  std::vector<bool> is_pivot(n, false);
  for (const std::size_t j : echelon.pivot_columns) is_pivot[j] = true;
  for (std::size_t j = 0; j < n; ++j) {
    if (!is_pivot[j]) result.x[j] = nearest_multiple(near[j], bits);
  }
  for (std::size_t p = 0; p < echelon.rank(); ++p) {
    Rational sum(echelon.rows[p][n]);
    for (std::size_t j = 0; j < n; ++j) {
      if (!is_pivot[j] && !echelon.rows[p][j].is_zero()) sum -= Rational(echelon.rows[p][j]) * result.x[j];
    }
    result.x[echelon.pivot_columns[p]] = sum / Rational(echelon.pivot);
  }
  result.open_directions = n - echelon.rank();
  return result;
}

}  // namespace slipproof
