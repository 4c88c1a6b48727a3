#include "records/degenerate/law_check.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof::test::degenerate {

namespace {

/// W r + V lambda + q, with the compliance and the bias.
std::vector<Rational> velocities(const ProblemFile& p, const std::vector<Rational>& r,
                                 const std::vector<Rational>& lambda) {
  std::vector<Rational> u;
  for (std::size_t i = 0; i < p.q.size(); ++i) {
    Rational sum = to_rational(p.q[i]);
    for (std::size_t e = p.W.starts[i]; e < p.W.starts[i + 1]; ++e) sum += to_rational(p.W.value[e]) * r[p.W.column[e]];
    for (std::size_t e = p.s.empty() ? 0 : p.V.starts[i]; !p.s.empty() && e < p.V.starts[i + 1]; ++e) {
      sum += to_rational(p.V.value[e]) * lambda[p.V.column[e]];
    }
    if (!p.compliance.empty()) sum += to_rational(p.compliance[i]) * r[i] + to_rational(p.bias[i]);
    u.push_back(std::move(sum));
  }
  return u;
}

/// V^T r + R lambda + s = 0.
bool balanced(const ProblemFile& p, const std::vector<Rational>& r, const std::vector<Rational>& lambda) {
  std::vector<Rational> rest;
  for (const double s : p.s) rest.push_back(to_rational(s));
  for (std::size_t i = 0; i < r.size() && !rest.empty(); ++i) {
    for (std::size_t e = p.V.starts[i]; e < p.V.starts[i + 1]; ++e) {
      rest[p.V.column[e]] += to_rational(p.V.value[e]) * r[i];
    }
  }
  for (std::size_t i = 0; i < rest.size(); ++i) {
    for (std::size_t e = p.R.starts[i]; e < p.R.starts[i + 1]; ++e) {
      rest[i] += to_rational(p.R.value[e]) * lambda[p.R.column[e]];
    }
  }
  return std::ranges::all_of(rest, [](const Rational& x) { return x.is_zero(); });
}

/// One contact's normal force and velocity, and the tangential ones, 0 where the dimension has fewer.
struct Contact {
  Rational rN, uN, r1, r2, u1, u2, bound;  ///< bound: mu r_N

  Rational power() const { return r1 * u1 + r2 * u2; }
  bool moves() const { return !u1.is_zero() || !u2.is_zero(); }
  /// 0 <= r_N, 0 <= u_N, one of them 0.
  bool signorini() const { return rN.sign() >= 0 && uN.sign() >= 0 && (rN.is_zero() || uN.is_zero()); }
  bool in_cone() const { return rN.sign() >= 0 && r1 * r1 + r2 * r2 <= bound * bound; }
  /// r_T = -f u_T with f >= 0, and |r_T| = size.
  bool against_slip(const Rational& size) const {
    return (r1 * u2 - r2 * u1).is_zero() && power().sign() <= 0 && r1 * r1 + r2 * r2 == size * size;
  }
};

bool one_direction(const Rational& r, const Rational& u, const Rational& bound) {
  return abs(r) <= bound && (u.is_zero() || r == (u.sign() > 0 ? Rational(-bound) : bound));
}

bool coulomb(const Contact& c) {
  return c.signorini() && c.in_cone() && (!c.moves() || c.against_slip(c.bound));
}

bool diamond(const Contact& c) {
  const Rational most = std::max(abs(c.u1), abs(c.u2));
  return c.signorini() && abs(c.r1) + abs(c.r2) <= c.bound && c.power() == -c.bound * most;
}

bool associated(const Contact& c, const Rational& mu) {
  const bool dual = c.uN.sign() >= 0 && mu * mu * (c.u1 * c.u1 + c.u2 * c.u2) <= c.uN * c.uN;
  return c.in_cone() && dual && (c.rN * c.uN + c.power()).is_zero();
}

/// |r_T| = mu r_N f: with f^2 rational both are compared as squares.
bool regularised(const Contact& c, const ContactLaw& law) {
  const Rational speed = to_rational(law.slip_speed), square = (c.u1 * c.u1 + c.u2 * c.u2) / (speed * speed);
  const Rational f2 = law.function == Regularisation::soft ? square / (1 + square) : std::min(square, Rational(1));
  const bool size = c.r1 * c.r1 + c.r2 * c.r2 == c.bound * c.bound * f2;
  return c.signorini() && size && (c.r1 * c.u2 - c.r2 * c.u1).is_zero() && c.power().sign() <= 0;
}

bool obeys(const ProblemFile& p, std::size_t k, const Contact& c) {
  if (p.dimension == 1) return c.signorini();
  const auto bound = [&](std::size_t t) { return to_rational(p.law.bounds[k * (p.dimension - 1) + t]); };
  switch (p.law.kind) {
    case FrictionLaw::box:
      return c.signorini() && one_direction(c.r1, c.u1, c.bound) && one_direction(c.r2, c.u2, c.bound);
    case FrictionLaw::fixed:
      return c.signorini() && one_direction(c.r1, c.u1, bound(0)) &&
             (p.dimension == 2 || one_direction(c.r2, c.u2, bound(1)));
    case FrictionLaw::diamond:
      return p.dimension == 2 ? coulomb(c) : diamond(c);
    case FrictionLaw::associated:
      return associated(c, to_rational(p.mu[k]));
    case FrictionLaw::regularised:
      return regularised(c, p.law);
    default:
      return coulomb(c);
  }
}

}  // namespace

bool solves(const ProblemFile& p, const std::vector<Rational>& r, const std::vector<Rational>& lambda) {
  if (!balanced(p, r, lambda)) return false;
  const std::vector<Rational> u = velocities(p, r, lambda);
  for (std::size_t k = 0; k * p.dimension < r.size(); ++k) {
    const std::size_t n = k * p.dimension;
    Contact c{r[n], u[n], 0, 0, 0, 0, 0};
    if (p.dimension > 1) c.r1 = r[n + 1], c.u1 = u[n + 1], c.bound = to_rational(p.mu[k]) * c.rN;
    if (p.dimension > 2) c.r2 = r[n + 2], c.u2 = u[n + 2];
    if (!obeys(p, k, c)) return false;
  }
  return true;
}

bool solves_roughly(const ProblemFile& p, const std::vector<double>& r, double error) {
  double force = 0, speed = 0;  // the sizes by which errors are measured: without forces, what would stop q
  double largest = 0;           // entry of W: what a change of a force can do, also of one that moves nothing
  std::vector<double> u;
  for (std::size_t i = 0; i < r.size(); ++i) {
    double sum = p.q[i], size = std::abs(p.q[i]);
    for (std::size_t e = p.W.starts[i]; e < p.W.starts[i + 1]; ++e) {
      sum += p.W.value[e] * r[p.W.column[e]];
      size += std::abs(p.W.value[e] * r[p.W.column[e]]);
      if (p.W.value[e] != 0) force = std::max(force, std::abs(p.q[i] / p.W.value[e]));
      largest = std::max(largest, std::abs(p.W.value[e]));
    }
    u.push_back(sum);
    speed = std::max(speed, size);
    force = std::max(force, std::abs(r[i]));
  }
  const double small_force = error * force, small_speed = error * std::max(speed, largest * force);
  for (std::size_t k = 0; k * p.dimension < r.size(); ++k) {
    const std::size_t n = k * p.dimension, d = p.dimension;
    if (r[n] < -small_force || u[n] < -small_speed || (r[n] > small_force && u[n] > small_speed)) return false;
    if (d == 1) continue;
    const double bound = p.mu[k] * std::max(r[n], 0.0), T = std::hypot(r[n + 1], d == 3 ? r[n + 2] : 0);
    const double slip = std::hypot(u[n + 1], d == 3 ? u[n + 2] : 0);
    if (T > bound + small_force) return false;
    if (slip <= 100 * small_speed) continue;
    for (std::size_t t = 1; t < d; ++t) {
      if (std::abs(r[n + t] + bound * u[n + t] / slip) > 0.03 * force) return false;
    }
  }
  return true;
}

}  // namespace slipproof::test::degenerate
