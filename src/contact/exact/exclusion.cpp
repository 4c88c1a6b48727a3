#include "contact/exact/exclusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/number/binary64.hpp"
#include "contact/enclosure/sizes.hpp"
#include "contact/linear/rounding.hpp"

namespace slipproof {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// A quotient of bounds that are each right to a few ulps: 2^-40 pays for all of them.
double rounded_down(double radius) {
  return radius > 0 ? radius * (1 - 0x1p-40) : 0;
}

double double_of(const Rational& x) {
  return nearest_binary64(x);
}

/// The sum of a row's |a_ij|, rounded up.
double slope_of(const MixedProblem& problem, std::size_t row) {
  double sum = 0;
  for (const double a : problem.A.values_of(row)) sum += std::abs(a);
  const std::size_t n = problem.A.values_of(row).size();
  return sum > 0 ? rounded_up(sum, n) + underflow_of(n) : 0;
}

/// Up to which radius does value + slope * radius stay positive?
double while_positive(double value, double slope) {
  if (!(value > 0)) return 0;
  return slope > 0 ? value / slope : unbounded;
}

/// The same of value - slope * radius - square * radius^2; the root of the quadratic without cancellation.
double while_positive(double value, double slope, double square) {
  if (!(value > 0)) return 0;
  if (square == 0) return while_positive(value, slope);
  return 2 * value / (slope + std::sqrt(slope * slope + 4 * square * value));
}

class ContactExclusion {
 public:
  ContactExclusion(const MixedProblem& problem, std::span<const double> x, std::span<const Rational> w, std::size_t k)
      : d_(problem.dimension), mu_(problem.mu[k]) {
    for (std::size_t i = 0; i < d_; ++i) {
      const std::size_t row = problem.normal(k) + i;
      r_[i] = to_rational(x[row]);
      u_[i] = w[row];
      slope_[i] = slope_of(problem, row);
    }
  }

  /// 0 as soon as it is known not to exceed `needed`.
  double radius(double needed) const {
    double result = rounded_down(open());
    if (result > needed) result = std::min(result, rounded_down(d_ == 1 || mu_ == 0 ? frictionless() : stick()));
    if (result > needed && d_ > 1 && mu_ != 0) result = std::min(result, rounded_down(slide()));
    return result > needed ? result : 0;
  }

 private:
  double size(const Rational& x) const { return double_of(abs(x)); }
  /// u_i = 0 fails.
  double moves(std::size_t i) const { return while_positive(size(u_[i]), slope_[i]); }
  double pulls() const { return while_positive(double_of(-r_[0]), 1); }
  double some_force(std::size_t from) const {
    double result = 0;
    for (std::size_t i = from; i < d_; ++i) result = std::max(result, size(r_[i]));
    return result;
  }

  double open() const { return std::max(some_force(0), while_positive(double_of(-u_[0]), slope_[0])); }
  double frictionless() const { return std::max({pulls(), moves(0), some_force(1)}); }

  /// |r_t| - mu r_n, from the difference of the squares; the box moves it by (sqrt(2) + mu) times the radius at most.
  double beyond_cone(int sign) const {
    Rational squares = -to_rational(mu_) * to_rational(mu_) * r_[0] * r_[0];
    double length = 0;
    for (std::size_t i = 1; i < d_; ++i) {
      squares += r_[i] * r_[i];
      length = std::hypot(length, double_of(r_[i]));
    }
    const double sum = length + mu_ * size(r_[0]);
    const double difference = sum > 0 ? sign * double_of(squares) / sum : 0;
    return r_[0].sign() < 0 ? 0 : while_positive(difference, std::sqrt(2.0) + mu_);
  }

  double stick() const {
    double result = std::max(pulls(), beyond_cone(1));
    for (std::size_t i = 0; i < d_; ++i) result = std::max(result, moves(i));
    return result;
  }

  double slide() const {
    double result = std::max({pulls(), moves(0), beyond_cone(1), beyond_cone(-1)});
    Rational dot = 0;
    double slope = 0, square = 0;
    for (std::size_t i = 1; i < d_; ++i) {
      dot += r_[i] * u_[i];
      slope += size(u_[i]) + slope_[i] * size(r_[i]);
      square += slope_[i];
    }
    result = std::max(result, while_positive(double_of(dot), slope, square));
    if (d_ == 3) {
      const Rational cross = abs(r_[1] * u_[2] - r_[2] * u_[1]);
      const double turn = size(u_[1]) + size(u_[2]) + slope_[2] * size(r_[1]) + slope_[1] * size(r_[2]);
      result = std::max(result, while_positive(double_of(cross), turn, slope_[1] + slope_[2]));
    }
    return result;
  }

  std::size_t d_;
  double mu_;
  std::array<Rational, 3> r_, u_;
  std::array<double, 3> slope_{};
};

}  // namespace

Exclusion exclusion(const MixedProblem& problem, std::span<const double> x, std::span<const Rational> w) {
  Exclusion best;
  const auto consider = [&best](double radius, std::optional<std::size_t> contact, std::size_t row) {
    if (!(radius > best.radius)) return;
    best = {std::min(radius, std::numeric_limits<double>::max()), contact, row};
  };
  for (std::size_t k = 0; k < problem.contacts(); ++k)
    consider(ContactExclusion(problem, x, w, k).radius(best.radius), k, 0);
  for (std::size_t i = 0; i < problem.free; ++i) {
    const double value = nearest_binary64(abs(w[i]));
    consider(rounded_down(while_positive(value, slope_of(problem, i))), std::nullopt, i);
  }
  return best;
}

double relative_exclusion(const MixedProblem& problem, std::span<const double> x, std::span<const Rational> w) {
  double force = 0;
  for (std::size_t i = problem.free; i < x.size(); ++i) force = std::max(force, std::abs(x[i]));
  if (force == 0) return 0;
  std::vector<double> size = free_sizes(problem, force).unknowns, scaled(x.begin(), x.end());
  size.resize(x.size(), force);
  MixedProblem own = problem;
  for (std::size_t e = 0; e < own.A.value.size(); ++e) own.A.value[e] *= size[own.A.column[e]];
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] /= size[i] > 0 ? size[i] : 1;
  return exclusion(own, scaled, w).radius;
}

}  // namespace slipproof
