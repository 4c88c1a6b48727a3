#include "contact/complete/motion/motion_box.hpp"

#include <algorithm>

#include "base/number/binary64.hpp"
#include "contact/complete/motion/mode_square.hpp"
#include "contact/complete/solve_near.hpp"

namespace slipproof {

namespace {

using Vector = std::vector<Rational>;
constexpr int center_bits = 90;

/// A power of 2 that is at least x.
Rational power_above(const Rational& x) {
  if (x.sign() <= 0) return power_of_two(-2 * center_bits);
  return power_of_two(static_cast<long>(numerator(x).bits()) - static_cast<long>(denominator(x).bits()) + 1);
}

/// R f, of the entries of f in these places.
Vector product(const RationalMatrix& R, const Vector& f, const std::vector<std::size_t>& places) {
  Vector result(R.size());
  for (std::size_t j = 0; j < R.size(); ++j) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!f[places[i]].is_zero()) result[j] += R[j][i] * f[places[i]];
    }
  }
  return result;
}

/// Krawczyk's test: F are the mode's equations, z the center, R an approximate inverse of their derivative J.
class BoxTest {
 public:
  BoxTest(const ModeSquare& square, const std::vector<double>& zero)
      : square_(square), equations_(square.equations), left_(square.left), kept_(square.kept) {
    for (const double x : zero) center_.push_back(nearest_multiple(x, center_bits));
    for (std::size_t j = 0; j < center_.size(); ++j) {
      if (square.is_touching(j)) center_[j] = 0;
    }
    for (int i = 0; i < 4; ++i) {
      const Vector step = shift();
      for (std::size_t j = 0; j < left_.size(); ++j) {
        center_[left_[j]] = rounded_down(center_[left_[j]] - step[j], center_bits);
      }
    }
    defect_ = defect();
  }

  std::optional<SpatialMotion> motion() const {
    const Vector step = shift();
    Vector p = least_box(step);
    const Vector shape = square_.dropped.empty() ? neighbourhood() : Vector();
    Integer alone = 0;
    if (!shape.empty()) {
      alone = times_within(p, shape);
      for (std::size_t j = 0; alone > 0 && j < p.size(); ++j) p[j] = shape[j] / Rational(alone);
    }
    const Vector spread = spread_of(p), bend = bent(p);
    for (std::size_t j = 0; j < left_.size(); ++j) {
      if (abs(step[j]) + spread[j] + bend[j] > p[left_[j]] || spread[j] >= p[left_[j]]) return std::nullopt;
    }
    SpatialMotion motion = motion_at(square_.contacts, square_.mode, square_.touching, center_, p);
    if (!conditions_hold(motion)) return std::nullopt;
    motion.alone = alone;
    motion.inverse = square_.inverse;
    motion.dropped = square_.dropped;
    std::vector<bool> is_left(center_.size(), false);
    for (const std::size_t j : left_) is_left[j] = true;
    motion.pinned = all_but(is_left.size(), is_left);
    for (const std::size_t j : motion.pinned) motion.open_directions += square_.is_touching(j) ? 0 : 1;
    return motion;
  }

 private:
  /// R F(z).
  Vector shift() const {
    Vector f;
    for (const auto& equation : equations_) f.push_back(value_at(equation, center_));
    return product(square_.inverse, f, kept_);
  }

  /// |I - R J| by entries.
  RationalMatrix defect() const {
    const std::size_t n = left_.size();
    RationalMatrix result(n, Vector(n));
    for (std::size_t i = 0; i < n; ++i) {
      const Vector slope = slope_at(equations_[kept_[i]], center_);
      for (std::size_t j = 0; j < n; ++j) {
        if (square_.inverse[j][i].is_zero()) continue;
        for (std::size_t k = 0; k < n; ++k) {
          if (!slope[left_[k]].is_zero()) result[j][k] -= square_.inverse[j][i] * slope[left_[k]];
        }
      }
    }
    for (std::size_t j = 0; j < n; ++j) result[j][j] += 1;
    for (auto& row : result) {
      for (Rational& x : row) x = abs(x);
    }
    return result;
  }

  Vector spread_of(const Vector& p) const { return product(defect_, p, left_); }

  /// |R| q for the products of unknowns within p of the center.
  Vector bent(const Vector& p) const {
    Vector result(left_.size());
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const Rational q = bend_within(equations_[kept_[i]], p);
      for (std::size_t j = 0; j < left_.size() && !q.is_zero(); ++j) result[j] += abs(square_.inverse[j][i]) * q;
    }
    return result;
  }

  /// Four times the step, each at least 2^-20 of the largest.
  Vector least_box(const Vector& step) const {
    Vector p(center_.size());
    Rational largest = power_of_two(-2 * center_bits);
    for (std::size_t j = 0; j < left_.size(); ++j) {
      p[left_[j]] = power_above(abs(step[j]) * 4);
      largest = std::max(largest, p[left_[j]]);
    }
    for (const std::size_t j : left_) p[j] = std::max(p[j], Rational(largest * power_of_two(-20)));
    return p;
  }

  /// How many times the least box goes into a neighbourhood, a power of 2; 0 if not once.
  Integer times_within(const Vector& least, const Vector& shape) const {
    Rational times = power_of_two(40);
    for (const std::size_t j : left_) times = std::min(times, Rational(shape[j] / least[j]));
    return times < 1 ? Integer(0) : numerator(times);
  }

  /// The conditions that are not equations, everywhere in the box.
  bool conditions_hold(const SpatialMotion& motion) const {
    const ExactContacts& contacts = square_.contacts;
    for (std::size_t k = 0; k < square_.mode.size(); ++k) {
      const std::size_t i = contacts.normal(k), slip = square_.unknowns.first[k] + 3;
      if (!square_.touching.empty() && square_.touching[k]) continue;
      if (square_.mode[k].kind == ContactState::Kind::open) {
        if (motion.u[i] < motion.u_radius[i]) return false;
        continue;
      }
      if (motion.r[i] < motion.r_radius[i]) return false;
      if (square_.unknowns.slips_in_space(k)) {
        if (motion.center[slip] < motion.radius[slip]) return false;
      } else if (square_.mode[k].kind == ContactState::Kind::slip) {
        const Rational u = square_.mode[k].from.x.sign() > 0 ? motion.u[i + 1] : Rational(-motion.u[i + 1]);
        if (u < motion.u_radius[i + 1]) return false;
      } else if (!is_in_cone(motion, k)) {
        return false;
      }
    }
    return true;
  }

  bool is_in_cone(const SpatialMotion& motion, std::size_t k) const {
    const ExactContacts& contacts = square_.contacts;
    const std::size_t i = contacts.normal(k);
    Rational force;
    for (std::size_t t = 1; t < contacts.dimension; ++t) {
      const Rational most = abs(motion.r[i + t]) + motion.r_radius[i + t];
      force += most * most;
    }
    const Rational limit = contacts.mu[k] * (motion.r[i] - motion.r_radius[i]);
    return force <= limit * limit;
  }

  /// In which the equations have no other zero: |I - R J| P + 4 |R| q(P) < P. Empty where none was found.
  Vector neighbourhood() const {
    Vector v, best;
    for (const double size : square_.sizes) v.push_back(to_rational(size));
    Rational width;
    // Forces and slips bend the equations together: the box that |R| q makes of one is often better than the first.
    for (int shape = 0; shape < 3; ++shape) {
      const Vector next = bent(v);
      const Vector alone = alone_within(v, next);
      if (!alone.empty()) {
        const Rational least = *std::min_element(alone.begin(), alone.end());
        if (least > width) width = least, best = alone;
      }
      const Rational largest = *std::max_element(next.begin(), next.end());
      if (largest.is_zero()) break;
      const Rational unit = *std::max_element(v.begin(), v.end()) / power_above(largest);
      for (std::size_t j = 0; j < v.size(); ++j) v[j] = power_above((v[j] + unit * next[j]) / 2);
    }
    return best;
  }

  /// The largest share of v, a power of 2, within which the test holds.
  Vector alone_within(const Vector& v, const Vector& bend) const {
    const Vector spread = spread_of(v);
    for (int exponent = 4; exponent > -60; --exponent) {
      const Rational share = power_of_two(exponent);
      bool alone = true;
      for (std::size_t j = 0; j < v.size() && alone; ++j) alone = spread[j] + 4 * share * bend[j] < v[j];
      if (!alone) continue;
      Vector result = v;
      for (Rational& x : result) x *= share;
      return result;
    }
    return {};
  }

  const ModeSquare& square_;
  const std::vector<ModeEquation<Rational>>& equations_;
  const std::vector<std::size_t>&left_, &kept_;
  Vector center_;
  RationalMatrix defect_;
};

}  // namespace

SpatialMotion motion_at(const ExactContacts& contacts, const ContactPattern& mode, const std::vector<bool>& touching,
                        const std::vector<Rational>& point, const std::vector<Rational>& radius) {
  SpatialMotion motion;
  motion.mode = mode;
  motion.touching = touching;
  motion.center = point;
  motion.radius = radius;
  const std::size_t n = contacts.size();
  const ModeUnknowns unknowns(contacts, mode, touching);
  motion.r.resize(n), motion.r_radius.resize(n), motion.u_radius.resize(n);
  for (std::size_t k = 0; k < mode.size(); ++k) {
    for (std::size_t t = 0; t < unknowns.forces(k); ++t) {
      motion.r[contacts.normal(k) + t] = point[unknowns.first[k] + t];
      if (!radius.empty()) motion.r_radius[contacts.normal(k) + t] = radius[unknowns.first[k] + t];
    }
  }
  motion.u = velocities(contacts, motion.r);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (!motion.r_radius[j].is_zero()) motion.u_radius[i] += abs(contacts.W[i][j]) * motion.r_radius[j];
    }
  }
  return motion;
}

std::optional<SpatialMotion> motion_in_box(const ExactContacts& contacts, const ContactPattern& mode,
                                           const std::vector<bool>& touching, const std::vector<double>& zero,
                                           const Eigen::MatrixXd& derivative) {
  ModeSquare square(contacts, mode, touching);
  if (!square.pin(derivative, zero)) return std::nullopt;
  return BoxTest(square, zero).motion();
}

}  // namespace slipproof
