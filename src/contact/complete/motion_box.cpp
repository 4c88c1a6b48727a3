#include "contact/complete/motion_box.hpp"

#include <algorithm>

#include "contact/complete/equations.hpp"
#include "contact/complete/solve_near.hpp"

namespace slipproof {

namespace {

using Vector = std::vector<Rational>;
constexpr int center_bits = 90, inverse_bits = 34;

/// To a multiple of 2^-bits, downwards.
Rational rounded_down(const Rational& x, int bits) {
  const Rational scaled = x * power_of_two(bits);
  Integer quotient;
  fmpz_fdiv_q(quotient.flint(), numerator(scaled).flint(), denominator(scaled).flint());
  return Rational(quotient) * power_of_two(-bits);
}

/// A power of 2 that is at least x.
Rational power_above(const Rational& x) {
  if (x.sign() <= 0) return power_of_two(-2 * center_bits);
  return power_of_two(static_cast<long>(numerator(x).bits()) - static_cast<long>(denominator(x).bits()) + 1);
}

Vector product(const RationalMatrix& R, const Vector& f) {
  Vector result(f.size());
  for (std::size_t j = 0; j < f.size(); ++j) {
    for (std::size_t i = 0; i < f.size(); ++i) {
      if (!f[i].is_zero()) result[j] += R[j][i] * f[i];
    }
  }
  return result;
}

/// Krawczyk's test: F are the mode's equations, z the center, R an approximate inverse of their derivative J.
class BoxTest {
 public:
  BoxTest(const ExactContacts& contacts, const ContactPattern& mode, const std::vector<double>& zero,
          RationalMatrix inverse)
      : contacts_(contacts),
        mode_(mode),
        unknowns_(contacts, mode),
        equations_(mode_equations<Rational>(contacts, contacts, mode, unknowns_)),
        inverse_(std::move(inverse)) {
    for (const double x : zero) center_.push_back(nearest_multiple(x, center_bits));
    for (int i = 0; i < 4; ++i) {
      const Vector step = shift();
      for (std::size_t j = 0; j < count(); ++j) center_[j] = rounded_down(center_[j] - step[j], center_bits);
    }
    defect_ = defect();
  }

  std::optional<SpatialMotion> motion() const {
    const Vector step = shift();
    Vector p;
    for (const Rational& x : step) p.push_back(power_above(abs(x) * 4));
    const Rational largest = *std::max_element(p.begin(), p.end());
    for (Rational& x : p) x = std::max(x, Rational(largest * power_of_two(-20)));
    const Vector spread = product(defect_, p), bend = bent(p);
    for (std::size_t j = 0; j < count(); ++j) {
      if (abs(step[j]) + spread[j] + bend[j] > p[j] || spread[j] >= p[j]) return std::nullopt;
    }
    SpatialMotion motion = motion_at(contacts_, mode_, unknowns_, center_, p);
    motion.inverse = inverse_;
    if (!conditions_hold(motion)) return std::nullopt;
    motion.alone = neighbourhood(p);
    return motion;
  }

 private:
  std::size_t count() const { return unknowns_.count(); }

  /// R F(z).
  Vector shift() const {
    Vector f;
    for (const auto& equation : equations_) f.push_back(value_at(equation, center_));
    return product(inverse_, f);
  }

  /// |I - R J| by entries.
  RationalMatrix defect() const {
    const std::size_t n = count();
    RationalMatrix result(n, Vector(n));
    for (std::size_t i = 0; i < n; ++i) {
      const Vector slope = slope_at(equations_[i], center_);
      for (std::size_t j = 0; j < n; ++j) {
        if (inverse_[j][i].is_zero()) continue;
        for (std::size_t k = 0; k < n; ++k) {
          if (!slope[k].is_zero()) result[j][k] -= inverse_[j][i] * slope[k];
        }
      }
    }
    for (std::size_t j = 0; j < n; ++j) result[j][j] += 1;
    for (auto& row : result) {
      for (Rational& x : row) x = abs(x);
    }
    return result;
  }

  /// |R| q for the products of unknowns within p of the center.
  Vector bent(const Vector& p) const {
    Vector q(p.size()), result(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (const auto& term : equations_[i].products) q[i] += abs(term.coefficient) * p[term.i] * p[term.j];
    }
    for (std::size_t j = 0; j < p.size(); ++j) {
      for (std::size_t i = 0; i < p.size(); ++i) {
        if (!q[i].is_zero()) result[j] += abs(inverse_[j][i]) * q[i];
      }
    }
    return result;
  }

  /// The conditions that are not equations, everywhere in the box.
  bool conditions_hold(const SpatialMotion& motion) const {
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t i = contacts_.normal(k), speed = unknowns_.first[k] + 3;
      if (mode_[k].kind == ContactState::Kind::open) {
        if (motion.u[i] < motion.u_radius[i]) return false;
        continue;
      }
      if (motion.r[i] < motion.r_radius[i]) return false;
      if (slips_in_space(contacts_, mode_, k) && motion.center[speed] < motion.radius[speed]) return false;
      if (mode_[k].kind == ContactState::Kind::stick && !is_in_cone(motion, k)) return false;
    }
    return true;
  }

  bool is_in_cone(const SpatialMotion& motion, std::size_t k) const {
    const std::size_t i = contacts_.normal(k);
    Rational force;
    for (std::size_t t = 1; t < contacts_.dimension; ++t) {
      const Rational most = abs(motion.r[i + t]) + motion.r_radius[i + t];
      force += most * most;
    }
    const Rational limit = contacts_.mu[k] * (motion.r[i] - motion.r_radius[i]);
    return force <= limit * limit;
  }

  /// In which the equations have no other zero: |I - R J| P + 2 |R| q(P) < P. It contains the box, so that this zero is
  /// the motion; empty where none was found.
  Vector neighbourhood(const Vector& box) const {
    Vector v = first_shape(), best;
    Rational width;
    // Forces and slips bend the equations together: the box that |R| q makes of one is often better than the first.
    for (int shape = 0; shape < 3; ++shape) {
      const Vector next = bent(v);
      const Vector alone = alone_within(v, next);
      if (!alone.empty()) {
        const Rational least = *std::min_element(alone.begin(), alone.end());
        const bool contains = std::ranges::equal(box, alone, [](const auto& p, const auto& P) { return p <= P; });
        if (contains && least > width) width = least, best = alone;
      }
      const Rational largest = *std::max_element(next.begin(), next.end());
      if (largest.is_zero()) break;
      const Rational unit = *std::max_element(v.begin(), v.end()) / power_above(largest);
      for (std::size_t j = 0; j < v.size(); ++j) v[j] = power_above((v[j] + unit * next[j]) / 2);
    }
    return best;
  }

  /// Forces and speeds of their own size, directions of size 1.
  Vector first_shape() const {
    Vector v(count(), Rational(1));
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t first = unknowns_.first[k];
      const std::size_t forces = slips_in_space(contacts_, mode_, k) ? 1 : unknowns_.of(k);
      for (std::size_t t = 0; t < forces; ++t) v[first + t] = power_above(center_[first]);
    }
    return v;
  }

  /// The largest share of v, a power of 2, within which the test holds.
  Vector alone_within(const Vector& v, const Vector& bend) const {
    const Vector spread = product(defect_, v);
    for (int exponent = 4; exponent > -60; --exponent) {
      const Rational share = power_of_two(exponent);
      bool alone = true;
      for (std::size_t j = 0; j < v.size() && alone; ++j) alone = spread[j] + 2 * share * bend[j] < v[j];
      if (!alone) continue;
      Vector result = v;
      for (Rational& x : result) x *= share;
      return result;
    }
    return {};
  }

  const ExactContacts& contacts_;
  const ContactPattern& mode_;
  const ModeUnknowns unknowns_;
  const std::vector<ModeEquation<Rational>> equations_;
  const RationalMatrix inverse_;
  Vector center_;
  RationalMatrix defect_;
};

}  // namespace

SpatialMotion motion_at(const ExactContacts& contacts, const ContactPattern& mode, const ModeUnknowns& unknowns,
                        const std::vector<Rational>& point, const std::vector<Rational>& radius) {
  SpatialMotion motion;
  motion.mode = mode;
  motion.center = point;
  motion.radius = radius;
  const std::size_t n = contacts.size();
  const Vector &z = point, p = radius.empty() ? Vector(point.size()) : radius;
  motion.r.resize(n), motion.r_radius.resize(n), motion.u_radius.resize(n);
  for (std::size_t k = 0; k < mode.size(); ++k) {
    const std::size_t first = unknowns.first[k], i = contacts.normal(k);
    const Rational& mu = contacts.mu[k];
    const bool slips = mode[k].kind == ContactState::Kind::slip && contacts.has_friction(k);
    for (std::size_t t = 0; t < (slips ? 1 : unknowns.of(k)); ++t) {
      motion.r[i + t] = z[first + t];
      motion.r_radius[i + t] = p[first + t];
    }
    if (slips && contacts.dimension == 2) {
      motion.r[i + 1] = (mode[k].from.x.sign() > 0 ? -mu : mu) * z[first];
      motion.r_radius[i + 1] = mu * p[first];
    }
    for (std::size_t t = 1; slips && contacts.dimension == 3 && t < 3; ++t) {
      motion.r[i + t] = -mu * z[first] * z[first + t];
      motion.r_radius[i + t] = mu * (abs(z[first]) * p[first + t] + (abs(z[first + t]) + p[first + t]) * p[first]);
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
                                           const std::vector<double>& zero, const Eigen::MatrixXd& derivative) {
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(derivative);
  if (lu.rcond() < 1e-11) return std::nullopt;
  const Eigen::MatrixXd approximate = lu.inverse();
  RationalMatrix inverse;
  for (const auto& row : approximate.rowwise()) {
    Vector& own = inverse.emplace_back();
    for (const double x : row) own.push_back(nearest_multiple(x, inverse_bits));
  }
  return BoxTest(contacts, mode, zero, std::move(inverse)).motion();
}

}  // namespace slipproof
