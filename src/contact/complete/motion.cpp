#include "contact/complete/motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;
constexpr int center_bits = 90, inverse_bits = 34;

bool has_slip(const ExactContacts& contacts, const ContactState& state, std::size_t k) {
  return contacts.dimension == 3 && state.kind == Kind::slip && contacts.has_friction(k);
}

bool is_linear(const ExactContacts& contacts, const ContactPattern& mode) {
  for (std::size_t k = 0; k < mode.size(); ++k) {
    if (has_slip(contacts, mode[k], k)) return false;
  }
  return true;
}

/// The equations of a mode over any number type.
template <class T>
class EquationMaker {
 public:
  using Equation = ModeEquation<T>;

  template <class Contacts>
  EquationMaker(const Contacts& contacts, const ExactContacts& exact, const ContactPattern& mode,
                const ModeUnknowns& unknowns)
      : W_(contacts.W), q_(contacts.q), mu_(contacts.mu), exact_(exact), mode_(mode), unknowns_(unknowns) {
    for (std::size_t k = 0; k < mode.size(); ++k) add_contact(mode[k], k);
  }

  std::vector<Equation> equations;

 private:
  Equation row(std::size_t i) const {
    Equation result{q_[i], {}, {}};
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      if (mode_[k].kind != Kind::open) add_forces(result, i, k);
    }
    return result;
  }

  /// What the forces of contact k do in row i.
  void add_forces(Equation& row, std::size_t i, std::size_t k) const {
    const std::size_t normal = exact_.normal(k), first = unknowns_.first[k];
    const T mu = mu_[k];
    if (!exact_.has_friction(k)) {
      row.linear.emplace_back(first, W_[i][normal]);
    } else if (mode_[k].kind != Kind::slip) {
      for (std::size_t t = 0; t < exact_.dimension; ++t) row.linear.emplace_back(first + t, W_[i][normal + t]);
    } else if (exact_.dimension == 2) {
      const T friction = mu * W_[i][normal + 1];
      row.linear.emplace_back(first,
                              mode_[k].from.x.sign() > 0 ? T(W_[i][normal] - friction) : T(W_[i][normal] + friction));
    } else {
      row.linear.emplace_back(first, W_[i][normal]);
      for (const std::size_t t : {1, 2}) row.products.push_back({first, first + t, T(-(mu * W_[i][normal + t]))});
    }
  }

  void add_contact(const ContactState& state, std::size_t k) {
    if (state.kind == Kind::open) return;
    const std::size_t normal = exact_.normal(k), first = unknowns_.first[k];
    equations.push_back(row(normal));
    if (!exact_.has_friction(k)) return;
    for (std::size_t t = 1; state.kind != Kind::slip && t < exact_.dimension; ++t) equations.push_back(row(normal + t));
    if (state.kind != Kind::slip || exact_.dimension == 2) return;
    for (const std::size_t t : {1, 2}) {
      Equation tangential = row(normal + t);
      tangential.products.push_back({first + 3, first + t, T(-1)});
      equations.push_back(std::move(tangential));
    }
    equations.push_back({T(-1), {}, {{first + 1, first + 1, T(1)}, {first + 2, first + 2, T(1)}}});
  }

  const std::vector<std::vector<T>>& W_;
  const std::vector<T>&q_, &mu_;
  const ExactContacts& exact_;
  const ContactPattern& mode_;
  const ModeUnknowns& unknowns_;
};

template <class T>
T value_at(const ModeEquation<T>& equation, const std::vector<T>& z) {
  T sum = equation.constant;
  for (const auto& [j, a] : equation.linear) sum += a * z[j];
  for (const auto& p : equation.products) sum += p.coefficient * z[p.i] * z[p.j];
  return sum;
}

template <class T>
std::vector<T> slope_at(const ModeEquation<T>& equation, const std::vector<T>& z) {
  std::vector<T> slope(z.size());
  for (const auto& [j, a] : equation.linear) slope[j] += a;
  for (const auto& p : equation.products) {
    slope[p.i] += p.coefficient * z[p.j];
    slope[p.j] += p.coefficient * z[p.i];
  }
  return slope;
}

Rational rounded(double x, int bits) {
  return to_rational(std::nearbyint(std::ldexp(x, bits))) * power_of_two(-bits);
}

/// To a multiple of 2^-bits, downwards.
Rational rounded(const Rational& x, int bits) {
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

class MotionFinder {
 public:
  MotionFinder(const ExactContacts& exact, const FloatingContacts& contacts, const ContactPattern& mode)
      : exact_(exact), contacts_(contacts), mode_(mode), unknowns_(exact, mode) {}

  std::optional<SpatialMotion> find(const ProposedPoint& start) {
    if (is_linear(exact_, mode_)) return find_exactly(start);
    std::vector<double> z = unknowns_at(start);
    if (!newton(z) || !plausible(z)) return std::nullopt;
    return enclose(z);
  }

 private:
  std::vector<double> unknowns_at(const ProposedPoint& point) const {
    std::vector<double> z(unknowns_.count());
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t first = unknowns_.first[k], i = exact_.normal(k);
      if (!has_slip(exact_, mode_[k], k)) {
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
    const auto equations = EquationMaker<double>(contacts_, exact_, mode_, unknowns_).equations;
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
      if (has_slip(exact_, mode_[k], k) && z[unknowns_.first[k] + 3] < -slack) return false;
    }
    return true;
  }

  // --- linear modes ---

  std::optional<SpatialMotion> find_exactly(const ProposedPoint& start) const {
    const auto equations = EquationMaker<Rational>(exact_, exact_, mode_, unknowns_).equations;
    const std::size_t n = unknowns_.count();
    RationalMatrix rows;
    for (const auto& equation : equations) {
      std::vector<Rational>& row = rows.emplace_back(n + 1);
      for (const auto& [j, a] : equation.linear) row[j] += a;
      row[n] = -equation.constant;
    }
    const Echelon echelon = eliminate(rows);
    if (n > 0 && echelon.rank(n) != echelon.rank()) return std::nullopt;
    std::vector<Rational> z(n);
    std::vector<bool> is_pivot(n, false);
    for (const std::size_t j : echelon.pivot_columns) is_pivot[j] = true;
    const std::vector<double> near = unknowns_at(start);
    for (std::size_t j = 0; j < n; ++j) {
      if (!is_pivot[j]) z[j] = rounded(near[j], 20);
    }
    for (std::size_t p = 0; p < echelon.rank(); ++p) {
      Rational sum(echelon.rows[p][n]);
      for (std::size_t j = 0; j < n; ++j) {
        if (!is_pivot[j] && !echelon.rows[p][j].is_zero()) sum -= Rational(echelon.rows[p][j]) * z[j];
      }
      z[echelon.pivot_columns[p]] = sum / Rational(echelon.pivot);
    }
    SpatialMotion motion = motion_at(z, {});
    if (!satisfies_law(exact_, motion.r, motion.u)) return std::nullopt;
    motion.open_directions = n - echelon.rank();
    return motion;
  }

  /// The point, and what radii of its unknowns mean for forces and velocities.
  SpatialMotion motion_at(const std::vector<Rational>& z, const std::vector<Rational>& p) const {
    SpatialMotion motion;
    motion.mode = mode_;
    motion.center = z;
    motion.radius = p;
    const std::size_t n = exact_.size();
    motion.r.resize(n), motion.r_radius.resize(n), motion.u_radius.resize(n);
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t first = unknowns_.first[k], i = exact_.normal(k);
      const Rational& mu = exact_.mu[k];
      const bool slips = mode_[k].kind == Kind::slip && exact_.has_friction(k);
      for (std::size_t t = 0; t < (slips ? 1 : unknowns_.of(k)); ++t) {
        motion.r[i + t] = z[first + t];
        if (!p.empty()) motion.r_radius[i + t] = p[first + t];
      }
      if (slips && exact_.dimension == 2) {
        motion.r[i + 1] = (mode_[k].from.x.sign() > 0 ? -mu : mu) * z[first];
        if (!p.empty()) motion.r_radius[i + 1] = mu * p[first];
      }
      for (std::size_t t = 1; slips && exact_.dimension == 3 && t < 3; ++t) {
        motion.r[i + t] = -mu * z[first] * z[first + t];
        if (p.empty()) continue;
        motion.r_radius[i + t] = mu * (abs(z[first]) * p[first + t] + (abs(z[first + t]) + p[first + t]) * p[first]);
      }
    }
    motion.u = velocities(exact_, motion.r);
    for (std::size_t i = 0; i < n && !p.empty(); ++i) {
      for (std::size_t j = 0; j < n; ++j) motion.u_radius[i] += abs(exact_.W[i][j]) * motion.r_radius[j];
    }
    return motion;
  }

  // --- a box ---

  std::optional<SpatialMotion> enclose(const std::vector<double>& start) {
    const auto n = static_cast<Eigen::Index>(unknowns_.count());
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(derivative_);
    if (lu.rcond() < 1e-11) return std::nullopt;
    const Eigen::MatrixXd inverse = lu.inverse();
    RationalMatrix R(unknowns_.count(), std::vector<Rational>(unknowns_.count()));
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        R[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = rounded(inverse(i, j), inverse_bits);
      }
    }
    equations_ = EquationMaker<Rational>(exact_, exact_, mode_, unknowns_).equations;
    std::vector<Rational> z;
    for (const double x : start) z.push_back(rounded(x, center_bits));
    std::vector<Rational> step;
    for (int i = 0; i < 4; ++i) {
      step = product(R, values(z));
      for (std::size_t j = 0; j < z.size(); ++j) z[j] = rounded(z[j] - step[j], center_bits);
    }
    return test(z, R);
  }

  std::vector<Rational> values(const std::vector<Rational>& z) const {
    std::vector<Rational> f;
    for (const auto& equation : equations_) f.push_back(value_at(equation, z));
    return f;
  }

  static std::vector<Rational> product(const RationalMatrix& R, const std::vector<Rational>& f) {
    std::vector<Rational> result(f.size());
    for (std::size_t j = 0; j < f.size(); ++j) {
      for (std::size_t i = 0; i < f.size(); ++i) result[j] += R[j][i] * f[i];
    }
    return result;
  }

  /// |R| q for the products of unknowns within p of the center.
  std::vector<Rational> bent(const RationalMatrix& R, const std::vector<Rational>& p) const {
    std::vector<Rational> q(p.size()), result(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (const auto& term : equations_[i].products) q[i] += abs(term.coefficient) * p[term.i] * p[term.j];
    }
    for (std::size_t j = 0; j < p.size(); ++j) {
      for (std::size_t i = 0; i < p.size(); ++i) {
        if (!q[i].is_zero()) result[j] += abs(R[j][i]) * q[i];
      }
    }
    return result;
  }

  /// |I - R J| by entries.
  RationalMatrix defect(const RationalMatrix& R, const std::vector<Rational>& z) const {
    const std::size_t n = z.size();
    RationalMatrix result(n, std::vector<Rational>(n));
    for (std::size_t i = 0; i < n; ++i) {
      const std::vector<Rational> slope = slope_at(equations_[i], z);
      for (std::size_t j = 0; j < n; ++j) {
        if (R[j][i].is_zero()) continue;
        for (std::size_t k = 0; k < n; ++k) {
          if (!slope[k].is_zero()) result[j][k] -= R[j][i] * slope[k];
        }
      }
    }
    for (std::size_t j = 0; j < n; ++j) result[j][j] += 1;
    for (auto& row : result) {
      for (Rational& x : row) x = abs(x);
    }
    return result;
  }

  std::optional<SpatialMotion> test(const std::vector<Rational>& z, const RationalMatrix& R) const {
    const RationalMatrix defects = defect(R, z);
    const std::vector<Rational> shift = product(R, values(z));
    std::vector<Rational> p;
    for (const Rational& x : shift) p.push_back(power_above(abs(x) * 4));
    const Rational largest = *std::max_element(p.begin(), p.end());
    for (Rational& x : p) x = std::max(x, Rational(largest * power_of_two(-20)));
    const std::vector<Rational> spread = product(defects, p), bend = bent(R, p);
    for (std::size_t j = 0; j < z.size(); ++j) {
      if (abs(shift[j]) + spread[j] + bend[j] > p[j]) return std::nullopt;
    }
    SpatialMotion motion = motion_at(z, p);
    motion.inverse = R;
    if (!conditions_hold(motion)) return std::nullopt;
    find_neighbourhood(motion, z, R, defects);
    return motion;
  }

  /// The conditions that are not equations, everywhere in the box.
  bool conditions_hold(const SpatialMotion& motion) const {
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t i = exact_.normal(k);
      if (mode_[k].kind == Kind::open) {
        if (motion.u[i] < motion.u_radius[i]) return false;
        continue;
      }
      if (motion.r[i] < motion.r_radius[i]) return false;
      const std::size_t speed = unknowns_.first[k] + 3;
      if (has_slip(exact_, mode_[k], k) && motion.center[speed] < motion.radius[speed]) return false;
      if (mode_[k].kind != Kind::stick || !exact_.has_friction(k)) continue;
      Rational force;
      for (std::size_t t = 1; t < exact_.dimension; ++t) {
        const Rational most = abs(motion.r[i + t]) + motion.r_radius[i + t];
        force += most * most;
      }
      const Rational limit = exact_.mu[k] * (motion.r[i] - motion.r_radius[i]);
      if (force > limit * limit) return false;
    }
    return true;
  }

  /// In which the equations have no other zero: |I - R J| P + 2 |R| q(P) < P.
  void find_neighbourhood(SpatialMotion& motion, const std::vector<Rational>& z, const RationalMatrix& R,
                          const RationalMatrix& defects) const {
    std::vector<Rational> v(z.size(), Rational(1));
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t first = unknowns_.first[k];
      const bool slips = has_slip(exact_, mode_[k], k);
      for (std::size_t t = 0; t < (slips ? 1 : unknowns_.of(k)); ++t) v[first + t] = power_above(z[first]);
    }
    // Forces and slips bend the equations together: the box that |R| q makes of one is often better than the first.
    std::optional<Rational> best;
    for (int shape = 0; shape < 3; ++shape) {
      const auto tau = alone_within(v, R, defects);
      Rational least;
      for (const Rational& x : v) {
        if (tau && (least.is_zero() || *tau * x < least)) least = *tau * x;
      }
      if (tau && (!best || least > *best)) {
        best = least;
        motion.alone = v;
        for (Rational& x : motion.alone) x *= *tau;
      }
      std::vector<Rational> next = bent(R, v);
      const Rational largest = *std::max_element(next.begin(), next.end());
      if (largest.is_zero()) return;
      const Rational unit = *std::max_element(v.begin(), v.end()) / power_above(largest);
      for (std::size_t j = 0; j < v.size(); ++j) v[j] = power_above((v[j] + unit * next[j]) / 2);
    }
  }

  /// The largest share of v, a power of 2, within which the test holds.
  std::optional<Rational> alone_within(const std::vector<Rational>& v, const RationalMatrix& R,
                                       const RationalMatrix& defects) const {
    const std::vector<Rational> spread = product(defects, v), bend = bent(R, v);
    for (int exponent = 4; exponent > -60; --exponent) {
      const Rational tau = power_of_two(exponent);
      bool alone = true;
      for (std::size_t j = 0; j < v.size() && alone; ++j) alone = spread[j] + 2 * tau * bend[j] < v[j];
      if (alone) return tau;
    }
    return std::nullopt;
  }

  const ExactContacts& exact_;
  const FloatingContacts& contacts_;
  const ContactPattern& mode_;
  const ModeUnknowns unknowns_;
  Eigen::MatrixXd derivative_;
  std::vector<ModeEquation<Rational>> equations_;
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
