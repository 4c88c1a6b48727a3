#include "mechanics/kernel/mode_over_loads.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/algebra/elimination.hpp"

namespace slipproof {

namespace {

/// A form on a space over the load; nothing where it is undetermined.
std::optional<Affine<Rational>> value_on(const AffineSpace& space, const AffineForm& form) {
  AffineForm whole = space.on(form);
  if (!is_free_of_unknowns(whole)) return std::nullopt;
  return Affine<Rational>(std::move(whole.constant), std::move(whole.coefficients.back()));
}

/// Whether there surely is no load at which two motions are the same.
bool surely_never_meet(const ModeOfCells& x, const ModeOfCells& y) {
  std::optional<Approximate> load;
  for (std::size_t i = 0; i < std::min(x.near().size(), y.near().size()); ++i) {
    const Affine<Approximate> d = x.near()[i] - y.near()[i];
    const auto slope = sure_sign(d.beta);
    if (!slope) continue;
    if (*slope == 0) {
      if (sure_sign(d.alpha).value_or(0) != 0) return true;
      continue;
    }
    const Approximate root = -d.alpha / d.beta;
    if (load && sure_sign(*load - root).value_or(0) != 0) return true;
    load = root;
  }
  return false;
}

}  // namespace

OverLoads at(const OverLoads& values, const Rational& load) {
  OverLoads result;
  for (const auto& value : values) result.emplace_back(value.at(load));
  return result;
}
ForcesOverLoads at(const ForcesOverLoads& values, const Rational& load) {
  ForcesOverLoads result;
  for (const auto& value : values) result.push_back(value ? std::optional<Affine<Rational>>(value->at(load)) : value);
  return result;
}

IntegerSpace::IntegerSpace(const AffineSpace& space) {
  std::vector<Rational> numbers;
  for (std::size_t i = 0; i < space.unknowns(); ++i) {
    const AffineForm& value = space.fixed(i);
    numbers.insert(numbers.end(), {value.constant, value.coefficients.back()});
  }
  denominator_ = common_denominator(numbers);
  for (const Rational& x : numbers) values_.push_back(integer_times(x, denominator_));
}

Affine<Rational> IntegerSpace::on(const AffineForm& form) const {
  const Integer factor = common_denominator(form.coefficients, denominator(form.constant));
  const Integer all = factor * denominator_;
  Integer constant = integer_times(form.constant, all), slope = integer_times(form.coefficients.back(), all);
  for (std::size_t i = 0; i < values_.size() / 2; ++i) {
    if (form.coefficients[i].is_zero()) continue;
    const Integer entry = integer_times(form.coefficients[i], factor);
    constant.add_product(entry, values_[2 * i]);
    slope.add_product(entry, values_[2 * i + 1]);
  }
  return {Rational(std::move(constant), all), Rational(std::move(slope), all)};
}

NearForms near(const std::vector<AffineForm>& forms) {
  NearForms result;
  for (const AffineForm& form : forms) {
    std::vector<Approximate>& numbers = result.emplace_back();
    for (const Rational& coefficient : form.coefficients) numbers.emplace_back(coefficient);
    numbers.emplace_back(form.constant);
  }
  return result;
}

ModeOfCells::ModeOfCells(const FrictionProblem& problem, const ConsistentMode& mode, const NearForms& accelerations)
    : problem_(&problem), found_(&mode), accelerations_(problem.accelerations.size()) {
  if (!regular()) return;
  std::vector<Affine<Approximate>> unknowns;
  for (std::size_t i = 0; i < space().unknowns(); ++i) {
    const AffineForm& value = space().fixed(i);
    unknowns.emplace_back(Approximate(value.constant), Approximate(value.coefficients.back()));
  }
  for (const std::vector<Approximate>& form : accelerations) {
    Affine<Approximate>& sum = near_.emplace_back(form[unknowns.size() + 1], form[unknowns.size()]);
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      if (!form[i].is_zero()) sum = sum + form[i] * unknowns[i];
    }
  }
}

const Affine<Rational>& ModeOfCells::acceleration(std::size_t i) const {
  auto& known = accelerations_[i];
  if (!known) known = exact(problem_->accelerations[i]);
  return *known;
}

OverLoads ModeOfCells::accelerations() const {
  OverLoads values;
  for (std::size_t i = 0; i < accelerations_.size(); ++i) values.push_back(acceleration(i));
  return values;
}

ForcesOverLoads ModeOfCells::forces() const {
  ForcesOverLoads values;
  for (const AffineForm& form : problem_->forces) values.push_back(exact(form));
  return values;
}

std::vector<Rational> ModeOfCells::accelerations_at(const Rational& load) const {
  std::vector<Rational> values;
  for (std::size_t i = 0; i < accelerations_.size(); ++i) values.push_back(acceleration(i).at(load));
  return values;
}

std::optional<Affine<Rational>> ModeOfCells::exact(const AffineForm& form) const {
  if (!regular()) return value_on(space(), form);
  if (!integers_) integers_.emplace(space());
  return integers_->on(form);
}

bool surely_differ(const ModeOfCells& x, const ModeOfCells& y, const std::optional<Rational>& load) {
  const auto is_nonzero = [](const Approximate& d) { return std::fabs(d.value) > d.error; };
  for (std::size_t i = 0; i < std::min(x.near().size(), y.near().size()); ++i) {
    const Affine<Approximate> d = x.near()[i] - y.near()[i];
    if (load ? is_nonzero(d.at(Approximate(*load))) : is_nonzero(d.alpha) || is_nonzero(d.beta)) return true;
  }
  return false;
}

std::optional<Rational> crossing(const ModeOfCells& x, const ModeOfCells& y, std::size_t accelerations) {
  if (surely_never_meet(x, y)) return std::nullopt;
  std::optional<Rational> load;
  for (std::size_t i = 0; i < accelerations; ++i) {
    const Affine<Rational> d = x.acceleration(i) - y.acceleration(i);
    if (d.beta.is_zero()) {
      if (!d.alpha.is_zero()) return std::nullopt;
      continue;
    }
    const Rational root = -d.alpha / d.beta;
    if (load && *load != root) return std::nullopt;
    load = root;
  }
  return load;
}

}  // namespace slipproof
