#include "contact/complete/program.hpp"

#include <algorithm>
#include <cmath>
#include <coin/ClpSimplex.hpp>
#include <numbers>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;

constexpr double small = 1e-9;       ///< what rounding may have made of 0
constexpr double most_slack = 1e-8;  ///< by which equations may fail, so that a program with a point has it still
/// What conditions keep, so that multipliers can be rounded, and to how many bits after the leading one of the largest.
struct Precision {
  double margin;
  int places;
  double tolerance;  ///< of the program
};
constexpr std::array<Precision, 2> precisions{{{0x1p-18, 24, 1e-9}, {0x1p-34, 46, 1e-12}}};
constexpr std::size_t polygon = 8;  ///< sides around a circle to begin with
constexpr int most_cuts = 40;       ///< times that a polygon is refined

double power_near(double x) {
  return x > 0 && std::isfinite(x) ? std::exp2(std::nearbyint(std::log2(x))) : 1;
}

}  // namespace

FloatingContacts::FloatingContacts(const ExactContacts& contacts) : dimension(contacts.dimension) {
  for (const auto& row : contacts.W) {
    std::vector<double>& own = W.emplace_back();
    for (const Rational& a : row) own.push_back(a.to_double());
  }
  for (const Rational& x : contacts.q) q.push_back(x.to_double());
  for (const Rational& m : contacts.mu) mu.push_back(m.to_double());
}

PatternProgram::PatternProgram(const ExactContacts& exact, const IntegerContacts& integers,
                               const FloatingContacts& contacts, const ContactPattern& pattern)
    : exact_(exact), integers_(integers), contacts_(contacts), pattern_(pattern), tangents_(pattern.size()) {
  for (auto& angles : tangents_) {
    for (std::size_t i = 0; i < polygon; ++i) angles.push_back(2 * std::numbers::pi * static_cast<double>(i) / polygon);
  }
}

void PatternProgram::add_cones() {
  edges_.clear();
  for (std::size_t k = 0; k < pattern_.size(); ++k) {
    const ContactState& state = pattern_[k];
    const std::size_t normal = contacts_.normal(k);
    if (state.kind == Kind::any || state.kind == Kind::open) edges_.push_back({normal, false, false, {1, 0, 0}});
    if (state.kind == Kind::slip) {
      for (const Direction* d : {&state.from, &state.to}) {
        if (d == &state.to && state.from == state.to) break;
        edges_.push_back({normal, false, true, {0, std::cos(d->angle()), std::sin(d->angle())}});
      }
    }
    if (state.kind == Kind::open) continue;
    if (!exact_.has_friction(k)) {
      edges_.push_back({normal, true, state.kind != Kind::any, {1, 0, 0}});
    } else if (state.kind == Kind::slip) {
      add_arc(k);
    } else {
      add_polygon(k);
    }
  }
}

/// Around the circle of forces: corners where neighbouring tangents meet.
void PatternProgram::add_polygon(std::size_t k) {
  const bool strict = pattern_[k].kind != Kind::any;
  const std::size_t normal = contacts_.normal(k);
  const double mu = contacts_.mu[k];
  if (contacts_.dimension == 2) {
    for (const double side : {1.0, -1.0}) edges_.push_back({normal, true, strict, {1, side * mu, 0}});
    return;
  }
  const std::vector<double>& angles = tangents_[k];
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * std::numbers::pi;
    const double half = (next - angles[i]) / 2, middle = angles[i] + half, radius = mu / std::cos(half);
    edges_.push_back({normal, true, strict, {1, radius * std::cos(middle), radius * std::sin(middle)}});
  }
}

/// Around the arc of forces against the slip: its ends, and corners between them.
void PatternProgram::add_arc(std::size_t k) {
  const std::size_t normal = contacts_.normal(k);
  const double mu = contacts_.mu[k], from = pattern_[k].from.angle();
  double width = pattern_[k].to.angle() - from;
  if (width < 0) width += 2 * std::numbers::pi;
  const auto add = [&](double angle, double radius) {
    edges_.push_back({normal, true, true, {1, -mu * radius * std::cos(angle), -mu * radius * std::sin(angle)}});
  };
  add(from, 1);
  if (contacts_.dimension == 2) return;
  const double corner = 1 / std::cos(width / 4);
  add(from + width / 4, corner);
  add(from + width * 3 / 4, corner);
  add(from + width, 1);
}

/// Rows in which any u is allowed: their multiplier is that of the form.
bool PatternProgram::is_fixed_row(std::size_t row) const {
  const Kind kind = pattern_[row / contacts_.dimension].kind;
  return row % contacts_.dimension != 0 && kind != Kind::stick && kind != Kind::slip;
}

/// u - W r + slack = q.
void PatternProgram::build() {
  const std::size_t n = contacts_.size();
  std::vector<ColumnProgram::Column> columns;
  for (const Edge& edge : edges_) {
    ColumnProgram::Column& column = columns.emplace_back();
    for (std::size_t i = 0; i < n; ++i) {
      double value = 0;
      for (std::size_t t = 0; t < contacts_.dimension; ++t) {
        if (edge.force) value -= contacts_.W[i][edge.normal + t] * edge.v[t];
        if (!edge.force && i == edge.normal + t) value = edge.v[t];
      }
      if (value != 0) column.push_back({static_cast<int>(i), value});
    }
  }
  std::vector<bool> free_rows;
  for (std::size_t i = 0; i < n; ++i) free_rows.push_back(is_fixed_row(i));
  program_ = std::make_unique<ColumnProgram>(contacts_.q, free_rows, columns);
}

bool PatternProgram::solve(double tolerance) {
  ++solved_;
  return program_->solve(tolerance);
}

ProposedPoint PatternProgram::point() const {
  ProposedPoint result{std::vector<double>(contacts_.size()), std::vector<double>(contacts_.q)};
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const double value = program_->value(e);
    for (std::size_t t = 0; edges_[e].force && t < contacts_.dimension; ++t) {
      result.r[edges_[e].normal + t] += value * edges_[e].v[t];
    }
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    for (std::size_t j = 0; j < contacts_.size(); ++j) result.u[i] += contacts_.W[i][j] * result.r[j];
  }
  return result;
}

std::vector<double> PatternProgram::duals() const {
  std::vector<double> y;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    y.push_back(program_->price(i));
  }
  return y;
}

/// Adds a tangent where the point's force is outside of the true cone; false if it is nowhere.
bool PatternProgram::cut(const ProposedPoint& point) {
  bool cuts = false;
  for (std::size_t k = 0; k < pattern_.size() && contacts_.dimension == 3; ++k) {
    const std::size_t i = contacts_.normal(k);
    if (!exact_.has_friction(k) || pattern_[k].kind == Kind::slip || pattern_[k].kind == Kind::open) continue;
    const double force = std::hypot(point.r[i + 1], point.r[i + 2]);
    if (force <= contacts_.mu[k] * point.r[i] * (1 + 1e-9) + small) continue;
    double angle = std::atan2(point.r[i + 2], point.r[i + 1]);
    if (angle < 0) angle += 2 * std::numbers::pi;
    std::vector<double>& angles = tangents_[k];
    angles.insert(std::lower_bound(angles.begin(), angles.end(), angle), angle);
    cuts = true;
  }
  return cuts;
}

double PatternProgram::column_cost(const Edge& edge, std::span<const double> f, std::span<const double> h) const {
  double cost = 0;
  for (std::size_t t = 0; t < contacts_.dimension; ++t) {
    const std::size_t i = edge.normal + t;
    cost += (edge.force ? h.empty() ? 0 : h[i] : f.empty() ? 0 : f[i]) * edge.v[t];
  }
  return cost;
}

/// In short numbers. What is within `small` of 0, or of the form where that is a condition,
/// is that.
std::vector<Rational> PatternProgram::rounded(std::span<const double> y, std::span<const double> f,
                                              const ContactForm& form, int places) const {
  double largest = 0;
  for (const double x : y) largest = std::max(largest, std::abs(x));
  const double step = largest > 0 ? std::ldexp(power_near(largest), -places) : 1;
  std::vector<Rational> result;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double own = f.empty() ? 0 : f[i];
    const bool at_form = is_fixed_row(i) || std::abs(y[i] - own) < small;
    const double value = at_form ? 0 : std::nearbyint(y[i] / step) * step;
    result.push_back(to_rational(value));
    if (!at_form) continue;
    for (const auto& [j, exactly] : form.u) {
      if (j == i) result.back() = exactly;
    }
  }
  return result;
}

PatternProgram::Feasibility PatternProgram::feasibility() {
  ProposedPoint nearest;
  for (int round = 0; round <= most_cuts; ++round) {
    add_cones();
    build();
    if (!solve(precisions[0].tolerance)) return {};
    nearest = point();
    if (program_->least() > small) break;
    if (round == most_cuts || !cut(nearest)) return {std::move(nearest), {}};
  }
  if (!prove_empty().empty()) return {std::move(nearest), proved_};
  return {std::move(nearest), {}};
}

/// Multipliers that prove that the program, which has no point, has none: first in few digits and quickly.
const std::vector<Rational>& PatternProgram::prove_empty() {
  const std::vector<double> y = duals();
  for (const Precision& precision : precisions) {
    set_costs({}, {}, precision.margin);
    if (!solve(precision.tolerance) || program_->least() <= 0) continue;
    proved_ = rounded(duals(), {}, {}, precision.places);
    if (proves_empty(exact_, integers_, pattern_, proved_)) return proved_;
  }
  const std::vector<double> zero(contacts_.size());
  proved_ = on_face(y, zero, zero, {});
  if (!proves_empty(exact_, integers_, pattern_, proved_)) proved_.clear();
  return proved_;
}

/// Of edges the value of the form along them, less what is kept.
void PatternProgram::set_costs(std::span<const double> f, std::span<const double> h, double kept) {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    program_->set_cost(e, column_cost(edges_[e], f, h) - kept);
  }
}

/// A form in binary64, by components of u and of r.
struct DenseForm {
  std::vector<double> f, h;
  double size = small;

  DenseForm(const ContactForm& form, std::size_t n) : f(n), h(n) {
    for (const auto& [i, value] : form.u) f[i] = value.to_double();
    for (const auto& [i, value] : form.r) h[i] = value.to_double();
    for (std::size_t i = 0; i < n; ++i) size = std::max({size, std::abs(f[i]), std::abs(h[i])});
    for (double& x : f) x /= size;
    for (double& x : h) x /= size;
  }
};

/// The multipliers of the least value of a form, less what edges keep. u in rows that may take any value is W r + q:
/// its share goes to the forces.
std::optional<std::vector<double>> PatternProgram::least_duals(std::span<const double> f, std::span<const double> h,
                                                               double kept, bool exactly, double slack) {
  const std::size_t n = contacts_.size();
  std::vector<double> forces(h.begin(), h.end());
  program_->bound_slacks(slack);
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_fixed_row(i) || f[i] == 0) continue;
    for (std::size_t j = 0; j < n; ++j) forces[j] += contacts_.W[i][j] * f[i];
  }
  set_costs(f, forces, kept);
  if (!solve(exactly ? precisions[1].tolerance : precisions[0].tolerance)) return std::nullopt;
  std::vector<double> y = duals();
  for (std::size_t i = 0; i < n; ++i) {
    if (is_fixed_row(i)) y[i] = f[i];
  }
  return y;
}

std::vector<Rational> PatternProgram::prove_least(const ContactForm& form, const Rational& least) {
  const DenseForm dense(form, contacts_.size());
  std::vector<double> f = dense.f, h = dense.h;
  for (double& x : f) x *= dense.size;
  for (double& x : h) x *= dense.size;
  const auto proves = [&](const std::vector<Rational>& y) {
    const auto bound = lower_bound(exact_, integers_, pattern_, form, y);
    return bound && bound->value >= least;
  };
  const double wanted = least.to_double() / dense.size;
  for (const bool exactly : {false, true}) {
    auto y = least_duals(dense.f, dense.h, exactly ? 0 : precisions[0].margin, exactly);
    if (!y && !exactly) y = least_duals(dense.f, dense.h, precisions[0].margin, false, most_slack);
    if (!y) continue;
    const double found = value_of(*y);
    for (double& x : *y) x *= dense.size;
    std::vector<Rational> proposed = exactly ? on_face(*y, f, h, form) : rounded(*y, f, form, precisions[0].places);
    if (!proposed.empty() && proves(proposed)) return proposed;
    if (found < wanted - 1e-4 * (1 + std::abs(wanted))) return {};
  }
  return {};
}

double PatternProgram::value_of(std::span<const double> y) const {
  double value = 0;
  for (std::size_t i = 0; i < y.size(); ++i) value += y[i] * contacts_.q[i];
  return value;
}

std::vector<Rational> PatternProgram::strict_multipliers(const ProposedPoint& point) {
  constexpr double none = 1e-7;  // below which a point says that something may be impossible
  for (std::size_t k = 0; k < pattern_.size(); ++k) {
    const ContactState& state = pattern_[k];
    const std::size_t i = contacts_.normal(k);
    if (state.kind == Kind::any || state.kind == Kind::open) continue;
    std::vector<Rational> y;
    if (state.kind == Kind::slip &&
        std::abs(point.u[i + 1]) + (contacts_.dimension > 2 ? std::abs(point.u[i + 2]) : 0) < none) {
      ContactForm form;
      const Rational a(state.from.length), b(state.to.length);
      form.u.emplace_back(i + 1, -(Rational(state.from.x) / a + Rational(state.to.x) / b));
      if (contacts_.dimension > 2) form.u.emplace_back(i + 2, -(Rational(state.from.y) / a + Rational(state.to.y) / b));
      y = excluded(std::move(form));
    }
    if (y.empty() && point.r[i] < none) y = excluded({{}, {{i, Rational(-1)}}});
    if (!y.empty() && proves_empty(exact_, integers_, pattern_, y)) return y;
  }
  return {};
}

/// The least of side * t / a, where t and a are the parts of u_T or -r_T across and along a direction and a >= 0, by
/// Dinkelbach's method: a zero of the least of side * t - slope * a.
std::optional<double> PatternProgram::least_slope(bool forces, std::size_t row, double middle, double side,
                                                  double start) {
  const std::size_t n = contacts_.size();
  const double c = std::cos(middle), s = std::sin(middle), sign = forces ? -1 : 1;
  double slope = start;
  for (int step = 0; step < 3; ++step) {
    std::vector<double> form(n);
    form[row + 1] = sign * (-side * s - slope * c);
    form[row + 2] = sign * (side * c - slope * s);
    const std::vector<double> zero(n);
    if (!least_duals(forces ? zero : form, forces ? form : zero, 0)) return std::nullopt;
    const ProposedPoint corner = point();
    const double x = sign * (forces ? corner.r : corner.u)[row + 1], y = sign * (forces ? corner.r : corner.u)[row + 2];
    const double along = c * x + s * y, across = side * (c * y - s * x);
    if (along < small) return step > 0 ? std::optional(slope) : std::nullopt;
    const double next = across / along;
    const bool settled = std::abs(next - slope) < 0.02;
    slope = next;
    if (settled) break;
  }
  return slope;
}

std::array<double, 2> PatternProgram::directions(std::size_t k) {
  const double from = pattern_[k].from.angle();
  double width = pattern_[k].to.angle() - from;
  if (width < 0) width += 2 * std::numbers::pi;
  const double middle = from + width / 2, edge = std::tan(width / 2);
  std::array<double, 2> range{0, 1};
  for (const bool forces : {true, false}) {
    for (const double side : {1.0, -1.0}) {
      const auto slope = least_slope(forces, contacts_.normal(k), middle, side, 0);
      if (!slope) continue;
      const double share = 0.5 + side * std::atan(std::clamp(*slope, -edge, edge)) / width;
      if (side > 0) range[0] = std::max(range[0], share);
      if (side < 0) range[1] = std::min(range[1], share);
    }
  }
  return range;
}

ProposedPoint PatternProgram::middle() {
  const std::size_t n = contacts_.size();
  ProposedPoint sum{std::vector<double>(n), std::vector<double>(n)};
  const std::vector<double> zero(n);
  double points = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (pattern_[i / contacts_.dimension].kind == Kind::open) continue;
    for (const double side : {1.0, -1.0}) {
      std::vector<double> h(n);
      h[i] = side;
      if (!least_duals(zero, h, 0)) continue;  // without a bound
      const ProposedPoint corner = point();
      for (std::size_t j = 0; j < n; ++j) sum.r[j] += corner.r[j], sum.u[j] += corner.u[j];
      ++points;
    }
  }
  for (std::size_t j = 0; j < n && points > 0; ++j) sum.r[j] /= points, sum.u[j] /= points;
  return sum;
}

/// Multipliers that should prove that a form, which would be negative, is at least 0.
std::vector<Rational> PatternProgram::excluded(ContactForm form) {
  const DenseForm dense(form, contacts_.size());
  const auto y = least_duals(dense.f, dense.h, 0);
  if (!y || program_->least() < -small) return {};
  std::vector<Rational> exact = on_face(*y, dense.f, dense.h, form);
  return exact;
}

/// Multipliers near y that satisfy exactly what y satisfies with equality: a linear system, whose free unknowns are
/// rounded.
std::vector<Rational> PatternProgram::on_face(std::span<const double> y, std::span<const double> f,
                                              std::span<const double> h, const ContactForm& form) const {
  constexpr double active = 1e-8;
  const std::size_t n = contacts_.size(), dimension = contacts_.dimension;
  double size = 1;
  for (const auto& [i, value] : form.u) size = std::max(size, std::abs(value.to_double()));
  std::vector<Rational> own_f(n), own_h(n);
  for (const auto& [i, value] : form.u) own_f[i] = value;
  for (const auto& [i, value] : form.r) own_h[i] = value;
  RationalMatrix system;  // rows: coefficients of y, then the right-hand side
  const auto add_velocity = [&](std::size_t i, const std::array<Rational, 2>& d, std::size_t parts) {
    std::vector<Rational>& row = system.emplace_back(n + 1);
    for (std::size_t t = 0; t < parts; ++t) row[i + t] = d[t], row[n] += d[t] * own_f[i + t];
  };
  const auto add_force = [&](std::size_t i, const std::array<Rational, 3>& r) {
    std::vector<Rational>& row = system.emplace_back(n + 1);
    for (std::size_t t = 0; t < dimension; ++t) {
      if (r[t].is_zero()) continue;
      for (std::size_t j = 0; j < n; ++j) row[j] += r[t] * exact_.W[j][i + t];
      row[n] -= r[t] * own_h[i + t];
    }
  };
  std::vector<double> g(h.begin(), h.end());
  double value = 0;
  for (std::size_t i = 0; i < n; ++i) {
    value += y[i] * contacts_.q[i];
    for (std::size_t j = 0; j < n; ++j) g[j] += contacts_.W[i][j] * y[i];
  }
  if (std::abs(value) < active) {
    std::vector<Rational>& row = system.emplace_back(exact_.q);
    row.emplace_back(0);
  }
  for (std::size_t k = 0; k < pattern_.size(); ++k) {
    const ContactState& state = pattern_[k];
    const std::size_t i = contacts_.normal(k);
    const auto slack = [&](const Direction& d) {
      const double angle = d.angle();
      double sum = (f[i + 1] - y[i + 1]) * std::cos(angle);
      if (dimension > 2) sum += (f[i + 2] - y[i + 2]) * std::sin(angle);
      return sum;
    };
    if ((state.kind == Kind::any || state.kind == Kind::open) && std::abs(f[i] - y[i]) < active)
      add_velocity(i, {Rational(1), Rational(0)}, 1);
    for (std::size_t t = 1; t < dimension; ++t) {
      if (is_fixed_row(i + t)) add_velocity(i + t, {Rational(1), Rational(0)}, 1);
    }
    if (state.kind == Kind::slip) {
      for (const Direction& d : {state.from, state.to}) {
        if (std::abs(slack(d)) < active) add_velocity(i + 1, {Rational(d.x), Rational(d.y)}, dimension - 1);
      }
    }
    if (state.kind == Kind::open) continue;
    double largest = 0;
    for (std::size_t t = 0; t < (exact_.has_friction(k) ? dimension : 1); ++t)
      largest = std::max(largest, std::abs(g[i + t]));
    if (largest < active) {
      for (std::size_t t = 0; t < (exact_.has_friction(k) ? dimension : 1); ++t) {
        std::array<Rational, 3> r{};
        r[t] = 1;
        add_force(i, r);
      }
    } else if (state.kind == Kind::slip && exact_.has_friction(k)) {
      for (const Direction& d : {state.from, state.to}) {
        const double angle = d.angle();
        double sum = g[i] - contacts_.mu[k] * g[i + 1] * std::cos(angle);
        if (dimension > 2) sum -= contacts_.mu[k] * g[i + 2] * std::sin(angle);
        if (std::abs(sum) < active)
          add_force(i, {Rational(d.length), -exact_.mu[k] * Rational(d.x), -exact_.mu[k] * Rational(d.y)});
      }
    } else if (dimension == 2 && exact_.has_friction(k)) {
      for (const int side : {1, -1}) {
        if (std::abs(g[i] + side * contacts_.mu[k] * g[i + 1]) < active)
          add_force(i, {Rational(1), side * exact_.mu[k], Rational(0)});
      }
    }
  }
  if (system.empty()) return rounded(y, f, form, 24);
  const Echelon echelon = eliminate(system);
  if (echelon.rank(n) != echelon.rank()) return {};
  std::vector<Rational> result(n);
  std::vector<bool> is_pivot(n, false);
  for (const std::size_t j : echelon.pivot_columns) is_pivot[j] = true;
  for (std::size_t j = 0; j < n; ++j) {
    if (!is_pivot[j]) result[j] = to_rational(std::nearbyint(std::ldexp(y[j], 24)) * 0x1p-24);
  }
  for (std::size_t p = 0; p < echelon.rank(); ++p) {
    Rational sum(echelon.rows[p][n]);
    for (std::size_t j = 0; j < n; ++j) {
      if (!is_pivot[j] && !echelon.rows[p][j].is_zero()) sum -= Rational(echelon.rows[p][j]) * result[j];
    }
    result[echelon.pivot_columns[p]] = sum / Rational(echelon.pivot);
  }
  return result;
}

}  // namespace slipproof
