#include "modes/mode_table.hpp"

#include <utility>

#include "model/conditions.hpp"

namespace slipproof {

namespace {

Affine<Rational> to_rational(const Quotient<Affine<Integer>, Integer>& q, const Integer& unit) {
  const Integer denominator = q.denominator * unit;
  return {Rational(q.numerator.alpha, denominator), Rational(q.numerator.beta, denominator)};
}

/// Keeps the forces where the quotient is >= 0 (> 0). Units are positive, so signs and roots are those of the SI value.
void restrict_to(ForceInterval& interval, const Quotient<Affine<Integer>, Integer>& q, bool strict) {
  const bool negative = sign(q.denominator) < 0;
  if (interval.empty()) return;
  interval.restrict_to({Rational(negative ? Integer(-q.numerator.alpha) : q.numerator.alpha),
                        Rational(negative ? Integer(-q.numerator.beta) : q.numerator.beta)},
                       strict);
}

}  // namespace

Affine<Rational> ModeSolution::quantity(Quantity quantity) const {
  return to_rational(reduced_->quantity(quantity), units_->unit(quantity));
}

Affine<Rational> ModeSolution::condition_value(const Condition& condition) const {
  Quantity like = Quantity::N2;
  if (condition.kind == ConditionKind::slip) like = Quantity::slip2;
  if (condition.kind == ConditionKind::gap) like = Quantity::gap2;
  return to_rational(reduced_->condition_value(condition), units_->unit(like));
}

Motion<Affine<Rational>> ModeSolution::motion() const {
  Motion<Affine<Rational>> motion;
  for (const Quantity q : all_quantities()) motion[q] = quantity(q);
  return motion;
}

ModeTable::ModeTable(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind) {
  IntegerScene scene = to_integers(bicycle, road);
  const Affine<Integer> F(Integer(0), scene.force_unit());
  auto dynamics = reduce<Integer, Affine<Integer>>(scene.bicycle, scene.road, kind, F, scene.friction_denominator);
  ground_ = std::make_unique<const Ground>(Ground{std::move(scene), std::move(dynamics)});
  for (const ContactMode mode : all_modes()) {
    if (mode.on_road() || bicycle.J) solutions_.push_back(solve(mode, bicycle, road, kind));
  }
}

ModeSolution ModeTable::solve(ContactMode mode, const Bicycle<Rational>& bicycle, const Road<Rational>& road,
                              ForceKind kind) const {
  ModeSolution s;
  s.mode_ = mode;
  ReducedMotion<Integer, Affine<Integer>> reduced(ground_->dynamics, mode);
  const bool spins_freely = (mode.rear != ContactState::stick && reduced.rear_spin_inertia().is_zero()) ||
                            (mode.front != ContactState::stick && reduced.front_spin_inertia().is_zero());
  if (spins_freely || reduced.determinant().is_zero()) {
    if (auto continuum = solve_singular(bicycle, road, kind, mode)) {
      s.kind_ = ModeSolution::Kind::continuum;
      s.closed_ = continuum->closed;
      s.strict_ = continuum->strict;
      s.continuum_ = std::make_shared<const Continuum>(std::move(*continuum));
    }
    return s;
  }
  s.kind_ = ModeSolution::Kind::regular;
  s.closed_ = ForceInterval();
  bool always_boundary = false;
  for (const Condition& condition : conditions(mode)) {
    const auto value = reduced.condition_value(condition);
    if (value.numerator.alpha.is_zero() && value.numerator.beta.is_zero()) always_boundary = true;
    restrict_to(s.closed_, value, false);
  }
  s.strict_ = always_boundary ? ForceInterval::nothing() : s.closed_.interior();
  s.reduced_.emplace(std::move(reduced));
  s.units_ = &ground_->scene;
  return s;
}

const ModeSolution* ModeTable::find(ContactMode mode) const {
  for (const ModeSolution& s : solutions_) {
    if (s.mode() == mode) return &s;
  }
  return nullptr;
}

}  // namespace slipproof
