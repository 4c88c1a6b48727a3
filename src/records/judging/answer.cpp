#include "records/judging/answer.hpp"

#include <algorithm>

namespace slipproof {

std::size_t RecordAnswer::kind(std::size_t i) const {
  const std::size_t accelerations = setting_.kinds.accelerations.size();
  return i < accelerations ? setting_.kinds.accelerations[i] : setting_.kinds.forces[i - accelerations];
}

bool RecordAnswer::sets_yardstick(std::size_t i) const {
  const std::size_t accelerations = setting_.kinds.accelerations.size();
  return i < accelerations || !setting_.kinds.own_force[i - accelerations];
}

std::size_t RecordAnswer::place(std::size_t unknown) const {
  const std::size_t unknowns = setting_.kinds.unknown_accelerations;
  return unknown < unknowns ? unknown : unknown - unknowns + setting_.kinds.accelerations.size();
}

const AffineForm& RecordAnswer::line(std::size_t index) const {
  return MechanismKinds::line(problem_, setting_.kinds.unknown_accelerations, index);
}

Rational RecordAnswer::constant(std::size_t index) const {
  const AffineForm& form = line(index);
  return load_ ? Rational(form.constant + form.coefficients.back() * *load_) : form.constant;
}

std::vector<RecordAnswer::Component> RecordAnswer::components(const AffineSpace& space) const {
  std::vector<Component> result;
  for (const auto* forms : {&problem_.accelerations, &problem_.forces}) {
    for (const AffineForm& form : *forms) {
      result.push_back({space.on(form), false});
      result.back().open = !is_free_of_unknowns(result.back().form);
    }
  }
  return result;
}

void RecordAnswer::take_lines(const std::vector<Component>& components, Yardsticks& sizes) const {
  for (std::size_t i = 0; i < setting_.kinds.lines.size(); ++i) {
    const AffineForm& form = line(i);
    sizes.take(setting_.kinds.lines[i], constant(i));
    for (std::size_t unknown = 0; unknown < problem_.unknowns; ++unknown) {
      const std::size_t at = place(unknown);
      if (form.coefficients[unknown].is_zero() || components[at].open || !sets_yardstick(at)) continue;
      sizes.take(setting_.kinds.lines[i], form.coefficients[unknown] * components[at].form.constant);
    }
  }
}

Rational RecordAnswer::largest_coefficient(const MechanismKinds::Quotient& quotient) const {
  Rational largest = 0;
  for (const auto& [index, unknown] : quotient.places) {
    largest = std::max(largest, Rational(abs(line(index).coefficients[unknown])));
  }
  return largest;
}

Yardsticks RecordAnswer::sizes(const std::vector<Component>& components) const {
  const MechanismKinds& kinds = setting_.kinds;
  Yardsticks sizes(kinds.count);
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (!sets_yardstick(i)) continue;
    if (!components[i].open) sizes.take(kind(i), components[i].form.constant);
    if (components[i].open && has(i)) sizes.take(kind(i), answer(i));
  }
  take_lines(components, sizes);
  for (const MechanismKinds::Quotient& inertia : kinds.inertias) {
    const Rational divisor = largest_coefficient(inertia);
    if (divisor.is_zero()) continue;
    for (const auto& place : inertia.places) sizes.take(inertia.kind, constant(place.first) / divisor);
  }
  return sizes;
}

std::vector<Rational> RecordAnswer::yardsticks(const std::vector<Component>& components) const {
  const MechanismKinds& kinds = setting_.kinds;
  const Yardsticks own = sizes(components);
  Yardsticks result = own;
  const auto take = [&](const MechanismKinds::Quotient& quotient) {
    const Rational divisor = largest_coefficient(quotient);
    if (!divisor.is_zero()) result.take(quotient.kind, own[quotient.of] / divisor);
  };
  for (const MechanismKinds::Quotient& lever : kinds.levers) take(lever);
  std::vector<bool> nothing(kinds.count);
  for (std::size_t k = 0; k < kinds.count; ++k) nothing[k] = result[k].is_zero();
  for (const MechanismKinds::Quotient& quotient : kinds.all) {
    if (nothing[quotient.kind]) take(quotient);
  }
  std::vector<Rational> of_components;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const bool beyond = components[i].open && !sets_yardstick(i) && has(i);
    of_components.push_back(beyond ? std::max(result[kind(i)], Rational(abs(answer(i)))) : result[kind(i)]);
  }
  return of_components;
}

Distance RecordAnswer::distance(const ConsistentMode& mode, Effort& effort, std::size_t& worst) const {
  const AffineSpace& space = mode.solutions.space;
  const std::vector<Component> all = components(space);
  const std::vector<Rational> sizes = yardsticks(all);
  const std::vector<std::size_t> free = space.free_unknowns();
  const auto over_free = [&](const AffineForm& form) {
    AffineForm result{form.constant, {}};
    for (const std::size_t unknown : free) result.coefficients.push_back(form.coefficients[unknown]);
    return result;
  };
  std::vector<OpenComponent> open;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (has(i) && all[i].open) open.push_back({over_free(all[i].form), answer(i), sizes[i]});
  }
  std::vector<Rational> at;
  if (!open.empty()) {
    std::vector<AffineForm> sides;
    for (const AffineForm& side : mode.solutions.sides) sides.push_back(over_free(side));
    at = nearest_solution(open, sides, free.size(), effort);
  }
  Distance result{0, 0};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!has(i)) continue;
    const Rational exact = all[i].open ? over_free(all[i].form).at(at) : all[i].form.constant;
    if (compare({answer(i), exact, sizes[i], all[i].open}, result)) worst = i;
  }
  return result;
}

namespace {

bool holds_zero(const Range& range) {
  return range.lower->sign() <= 0 && range.upper->sign() >= 0;
}

}  // namespace

std::vector<RecordAnswer::Component> RecordAnswer::components(const SpaceMotion& motion) const {
  std::vector<Component> result;
  const auto add = [&](const std::optional<Range>& range, bool open) {
    Rational smallest = 0;
    if (range && !holds_zero(*range)) smallest = range->lower->sign() > 0 ? *range->lower : *range->upper;
    result.push_back({{std::move(smallest), {}}, open || !range});
  };
  for (const Range& acceleration : motion.accelerations) add(acceleration, false);
  for (const auto& force : motion.forces) add(force, motion.may_be_open());
  return result;
}

/// |u(answer) - u(other)| <= near * sum |coefficient| * yardstick where the answer is near another motion, for each gap
/// and slip u.
bool RecordAnswer::is_far_from_others(const SpaceMotion& motion, const std::vector<Rational>& sizes,
                                      const Rational& near) const {
  const std::size_t unknowns = setting_.kinds.unknown_accelerations;
  for (std::size_t j = 0; j < unknowns; ++j) {
    if (!has(j)) return false;
  }
  for (std::size_t i = unknowns; i < motion.accelerations.size(); ++i) {
    const AffineForm& form = problem_.accelerations[i];
    Rational value = form.constant, slack = *motion.others_within;
    if (load_) value += form.coefficients.back() * *load_;
    for (std::size_t j = 0; j < unknowns; ++j) {
      value += form.coefficients[j] * answer(j);
      slack += near * abs(form.coefficients[j]) * sizes[j];
    }
    const Range& range = motion.accelerations[i];
    if (value > *range.upper + slack || value < *range.lower - slack) return true;
  }
  return false;
}

RecordAnswer::Bounds RecordAnswer::bounds(const SpaceMotion& motion, const Rational& near,
                                          const std::vector<std::optional<Rational>>& forces) const {
  const std::vector<Component> all = components(motion);
  const std::vector<Rational> sizes = yardsticks(all);
  const std::size_t accelerations = motion.accelerations.size();
  Bounds result{{0, 0}, {0, 0}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!has(i)) continue;
    const Rational x = answer(i);
    if (all[i].open) {
      const std::optional<Rational> exact = forces.empty() ? std::nullopt : forces[i - accelerations];
      result.open_force = result.open_force || !exact;
      if (exact && compare({x, *exact, sizes[i], true}, result.most)) result.worst = i;
      continue;
    }
    const Range& range = i < accelerations ? motion.accelerations[i] : *motion.forces[i - accelerations];
    const bool as_zero = !range.is_point() && holds_zero(range);
    compare({x, std::clamp(x, *range.lower, *range.upper), sizes[i], as_zero}, result.least);
    for (const auto& end : {range.lower, range.upper}) {
      if (compare({x, *end, sizes[i], as_zero}, result.most)) result.worst = i;
    }
  }
  if (motion.others_within) result.far_from_others = is_far_from_others(motion, sizes, near);
  return result;
}

std::vector<Rational> RecordAnswer::forces_beside(const SpaceMotion& motion) const {
  std::vector<Rational> result;
  for (std::size_t i = 0; i < motion.forces.size(); ++i) {
    const std::size_t place = motion.accelerations.size() + i;
    result.push_back(has(place) ? answer(place) : motion.forces[i] ? *motion.forces[i]->lower : Rational(0));
  }
  return result;
}

}  // namespace slipproof
