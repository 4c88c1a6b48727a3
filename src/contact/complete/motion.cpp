#include "contact/complete/motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "contact/complete/equations.hpp"
#include "contact/complete/motion_box.hpp"
#include "contact/complete/solve_near.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;

class MotionFinder {
 public:
  MotionFinder(const ExactContacts& exact, const FloatingContacts& contacts, const ContactPattern& mode)
      : exact_(exact), contacts_(contacts), mode_(mode), unknowns_(exact, mode) {}

  std::optional<SpatialMotion> find(const ProposedPoint& start) {
    if (is_linear()) return find_exactly(start);
    std::vector<double> z = unknowns_at(start);
    if (!newton(z) || !plausible(z)) return std::nullopt;
    return motion_in_box(exact_, mode_, z, derivative_);
  }

 private:
  bool is_linear() const {
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      if (slips_in_space(exact_, mode_, k)) return false;
    }
    return true;
  }

  std::vector<double> unknowns_at(const ProposedPoint& point) const {
    std::vector<double> z(unknowns_.count());
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t first = unknowns_.first[k], i = exact_.normal(k);
      if (!slips_in_space(exact_, mode_, k)) {
        for (std::size_t t = 0; t < unknowns_.of(k); ++t) z[first + t] = point.r[i + t];
        continue;
      }
      const double speed = std::hypot(point.u[i + 1], point.u[i + 2]);
      double angle = std::atan2(-point.r[i + 2], -point.r[i + 1]);
      if (speed > 1e-6) angle = std::atan2(point.u[i + 2], point.u[i + 1]);
      z[first] = point.r[i];
      z[first + 1] = std::cos(angle);
      z[first + 2] = std::sin(angle);
      z[first + 3] = speed;
    }
    return z;
  }

  /// To a zero of the mode's equations; of dependent ones to the nearest.
  bool newton(std::vector<double>& z) {
    const auto equations = mode_equations<double>(contacts_, exact_, mode_, unknowns_);
    const auto n = static_cast<Eigen::Index>(z.size());
    Eigen::MatrixXd J(n, n);
    Eigen::VectorXd F(n);
    for (int step = 0; step < 40; ++step) {
      for (Eigen::Index i = 0; i < n; ++i) {
        const auto& equation = equations[static_cast<std::size_t>(i)];
        F[i] = value_at(equation, z);
        J.row(i) = Eigen::Map<const Eigen::VectorXd>(slope_at(equation, z).data(), n);
      }
      const Eigen::VectorXd d = J.completeOrthogonalDecomposition().solve(F);
      if (!d.allFinite()) return false;
      double size = 0;
      for (Eigen::Index j = 0; j < n; ++j) size = std::max(size, std::abs(z[static_cast<std::size_t>(j)] -= d[j]));
      if (size > 1e9) return false;
      if (d.lpNorm<Eigen::Infinity>() <= 1e-14 * size) {
        derivative_ = J;
        return F.lpNorm<Eigen::Infinity>() < 1e-10 * std::max(size, 1.0);
      }
    }
    return false;
  }

  /// Whether the conditions that are not equations hold, roughly.
  bool plausible(const std::vector<double>& z) const {
    constexpr double slack = 1e-9;
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      if (mode_[k].kind == Kind::open) continue;
      if (z[unknowns_.first[k]] < -slack) return false;
      if (slips_in_space(exact_, mode_, k) && z[unknowns_.first[k] + 3] < -slack) return false;
    }
    return true;
  }

  /// Where the mode's equations are linear.
  std::optional<SpatialMotion> find_exactly(const ProposedPoint& start) const {
    RationalMatrix rows;
    for (const auto& equation : mode_equations<Rational>(exact_, exact_, mode_, unknowns_)) {
      std::vector<Rational>& row = rows.emplace_back(unknowns_.count() + 1);
      for (const auto& [j, a] : equation.linear) row[j] += a;
      row.back() = -equation.constant;
    }
    const auto z = solve_near(rows, unknowns_at(start), 20);
    if (!z) return std::nullopt;
    SpatialMotion motion = motion_at(exact_, mode_, unknowns_, z->x);
    if (!satisfies_law(exact_, motion.r, motion.u)) return std::nullopt;
    motion.open_directions = z->open_directions;
    return motion;
  }

  const ExactContacts& exact_;
  const FloatingContacts& contacts_;
  const ContactPattern& mode_;
  const ModeUnknowns unknowns_;
  Eigen::MatrixXd derivative_;
};

}  // namespace

ModeUnknowns::ModeUnknowns(const ExactContacts& contacts, const ContactPattern& mode) : first{0} {
  for (std::size_t k = 0; k < mode.size(); ++k) {
    const bool slips = mode[k].kind == Kind::slip, space = contacts.dimension == 3;
    const std::size_t own = mode[k].kind == Kind::open                       ? 0
                            : !contacts.has_friction(k) || (slips && !space) ? 1
                            : slips                                          ? 4
                                                                             : contacts.dimension;
    first.push_back(first.back() + own);
  }
}

std::vector<Rational> velocities(const ExactContacts& contacts, std::span<const Rational> r) {
  std::vector<Rational> u = contacts.q;
  for (std::size_t i = 0; i < u.size(); ++i) {
    for (std::size_t j = 0; j < r.size(); ++j) {
      if (!r[j].is_zero()) u[i] += contacts.W[i][j] * r[j];
    }
  }
  return u;
}

bool satisfies_law(const ExactContacts& contacts, std::span<const Rational> r, std::span<const Rational> u) {
  for (std::size_t k = 0; k < contacts.contacts(); ++k) {
    const std::size_t i = contacts.normal(k);
    if (r[i].sign() < 0 || u[i].sign() < 0 || !(r[i] * u[i]).is_zero()) return false;
    Rational force, velocity, power;
    for (std::size_t t = 1; t < contacts.dimension; ++t) {
      force += r[i + t] * r[i + t];
      velocity += u[i + t] * u[i + t];
      power += r[i + t] * u[i + t];
    }
    const Rational limit = contacts.mu[k] * r[i] * contacts.mu[k] * r[i];
    if (force > limit) return false;
    if (velocity.is_zero() || limit.is_zero()) continue;
    if (force != limit || power.sign() > 0) return false;
    if (contacts.dimension == 3 && r[i + 1] * u[i + 2] != r[i + 2] * u[i + 1]) return false;
  }
  return true;
}

std::optional<SpatialMotion> find_motion(const ExactContacts& exact, const FloatingContacts& contacts,
                                         const ContactPattern& mode, const ProposedPoint& start) {
  return MotionFinder(exact, contacts, mode).find(start);
}

}  // namespace slipproof