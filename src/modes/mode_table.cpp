#include "modes/mode_table.hpp"

#include <utility>

#include "model/conditions.hpp"
#include "number/raw_fraction.hpp"

namespace slipproof {

namespace {

Affine<Rational> to_rational(Quotient<Affine<Integer>, Integer> q, const Integer& unit) {
  const bool constant = q.numerator.beta.is_zero(), linear = q.numerator.alpha.is_zero();
  if (constant && linear) return {};
  q.denominator *= unit;
  if (constant) return {Rational(std::move(q.numerator.alpha), std::move(q.denominator)), Rational()};
  if (linear) return {Rational(), Rational(std::move(q.numerator.beta), std::move(q.denominator))};
  return {Rational(std::move(q.numerator.alpha), q.denominator),
          Rational(std::move(q.numerator.beta), std::move(q.denominator))};
}

/// A closed interval of forces.
class Ends {
 public:
  /// Keeps the forces where side / D >= 0 for a D of the sign of `orientation`. Units are positive, so signs and roots
  /// are those of the SI value.
  void restrict_to(Affine<Integer> side, int orientation) {
    if (orientation < 0) side = -std::move(side);
    const int slope = sign(side.beta);
    if (slope == 0) {
      empty_ = empty_ || sign(side.alpha) < 0;
    } else if (slope > 0) {
      tighten(lower_, {-std::move(side.alpha), std::move(side.beta)}, 1);
    } else {
      tighten(upper_, {std::move(side.alpha), -std::move(side.beta)}, -1);
    }
  }
  ForceInterval interval() const {
    return empty_ ? ForceInterval::nothing() : ForceInterval::between(value(lower_), true, value(upper_), true);
  }

 private:
  static void tighten(RawFraction& end, RawFraction root, int direction) {
    if (!end.denominator.is_zero()) {
      const Integer difference = root.numerator * end.denominator - end.numerator * root.denominator;
      if (sign(difference) != direction) return;
    }
    end = std::move(root);
  }
  static std::optional<Rational> value(const RawFraction& end) {
    if (end.denominator.is_zero()) return std::nullopt;
    return Rational(end.numerator, end.denominator);
  }

  RawFraction lower_, upper_;  ///< denominators > 0; 0 for an end that is not there
  bool empty_ = false;
};

std::vector<ContactMode> every_mode() {
  constexpr auto modes = all_modes();
  return {modes.begin(), modes.end()};
}

}  // namespace

Affine<Rational> ModeSolution::quantity(Quantity quantity) const {
  return to_rational(reduced_->quantity(quantity), units_->unit(quantity));
}

Affine<Rational> ModeSolution::condition_value(const Condition& condition) const {
  Quantity like = Quantity::N2;
  using Kind = StateCondition;
  if (condition.kind == Kind::slips_forward || condition.kind == Kind::slips_backward) like = Quantity::slip2;
  if (condition.kind == Kind::opens) like = Quantity::gap2;
  return to_rational(reduced_->condition_value(condition), units_->unit(like));
}

Motion<Affine<Rational>> ModeSolution::motion() const {
  return [this]<std::size_t... i>(std::index_sequence<i...>) {
    return Motion<Affine<Rational>>{{quantity(static_cast<Quantity>(i))...}};
  }
  (std::make_index_sequence<quantity_count>());
}

ModeTable::ModeTable(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind)
    : ModeTable(bicycle, road, kind, every_mode()) {}

ModeTable::ModeTable(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind,
                     const std::vector<ContactMode>& modes)
    : detachment_(bicycle.J.has_value()) {
  IntegerScene scene = to_integers(bicycle, road);
  const Affine<Integer> F(Integer(0), scene.force_unit());
  auto dynamics = reduce<Integer, Affine<Integer>>(scene.bicycle, scene.road, kind, F, scene.friction_denominator);
  ground_ = std::make_unique<const Ground>(Ground{std::move(scene), std::move(dynamics)});
  std::optional<const SingularModes> made;  // for the first mode that needs it
  const auto singular = [&]() -> const SingularModes& { return made ? *made : made.emplace(bicycle, road, kind); };
  for (const ContactMode mode : modes) {
    if (mode.on_road() || bicycle.J) solutions_.push_back(solve(mode, singular));
  }
}

ModeSolution ModeTable::solve(ContactMode mode, const std::function<const SingularModes&()>& singular) const {
  ModeSolution s;
  s.mode_ = mode;
  ReducedMotion<Integer, Affine<Integer>> reduced(ground_->dynamics, mode);
  const bool spins_freely = (mode.rear != ContactState::stick && reduced.rear_spin_inertia().is_zero()) ||
                            (mode.front != ContactState::stick && reduced.front_spin_inertia().is_zero());
  if (spins_freely || reduced.determinant().is_zero()) {
    if (auto continuum = singular().solve(mode)) {
      s.kind_ = ModeSolution::Kind::continuum;
      s.closed_ = continuum->closed;
      s.strict_ = continuum->strict;
      s.continuum_ = std::make_shared<const Continuum>(std::move(*continuum));
    }
    return s;
  }
  s.kind_ = ModeSolution::Kind::regular;
  Ends ends;
  bool always_boundary = false;
  for (const Condition& condition : conditions(mode)) {
    Affine<Integer> side = reduced.condition_numerator(condition);
    if (side.alpha.is_zero() && side.beta.is_zero()) always_boundary = true;
    ends.restrict_to(std::move(side), sign(reduced.determinant()));
  }
  s.closed_ = ends.interval();
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
