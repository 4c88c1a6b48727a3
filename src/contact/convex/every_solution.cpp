#include "contact/convex/every_solution.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/enclosure/sizes.hpp"

namespace slipproof {

namespace {

/// A few operations on nonnegative numbers, rounded up, also where they underflow; 0 only where `zero` says that the
/// result is.
double raised(double x, bool zero) {
  return zero ? 0 : x * (1 + 0x1p-45) + 0x1p-1060;
}

/// What a contact lacks to be complementary: r . u, and for what bounds its friction sum b |u_t|.
Rational gap_of(const MixedProblem& problem, std::size_t k, const std::vector<Rational>& r,
                const std::vector<Rational>& u) {
  Rational gap = 0;
  const std::size_t first = problem.normal(k), d = problem.dimension;
  for (std::size_t i = 0; i < d; ++i) {
    gap += r[first + i] * u[first + i];
    if (i > 0 && problem.law.kind == FrictionLaw::fixed) {
      gap += to_rational(problem.law.bounds[(d - 1) * k + i - 1]) * abs(u[first + i]);
    }
  }
  return gap;
}

/// Whether u has a finite support on the forces of a contact: it is in the cone's dual.
bool is_dual(const MixedProblem& problem, std::size_t k, const std::vector<Rational>& u) {
  const std::size_t first = problem.normal(k);
  if (u[first].sign() < 0) return false;
  if (problem.law.kind != FrictionLaw::associated) return true;
  Rational square = 0;
  for (std::size_t i = 1; i < problem.dimension; ++i) square += u[first + i] * u[first + i];
  const Rational mu = to_rational(problem.mu[k]);
  return mu * mu * square <= u[first] * u[first];
}

/// What an answer is fitted to, and the bounds that follow.
class Bound {
 public:
  Bound(const MixedProblem& problem, std::span<const double> answer, MonotoneProof proof)
      : problem_(problem), x_(answer.begin(), answer.end()) {
    result_.proof = std::move(proof);
  }

  std::optional<EverySolution> around(std::span<const double> start) {
    fit(start);
    if (!settle_rest()) return std::nullopt;
    if (!measure()) return std::nullopt;
    spread_out();
    return std::move(result_);
  }

 private:
  const Rational& modulus(std::size_t i) const { return result_.proof.moduli[i]; }

  void fit(std::span<const double> start) {
    const Residual r = residual(problem_, start, exact_rows(problem_, start));
    for (std::size_t i = 0; i < problem_.free; ++i) result_.point.push_back(to_rational(start[i]));
    result_.motion.assign(problem_.free, Rational(0));
    for (const FittedContact& c : r.contacts) {
      result_.point.insert(result_.point.end(), c.r.begin(), c.r.end());
      result_.motion.insert(result_.motion.end(), c.u.begin(), c.u.end());
    }
  }

  /// Velocities of contacts with d = 0 have to be those of the point. Where they leave the dual cone, a push along
  /// which all contacts open brings them back.
  bool settle_rest() {
    std::vector<std::size_t> loose;
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      for (std::size_t i = 0; i < problem_.dimension; ++i) {
        if (modulus(problem_.normal(k) + i).sign() > 0) continue;
        loose.push_back(k);
        break;
      }
    }
    for (std::size_t i = 0; i < problem_.free; ++i) {
      if (modulus(i).sign() == 0 && !exact_row(problem_, i, result_.point).is_zero()) return false;
    }
    if (loose.empty()) return true;
    const std::vector<double> push = opening_push(loose);
    const double size = size_of_free(push);
    for (double part = 0; part < 0x1p-10; part = part == 0 ? 0x1p-60 : 4 * part) {
      const double much = part * size;
      std::vector<Rational> moved = result_.point;
      for (std::size_t j = 0; part > 0 && j < problem_.free; ++j) {
        if (modulus(j).sign() > 0) moved[j] = to_rational(nearest_binary64(moved[j] + to_rational(much * push[j])));
      }
      if (take_velocities(loose, moved)) {
        result_.point = std::move(moved);
        return true;
      }
      if (push.empty()) return false;
    }
    return false;
  }

  double size_of_free(const std::vector<double>& push) const {
    double size = 0, along = 0;
    for (std::size_t j = 0; j < problem_.free; ++j) {
      size = std::max(size, std::abs(x_[j]));
      along = std::max(along, push.empty() ? 0 : std::abs(push[j]));
    }
    return along > 0 && size > 0 ? size / along : 1;
  }

  bool take_velocities(const std::vector<std::size_t>& loose, const std::vector<Rational>& point) {
    for (const std::size_t k : loose) {
      for (std::size_t i = 0; i < problem_.dimension; ++i) {
        const std::size_t row = problem_.normal(k) + i;
        result_.motion[row] = exact_row(problem_, row, point);
      }
      if (!is_dual(problem_, k, result_.motion)) return false;
    }
    return true;
  }

  /// Free unknowns whose change moves all these contacts along their normals, in the least squares; empty if none does.
  std::vector<double> opening_push(const std::vector<std::size_t>& loose) const {
    if (problem_.free == 0 || problem_.free > 3000 || loose.size() > 3000) return {};
    const auto rows = static_cast<Eigen::Index>(loose.size() * problem_.dimension);
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(problem_.free));
    Eigen::VectorXd open = Eigen::VectorXd::Zero(rows);
    for (std::size_t k = 0; k < loose.size(); ++k) {
      for (std::size_t i = 0; i < problem_.dimension; ++i) {
        const std::size_t row = problem_.normal(loose[k]) + i;
        const auto at = static_cast<Eigen::Index>(k * problem_.dimension + i);
        open[at] = i == 0 ? 1 : 0;
        for (std::size_t e = problem_.A.starts[row]; e < problem_.A.starts[row + 1]; ++e) {
          if (problem_.A.column[e] < problem_.free) {
            H(at, static_cast<Eigen::Index>(problem_.A.column[e])) = problem_.A.value[e];
          }
        }
      }
    }
    const Eigen::VectorXd push = H.completeOrthogonalDecomposition().solve(open);
    if (!push.allFinite()) return {};
    return {push.data(), push.data() + push.size()};
  }

  /// Shares, gaps and the energy. Where a row has d = 0, nothing may be left.
  bool measure() {
    double squares = 0, gaps = 0;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      result_.velocity.push_back(exact_row(problem_, i, result_.point));
      const Rational rest = result_.velocity[i] - result_.motion[i];
      double share = 0;
      if (modulus(i).sign() > 0) {
        share = raised(upper_size(rest) / std::sqrt(enclose(modulus(i)).lower), rest.is_zero());
      } else if (!rest.is_zero()) {
        return false;
      }
      result_.shares.push_back(share);
      squares += raised(share * share, share == 0);
    }
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      const Rational gap = gap_of(problem_, k, result_.point, result_.motion);
      result_.gaps.push_back(raised(upper_size(gap), gap.sign() <= 0));
      gaps += result_.gaps.back();
    }
    squares *= 1 + 0x1p-30;  // far fewer than 2^20 sums
    gaps *= 1 + 0x1p-30;
    result_.energy = (std::sqrt(squares) + std::sqrt(squares + 4 * gaps)) / 2 * (1 + 0x1p-40);
    return std::isfinite(result_.energy);
  }

  static double distance(const Rational& away, double radius) {
    return raised(upper_size(away) + radius, away.is_zero() && radius == 0);
  }

  void spread_out() {
    const double energy = result_.energy;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const bool bounded = modulus(i).sign() > 0;
      result_.radius.push_back(bounded ? raised(energy / std::sqrt(enclose(modulus(i)).lower), energy == 0)
                                       : std::numeric_limits<double>::infinity());
      if (bounded) {
        const Rational away = result_.point[i] - to_rational(x_[i]);
        result_.rho = std::max(result_.rho, distance(away, result_.radius[i]));
        result_.apart = std::max(result_.apart, (enclose(abs(away)).lower - result_.radius[i]) * (1 - 0x1p-50));
      } else if (i >= problem_.free) {
        ++result_.open;
      }
    }
    const bool symmetric = problem_.A == transposed(problem_.A);
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      double sum = 0, own = 0;
      for (std::size_t e = problem_.A.starts[i]; e < problem_.A.starts[i + 1]; ++e) {
        const std::size_t j = problem_.A.column[e];
        if (j == i) own = problem_.A.value[e];
        const double size = std::abs(problem_.A.value[e]), radius = result_.radius[j];
        if (size != 0) sum += raised(size * radius, radius == 0);
      }
      sum *= 1 + 0x1p-30;
      if (symmetric) sum = std::min(sum, raised(std::sqrt(own) * energy, energy == 0));
      result_.changes.push_back(sum);
      if (i < problem_.free) continue;
      const Rational away = result_.velocity[i] - exact_row(problem_, i, std::span<const double>(x_));
      result_.eta = std::max(result_.eta, distance(away, sum));
    }
  }

  const MixedProblem& problem_;
  const std::vector<double> x_;
  EverySolution result_;
};

}  // namespace

std::optional<EverySolution> every_solution(const MixedProblem& problem, std::span<const double> start,
                                            std::span<const double> answer, MonotoneProof proof) {
  return Bound(problem, answer, std::move(proof)).around(start);
}

double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                const EverySolution& solution) {
  std::vector<Around> components, velocities;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const bool bounded = std::isfinite(solution.radius[i]);
    components.push_back(bounded ? Around{solution.point[i], solution.radius[i]} : Around{to_rational(x[i]), 0});
    velocities.push_back({solution.velocity[i], solution.changes[i]});
  }
  return error_of(problem, x, u, components, velocities);
}

}  // namespace slipproof
