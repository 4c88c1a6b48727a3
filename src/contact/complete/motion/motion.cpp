#include "contact/complete/motion/motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "contact/complete/motion/equations.hpp"
#include "contact/complete/motion/motion_box.hpp"
#include "contact/complete/solve_near.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;

Rational dot(std::span<const Rational> a, std::span<const Rational> b) {
  Rational sum;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i].is_zero()) sum += a[i] * b[i];
  }
  return sum;
}

class MotionFinder {
 public:
  MotionFinder(const ExactContacts& exact, const FloatingContacts& contacts, const ContactPattern& mode,
               std::vector<bool> touching)
      : exact_(exact),
        contacts_(contacts),
        mode_(mode),
        touching_(std::move(touching)),
        unknowns_(exact, mode, touching_) {}

  MotionCandidate find(const ProposedPoint& start, const std::function<bool(std::span<const double>)>& is_known) {
    std::vector<double> z = unknowns_at(start);
    if (is_linear()) {
      auto motion = find_exactly(z);
      return {false, motion || exact_.dimension < 3 ? std::move(motion) : find_at_border(z)};
    }
    if (!newton(z) || !plausible(z)) return {};
    u_ = velocities_at(z);
    if (is_known(u_)) return {true, std::nullopt};
    auto motion = motion_in_box(exact_, mode_, touching_, z, derivative_);
    return {false, motion ? std::move(motion) : find_at_border(z)};
  }

  /// After find(), which found no motion: the open contacts whose u_N is 0 up to rounding at the zero; empty if there
  /// are none.
  std::vector<bool> touching() const {
    if (u_.empty()) return {};
    std::vector<bool> result(mode_.size(), false);
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      result[k] = mode_[k].kind == Kind::open && std::abs(u_[exact_.normal(k)]) < 1e-9;
    }
    return std::ranges::find(result, true) == result.end() ? std::vector<bool>() : result;
  }

 private:
  bool is_linear() const {
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      if (unknowns_.slips_in_space(k)) return false;
    }
    return true;
  }

  std::vector<double> unknowns_at(const ProposedPoint& point) const {
    std::vector<double> z(unknowns_.count());
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t first = unknowns_.first[k], i = exact_.normal(k);
      for (std::size_t t = 0; t < unknowns_.forces(k); ++t) z[first + t] = point.r[i + t];
      if (!unknowns_.slips_in_space(k)) continue;
      const double speed = std::hypot(point.u[i + 1], point.u[i + 2]);
      double angle = std::atan2(-point.r[i + 2], -point.r[i + 1]);
      if (speed > 1e-6) angle = std::atan2(point.u[i + 2], point.u[i + 1]);
      const double friction = contacts_.mu[k] * std::max(point.r[i], 1e-9);
      z[first + 1] = -friction * std::cos(angle);
      z[first + 2] = -friction * std::sin(angle);
      z[first + 3] = speed / friction;
    }
    return z;
  }

  std::vector<double> velocities_at(std::span<const double> z) const {
    std::vector<double> u = contacts_.q;
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      for (std::size_t t = 0; t < unknowns_.forces(k); ++t) {
        const std::size_t j = exact_.normal(k) + t;
        for (std::size_t i = 0; i < u.size(); ++i) u[i] += contacts_.W[i][j] * z[unknowns_.first[k] + t];
      }
    }
    return u;
  }

  /// To a zero of the mode's equations; of dependent ones to the nearest.
  bool newton(std::vector<double>& z) {
    const auto equations = mode_equations<double>(contacts_, exact_, mode_, unknowns_);
    const auto n = static_cast<Eigen::Index>(z.size());
    std::vector<Eigen::Index> held;  // forces of contacts that touch
    for (std::size_t k = 0; k < touching_.size(); ++k) {
      if (touching_[k]) held.push_back(static_cast<Eigen::Index>(unknowns_.first[k])), z[unknowns_.first[k]] = 0;
    }
    Eigen::MatrixXd J(n, n);
    Eigen::VectorXd F(n);
    double last = 1;  // the step before, relative to the unknowns
    for (int step = 0, settled = 0; step < 40; ++step) {
      for (Eigen::Index i = 0; i < n; ++i) {
        const auto& equation = equations[static_cast<std::size_t>(i)];
        F[i] = value_at(equation, z);
        J.row(i) = Eigen::Map<const Eigen::VectorXd>(slope_at(equation, z).data(), n);
      }
      for (const Eigen::Index j : held) J.col(j).setZero();
      const Eigen::VectorXd d = J.completeOrthogonalDecomposition().solve(F);
      if (!d.allFinite()) return false;
      double size = 1e-300;
      for (Eigen::Index j = 0; j < n; ++j) size = std::max(size, std::abs(z[static_cast<std::size_t>(j)] -= d[j]));
      if (size > 1e9) return false;
      const double change = d.lpNorm<Eigen::Infinity>() / size;
      const bool is_rounding = change <= 1e-14 || (change <= 1e-11 && change > last / 2);
      last = change;
      if (is_rounding && ++settled == 2) {  // once more, for the small unknowns
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
      if (unknowns_.slips_in_space(k) && z[unknowns_.first[k] + 3] < -slack) return false;
    }
    return true;
  }

  /// Where the mode's equations are linear.
  std::optional<SpatialMotion> find_exactly(const std::vector<double>& near) const {
    RationalMatrix rows;
    for (const auto& equation : mode_equations<Rational>(exact_, exact_, mode_, unknowns_)) {
      std::vector<Rational>& row = rows.emplace_back(unknowns_.count() + 1);
      for (const auto& [j, a] : equation.linear) row[j] += a;
      row.back() = -equation.constant;
    }
    const auto z = solve_near(rows, near, 20);
    if (!z) return std::nullopt;
    SpatialMotion motion = motion_at(exact_, mode_, touching_, z->x);
    if (!satisfies_law(exact_, motion.r, motion.u)) return std::nullopt;
    motion.open_directions = z->open_directions;
    return motion;
  }

  /// Directions that forces may have, and along which velocities are 0: W r + q = 0 along `rows`, for r in `columns`.
  struct LinearMode {
    RationalMatrix columns, rows;
    std::vector<double> near;  ///< about the forces

    std::vector<std::size_t> loaded() const {
      constexpr double none = 1e-9;
      std::vector<std::size_t> result;
      for (std::size_t c = 0; c < near.size(); ++c) {
        if (std::abs(near[c]) > none) result.push_back(c);
      }
      return result;
    }
  };

  /// Nothing where a contact slips in a direction that is not short.
  std::optional<LinearMode> linear_mode(const std::vector<double>& z) const {
    LinearMode result;
    const auto placed = [&](std::size_t k, std::vector<Rational> part) {
      std::vector<Rational> own(exact_.size());
      std::ranges::move(part, own.begin() + static_cast<std::ptrdiff_t>(exact_.normal(k)));
      return own;
    };
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      if (mode_[k].kind == Kind::open) continue;
      const std::size_t first = unknowns_.first[k];
      for (std::size_t t = 0; t < unknowns_.forces(k) && !unknowns_.slips_in_space(k); ++t) {
        std::vector<Rational> part(exact_.dimension);
        part[t] = 1;
        result.columns.push_back(placed(k, part));
        result.rows.push_back(placed(k, part));
        result.near.push_back(z[first + t]);
      }
      if (!unknowns_.slips_in_space(k)) continue;
      const auto d = Direction::short_at(std::atan2(-z[first + 2], -z[first + 1]));
      if (!d) return std::nullopt;
      const Rational x(d->x, d->length), y(d->y, d->length), &mu = exact_.mu[k];
      result.columns.push_back(placed(k, {1, -mu * x, -mu * y}));
      result.rows.push_back(placed(k, {1, 0, 0}));
      result.rows.push_back(placed(k, {0, -y, x}));
      result.near.push_back(z[first]);
    }
    return result;
  }

  /// In space, at a border of a mode: where some contacts bear nothing no box is inside of its conditions. These have
  /// no force here; and if all slips have short directions, forces along them satisfy linear equations.
  std::optional<SpatialMotion> find_at_border(const std::vector<double>& z) const {
    const auto mode = linear_mode(z);
    if (!mode) return std::nullopt;
    RationalMatrix along, all(mode->rows.size()), system(mode->rows.size());
    for (const std::vector<Rational>& column : mode->columns) along.push_back(velocity_changes(exact_, column));
    const std::vector<std::size_t> loaded = mode->loaded();
    for (std::size_t e = 0; e < mode->rows.size(); ++e) {
      for (const std::vector<Rational>& u : along) all[e].push_back(dot(mode->rows[e], u));
      for (const std::size_t c : loaded) system[e].push_back(all[e][c]);
      system[e].push_back(-dot(mode->rows[e], exact_.q));
    }
    std::vector<double> near;
    for (const std::size_t c : loaded) near.push_back(mode->near[c]);
    const auto solution = solve_near(system, near, 36);
    if (!solution) return std::nullopt;
    std::vector<Rational> r(exact_.size());
    for (std::size_t c = 0; c < loaded.size(); ++c) {
      for (std::size_t i = 0; i < r.size(); ++i) r[i] += mode->columns[loaded[c]][i] * solution->x[c];
    }
    auto motion = exact_motion(exact_, mode_, std::move(r));
    if (motion && !along.empty()) motion->open_directions = along.size() - eliminate(all).rank();
    return motion;
  }

  const ExactContacts& exact_;
  const FloatingContacts& contacts_;
  const ContactPattern& mode_;
  const std::vector<bool> touching_;
  const ModeUnknowns unknowns_;
  std::vector<double> u_;  ///< at the zero
  Eigen::MatrixXd derivative_;
};

}  // namespace

ModeUnknowns::ModeUnknowns(const ExactContacts& contacts, const ContactPattern& mode, const std::vector<bool>& touching)
    : first{0} {
  for (std::size_t k = 0; k < mode.size(); ++k) {
    const bool touches = !touching.empty() && touching[k];
    std::size_t own = contacts.has_friction(k) && !touches ? contacts.dimension : 1;
    if (mode[k].kind == Kind::open && !touches) own = 0;
    if (mode[k].kind == Kind::slip && own == 3) own = 4;
    first.push_back(first.back() + own);
  }
}

bool SpatialMotion::differs(const SpatialMotion& other) const {
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (abs(u[i] - other.u[i]) > u_radius[i] + other.u_radius[i]) return true;
  }
  return false;
}

std::vector<Rational> velocity_changes(const ExactContacts& contacts, std::span<const Rational> r) {
  std::vector<Rational> result;
  for (const auto& row : contacts.W) result.push_back(dot(r, row));
  return result;
}

std::vector<Rational> velocities(const ExactContacts& contacts, std::span<const Rational> r) {
  std::vector<Rational> u = velocity_changes(contacts, r);
  for (std::size_t i = 0; i < u.size(); ++i) u[i] += contacts.q[i];
  return u;
}

std::size_t open_directions(const ExactContacts& contacts, const std::vector<bool>& pressed) {
  RationalMatrix columns;
  for (std::size_t k = 0; k < pressed.size(); ++k) {
    const std::size_t own = !pressed[k] ? 0 : contacts.has_friction(k) ? contacts.dimension : 1;
    for (std::size_t t = 0; t < own; ++t) {
      std::vector<Rational>& column = columns.emplace_back();
      for (const auto& row : contacts.W) column.push_back(row[contacts.normal(k) + t]);
    }
  }
  return columns.empty() ? 0 : columns.size() - eliminate(columns).rank();
}

std::optional<SpatialMotion> exact_motion(const ExactContacts& contacts, const ContactPattern& mode,
                                          std::vector<Rational> r) {
  SpatialMotion motion;
  motion.mode = mode;
  motion.u = velocities(contacts, r);
  if (!satisfies_law(contacts, r, motion.u)) return std::nullopt;
  motion.r = std::move(r);
  motion.r_radius.resize(contacts.size()), motion.u_radius.resize(contacts.size());
  return motion;
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

MotionCandidate find_motion(const ExactContacts& exact, const FloatingContacts& contacts, const ContactPattern& mode,
                            const ProposedPoint& start,
                            const std::function<bool(std::span<const double> u)>& is_known) {
  MotionFinder finder(exact, contacts, mode, {});
  MotionCandidate found = finder.find(start, is_known);
  if (found.motion || found.is_known) return found;
  std::vector<bool> touching = finder.touching();
  if (touching.empty()) return {};
  return MotionFinder(exact, contacts, mode, std::move(touching)).find(start, is_known);
}

}  // namespace slipproof
