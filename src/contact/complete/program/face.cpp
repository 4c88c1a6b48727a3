#include "contact/complete/program/face.hpp"

#include <cmath>

namespace slipproof {

namespace {

using Kind = ContactState::Kind;

bool is_active(double x) {
  return std::abs(x) < 1e-8;
}

}  // namespace

MultiplierFace::MultiplierFace(const ExactContacts& exact, const FloatingContacts& contacts,
                               const ContactPattern& pattern, const ContactForm& form, std::span<const double> y)
    : exact_(exact), contacts_(contacts), pattern_(pattern), y_(y), f_(y.size()), h_(y.size()) {
  for (const auto& [i, value] : form.u) f_[i] = value;
  for (const auto& [i, value] : form.r) h_[i] = value;
  for (std::size_t i = 0; i < y.size(); ++i) {
    v_.push_back(f_[i].to_double() - y[i]);
    double& g = g_.emplace_back(h_[i].to_double());
    for (std::size_t j = 0; j < y.size(); ++j) g += contacts.W[j][i] * y[j];
  }
  add_value();
  for (std::size_t k = 0; k < pattern.size(); ++k) {
    add_velocities(k);
    add_forces(k);
  }
}

void MultiplierFace::add_value() {
  double value = 0;
  for (std::size_t i = 0; i < y_.size(); ++i) value += y_[i] * contacts_.q[i];
  if (is_active(value)) equations_.emplace_back(exact_.q).emplace_back(0);
}

void MultiplierFace::add_velocities(std::size_t k) {
  const ContactState& state = pattern_[k];
  const std::size_t i = contacts_.normal(k), dimension = contacts_.dimension;
  const std::array<Rational, 1> one{Rational(1)};
  if ((state.kind == Kind::any || state.kind == Kind::open) && is_active(v_[i])) require_velocity(i, one);
  for (std::size_t t = 1; t < dimension; ++t) {
    if (allows_any_velocity(pattern_, dimension, i + t)) require_velocity(i + t, one);
  }
  if (state.kind != Kind::slip) return;
  for (const Direction& d : {state.from, state.to}) {
    const double angle = d.angle();
    const double along = v_[i + 1] * std::cos(angle) + (dimension > 2 ? v_[i + 2] * std::sin(angle) : 0);
    const std::array<Rational, 2> direction{Rational(d.x), Rational(d.y)};
    if (is_active(along)) require_velocity(i + 1, std::span(direction).first(dimension - 1));
  }
}

void MultiplierFace::add_forces(std::size_t k) {
  const ContactState& state = pattern_[k];
  if (state.kind == Kind::open) return;
  const std::size_t i = contacts_.normal(k), components = exact_.has_friction(k) ? contacts_.dimension : 1;
  bool none = true;
  for (std::size_t t = 0; t < components; ++t) none = none && is_active(g_[i + t]);
  if (none) {
    for (std::size_t t = 0; t < components; ++t) {
      std::array<Rational, 3> force;
      force[t] = 1;
      require_force(i, force);
    }
  } else if (state.kind == Kind::slip && exact_.has_friction(k)) {
    add_arc_of_forces(k);
  } else if (components == 2) {
    for (const int side : {1, -1}) {
      if (is_active(g_[i] + side * contacts_.mu[k] * g_[i + 1])) {
        require_force(i, {Rational(1), side * exact_.mu[k], Rational(0)});
      }
    }
  }
}

void MultiplierFace::add_arc_of_forces(std::size_t k) {
  const std::size_t i = contacts_.normal(k);
  const Rational& mu = exact_.mu[k];
  for (const Direction& d : {pattern_[k].from, pattern_[k].to}) {
    const double angle = d.angle();
    const double along = g_[i + 1] * std::cos(angle) + (contacts_.dimension > 2 ? g_[i + 2] * std::sin(angle) : 0);
    if (is_active(g_[i] - contacts_.mu[k] * along)) {
      require_force(i, {Rational(d.length), -mu * Rational(d.x), -mu * Rational(d.y)});
    }
  }
}

/// (f - y) . u = 0 for velocities in this direction.
void MultiplierFace::require_velocity(std::size_t first, std::span<const Rational> direction) {
  std::vector<Rational>& row = equations_.emplace_back(y_.size() + 1);
  for (std::size_t t = 0; t < direction.size(); ++t) {
    row[first + t] = direction[t];
    row.back() += direction[t] * f_[first + t];
  }
}

/// (h + W^T y) . r = 0 for this force.
void MultiplierFace::require_force(std::size_t normal, const std::array<Rational, 3>& force) {
  std::vector<Rational>& row = equations_.emplace_back(y_.size() + 1);
  for (std::size_t t = 0; t < contacts_.dimension; ++t) {
    if (force[t].is_zero()) continue;
    for (std::size_t j = 0; j < y_.size(); ++j) row[j] += force[t] * exact_.W[j][normal + t];
    row.back() -= force[t] * h_[normal + t];
  }
}

}  // namespace slipproof
