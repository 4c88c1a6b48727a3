#include "contact/complete/program/pattern_program.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slipproof {

namespace {

using Kind = ContactState::Kind;

constexpr std::size_t polygon = 8;         ///< sides around a circle to begin with
constexpr std::size_t inner_polygon = 64;  ///< corners within a circle
constexpr double inner_radius = 1 - 0x1p-14;
constexpr int most_cuts = 40;  ///< times that a polygon is refined

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
                               const FloatingContacts& contacts, const ContactPattern& pattern, Cones cones)
    : exact_(exact),
      integers_(integers),
      contacts_(contacts),
      pattern_(pattern),
      cones_(cones),
      tangents_(pattern.size()) {
  const std::size_t sides = cones == Cones::within ? inner_polygon : polygon;
  for (auto& angles : tangents_) {
    for (std::size_t i = 0; i < sides; ++i) {
      angles.push_back(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides));
    }
  }
}

void PatternProgram::add_cones() {
  edges_.clear();
  for (std::size_t k = 0; k < pattern_.size(); ++k) {
    const ContactState& state = pattern_[k];
    const std::size_t normal = contacts_.normal(k);
    if (state.kind == Kind::any || state.kind == Kind::open) edges_.push_back({normal, false, {1, 0, 0}});
    if (state.kind == Kind::slip) {
      for (const Direction* d : {&state.from, &state.to}) {
        if (d == &state.to && state.from == state.to) break;
        edges_.push_back({normal, false, {0, std::cos(d->angle()), std::sin(d->angle())}});
      }
    }
    if (state.kind == Kind::open) continue;
    if (!exact_.has_friction(k)) {
      edges_.push_back({normal, true, {1, 0, 0}});
    } else if (state.kind == Kind::slip) {
      add_arc(k);
    } else {
      add_polygon(k);
    }
  }
}

/// Around the circle of forces: corners where neighbouring tangents meet. Within it: corners at these angles.
void PatternProgram::add_polygon(std::size_t k) {
  const std::size_t normal = contacts_.normal(k);
  const double mu = contacts_.mu[k];
  if (contacts_.dimension == 2) {
    for (const double side : {1.0, -1.0}) edges_.push_back({normal, true, {1, side * mu, 0}});
    return;
  }
  const std::vector<double>& angles = tangents_[k];
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * std::numbers::pi;
    const double half = (next - angles[i]) / 2, middle = angles[i] + half;
    const double radius = mu * (cones_ == Cones::within ? inner_radius : 1 / std::cos(half));
    edges_.push_back({normal, true, {1, radius * std::cos(middle), radius * std::sin(middle)}});
  }
}

/// Around the arc of forces against the slip: its ends, and corners between them.
void PatternProgram::add_arc(std::size_t k) {
  const std::size_t normal = contacts_.normal(k);
  const double mu = contacts_.mu[k], from = pattern_[k].from.angle(), width = pattern_[k].width();
  const auto add = [&](double angle, double radius) {
    edges_.push_back({normal, true, {1, -mu * radius * std::cos(angle), -mu * radius * std::sin(angle)}});
  };
  add(from, 1);
  if (contacts_.dimension == 2) return;
  const double corner = 1 / std::cos(width / 4);
  add(from + width / 4, corner);
  add(from + width * 3 / 4, corner);
  add(from + width, 1);
}

bool allows_any_velocity(const ContactPattern& pattern, std::size_t dimension, std::size_t row) {
  const Kind kind = pattern[row / dimension].kind;
  return row % dimension != 0 && kind != Kind::stick && kind != Kind::slip;
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
  for (std::size_t i = 0; i < n; ++i) free_rows.push_back(allows_any_velocity(pattern_, contacts_.dimension, i));
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

/// Adds a tangent where the point's force is outside of the true cone; false if it is nowhere. Roughly while more is to
/// decide than directions: then patterns within this one follow.
bool PatternProgram::cut(const ProposedPoint& point) {
  bool cuts = false;
  const double outside = is_decided(exact_, pattern_) ? 1e-9 : 1e-3;
  for (std::size_t k = 0; k < pattern_.size() && contacts_.dimension == 3; ++k) {
    const std::size_t i = contacts_.normal(k);
    if (!exact_.has_friction(k) || pattern_[k].kind == Kind::slip || pattern_[k].kind == Kind::open) continue;
    const double force = std::hypot(point.r[i + 1], point.r[i + 2]);
    if (force <= contacts_.mu[k] * point.r[i] * (1 + outside) + small) continue;
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

PatternProgram::Feasibility PatternProgram::feasibility() {
  ProposedPoint nearest;
  for (int round = 0; round <= most_cuts; ++round) {
    add_cones();
    build();
    if (!solve(quick_tolerance)) return {};
    nearest = point();
    if (program_->least() > small) break;
    if (round == most_cuts || !cut(nearest)) return {std::move(nearest), {}};
  }
  if (!prove_empty().empty()) return {std::move(nearest), proved_};
  return {std::move(nearest), {}};
}

/// Where side * t is least, about the least of side * t / a: t and a are the parts of u_T or -r_T across and along a
/// direction, a > 0.
std::optional<double> PatternProgram::least_slope(bool forces, std::size_t row, double middle, double side) {
  const double c = std::cos(middle), s = std::sin(middle), sign = forces ? -1 : 1;
  std::vector<double> form(contacts_.size());
  const std::vector<double> zero(form);
  form[row + 1] = -sign * side * s;
  form[row + 2] = sign * side * c;
  if (!least_duals(forces ? zero : form, forces ? form : zero, 0)) return std::nullopt;
  const ProposedPoint corner = point();
  const double x = sign * (forces ? corner.r : corner.u)[row + 1], y = sign * (forces ? corner.r : corner.u)[row + 2];
  const double along = c * x + s * y;
  return along < small ? std::nullopt : std::optional(side * (c * y - s * x) / along);
}

std::array<double, 2> PatternProgram::directions(std::size_t k) {
  const double from = pattern_[k].from.angle(), width = pattern_[k].width();
  const double middle = from + width / 2, edge = std::tan(width / 2);
  std::array<double, 2> range{0, 1};
  for (const bool forces : {true, false}) {
    for (const double side : {1.0, -1.0}) {
      const auto slope = least_slope(forces, contacts_.normal(k), middle, side);
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

}  // namespace slipproof
