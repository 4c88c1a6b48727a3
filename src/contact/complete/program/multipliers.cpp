#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "contact/complete/program/face.hpp"
#include "contact/complete/solve_near.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;

constexpr double most_slack = 1e-8;  ///< by which equations may fail, so that a program with a point has it still
using Precision = PatternProgram::Precision;

constexpr std::array<Precision, 2> precisions{{{0x1p-18, 24, 1e-9}, {0x1p-34, 46, 1e-12}}};
constexpr int face_bits = 24;

double power_near(double x) {
  return x > 0 && std::isfinite(x) ? std::exp2(std::nearbyint(std::log2(x))) : 1;
}

/// A form in binary64, by components of u and of r.
struct DenseForm {
  std::vector<double> f, h;
  double size = 1e-9;

  DenseForm(const ContactForm& form, std::size_t n) : f(n), h(n) {
    for (const auto& [i, value] : form.u) f[i] = value.to_double();
    for (const auto& [i, value] : form.r) h[i] = value.to_double();
    for (std::size_t i = 0; i < n; ++i) size = std::max({size, std::abs(f[i]), std::abs(h[i])});
    for (double& x : f) x /= size;
    for (double& x : h) x /= size;
  }
};

}  // namespace

/// In short numbers, that differ by less than conditions keep. What is within `small` of the form, or has to be the
/// form, is that.
std::vector<Rational> PatternProgram::rounded(std::span<const double> y, const ContactForm& form, int places,
                                              double kept) const {
  double largest = 0;
  for (const double x : y) largest = std::max(largest, std::abs(x));
  double step = largest > 0 ? std::ldexp(power_near(largest), -places) : 1;
  double nothing = small;
  if (kept > 0) {
    step = std::min(step, power_near(kept / 64));
    nothing = std::min(small, kept / 64);
  }
  std::vector<Rational> result(y.size());
  for (const auto& [i, value] : form.u) result[i] = value;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (allows_any_velocity(pattern_, contacts_.dimension, i) || std::abs(y[i] - result[i].to_double()) < nothing)
      continue;
    result[i] = to_rational(std::nearbyint(y[i] / step) * step);
  }
  return result;
}

/// Multipliers that prove that the program, which has no point, has none: first in few digits and quickly.
const std::vector<Rational>& PatternProgram::prove_empty() {
  const std::vector<double> y = duals();
  for (const Precision& precision : precisions) {
    set_costs({}, {}, precision.margin);
    if (!solve(precision.tolerance) || program_->least() <= 0) continue;
    proved_ = rounded(duals(), {}, precision.places, precision.margin);
    if (proves_empty(exact_, integers_, pattern_, proved_)) return proved_;
  }
  proved_ = on_face(y, {});
  if (!proves_empty(exact_, integers_, pattern_, proved_)) proved_.clear();
  return proved_;
}

/// Of edges the value of the form along them, less what is kept.
void PatternProgram::set_costs(std::span<const double> f, std::span<const double> h, double kept) {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    program_->set_cost(e, column_cost(edges_[e], f, h) - kept);
  }
}

/// The multipliers of the least value of a form, less what edges keep. u in rows that may take any value is W r + q:
/// its share goes to the forces.
std::optional<std::vector<double>> PatternProgram::least_duals(std::span<const double> f, std::span<const double> h,
                                                               double kept, bool exactly, double slack) {
  const std::size_t n = contacts_.size();
  std::vector<double> forces(h.begin(), h.end());
  program_->bound_slacks(slack);
  for (std::size_t i = 0; i < n; ++i) {
    if (!allows_any_velocity(pattern_, contacts_.dimension, i) || f[i] == 0) continue;
    for (std::size_t j = 0; j < n; ++j) forces[j] += contacts_.W[i][j] * f[i];
  }
  set_costs(f, forces, kept);
  if (!solve(exactly ? precisions[1].tolerance : precisions[0].tolerance)) return std::nullopt;
  std::vector<double> y = duals();
  for (std::size_t i = 0; i < n; ++i) {
    if (allows_any_velocity(pattern_, contacts_.dimension, i)) y[i] = f[i];
  }
  return y;
}

/// Multipliers of a form with a precision, without one on their face, and the form's value at the program's point.
std::vector<Rational> PatternProgram::proposed(const ContactForm& form, const Precision* precision, double& value) {
  const DenseForm dense(form, contacts_.size());
  const double margin = precision != nullptr ? precision->margin : 0;
  const bool exactly = precision != precisions.data();
  auto y = least_duals(dense.f, dense.h, margin, exactly);
  if (!y && precision != nullptr) y = least_duals(dense.f, dense.h, margin, exactly, most_slack);
  if (!y) return {};
  for (double& x : *y) x *= dense.size;
  value = value_at(form, point());
  return precision != nullptr ? rounded(*y, form, precision->places, margin * dense.size) : on_face(*y, form);
}

std::vector<Rational> PatternProgram::prove_least(const ContactForm& form, const Rational& least) {
  const double size = DenseForm(form, contacts_.size()).size, wanted = least.to_double();
  for (const Precision* precision :
       {precisions.data(), precisions.data() + 1, static_cast<const Precision*>(nullptr)}) {
    double found = wanted;
    std::vector<Rational> y = proposed(form, precision, found);
    const auto bound = y.empty() ? std::nullopt : lower_bound(exact_, integers_, pattern_, form, y);
    if (bound && bound->value >= least) return y;
    if (found < wanted - 1e-6 * (size + std::abs(wanted))) return {};  // a point of the program where the form is less
  }
  return {};
}

std::vector<Rational> PatternProgram::prove_best(const ContactForm& form) {
  for (const Precision* precision :
       {precisions.data() + 1, precisions.data(), static_cast<const Precision*>(nullptr)}) {
    double value = 0;
    std::vector<Rational> y = proposed(form, precision, value);
    if (!y.empty() && lower_bound(exact_, integers_, pattern_, form, y)) return y;
  }
  return {};
}

/// Of a contact that slips or is open: minus its speed along the middle of the arc, or minus u_N, which is negative.
ContactForm PatternProgram::reversed(std::size_t k) const {
  const ContactState& state = pattern_[k];
  const std::size_t i = contacts_.normal(k);
  ContactForm form;
  if (state.kind == Kind::open) form.u.emplace_back(i, Rational(-1));
  if (state.kind != Kind::slip) return form;
  const auto [x, y] = state.middle();
  form.u.emplace_back(i + 1, -x);
  if (contacts_.dimension > 2) form.u.emplace_back(i + 2, -y);
  return form;
}

double PatternProgram::value_at(const ContactForm& form, const ProposedPoint& point) {
  double value = 0;
  for (const auto& [i, f] : form.u) value += f.to_double() * point.u[i];
  for (const auto& [i, h] : form.r) value += h.to_double() * point.r[i];
  return value;
}

std::vector<Rational> PatternProgram::strict_multipliers(ProposedPoint point) {
  constexpr double none = 1e-7;  // below which a point says that something may be impossible
  // First all of them together: where one is possible, its program's point often shows that others are.
  ContactForm all;
  for (std::size_t k = 0; k < pattern_.size(); ++k) {
    const ContactForm form = reversed(k);
    if (value_at(form, point) > -none) all.u.insert(all.u.end(), form.u.begin(), form.u.end());
  }
  if (all.u.empty()) return {};
  std::vector<Rational> y = excluded(all, &point);
  if (!y.empty() && proves_empty(exact_, integers_, pattern_, y)) return y;
  for (std::size_t k = 0; k < pattern_.size(); ++k) {
    const ContactForm form = reversed(k);
    if (form.u.empty() || value_at(form, point) <= -none) continue;
    y = excluded(form, nullptr);
    if (!y.empty() && proves_empty(exact_, integers_, pattern_, y)) return y;
  }
  return {};
}

/// Multipliers that should prove that a form, which would be negative, is at least 0. Where it is not, `least` gets a
/// point at which it is least.
std::vector<Rational> PatternProgram::excluded(const ContactForm& form, ProposedPoint* least) {
  const DenseForm dense(form, contacts_.size());
  auto y = least_duals(dense.f, dense.h, 0);
  if (!y) return {};
  if (program_->least() < -small) {
    if (least != nullptr) *least = point();
    return {};
  }
  for (double& x : *y) x *= dense.size;
  return on_face(*y, form);
}

/// Multipliers near y that satisfy exactly what y satisfies with equality.
std::vector<Rational> PatternProgram::on_face(std::span<const double> y, const ContactForm& form) const {
  const MultiplierFace face(exact_, contacts_, pattern_, form, y);
  if (face.equations().empty()) return rounded(y, form, face_bits);
  auto exact = solve_near(face.equations(), y, face_bits);
  return exact ? std::move(exact->x) : std::vector<Rational>{};
}

}  // namespace slipproof
