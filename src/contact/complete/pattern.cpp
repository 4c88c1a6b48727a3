#include "contact/complete/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slipproof {

namespace {

constexpr double quarter = std::numbers::pi / 2;

/// Of the rest of an angle after quarter turns.
double half_tangent(double angle, double turns) {
  return std::tan((angle - turns * quarter) / 2);
}

/// So many quarter turns from the direction whose half angle has the tangent p / q.
Direction turned(const Integer& p, const Integer& q, double turns) {
  Direction d{q * q - p * p, 2 * p * q, q * q + p * p};
  if (!d.x.is_odd() && !d.y.is_odd() && !d.length.is_odd()) d = {d.x / 2, d.y / 2, d.length / 2};
  for (long turn = std::lround(turns) & 3; turn > 0; --turn) d = {-d.y, d.x, d.length};
  return d;
}

}  // namespace

Direction Direction::near(double angle, int bits) {
  const double turns = std::nearbyint(angle / quarter);
  const auto p = static_cast<long>(std::nearbyint(std::ldexp(half_tangent(angle, turns), bits)));
  const Integer q = Integer(1) << static_cast<std::size_t>(bits), common = gcd(Integer(p), q);
  return turned(Integer(p) / common, q / common, turns);
}

std::optional<Direction> Direction::short_at(double angle) {
  const double turns = std::nearbyint(angle / quarter), t = half_tangent(angle, turns);
  for (long q = 1; q <= 1000; ++q) {
    const double p = std::nearbyint(t * static_cast<double>(q));
    if (std::abs(t - p / static_cast<double>(q)) < 1e-10) return turned(static_cast<long>(p), q, turns);
  }
  return std::nullopt;
}

double Direction::angle() const {
  return std::atan2(Rational(y, length).to_double(), Rational(x, length).to_double());
}

std::array<Rational, 2> ContactState::middle() const {
  return {Rational(from.x, from.length) + Rational(to.x, to.length),
          Rational(from.y, from.length) + Rational(to.y, to.length)};
}

double ContactState::width() const {
  const double width = to.angle() - from.angle();
  return width < 0 ? width + 2 * std::numbers::pi : width;
}

Integer cross(const Direction& a, const Direction& b) {
  return a.x * b.y - a.y * b.x;
}

ContactPattern rest_pattern(const ExactContacts& contacts) {
  ContactPattern pattern(contacts.contacts());
  for (std::size_t k = 0; k < pattern.size(); ++k) {
    pattern[k].kind = contacts.has_friction(k) ? ContactState::Kind::stick : ContactState::Kind::closed;
  }
  return pattern;
}

bool is_decided(const ExactContacts& contacts, const ContactPattern& pattern, std::size_t k) {
  using Kind = ContactState::Kind;
  const Kind kind = pattern[k].kind;
  return kind == Kind::open || kind == Kind::stick || kind == Kind::slip ||
         (kind == Kind::closed && !contacts.has_friction(k));
}

bool is_decided(const ExactContacts& contacts, const ContactPattern& pattern) {
  for (std::size_t k = 0; k < pattern.size(); ++k) {
    if (!is_decided(contacts, pattern, k)) return false;
  }
  return true;
}

namespace {

using Kind = ContactState::Kind;

/// The components of a vector at one contact, in any common scale.
struct Part {
  Rational normal;
  std::array<Rational, 2> tangential;

  bool is_tangential() const { return !tangential[0].is_zero() || !tangential[1].is_zero(); }
  Rational along(const Direction& d) const { return tangential[0] * Rational(d.x) + tangential[1] * Rational(d.y); }
};

/// -1: v . u is negative for some u that the state allows; 0: it is never; 1: it is positive for all of them.
int sign_over_velocities(const ContactState& state, const Part& v) {
  switch (state.kind) {
    case Kind::stick:
      return 0;
    case Kind::slip: {
      const int from = v.along(state.from).sign(), to = v.along(state.to).sign();
      return from < 0 || to < 0 ? -1 : from > 0 && to > 0 ? 1 : 0;
    }
    case Kind::closed:
      return v.is_tangential() ? -1 : 0;
    default:
      if (v.is_tangential() || v.normal.sign() < 0) return -1;
      return state.kind == Kind::open ? v.normal.sign() : 0;
  }
}

/// Whether g . r >= 0 for the forces (1, mu t) with |t| <= 1.
bool is_nonnegative_over_cone(const Part& g, const Rational& mu) {
  const Rational &x = g.tangential[0], &y = g.tangential[1];
  return g.normal.sign() >= 0 && g.normal * g.normal >= mu * mu * (x * x + y * y);
}

/// For the forces (1, -mu d), d in the arc. Over the whole circle g_T . d is greatest along g_T.
bool is_nonnegative_over_arc(const ContactState& state, const Part& g, const Rational& mu) {
  const auto side = [&](const Direction& d) {
    return (Rational(d.x) * g.tangential[1] - Rational(d.y) * g.tangential[0]).sign();
  };
  if (side(state.from) > 0 && side(state.to) < 0) return is_nonnegative_over_cone(g, mu);
  const auto at = [&](const Direction& d) { return (g.normal * Rational(d.length) - mu * g.along(d)).sign() >= 0; };
  return at(state.from) && at(state.to);
}

bool is_nonnegative_over_forces(const ContactState& state, const Part& g, const Rational& mu) {
  if (state.kind == Kind::open) return true;
  if (mu.is_zero()) return g.normal.sign() >= 0;
  return state.kind == Kind::slip ? is_nonnegative_over_arc(state, g, mu) : is_nonnegative_over_cone(g, mu);
}

Part part_of(std::span<const Rational> vector, std::size_t normal, std::size_t dimension) {
  Part result{vector[normal], {}};
  for (std::size_t t = 1; t < dimension; ++t) result.tangential[t - 1] = vector[normal + t];
  return result;
}

/// h + W^T y.
std::vector<Rational> on_forces(const IntegerContacts& contacts, const ContactForm& form, std::span<const Rational> y) {
  Integer common = common_denominator(y);
  std::vector<Integer> sum(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (y[i].is_zero()) continue;
    const Integer factor = integer_times(y[i], common);
    for (std::size_t j = 0; j < y.size(); ++j) sum[j].add_product(factor, contacts.matrix[i][j]);
  }
  common *= contacts.scale;
  std::vector<Rational> g;
  for (Integer& x : sum) g.emplace_back(std::move(x), common);
  for (const auto& [i, h] : form.r) g[i] += h;
  return g;
}

}  // namespace

std::optional<ProvedBound> lower_bound(const ExactContacts& contacts, const IntegerContacts& integers,
                                       const ContactPattern& pattern, const ContactForm& form,
                                       std::span<const Rational> y) {
  std::vector<Rational> v;
  for (const Rational& component : y) v.push_back(-component);
  for (const auto& [i, f] : form.u) v[i] += f;
  const std::vector<Rational> g = on_forces(integers, form, y);
  ProvedBound result;
  for (std::size_t k = 0; k < pattern.size(); ++k) {
    const std::size_t normal = contacts.normal(k);
    const int motion = sign_over_velocities(pattern[k], part_of(v, normal, contacts.dimension));
    if (motion < 0) return std::nullopt;
    if (!is_nonnegative_over_forces(pattern[k], part_of(g, normal, contacts.dimension), contacts.mu[k])) {
      return std::nullopt;
    }
    result.strict = result.strict || motion > 0;
  }
  for (std::size_t i = 0; i < y.size(); ++i) result.value += y[i] * contacts.q[i];
  return result;
}

bool proves_empty(const ExactContacts& contacts, const IntegerContacts& integers, const ContactPattern& pattern,
                  std::span<const Rational> y) {
  const auto bound = lower_bound(contacts, integers, pattern, {}, y);
  return bound && (bound->value.sign() > 0 || (bound->value.is_zero() && bound->strict));
}

}  // namespace slipproof
