#include "mechanics/bicycle_modes/mode_table.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "mechanics/bicycle/conditions.hpp"
#include "mechanics/bicycle/forced_scene.hpp"

namespace slipproof {

namespace {

template <class T>
Rational fraction(const T& numerator, const T& denominator) {
  return numerator.is_zero() ? Rational() : Rational(Integer(numerator), Integer(denominator));
}

template <class T>
Affine<Rational> in_units(const Quotient<Affine<T>, T>& q, const Integer& unit) {
  if (q.numerator.alpha.is_zero() && q.numerator.beta.is_zero()) return {};
  const T denominator = q.denominator * T(unit);
  return {fraction(q.numerator.alpha, denominator), fraction(q.numerator.beta, denominator)};
}

/// A quantity of the same unit as what a condition bounds from below.
Quantity like(const Condition& condition) {
  switch (condition.kind) {
    case StateCondition::slips_forward:
    case StateCondition::slips_backward:
      return Quantity::slip2;
    case StateCondition::opens:
      return Quantity::gap2;
    default:
      return Quantity::N2;
  }
}

/// A closed interval of forces.
template <class T>
class Ends {
 public:
  /// Keeps the forces where side / D >= 0 for a D of the sign of `orientation`. Units are positive, so signs and roots
  /// are those of the SI value.
  void restrict_to(Affine<T> side, int orientation) {
    if (orientation < 0) side = -std::move(side);
    const int slope = side.beta.sign();
    if (slope == 0) {
      empty_ = empty_ || side.alpha.sign() < 0;
    } else if (slope > 0) {
      tighten(lower_, {-std::move(side.alpha), std::move(side.beta)}, 1);
    } else {
      tighten(upper_, {std::move(side.alpha), -std::move(side.beta)}, -1);
    }
  }
  ForceInterval interval() const {
    if (empty_ || (lower_.is_there() && upper_.is_there() && lower_.compare(upper_) > 0)) {
      return ForceInterval::nothing();
    }
    return ForceInterval::between(value(lower_), true, value(upper_), true);
  }

 private:
  struct Fraction {
    T numerator{}, denominator{};  ///< > 0; 0 for an end that is not there

    bool is_there() const { return !denominator.is_zero(); }
    int compare(const Fraction& other) const {
      const int x = numerator.sign(), y = other.numerator.sign();
      if (x != y || x == 0) return x - y;
      return (long_product(numerator, other.denominator) - long_product(other.numerator, denominator)).sign();
    }
  };

  static void tighten(Fraction& end, Fraction root, int direction) {
    if (!end.is_there() || root.compare(end) * direction > 0) end = std::move(root);
  }
  static std::optional<Rational> value(const Fraction& end) {
    if (!end.is_there()) return std::nullopt;
    return fraction(end.numerator, end.denominator);
  }

  Fraction lower_, upper_;
  bool empty_ = false;
};

template <class T>
ReducedDynamics<T, Affine<T>> dynamics_of(const IntegerScene& scene, ForceKind kind) {
  const auto s =
      convert<Integer, T>({scene.bicycle, scene.road, kind, scene.force}, [](const Integer& x) { return T(x); });
  return reduce<T, Affine<T>>(s.bicycle, s.road, kind, {T(0), s.F}, T(scene.friction_denominator));
}

/// Whether ModeInteger has every number that is read of some modes.
bool fits_mode_integer(const IntegerScene& scene, ForceKind kind, const std::vector<ContactMode>& modes) {
  using Length = BitLength;
  const auto dynamics = dynamics_of<Length>(scene, kind);
  std::size_t longest = std::max(dynamics.A.bits, dynamics.I3.bits);
  const auto read = [&](const Quotient<Affine<Length>, Length>& q, Quantity quantity) {
    const std::size_t denominator = (q.denominator * Length(scene.unit(quantity))).bits;
    longest = std::max({longest, q.numerator.alpha.bits, q.numerator.beta.bits, denominator});
  };
  for (const ContactMode mode : modes) {
    const ReducedMotion<Length, Affine<Length>> motion(dynamics, mode);
    for (const Quantity q : all_quantities()) read(motion.quantity(q), q);
    for (const Condition& c : conditions(mode)) read(motion.condition_value(c), like(c));
  }
  return longest <= ModeInteger::value_bits;
}

std::vector<ContactMode> every_mode() {
  constexpr auto modes = all_modes();
  return {modes.begin(), modes.end()};
}

}  // namespace

/// What `read` gives for the solution of a regular mode.
template <class Read>
auto ModeSolution::read(const Read& read) const {
  const auto* fixed = std::get_if<Reduced<ModeInteger>>(&reduced_);
  return fixed != nullptr ? read(*fixed) : read(std::get<Reduced<Integer>>(reduced_));
}

Affine<Rational> ModeSolution::quantity(Quantity quantity) const {
  return read([&](const auto& reduced) { return in_units(reduced.quantity(quantity), units_->unit(quantity)); });
}

Affine<Rational> ModeSolution::condition_value(const Condition& condition) const {
  return read(
      [&](const auto& reduced) { return in_units(reduced.condition_value(condition), units_->unit(like(condition))); });
}

Motion<Affine<Rational>> ModeSolution::motion() const {
  return read([this](auto reduced) {
    reduced.cancel();
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      const auto value = [&](Quantity q) { return in_units(reduced.quantity(q), units_->unit(q)); };
      return Motion<Affine<Rational>>{{value(static_cast<Quantity>(i))...}};
    }
    (std::make_index_sequence<quantity_count>());
  });
}

ModeTable::ModeTable(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind)
    : ModeTable(bicycle, road, kind, every_mode()) {}

ModeTable::ModeTable(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind,
                     const std::vector<ContactMode>& modes)
    : detachment_(bicycle.J.has_value()) {
  std::vector<ContactMode> modelled;
  std::copy_if(modes.begin(), modes.end(), std::back_inserter(modelled),
               [&](ContactMode mode) { return mode.on_road() || detachment_; });
  auto ground = std::make_unique<Ground>(to_integers(bicycle, road));
  if (fits_mode_integer(ground->scene, kind, modelled)) {
    ground->dynamics = dynamics_of<ModeInteger>(ground->scene, kind);
  } else {
    ground->dynamics = dynamics_of<Integer>(ground->scene, kind);
  }
  ground_ = std::move(ground);
  std::optional<const SingularModes> made;  // for the first mode that needs it
  const auto singular = [&]() -> const SingularModes& { return made ? *made : made.emplace(bicycle, road, kind); };
  solutions_.reserve(modelled.size());
  for (const ContactMode mode : modelled) solutions_.push_back(solve(mode, singular));
}

template <class T>
bool ModeTable::solve_regular(const ReducedDynamics<T, Affine<T>>& dynamics, ModeSolution& s) const {
  auto& reduced = s.reduced_.emplace<ModeSolution::Reduced<T>>(dynamics, s.mode_);
  const bool spins_freely = (s.mode_.rear != ContactState::stick && reduced.rear_spin_inertia().is_zero()) ||
                            (s.mode_.front != ContactState::stick && reduced.front_spin_inertia().is_zero());
  if (spins_freely || reduced.determinant().is_zero()) return false;
  Ends<T> ends;
  bool always_boundary = false;
  for (const Condition& condition : conditions(s.mode_)) {
    Affine<T> side = reduced.condition_numerator(condition);
    if (side.alpha.is_zero() && side.beta.is_zero()) always_boundary = true;
    ends.restrict_to(std::move(side), reduced.determinant().sign());
  }
  s.closed_ = ends.interval();
  s.strict_ = always_boundary ? ForceInterval::nothing() : s.closed_.interior();
  return true;
}

ModeSolution ModeTable::solve(ContactMode mode, const std::function<const SingularModes&()>& singular) const {
  ModeSolution s;
  s.mode_ = mode;
  s.units_ = &ground_->scene;
  if (std::visit([&](const auto& dynamics) { return solve_regular(dynamics, s); }, ground_->dynamics)) {
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
  for (const ModeSolution& s : solutions_) {
    if (s.mode() == mode) return &s;
  }
  return nullptr;
}

}  // namespace slipproof
