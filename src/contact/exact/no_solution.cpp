#include "contact/exact/no_solution.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "base/algebra/linear_program.hpp"
#include "base/number/binary64.hpp"
#include "base/number/dice.hpp"

namespace slipproof {

namespace {

/// A^T y.
std::vector<Rational> combined_rows(const SparseMatrix& A, const std::vector<Rational>& y) {
  std::vector<Rational> g(A.columns);
  for (std::size_t i = 0; i < A.rows; ++i) {
    if (y[i].is_zero()) continue;
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) g[A.column[k]] += y[i] * to_rational(A.value[k]);
  }
  return g;
}

enum class Length { full, cut };

/// The linear program: minimize c . y >= -1 over the y of free and normal rows, with g in pyramids. The cost of exact
/// pivots depends on the length of their numbers. So the coefficients of normal rows, where y >= 0, may be cut to some
/// bits, downwards in quantities that must be >= 0 and upwards in those that must be < 0. A solution found this way is
/// still right; it is missed only if there is hardly any room.
class MultiplierProgram {
 public:
  explicit MultiplierProgram(const MixedProblem& problem) : problem_(problem), columns_(transposed(problem.A)) {
    for (std::size_t i = 0; i < problem.free; ++i) rows_.push_back(i);
    for (std::size_t k = 0; k < problem.contacts(); ++k) rows_.push_back(problem.normal(k));
    place_.assign(problem.size(), rows_.size());
    for (std::size_t v = 0; v < rows_.size(); ++v) place_[rows_[v]] = v;
    objective_.coefficients.resize(rows_.size());
    for (std::size_t v = 0; v < rows_.size(); ++v) objective_.coefficients[v] = to_rational(problem.c[rows_[v]]);
  }

  /// In dimension 3 with pyramids of so many sides.
  std::optional<std::vector<Rational>> solve(int sides, Length length, Effort& effort) const {
    AffineForm objective = objective_;
    std::vector<AffineForm> cones;
    for (std::size_t k = 0; k < problem_.contacts(); ++k) add_cone(cones, k, sides);
    if (length == Length::cut) {
      objective = negative(cut(negative(std::move(objective))));
      for (AffineForm& form : cones) form = cut(std::move(form));
    }
    std::vector<AffineForm> all = constraints(objective);
    std::move(cones.begin(), cones.end(), std::back_inserter(all));
    const LinearOptimum found = minimize(objective, all, effort);
    if (found.kind != LinearOptimum::Kind::attained || found.value.sign() >= 0) return std::nullopt;
    std::vector<Rational> y(problem_.size());
    for (std::size_t v = 0; v < rows_.size(); ++v) y[rows_[v]] = found.x[v];
    return y;
  }

 private:
  /// Those that are no cones. y >= 0 comes before the cones: the simplex method begins with pivots on the first rows,
  /// and these are of one entry 1.
  std::vector<AffineForm> constraints(const AffineForm& objective) const {
    std::vector<AffineForm> result;
    AffineForm bounded = objective;
    bounded.constant = 1;
    result.push_back(std::move(bounded));
    for (std::size_t i = 0; i < problem_.free; ++i) {
      const AffineForm g = combination(i);
      result.push_back(g);
      result.push_back(negative(g));
    }
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      AffineForm& y = result.emplace_back(AffineForm{0, std::vector<Rational>(rows_.size())});
      y.coefficients[problem_.free + k] = 1;
    }
    return result;
  }

  /// -g_N >= mu e . g_T for vectors e whose hull contains the unit disk, or is [-1, 1].
  void add_cone(std::vector<AffineForm>& to, std::size_t k, int sides) const {
    const std::size_t at = problem_.normal(k);
    const AffineForm inward = negative(combination(at));
    const Rational mu = to_rational(problem_.mu[k]);
    if (problem_.dimension == 1 || mu.is_zero()) {
      to.push_back(inward);
    } else if (problem_.dimension == 2) {
      const AffineForm tangential = combination(at + 1);
      to.push_back(sum(inward, mu, tangential));
      to.push_back(sum(inward, -mu, tangential));
    } else {
      const AffineForm first = combination(at + 1), second = combination(at + 2);
      for (const auto& [x, y] : corners(sides)) to.push_back(sum(sum(inward, mu * x, first), mu * y, second));
    }
  }

  /// The corners of a polygon around the unit disk, in short numbers. If one lies too close to the disk, the check of y
  /// decides.
  static std::vector<std::pair<Rational, Rational>> corners(int sides) {
    constexpr int unit = 1 << 12;
    const double radius = (unit + 2) / std::cos(std::numbers::pi / sides);
    std::vector<std::pair<Rational, Rational>> result;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      result.emplace_back(Rational(std::lround(radius * std::cos(angle)), unit),
                          Rational(std::lround(radius * std::sin(angle)), unit));
    }
    return result;
  }

  /// Component j of A^T y.
  AffineForm combination(std::size_t j) const {
    AffineForm g{0, std::vector<Rational>(rows_.size())};
    for (std::size_t k = columns_.starts[j]; k < columns_.starts[j + 1]; ++k) {
      const std::size_t v = place_[columns_.column[k]];
      if (v < rows_.size()) g.coefficients[v] = to_rational(columns_.value[k]);
    }
    return g;
  }

  static AffineForm sum(AffineForm a, const Rational& factor, const AffineForm& b) {
    for (std::size_t v = 0; v < a.coefficients.size(); ++v) a.coefficients[v] += factor * b.coefficients[v];
    return a;
  }

  static AffineForm negative(AffineForm form) {
    for (Rational& x : form.coefficients) x = -x;
    return form;
  }

  /// With less in normal rows, by less than 2^-14 of the largest.
  AffineForm cut(AffineForm form) const {
    double largest = 0;
    for (const Rational& x : form.coefficients) largest = std::max(largest, std::abs(nearest_binary64(x)));
    if (largest == 0 || !std::isfinite(largest)) return form;
    const Rational unit = power_of_two(std::ilogb(largest) - 14);
    for (std::size_t v = problem_.free; v < form.coefficients.size(); ++v) {
      const Rational units = form.coefficients[v] / unit;
      Integer whole = numerator(units) / denominator(units);
      if (whole > units) --whole;  // the quotient is cut towards 0
      form.coefficients[v] = whole * unit;
    }
    return form;
  }

  const MixedProblem& problem_;
  const SparseMatrix columns_;
  std::vector<std::size_t> rows_;   ///< that have a multiplier: the variables
  std::vector<std::size_t> place_;  ///< of each row among them
  AffineForm objective_;
};

}  // namespace

bool shows_no_solution(const std::vector<Rational>& y, const MixedProblem& problem) {
  if (y.size() != problem.size()) return false;
  Rational value = 0;
  for (std::size_t i = 0; i < y.size(); ++i) value += y[i] * to_rational(problem.c[i]);
  if (value.sign() >= 0) return false;
  const std::vector<Rational> g = combined_rows(problem.A, y);
  for (std::size_t i = 0; i < problem.free; ++i) {
    if (!g[i].is_zero()) return false;
  }
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const std::size_t at = problem.normal(k);
    if (y[at].sign() < 0 || g[at].sign() > 0) return false;
    Rational tangential = 0;
    for (std::size_t t = 1; t < problem.dimension; ++t) {
      if (!y[at + t].is_zero()) return false;
      tangential += g[at + t] * g[at + t];
    }
    const Rational mu = to_rational(problem.mu[k]);
    if (mu * mu * tangential > g[at] * g[at]) return false;
  }
  return true;
}

std::optional<std::vector<Rational>> infeasibility(const MixedProblem& problem, Effort& effort) {
  constexpr int few_sides = 8, many_sides = 24;
  try {
    const MultiplierProgram program(problem);
    for (const auto& [sides, length] :
         {std::pair(few_sides, Length::cut), std::pair(many_sides, Length::cut), std::pair(few_sides, Length::full)}) {
      if (problem.dimension < 3 && sides == many_sides) continue;
      auto y = program.solve(sides, length, effort);
      if (y && shows_no_solution(*y, problem)) return y;
    }
  } catch (const TooMuchWork&) {
  }
  return std::nullopt;
}

}  // namespace slipproof
