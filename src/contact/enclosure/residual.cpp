#include "contact/enclosure/residual.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"
#include "contact/enclosure/sizes.hpp"
#include "contact/linear/rounding.hpp"

namespace slipproof {

namespace {

double upper(const Rational& x) {
  return enclose(x).upper;
}

double upper_size(const Rational& x) {
  return upper(abs(x));
}

/// A contact with its r and u; the fits are compared by what they change, velocities moved by the contact's own forces
/// included.
class ContactJudge {
 public:
  ContactJudge(std::size_t dimension, double mu, double scale, FrictionLaw law)
      : dimension_(dimension), mu_(mu), scale_(scale), law_(law) {}

  FittedContact fit(std::span<const double> r, std::vector<Rational> u) {
    r_ = r;
    u_ = std::move(u);
    best_.reset();
    try_open();
    if (best_->change == 0 && best_->moved == 0) return std::move(*best_);
    if (r_[0] >= 0) {
      if (dimension_ == 1 || mu_ == 0) {
        try_frictionless();
      } else {
        try_tangential();
      }
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

  void try_open() {
    std::vector<Rational> u = u_;
    if (u[0].sign() < 0) u[0] = 0;
    consider(ContactFit::open, std::vector<Rational>(dimension_), std::move(u));
  }

  void try_frictionless() {
    std::vector<Rational> r(dimension_), u = u_;
    r[0] = to_rational(r_[0]);
    u[0] = 0;
    consider(ContactFit::stick, std::move(r), std::move(u));
  }

  /// Planar friction, and each direction of the box, chooses among -1, 0 and 1 times the bound; the diamond also has
  /// its edges, the cone all directions.
  void try_tangential() {
    const Rational N = to_rational(r_[0]), bound = to_rational(mu_) * N;
    std::vector<Rational> r{N}, u(dimension_);
    for (std::size_t i = 1; i < dimension_; ++i) r.push_back(to_rational(r_[i]));
    if (dimension_ == 2 || law_ == FrictionLaw::box) {
      try_box(r, bound);
    } else if (law_ == FrictionLaw::diamond) {
      try_diamond(r, bound);
    } else {
      try_cone(r, bound);
    }
  }

  void try_box(const std::vector<Rational>& r, const Rational& bound) {
    std::vector<Rational> fitted{r[0]}, u(1);
    ContactFit fit = ContactFit::stick;
    for (std::size_t i = 1; i < dimension_; ++i) {
      // Either u_i = 0 and |r_i| <= bound, or r_i = -bound sign(u_i).
      const Rational held = std::clamp(r[i], Rational(-bound), bound);
      const Rational slid = u_[i].sign() > 0 ? Rational(-bound) : bound;
      const Rational scale = to_rational(scale_);
      const bool slides = scale * abs(slid - r[i]) < abs(u_[i]) + scale * abs(held - r[i]);
      if (slides) fit = ContactFit::slide;
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

  std::size_t dimension_;
  double mu_, scale_;
  FrictionLaw law_;
  std::span<const double> r_;
  std::vector<Rational> u_;
  std::optional<FittedContact> best_;
};

/// What a contact violates, by the way it fits best.
void add_violations(std::vector<Violation>& to, std::size_t k, const FittedContact& c, double scale) {
  const auto add = [&](const char* condition, double amount, double effect) {
    if (amount > 0) to.push_back({k, 0, condition, amount, amount * effect});
  };
  switch (c.fit) {
    case ContactFit::open:
      add("u_n >= 0", c.change, 1);
      add("r = 0 where the contact opens", c.moved, scale);
      break;
    case ContactFit::stick:
      add(c.u.size() == 1 ? "w = 0 where z > 0" : "u = 0 where the contact sticks", c.change, 1);
      add("|r_t| <= mu r_n", c.moved, scale);
      break;
    case ContactFit::slide:
      add("u_n = 0, u_t opposite to r_t where the contact slides", c.change, 1);
      add("|r_t| = mu r_n where the contact slides", c.moved, scale);
      break;
  }
}

/// How fast an answer's forces would move its contacts; 1 if there are none.
double velocity_of_forces(const MixedProblem& problem, std::span<const double> x, const std::vector<double>& scales) {
  double largest = 0;
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    for (const double r : x.subspan(problem.normal(k), problem.dimension)) {
      largest = std::max(largest, std::abs(r) * scales[k]);
    }
  }
  return largest > 0 ? largest : 1;
}

}  // namespace

std::string_view name(FrictionLaw law) {
  switch (law) {
    case FrictionLaw::box:
      return "box pyramid |t1| <= mu n, |t2| <= mu n";
    case FrictionLaw::diamond:
      return "diamond pyramid |t1| + |t2| <= mu n";
    default:
      return "friction cone";
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

std::vector<double> contact_scales(const MixedProblem& problem) {
  std::vector<double> diagonal(problem.free, 0);
  for (std::size_t i = 0; i < problem.free; ++i) {
    const auto columns = problem.A.columns_of(i);
    for (std::size_t e = 0; e < columns.size(); ++e) {
      if (columns[e] == i) diagonal[i] = std::abs(problem.A.values_of(i)[e]);
    }
  }
  std::vector<double> scales;
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const std::size_t first = problem.normal(k), end = first + problem.dimension;
    double block = 0, through_free = 0;
    for (std::size_t i = first; i < end; ++i) {
      const auto columns = problem.A.columns_of(i);
      const auto values = problem.A.values_of(i);
      double row = 0, other = 0;
      for (std::size_t e = 0; e < columns.size(); ++e) {
        if (columns[e] >= first && columns[e] < end) row += std::abs(values[e]);
        if (columns[e] < problem.free && diagonal[columns[e]] > 0)
          other += values[e] * values[e] / diagonal[columns[e]];
      }
      block = std::max(block, row);
      through_free = std::max(through_free, other);
    }
    const double scale = block + through_free;
    scales.push_back(scale > 0 && std::isfinite(scale) ? scale : 1);
  }
  return scales;
}

Residual residual(const MixedProblem& problem, std::span<const double> x, std::span<const Rational> w,
                  FrictionLaw law) {
  Residual result;
  const std::size_t d = problem.dimension;
  const std::vector<double> scales = contact_scales(problem);
  const ContactSizes sizes = contact_sizes(problem);
  const FreeSizes free = free_sizes(problem, sizes.force);
  result.scale = sizes.velocity > 0 ? sizes.velocity : velocity_of_forces(problem, x, scales);
  std::vector<double> moved(problem.size(), 0), change(problem.size(), 0);
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    stop_if_asked();
    const std::size_t first = problem.normal(k);
    const auto u = w.subspan(first, d);
    ContactJudge judge(d, problem.mu[k], scales[k], law);
    result.contacts.push_back(judge.fit(x.subspan(first, d), {u.begin(), u.end()}));
    const FittedContact& c = result.contacts.back();
    for (std::size_t i = 0; i < d; ++i) {
      moved[first + i] = c.moved;
      change[first + i] = c.change;
    }
    add_violations(result.worst, k, c, scales[k]);
    result.moved = std::max(result.moved, c.moved);
  }
  for (std::size_t i = 0; i < problem.free; ++i) {
    change[i] = upper_size(w[i]);
    const double effect = change[i] * (free.rows[i] > 0 ? result.scale / free.rows[i] : 1);
    if (change[i] > 0) result.worst.push_back({std::nullopt, i, "equation", change[i], effect});
  }
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const auto columns = problem.A.columns_of(i);
    const auto values = problem.A.values_of(i);
    double sum = change[i];
    for (std::size_t e = 0; e < columns.size(); ++e) sum += std::abs(values[e]) * moved[columns[e]];
    if (sum > 0) sum = rounded_up(sum, columns.size()) + underflow_of(columns.size());
    result.change = std::max(result.change, sum);
    const double size = i < problem.free ? free.rows[i] : result.scale;
    if (sum > 0) result.relative = std::max(result.relative, sum / size);
  }
  std::stable_sort(result.worst.begin(), result.worst.end(),
                   [](const Violation& a, const Violation& b) { return a.effect > b.effect; });
  if (result.worst.size() > 10) result.worst.resize(10);
  return result;
}

}  // namespace slipproof
