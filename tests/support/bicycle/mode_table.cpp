#include "support/bicycle/mode_table.hpp"

#include <algorithm>
#include <utility>

#include "support/bicycle/conditions.hpp"

namespace slipproof {

namespace {

Affine<Rational> value_of(const Quotient<Affine<Rational>, Rational>& q) {
  return {q.numerator.alpha / q.denominator, q.numerator.beta / q.denominator};
}

}  // namespace

Affine<Rational> ModeSolution::quantity(Quantity quantity) const {
  return value_of(reduced_->quantity(quantity));
}

Motion<Affine<Rational>> ModeSolution::motion() const {
  Motion<Affine<Rational>> result;
  for (const Quantity q : all_quantities()) result[q] = quantity(q);
  return result;
}

ModeTable::ModeTable(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind)
    : dynamics_(std::make_unique<const Dynamics>(
          reduce<Rational, Affine<Rational>>(bicycle, road, kind, {0, 1}, Rational(1)))),
      detachment_(bicycle.J.has_value()) {
  std::optional<const SingularModes> made;  // for the first mode that needs it
  const auto singular = [&]() -> const SingularModes& { return made ? *made : made.emplace(bicycle, road, kind); };
  for (const ContactMode mode : all_modes()) {
    if (mode.on_road() || detachment_) solutions_.push_back(solve(mode, singular));
  }
}

bool ModeTable::solve_regular(ModeSolution& s) const {
  const auto& reduced = s.reduced_.emplace(*dynamics_, s.mode_);
  const bool spins_freely = (s.mode_.rear != WheelState::stick && reduced.rear_spin_inertia().is_zero()) ||
                            (s.mode_.front != WheelState::stick && reduced.front_spin_inertia().is_zero());
  if (spins_freely || reduced.determinant().is_zero()) return false;
  s.closed_ = ForceInterval();
  bool always_boundary = false;
  for (const Condition& condition : conditions(s.mode_)) {
    const Affine<Rational> side = reduced.condition_numerator(condition);
    if (side.alpha.is_zero() && side.beta.is_zero()) always_boundary = true;
    s.closed_.restrict_to(sign(reduced.determinant()) < 0 ? -side : side, false);
  }
  s.strict_ = always_boundary ? ForceInterval::nothing() : s.closed_.interior();
  return true;
}

ModeSolution ModeTable::solve(ContactMode mode, const std::function<const SingularModes&()>& singular) const {
  ModeSolution s;
  s.mode_ = mode;
  if (solve_regular(s)) {
    s.kind_ = ModeSolution::Kind::regular;
  } else if (auto continuum = singular().solve(mode)) {
    s.kind_ = ModeSolution::Kind::continuum;
    s.closed_ = continuum->closed;
    s.strict_ = continuum->strict;
    s.continuum_ = std::make_shared<const Continuum>(std::move(*continuum));
  }
  return s;
}

const ModeSolution* ModeTable::find(ContactMode mode) const {
  const auto found = std::ranges::find(solutions_, mode, &ModeSolution::mode);
  return found == solutions_.end() ? nullptr : &*found;
}

}  // namespace slipproof
