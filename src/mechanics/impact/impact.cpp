#include "mechanics/impact/impact.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "mechanics/bodies/frame.hpp"
#include "mechanics/impact/poisson.hpp"
#include "mechanics/mechanism/forms.hpp"
#include "mechanics/mechanism/names.hpp"

namespace slipproof {

namespace {

using bodies_in_motion::plus;
using bodies_in_motion::times;
using bodies_in_motion::unplaced;

Mechanism with_optional_load(const Mechanism& mechanism) {
  Mechanism result = without_load(mechanism);
  if (mechanism.load) result.parameters.back().optional = true;
  return result;
}

class ImpactDerivation {
 public:
  /// `suffix` ends the names of velocities.
  ImpactDerivation(const Mechanism& mechanism, const Bodies& bodies, ImpactLaw law, std::string suffix,
                   Mistakes& mistakes)
      : names_(mechanism),
        suffix_(std::move(suffix)),
        mistakes_(mistakes),
        result_(with_optional_load(mechanism)),
        bodies_(bodies) {
    result_.impact.emplace();
    result_.impact->law = law;
  }

  /// Of each contact.
  std::vector<Expression> restitutions() {
    std::vector<Expression> result;
    for (std::size_t i = 0; i < result_.contacts.size(); ++i) {
      const bool open = result_.contacts[i].start == ElementKind::Start::open;
      result.push_back(open ? zero_literal() : restitution_of(i));
    }
    return result;
  }

  Mechanism derive(const BodyGeometry& geometry, const Approaches& approaches) {
    take_velocities();
    leave_out_friction();
    prepare_contacts(geometry);
    const std::size_t shapes = result_.shapes.size();
    result_.equations.clear();
    derive_mechanism(bodies_, result_, mistakes_);
    result_.shapes.resize(shapes);  // they are drawn already
    for (MechanismEquation& equation : result_.equations) {
      equation.right = equation.left;
      equation.right.expression = substitute(equation.left.expression, [&](const std::string& s) { return before(s); });
    }
    for (std::size_t i = 0; i < result_.contacts.size(); ++i) restore(i, approaches[i]);
    derive_forms(result_, mistakes_);
    result_.bodies = std::make_shared<const Bodies>(std::move(bodies_));
    return std::move(result_);
  }

 private:
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> renamed{
      {{"ax", "vx"}, {"ay", "vy"}, {"az", "vz"}, {"alphax", "omegax"}, {"alphay", "omegay"}, {"alphaz", "omegaz"}}};

  /// The name of a velocity after; a name of the file's own stays.
  std::string velocity_name(const Body& body, std::size_t axis) const {
    auto [from, to] = renamed[axis];
    if (bodies_.dimension == 2 && axis == 5) from = "alpha", to = "omega";
    const std::string& old = body.unknowns[axis].symbol;
    const std::string tail = "_" + body.name;
    for (const std::string& suffix : {std::string(), tail}) {
      if (old != std::string(from) + suffix) continue;
      const std::string name = std::string(to) + suffix;
      return (names_.find(name) ? name + "_after" : name) + suffix_;
    }
    return old + suffix_;
  }

  /// Velocities take the place of accelerations, and nothing moves or pushes otherwise.
  void take_velocities() {
    std::size_t next = 0;
    for (Body& body : bodies_.bodies) {
      const auto velocity = unplaced(body.velocity), spin = unplaced(body.spin);
      for (std::size_t axis = 0; axis < 6; ++axis) {
        Body::Unknown& unknown = body.unknowns[axis];
        const Expression before = axis < 3 ? velocity[axis] : spin[axis - 3];
        if (unknown.symbol.empty()) {
          if (!is_literal_zero(before)) result_.impact->prescribed.push_back(before);
          continue;
        }
        result_.impact->velocities.push_back(unknown.negated ? negative_of(before) : before);
        const std::string name = velocity_name(body, axis);
        for (MechanismShape& shape : result_.shapes) {
          if (shape.acceleration == unknown.symbol) shape.acceleration = name;
        }
        unknown.symbol = name;
        MechanismUnknown& of_mechanism = result_.unknowns[next++];
        of_mechanism.symbol = name;
        if (!of_mechanism.unit.empty()) of_mechanism.unit = axis < 3 ? "m/s" : "s^-1";
      }
      body.acceleration = std::exchange(body.velocity, {});
      body.turning = std::exchange(body.spin, {});
    }
    bodies_.gravity = {};
    bodies_.forces.clear();
    bodies_.torques.clear();
    bodies_.rates.clear();
    for (BodyJoint& joint : bodies_.joints) joint.tension = {};
  }

  Expression before(const std::string& symbol) const {
    for (std::size_t i = 0; i < result_.accelerations; ++i) {
      if (result_.unknowns[i].symbol == symbol) return result_.impact->velocities[i];
    }
    return nullptr;
  }

  /// A couple with a limit of its own has no impulse; rolling resistance has one, as N has.
  void leave_out_friction() {
    bodies_.friction.clear();
    std::vector<MechanismFriction> kept;
    std::vector<std::size_t> gone;
    for (MechanismFriction& friction : result_.friction) {
      if (friction.contact) {
        kept.push_back(std::move(friction));
        kept.back().start = ElementKind::Start::rest;
        bodies_.contacts[contact_of(*kept.back().contact)].rolling = kept.size() - 1;
        continue;
      }
      for (const std::string& symbol : symbols(friction.static_limit.expression)) {
        const auto entry = names_.find(symbol);
        if (!entry || (entry->kind != NameKind::force && entry->kind != NameKind::element_force)) continue;
        mistakes_.add(friction.place, friction.name + ": found a limit with the force " + symbol +
                                          ", expected one without forces, which has no impulse, in an impact");
      }
      result_.impact->left_out.push_back(friction.name);
      gone.push_back(friction.force);
    }
    result_.friction = std::move(kept);
    std::ranges::sort(gone, std::greater<>());
    for (const std::size_t unknown : gone) remove_unknown(unknown);
  }

  std::size_t contact_of(std::size_t contact) const {
    const auto found = std::ranges::find(bodies_.contacts, contact, &BodyContact::contact);
    return static_cast<std::size_t>(found - bodies_.contacts.begin());
  }

  void remove_unknown(std::size_t gone) {
    result_.unknowns.erase(result_.unknowns.begin() + static_cast<std::ptrdiff_t>(gone));
    const auto shift = [&](std::size_t& unknown) { unknown -= unknown > gone ? 1 : 0; };
    for (MechanismContact& contact : result_.contacts) {
      shift(contact.normal);
      if (contact.tangent) shift(*contact.tangent);
      if (contact.second) shift(contact.second->force);
    }
    for (MechanismLink& link : result_.links) shift(link.force);
    for (std::size_t i = 0; i < result_.friction.size(); ++i) {
      shift(result_.friction[i].force);
      result_.unknowns[result_.friction[i].force].owner = i;
    }
  }

  /// Velocities before; and which way a contact slid does not matter to its impulse.
  void prepare_contacts(const BodyGeometry& geometry) {
    using Start = ElementKind::Start;
    result_.impact->contacts.resize(result_.contacts.size());
    for (const ElementVelocity& velocity : geometry.velocities) {
      if (velocity.element >= result_.contacts.size()) continue;
      MechanismContact& contact = result_.contacts[velocity.element];
      const bool apart = velocity.state_given && contact.start == Start::open;
      contact.start = apart ? Start::open : Start::rest;
      contact.sliding.clear();
      contact.static_friction = contact.kinetic_friction;
      MechanismImpact::Contact& before = result_.impact->contacts[velocity.element];
      before.name = contact.name;
      before.gap = contact.gap_name;
      if (velocity.sliding) before.slip = contact.slip_name;
      if (contact.second) before.second_slip = contact.second->name;
      before.restored = zero_literal();
      before.sliding = velocity.sliding;
      before.second = velocity.second;
      if (!apart) before.opening = velocity.opening;
    }
  }

  /// 0 at joints and guides, which do not open. Reports one that is missing.
  Expression restitution_of(std::size_t contact) {
    const std::size_t index = contact_of(contact);
    if (index == bodies_.contacts.size() || result_.contacts[contact].bilateral) return zero_literal();
    if (const PlacedExpression& given = bodies_.contacts[index].restitution) return unplaced(given);
    mistakes_.add(result_.contacts[contact].place,
                  "contact " + result_.contacts[contact].name +
                      ": missing restitution, from 0 to 1, here or for all contacts at the top of the mechanism");
    return zero_literal();
  }

  void restore(std::size_t index, std::optional<int> approach) {
    MechanismImpact::Contact& before = result_.impact->contacts[index];
    if (!before.opening) return;
    restore_sliding(index);
    if (is_literal_zero(before.opening) || result_.impact->law == ImpactLaw::poisson) return;
    const Expression e = restitution_of(index);
    const bool by_sign = result_.impact->law == ImpactLaw::newton;
    if (by_sign && approach && *approach >= 0) return;
    const Expression approaching =
        by_sign && !approach ? make(Operation::minimum, {zero_literal(), before.opening}) : before.opening;
    before.restored = times(e, approaching);
    add(result_.contacts[index].gap, before.restored);
  }

  void restore_sliding(std::size_t index) {
    MechanismContact& contact = result_.contacts[index];
    const std::size_t in_bodies = contact_of(index);
    if (contact.frictionless() || in_bodies == bodies_.contacts.size()) return;
    const PlacedExpression& given = bodies_.contacts[in_bodies].tangential_restitution;
    if (!given) return;
    if (result_.impact->law == ImpactLaw::poisson) return have_none(contact, given);
    MechanismImpact::Contact& before = result_.impact->contacts[index];
    before.slip_restored = times(unplaced(given), before.sliding);
    add(contact.slip, before.slip_restored);
    if (!contact.second) return;
    before.second_restored = times(unplaced(given), before.second);
    add(contact.second->slip, before.second_restored);
  }

  /// Poisson's law has no tangential restitution.
  void have_none(const MechanismContact& contact, const PlacedExpression& given) {
    const Expression e = unplaced(given);
    if (is_literal_zero(e)) return;
    if (symbols(e).empty()) {
      mistakes_.add(given.place(), "tangential_restitution: found one with Poisson's law, expected none or 0");
    }
    result_.assume.push_back(
        {contact.name + "-tangential-restitution",
         {make_comparison({e, zero_literal()}, {Relation::equal}), PlacedText("", given.place())}});
  }

  static void add(PlacedExpression& to, const Expression& constant) { to.expression = plus(to.expression, constant); }

  const MechanismNames names_;
  const std::string suffix_;
  Mistakes& mistakes_;
  Mechanism result_;
  Bodies bodies_;
};

}  // namespace

Mechanism impact_of(const Mechanism& mechanism, const Bodies& bodies, const BodyGeometry& geometry,
                    const Approaches& approaches, ImpactLaw law, Mistakes& mistakes) {
  const auto derivation = [&](const std::string& suffix) {
    return ImpactDerivation(mechanism, bodies, law, suffix, mistakes);
  };
  if (law != ImpactLaw::poisson) return derivation("").derive(geometry, approaches);
  const std::vector<Expression> restitution = derivation("").restitutions();
  if (!mistakes.empty()) return mechanism;
  if (bodies.dimension == 3) return derivation("").derive(geometry, approaches);
  return poisson_of(derivation("").derive(geometry, approaches),
                    derivation("_compression").derive(geometry, approaches), restitution, mistakes);
}

Mechanism with_approach(Mechanism mechanism) {
  std::vector<Expression> approaches;
  for (const MechanismImpact::Contact& contact : mechanism.impact->contacts) {
    if (contact.opening) approaches.push_back(make_comparison({contact.opening, zero_literal()}, {Relation::less}));
  }
  if (approaches.empty()) {
    throw InputError({{mechanism.file, 0, 0, "found no contact that is closed, expected one that approaches"}});
  }
  const Expression any =
      approaches.size() == 1 ? approaches.front() : make(Operation::logical_or, std::move(approaches));
  mechanism.assume.push_back({"approach", {any, PlacedText()}});
  return mechanism;
}

}  // namespace slipproof
