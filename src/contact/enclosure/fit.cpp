#include "contact/enclosure/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

/// At least the root of x >= 0, and above it by a few ulps.
Rational root_above(const Rational& x) {
  double root = std::sqrt(upper_size(x));
  while (to_rational(root) * to_rational(root) < x)
    root = std::nextafter(root, std::numeric_limits<double>::infinity());
  return to_rational(root);
}

/// Part of a vector: u_T, r_T, or a direction.
using Tangential = std::vector<Rational>;

Rational dot(const Tangential& a, const Tangential& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// A rational unit vector near the direction of t; nothing for 0.
std::optional<Tangential> direction_of(const Tangential& t) {
  if (dot(t, t).is_zero()) return std::nullopt;
  if (t.size() == 1) return Tangential{t[0].sign()};
  const Rational largest = std::max(Rational(abs(t[0])), Rational(abs(t[1])));  // the quotients do not underflow
  const auto [x, y] = unit_direction(nearest_binary64(t[0] / largest), nearest_binary64(t[1] / largest));
  return Tangential{x, y};
}

/// The normal part, and a multiple of a tangential one.
std::vector<Rational> joined(const Rational& normal, const Rational& factor, const Tangential& t) {
  std::vector<Rational> result{normal};
  for (const Rational& x : t) result.push_back(factor * x);
  return result;
}

/// The fits are compared by what they change, velocities moved by the contact's own forces included.
class ContactFitter {
 public:
  ContactFitter(const ContactLaw& law, const ContactAnswer& a)
      : law_(law), dimension_(a.r.size()), mu_(a.mu), scale_(a.scale), r_(a.r), u_(a.u), bounds_(a.bounds) {}

  FittedContact fit() {
    try_open();
    const bool fits = best_->change == 0 && best_->moved == 0;
    if (fits || (r_[0] < 0 && law_.kind != FrictionLaw::fixed)) return std::move(*best_);
    if (dimension_ == 1 || (mu_ == 0 && law_.kind != FrictionLaw::fixed)) {
      try_frictionless();
    } else {
      try_tangential();
    }
    return std::move(*best_);
  }

 private:
  double cost(const FittedContact& c) const { return c.change + scale_ * c.moved; }

  void consider(ContactFit fit, std::vector<Rational> r, std::vector<Rational> u) {
    FittedContact found{fit, std::move(r), std::move(u)};
    for (std::size_t i = 0; i < dimension_; ++i) {
      found.moved = std::max(found.moved, upper_size(found.r[i] - to_rational(r_[i])));
      found.change = std::max(found.change, upper_size(found.u[i] - u_[i]));
    }
    if (!best_ || cost(found) < cost(*best_)) best_ = std::move(found);
  }

  Tangential r_T() const {
    Tangential t;
    for (std::size_t i = 1; i < dimension_; ++i) t.push_back(to_rational(r_[i]));
    return t;
  }
  Tangential u_T() const { return {u_.begin() + 1, u_.end()}; }
  std::vector<Rational> nothing() const { return std::vector<Rational>(dimension_); }

  void try_open() {
    std::vector<Rational> u(u_.begin(), u_.end());
    Rational least = 0;
    if (law_.kind == FrictionLaw::associated && dimension_ > 1) {
      const Rational mu = to_rational(mu_), square = mu * mu * dot(u_T(), u_T());
      if (u[0].sign() < 0 || u[0] * u[0] < square) least = root_above(square);
    }
    u[0] = std::max(u[0], least);
    if (law_.kind == FrictionLaw::fixed) return try_fixed(0, u[0]);
    consider(ContactFit::open, nothing(), std::move(u));
  }

  void try_frictionless() {
    std::vector<Rational> r(dimension_), u(u_.begin(), u_.end());
    r[0] = to_rational(r_[0]);
    u[0] = 0;
    consider(ContactFit::stick, std::move(r), std::move(u));
  }

  void try_tangential() {
    const Rational N = to_rational(r_[0]), bound = to_rational(mu_) * N;
    const std::vector<Rational> r = joined(N, 1, r_T());
    switch (law_.kind) {
      case FrictionLaw::fixed:
        return try_fixed(std::max(N, Rational(0)), 0);
      case FrictionLaw::associated:
        return try_associated();
      case FrictionLaw::regularised:
        return law_.function == Regularisation::linear ? try_linear(N, bound) : try_soft(N, bound);
      case FrictionLaw::diamond:
        if (dimension_ == 3) return try_diamond(r, bound);
        break;
      case FrictionLaw::cone:
        if (dimension_ == 3) return try_cone(r, bound);
        break;
      case FrictionLaw::box:
        break;
    }
    try_box(r, 0, Tangential(dimension_ - 1, bound));
  }

  /// Bounds on friction that do not depend on the normal force.
  void try_fixed(const Rational& normal, const Rational& velocity) {
    Tangential bounds;
    for (const double b : bounds_) bounds.push_back(to_rational(b));
    try_box(joined(normal, 1, r_T()), velocity, bounds);
  }

  /// On the edge of K with u on the edge of K*: r = N (1, mu d), u = s (mu, -d).
  void try_associated() {
    const Rational mu = to_rational(mu_), N = to_rational(r_[0]), weight = 1 + mu * mu;
    const Tangential force = r_T(), slip = u_T();
    if (dot(force, force) <= mu * mu * N * N) consider(ContactFit::stick, joined(N, 1, force), nothing());
    Tangential against = slip;
    for (Rational& x : against) x = -x;
    for (const Tangential& near : {force, against}) {
      const auto d = direction_of(near);
      if (!d) continue;
      const Rational on_edge = std::max(Rational((N + mu * dot(*d, force)) / weight), Rational(0));
      const Rational s = std::max(Rational((mu * u_[0] - dot(*d, slip)) / weight), Rational(0));
      consider(ContactFit::stick, joined(on_edge, mu * on_edge, *d), nothing());
      consider(ContactFit::slide, joined(on_edge, mu * on_edge, *d), joined(mu * s, -s, *d));
    }
  }

  /// On the graph of min(|u_T| / v_s, 1), from the velocity and from the force.
  void try_linear(const Rational& N, const Rational& bound) {
    const Rational speed = to_rational(law_.slip_speed);
    const Tangential force = r_T(), slip = u_T();
    if (dot(slip, slip) <= speed * speed) {
      consider(ContactFit::stick, joined(N, -bound / speed, slip), joined(0, 1, slip));
    } else {
      const Tangential d = *direction_of(slip);
      const Rational along = std::max(speed, Rational(dot(d, slip)));
      consider(ContactFit::slide, joined(N, -bound, d), joined(0, along, d));
    }
    if (!bound.is_zero() && dot(force, force) <= bound * bound) {
      consider(ContactFit::stick, joined(N, 1, force), joined(0, -speed / bound, force));
    }
  }

  /// On the graph of s / sqrt(1 + s^2), which has the rational points s = 2 t / (1 - t^2), f = 2 t / (1 + t^2).
  void try_soft(const Rational& N, const Rational& bound) {
    const Tangential force = r_T(), slip = u_T();
    const auto at = [&](double rest, const Tangential& d) {
      const Rational t = 1 - to_rational(rest);
      if (t.sign() < 0 || t >= 1) return;
      const Rational s = 2 * t / (1 - t * t), f = 2 * t / (1 + t * t);
      const ContactFit fit = s >= 1 ? ContactFit::slide : ContactFit::stick;
      consider(fit, joined(N, -bound * f, d), joined(0, to_rational(law_.slip_speed) * s, d));
    };
    if (const auto d = direction_of(slip)) {
      const double s = nearest_binary64(dot(*d, slip) / to_rational(law_.slip_speed)), root = std::hypot(1.0, s);
      at((1 + 1 / (root + s)) / (1 + root), *d);
    } else {
      consider(ContactFit::stick, joined(N, 0, force), nothing());
    }
    const auto d = direction_of(force);
    if (!d || bound.is_zero() || dot(force, force) >= bound * bound) return;
    const double f = std::min(1.0, nearest_binary64(dot(*d, force) / bound)), t = f / (1 + std::sqrt(1 - f * f));
    Tangential back = *d;
    for (Rational& x : back) x = -x;
    at(1 - t, back);
  }

  /// Each direction chooses among -1, 0 and 1 times its bound.
  void try_box(const std::vector<Rational>& r, const Rational& normal_velocity, const Tangential& bounds) {
    std::vector<Rational> fitted{r[0]}, u{normal_velocity};
    ContactFit fit = r[0].is_zero() ? ContactFit::open : ContactFit::stick;
    for (std::size_t i = 1; i < dimension_; ++i) {
      const Rational& bound = bounds[i - 1];
      // Either u_i = 0 and |r_i| <= bound, or r_i = -bound sign(u_i).
      const Rational held = std::clamp(r[i], Rational(-bound), bound);
      const Rational slid = u_[i].sign() > 0 ? Rational(-bound) : bound;
      const Rational scale = to_rational(scale_);
      const bool slides = scale * abs(slid - r[i]) < abs(u_[i]) + scale * abs(held - r[i]);
      if (slides && !r[0].is_zero()) fit = ContactFit::slide;
      fitted.push_back(slides ? slid : held);
      u.push_back(slides ? u_[i] : Rational(0));
    }
    consider(fit, std::move(fitted), std::move(u));
  }

  void try_cone(const std::vector<Rational>& r, const Rational& bound) {
    const double x = r_[1], y = r_[2];
    if (x == 0 && y == 0) return consider(ContactFit::stick, r, std::vector<Rational>(3));
    const bool inside = r[1] * r[1] + r[2] * r[2] <= bound * bound;
    if (inside) {
      consider(ContactFit::stick, r, std::vector<Rational>(3));
      // Sliding would have to move r to the edge: not where that is far.
      if (cost(*best_) < 0.5 * scale_ * (mu_ * r_[0] - std::hypot(x, y))) return;
    }
    const auto [cx, cy] = unit_direction(x, y);
    const std::vector<Rational> edge{r[0], bound * cx, bound * cy};
    if (!inside) consider(ContactFit::stick, edge, std::vector<Rational>(3));
    const Rational along = std::min(Rational(cx * u_[1] + cy * u_[2]), Rational(0));
    consider(ContactFit::slide, edge, {Rational(0), along * cx, along * cy});
  }

  void try_diamond(const std::vector<Rational>& r, const Rational& bound) {
    const Rational size = abs(r[1]) + abs(r[2]);
    const int s1 = r[1].sign() < 0 ? -1 : 1, s2 = r[2].sign() < 0 ? -1 : 1;
    // Back onto the nearest edge along its normal, a little further where that leaves the edge.
    const Rational excess = (size - bound) / 2;
    const Rational t1 = std::clamp(Rational(abs(r[1]) - excess), Rational(0), bound);
    const std::vector<Rational> edge{r[0], s1 * t1, s2 * (bound - t1)};
    consider(ContactFit::stick, size <= bound ? r : edge, std::vector<Rational>(3));
    // An edge's normal is (s1, s2): u_T = -s (s1, s2).
    const Rational s = std::max(Rational(-(s1 * u_[1] + s2 * u_[2]) / 2), Rational(0));
    consider(ContactFit::slide, edge, {Rational(0), -s * s1, -s * s2});
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {  // a corner: all between two normals
      const std::size_t other = 3 - i;
      const int sign = u_[i].sign() > 0 ? 1 : -1;
      std::vector<Rational> corner{r[0], Rational(0), Rational(0)}, u(3);
      corner[i] = -sign * bound;
      u[i] = u_[i];
      u[other] = std::clamp(u_[other], Rational(-abs(u_[i])), Rational(abs(u_[i])));
      consider(ContactFit::slide, std::move(corner), std::move(u));
    }
  }

  const ContactLaw& law_;
  std::size_t dimension_;
  double mu_, scale_;
  std::span<const double> r_;
  std::span<const Rational> u_;
  std::span<const double> bounds_;
  std::optional<FittedContact> best_;
};

}  // namespace

FittedContact fit_contact(const ContactLaw& law, const ContactAnswer& answer) {
  return ContactFitter(law, answer).fit();
}

namespace {

std::pair<std::string_view, std::string_view> conditions_of_pyramid(bool box, ContactFit fit) {
  if (fit == ContactFit::stick) {
    return {"u = 0 where the contact sticks",
            box ? "max |r_i| <= mu r_n over tangential i" : "|r_1| + |r_2| <= mu r_n"};
  }
  if (box)
    return {"u_n = 0, each u_i opposite to r_i where the contact slides",
            "|r_i| = mu r_n in each direction i that slides"};
  return {"u_n = 0, r_t . u_t = -mu r_n max |u_i| where the contact slides",
          "|r_1| + |r_2| = mu r_n where the contact slides"};
}

}  // namespace

std::pair<std::string_view, std::string_view> conditions_of(FrictionLaw law, ContactFit fit, std::size_t dimension) {
  const bool associated = law == FrictionLaw::associated, fixed = law == FrictionLaw::fixed;
  if (law == FrictionLaw::regularised && dimension > 1 && fit != ContactFit::open) {
    constexpr std::string_view graph = "r_t = -mu r_n f(|u_t| / v_s) u_t / |u_t|";
    return {graph, graph};
  }
  const bool faces = dimension == 3 && (law == FrictionLaw::box || law == FrictionLaw::diamond);
  if (faces && fit != ContactFit::open) return conditions_of_pyramid(law == FrictionLaw::box, fit);
  switch (fit) {
    case ContactFit::open:
      return {associated && dimension > 1 ? "u_n >= mu |u_t|" : "u_n >= 0",
              fixed ? "r_n = 0 where the contact opens" : "r = 0 where the contact opens"};
    case ContactFit::stick:
      return {dimension == 1 ? "w = 0 where z > 0" : "u = 0 where the contact sticks",
              fixed ? "|r_t| <= its bound" : "|r_t| <= mu r_n"};
    default:
      return {associated ? "u_n = mu |u_t|, u_t opposite to r_t where the contact slides"
                         : "u_n = 0, u_t opposite to r_t where the contact slides",
              fixed ? "|r_t| = its bound where the contact slides" : "|r_t| = mu r_n where the contact slides"};
  }
}

std::pair<Rational, Rational> unit_direction(double x, double y) {
  // The tangent of half the angle to the nearer axis is at most 1, and any value of it is rational.
  const bool steep = std::abs(y) > std::abs(x);
  const double near = std::abs(steep ? y : x), far = steep ? x : y;
  const double ratio = far / near;
  const Rational t = to_rational(ratio / (1 + std::hypot(1.0, ratio)));
  const Rational square = t * t;
  const Rational cosine = (1 - square) / (1 + square) * ((steep ? y : x) < 0 ? -1 : 1), sine = 2 * t / (1 + square);
  if (steep) return {sine, cosine};
  return {cosine, sine};
}

}  // namespace slipproof
