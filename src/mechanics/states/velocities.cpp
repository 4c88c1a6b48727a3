#include "mechanics/states/velocities.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "base/expression/parser.hpp"
#include "mechanics/bodies/parts.hpp"
#include "mechanics/bodies/sure_sign.hpp"
#include "mechanics/mechanism/algebra.hpp"
#include "mechanics/states/linear_rates.hpp"

namespace slipproof {

namespace bodies_in_motion {

namespace {

/// A component of the velocity of a body, or of its spin.
struct UnknownRate {
  std::size_t body = 0, axis = 0;
  bool spins = false;

  /// No file can have it.
  std::string symbol() const {
    return std::string(spins ? "spin " : "velocity ") + std::to_string(axis) + " of " + std::to_string(body);
  }
};

const BodyJoint& joint_of(const Bodies& bodies, const BodyRate& rate) {
  return rate.of < bodies.joints.size() ? bodies.joints[rate.of] : bodies.guides[rate.of - bodies.joints.size()];
}

/// Of which a rate says something.
std::vector<std::size_t> bodies_of(const Bodies& bodies, const BodyRate& rate) {
  using Kind = BodyRate::Kind;
  if (rate.kind == Kind::spin || rate.kind == Kind::velocity) return {rate.of};
  if (rate.kind == Kind::rate || rate.kind == Kind::speed) {
    const BodyJoint& joint = joint_of(bodies, rate);
    return {joint.first, joint.second};
  }
  return {bodies.contacts[rate.of].of, bodies.contacts[rate.of].on};
}

/// Bodies that joints and guides hold together. The ground and bodies that move as prescribed hold nothing together.
std::vector<bool> bodies_of_linkages_in_state(const Bodies& bodies, const Mechanism& mechanism) {
  std::vector<std::size_t> linkage(bodies.bodies.size());
  std::iota(linkage.begin(), linkage.end(), std::size_t{0});
  const auto moves = [&](std::size_t i) { return !bodies.bodies[i].is_prescribed(); };
  const auto hold = [&](std::size_t a, std::size_t b) {
    if (!moves(a) || !moves(b)) return;
    const std::size_t from = linkage[a], to = linkage[b];
    std::ranges::replace(linkage, from, to);
  };
  for (const BodyJoint& joint : bodies.joints) hold(joint.first, joint.second);
  for (const BodyJoint& joint : bodies.guides) hold(joint.first, joint.second);
  for (const BodyContact& contact : bodies.contacts) {
    if (mechanism.contacts[contact.contact].bilateral) hold(contact.of, contact.on);
  }
  std::vector<bool> wanted(bodies.bodies.size());
  const auto want = [&](std::size_t body) {
    for (std::size_t i = 0; i < linkage.size(); ++i) wanted[i] = wanted[i] || (moves(i) && linkage[i] == linkage[body]);
  };
  for (const BodyRate& rate : bodies.rates) {
    for (const std::size_t body : bodies_of(bodies, rate)) {
      if (moves(body)) want(body);
    }
  }
  return wanted;
}

class Velocities {
 public:
  Velocities(Bodies& bodies, const Mechanism& mechanism, Mistakes& mistakes)
      : bodies_(bodies),
        mechanism_(mechanism),
        mistakes_(mistakes),
        place_(bodies.rates.front().is.place()),
        quotients_(mechanism) {}

  std::vector<GeometryFact> find() {
    Bodies moving = bodies_;
    name_unknowns(moving);
    Mechanism scratch = mechanism_;
    Mistakes told_later("");  // by derive_mechanism(), which meets them again
    Derivation derivation(moving, scratch, told_later);
    LinearRates rates(quotients_, unknowns_.size());
    rates_ = &rates;
    try {
      insert_joints(derivation);
      for (const BodyRate& rate : bodies_.rates) insert_rate(derivation, rate);
      insert_given();
      insert_contacts(derivation);
      finish();
    } catch (const NoQuotient&) {
      refuse("found a function such as abs in what the velocities follow from, expected quotients of polynomials");
    } catch (const Budget::Spent&) {
      refuse("found velocities that are too long to compute, expected them with the bodies: velocity and spin");
    } catch (const ExpressionError&) {
      refuse("found velocities that are too long to write, expected them with the bodies: velocity and spin");
    }
    return std::move(facts_);
  }

 private:
  void refuse(const std::string& message) { mistakes_.add(place_, "state: " + message); }

  /// Velocities first, and those of the last bodies, so that spins are left where something is.
  void name_unknowns(Bodies& moving) {
    const auto wanted = bodies_of_linkages_in_state(bodies_, mechanism_);
    const std::size_t dimension = bodies_.dimension;
    for (const bool spins : {false, true}) {
      for (std::size_t i = wanted.size(); i-- > 0;) {
        Body& body = moving.bodies[i];
        if (!wanted[i] || (spins && !body.turns_freely())) continue;
        PlacedVector& vector = spins ? body.spin : body.velocity;
        for (std::size_t k = spins && dimension == 2 ? 2 : 0; k < (spins ? 3 : dimension); ++k) {
          unknowns_.push_back({i, k, spins});
          numbers_.emplace(unknowns_.back().symbol(), unknowns_.size() - 1);
          component(vector, k) = {make_symbol(unknowns_.back().symbol()), PlacedText("", body.place)};
        }
      }
    }
  }

  static PlacedExpression& component(PlacedVector& vector, std::size_t axis) {
    return axis == 0 ? vector.x : axis == 1 ? vector.y : vector.z;
  }

  bool has_unknowns(const Expression& expression) const {
    return std::ranges::any_of(symbols(expression), [&](const auto& symbol) { return numbers_.contains(symbol); });
  }

  /// With 0 for the unknowns.
  Quotient at_rest(const Expression& expression) {
    const auto still = [&](const std::string& symbol) { return numbers_.contains(symbol) ? zero_literal() : nullptr; };
    return Quotients::shortened(quotients_.of(substitute(expression, still)));
  }

  /// An expression that is 0, and linear in the unknowns.
  RateEquation equation(const Expression& zero) {
    RateEquation result{{}, at_rest(zero)};
    for (const std::string& symbol : symbols(zero)) {
      const auto known = numbers_.find(symbol);
      if (known == numbers_.end()) continue;
      Quotient term = at_rest(derivative_of(zero, symbol));
      if (!term.over.is_zero()) result.terms.emplace(known->second, std::move(term));
    }
    return result;
  }

  /// What a file says beside what follows; returns whether they agree for all parameters.
  bool insert(const Expression& zero, const std::string& name, const std::string& key, Place place) {
    const auto more = rates_->insert(equation(zero));
    if (!more || more->over.is_zero()) return true;
    facts_.push_back({GeometryFact::Kind::zero, quotients_.expression(*more), name + "-fits",
                      key + ": found a number that differs by X from what follows from the joints and the numbers "
                            "before it, expected the same",
                      place});
    return false;
  }

  void insert_joints(Derivation& d) {
    for (const BodyJoint& joint : bodies_.joints) derive_joint(d, joint);
    for (const GeometryFact& fact : d.geometry.facts) {
      if (has_unknowns(fact.value)) rates_->insert(equation(fact.value));
    }
    for (const BodyContact& contact : bodies_.contacts) {
      if (mechanism_.contacts[contact.contact].bilateral) insert_unseen(velocity_of(d, contact).opening);
    }
  }
  /// What derive_mechanism() and settle_geometry() compare with the velocities.
  void insert_unseen(const Expression& zero) {
    if (zero && has_unknowns(zero)) rates_->insert(equation(zero));
  }

  static ElementVelocity velocity_of(Derivation& d, const BodyContact& contact) {
    derive_contact(d, contact);
    return *std::ranges::find(d.geometry.velocities, contact.contact, &ElementVelocity::element);
  }

  void insert_rate(Derivation& d, const BodyRate& rate) {
    std::string name = rate.name;
    std::ranges::replace(name, '.', '-');
    insert(minus(rate_in(d, rate), unplaced(rate.is)), name, rate.name, rate.is.place());
  }

  Expression rate_in(Derivation& d, const BodyRate& rate) {
    using Kind = BodyRate::Kind;
    switch (rate.kind) {
      case Kind::spin:
        return d.frames[rate.of].spin[rate.axis];
      case Kind::velocity:
        return MovingPoint(d.frames[rate.of], unplaced(rate.at)).velocity[rate.axis];
      case Kind::rate:
      case Kind::speed:
        return rate_of_joint(d, joint_of(bodies_, rate), rate.kind == Kind::speed);
      case Kind::opening:
        return velocity_of(d, bodies_.contacts[rate.of]).opening;
      case Kind::sliding:
        break;
    }
    const ElementVelocity velocity = velocity_of(d, bodies_.contacts[rate.of]);
    const Expression& sliding = rate.axis == 0 ? velocity.sliding : velocity.second;
    return sliding ? sliding : zero_literal();  // its tangent is a mistake, which is told later
  }

  Expression rate_of_joint(Derivation& d, const BodyJoint& joint, bool slides) {
    const Frame &first = d.frames[joint.first], &second = d.frames[joint.second];
    const SceneVector along = joint.axis ? first.in_scene(unplaced(joint.axis)) : axis(2);
    if (!slides) return dot(along, second.spin - first.spin);
    const SceneVector end =
        joint.to ? unplaced(joint.to) : second.in_body(first.at + first.in_scene(unplaced(joint.at)) - second.at);
    return dot(along, RelativePoint(MovingPoint(second, end), first).velocity);
  }

  /// One that does not agree gives way, so that it alone is told.
  void insert_given() {
    std::vector<PlacedVector*> wrong;
    for (const UnknownRate& unknown : unknowns_) {
      PlacedVector& given = vector_of(unknown);
      if (!given) continue;
      const std::string& body = bodies_.bodies[unknown.body].name;
      const std::string key = unknown.spins ? "spin" : "velocity";
      const Expression more = minus(make_symbol(unknown.symbol()), unplaced(component(given, unknown.axis)));
      if (!insert(more, body + "-" + key, "body " + body + ": " + key + along(unknown), given.place))
        wrong.push_back(&given);
    }
    for (PlacedVector* vector : wrong) *vector = {};
  }

  PlacedVector& vector_of(const UnknownRate& unknown) {
    Body& body = bodies_.bodies[unknown.body];
    return unknown.spins ? body.spin : body.velocity;
  }

  /// Those in place of joints stay closed.
  void insert_contacts(Derivation& d) {
    using Start = ElementKind::Start;
    std::vector<bool> closed;
    for (const BodyContact& contact : bodies_.contacts) closed.push_back(contact.state_given);
    for (const BodyJoint& joint : bodies_.guides) {
      for (const BodyJoint::Guide& guide : joint.guides) closed[guide.contact] = true;
    }
    for (std::size_t i = 0; i < closed.size(); ++i) {
      const BodyContact& contact = bodies_.contacts[i];
      const Start start = mechanism_.contacts[contact.contact].start;
      if (!closed[i] || start == Start::open) continue;
      const ElementVelocity velocity = velocity_of(d, contact);
      insert_unseen(velocity.opening);
      if (!contact.state_given || start != Start::rest) continue;
      insert_unseen(velocity.sliding);
      insert_unseen(velocity.second);
    }
  }

  std::string along(const UnknownRate& unknown) const {
    if (unknown.spins && bodies_.dimension == 2) return "";
    return std::string(unknown.spins ? " about " : " along ") + "xyz"[unknown.axis];
  }

  void finish() {
    const Quotient determinant = rates_->determinant();
    const auto open = rates_->undetermined();
    if (!open.empty()) return refuse_freedoms(open);
    must_be_determined(determinant);
    const auto values = rates_->values();
    std::vector<bool> given;
    for (const UnknownRate& unknown : unknowns_) given.push_back(static_cast<bool>(vector_of(unknown)));
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      if (given[i]) continue;
      PlacedVector& vector = vector_of(unknowns_[i]);
      component(vector, unknowns_[i].axis) = {quotients_.expression(values[i]), PlacedText("", place_)};
      vector.place = place_;
    }
  }

  void refuse_freedoms(const std::vector<std::size_t>& open) {
    std::string list;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const UnknownRate& unknown = unknowns_[open[i]];
      list += (i == 0                 ? ""
               : i + 1 == open.size() ? " and "
                                      : ", ") +
              std::string("the ") + (unknown.spins ? "spin of " : "velocity of ") + bodies_.bodies[unknown.body].name +
              along(unknown);
    }
    refuse(open.size() == 1 ? "1 freedom is left: " + list + " is not determined, expected one more number"
                            : std::to_string(open.size()) + " freedoms are left: " + list +
                                  " are not determined, expected as many more numbers");
  }

  /// Its numerator has no root; factors that domains keep from 0 say nothing.
  void must_be_determined(const Quotient& determinant) {
    const Factorization numerator = quotients_.factored(Quotients::shortened(determinant)).over;
    Expression product = make_number(1);
    for (const auto& [factor, exponent] : numerator.factors) {
      const Expression value = read_back(factor);
      if (sure_signs(mechanism_, value).zero) product = times(product, value);
    }
    if (product->operands.empty() && product->operation == Operation::number) return;
    facts_.push_back({GeometryFact::Kind::not_zero, product, "state-is-enough",
                      "state: found a place at which the velocities do not follow from it, as X is 0, expected another",
                      place_, true});
  }

  Bodies& bodies_;
  const Mechanism& mechanism_;
  Mistakes& mistakes_;
  const Place place_;
  Quotients quotients_;
  LinearRates* rates_ = nullptr;
  std::vector<UnknownRate> unknowns_;
  std::map<std::string, std::size_t> numbers_;  ///< of the unknowns, by symbol
  std::vector<GeometryFact> facts_;
};

}  // namespace

}  // namespace bodies_in_motion

std::vector<GeometryFact> find_velocities(Bodies& bodies, const Mechanism& mechanism, Mistakes& mistakes) {
  if (bodies.rates.empty()) return {};
  return bodies_in_motion::Velocities(bodies, mechanism, mistakes).find();
}

}  // namespace slipproof
