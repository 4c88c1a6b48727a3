#include "mechanics/bodies/derive.hpp"

#include <algorithm>

#include "base/expression/cases.hpp"
#include "mechanics/bodies/frame.hpp"
#include "mechanics/bodies/identity.hpp"
#include "mechanics/bodies/parts.hpp"

namespace slipproof {

namespace bodies_in_motion {

Derivation::Derivation(const Bodies& scene, Mechanism& result, Mistakes& list)
    : bodies(scene),
      mechanism(result),
      mistakes(list),
      frames(bodies_in_motion::frames(scene)),
      loads(scene.bodies.size()) {
  for (Load& load : loads) load = {{zero_literal(), zero_literal()}, zero_literal()};
}

PlacedExpression Derivation::derived(const Expression& expression, Place place) {
  return {expression, PlacedText("", place)};
}

std::vector<PlacedExpression> Derivation::derived(const PlanarVector& vector, Place place) {
  return {derived(vector.x, place), derived(vector.y, place)};
}

void Derivation::must_be(GeometryFact::Kind kind, const Expression& value, std::string name, std::string what,
                         Place place) {
  if (kind == GeometryFact::Kind::zero && is_literal_zero(value)) return;
  geometry.facts.push_back({kind, value, std::move(name), std::move(what), place});
}

void Derivation::must_vanish(const Expression& value, std::string name, std::string what, Place place) {
  must_be(GeometryFact::Kind::zero, value, std::move(name), std::move(what), place);
}

void Derivation::must_have_length_1(const PlanarVector& vector, const std::string& name, Place place) {
  must_vanish(minus(dot(vector, vector), make_number(1)), name + "-has-length-1",
              name + ": found a vector whose length squared is 1 plus X, expected one of length 1", place);
}

Expression Derivation::distance(const PlanarVector& between, const std::string& kind, const std::string& name,
                                Place place) {
  const Expression square = dot(between, between);
  const auto root = root_of_square(mechanism, square);
  if (!root) {
    mistakes.add(place, kind + " " + name + ": found a distance whose square is " + in_quotes(to_string(square)) +
                            ", which is not the square of a rational expression, expected places at a rational "
                            "distance, such as (3/5, 4/5), or a distance times the cosine and sine of an angle");
    return nullptr;
  }
  must_be(GeometryFact::Kind::positive, *root, name + "-is-apart",
          kind + " " + name + ": found the distance X, which leaves its direction open, expected one above 0", place);
  return *root;
}

void Derivation::push(std::size_t body, const PlanarVector& arm, const PlanarVector& force) {
  loads[body].force = loads[body].force + force;
  loads[body].moment = plus(loads[body].moment, cross(arm, force));
}

void Derivation::turn(std::size_t body, const Expression& couple) {
  loads[body].moment = plus(loads[body].moment, couple);
}

namespace {

void apply_forces(Derivation& d) {
  for (const BodyForce& force : d.bodies.forces) {
    const Frame& frame = d.frames[force.on];
    const PlanarVector arm = frame.in_scene(unplaced(force.at));
    const PlanarVector is = force.follows ? frame.in_scene(unplaced(force.is)) : unplaced(force.is);
    d.push(force.on, arm, is);
    if (force.back_on) d.push(*force.back_on, frame.at + arm - d.frames[*force.back_on].at, -is);
  }
  for (const BodyTorque& torque : d.bodies.torques) {
    d.turn(torque.on, unplaced(torque.is));
    if (torque.back_on) d.turn(*torque.back_on, negative_of(unplaced(torque.is)));
  }
}

void add_equation(Derivation& d, const Body::Unknown& unknown, const PlacedExpression& inertia, const Expression& push,
                  Place place) {
  if (unknown.symbol.empty()) return;
  MechanismEquation equation;
  equation.name = unknown.symbol;
  equation.left = d.derived(times(unplaced(inertia), make_symbol(unknown.symbol)), place);
  equation.right = d.derived(unknown.negated ? negative_of(push) : push, place);
  d.mechanism.equations.push_back(std::move(equation));
}

void write_equations(Derivation& d) {
  d.mechanism.by_virtual_work = true;
  const PlanarVector gravity = unplaced(d.bodies.gravity);
  for (std::size_t i = 0; i < d.bodies.bodies.size(); ++i) {
    const Body& body = d.bodies.bodies[i];
    if (body.is_prescribed()) continue;
    const PlanarVector push = unplaced(body.mass) * gravity + d.loads[i].force;
    add_equation(d, body.ax, body.mass, push.x, body.mass.place());
    add_equation(d, body.ay, body.mass, push.y, body.mass.place());
    add_equation(d, body.alpha, body.inertia, d.loads[i].moment, body.inertia ? body.inertia.place() : body.place);
  }
}

/// What the file divides by is not 0, wherever its quotients are multiplied by 0.
void check_divisors(Derivation& d) {
  const auto check = [&](const PlacedExpression& placed, const std::string& key) {
    if (!placed) return;
    for (const Expression& divisor : divisors(placed.expression)) {
      d.must_be(GeometryFact::Kind::not_zero, unplaced(PlacedExpression{divisor, placed.text}), key + "-divides",
                key + ": found a division by X, expected one by another number", placed.place(divisor));
    }
  };
  for (const MechanismDefinition& one : d.mechanism.definitions) check(one.expression, one.symbol);
  visit_expressions(
      d.bodies, [&](const PlacedExpression& placed, std::string_view key, bool) { check(placed, std::string(key)); });
}

void check_body(Derivation& d, const Body& body) {
  const std::string name = "body " + body.name + ": ";
  if (body.cosine) {
    d.must_vanish(minus(plus(make_power(unplaced(body.cosine), 2), make_power(unplaced(body.sine), 2)), make_number(1)),
                  body.name + "-angle",
                  name + "found an angle whose cosine and sine have squares that add up to 1 plus X, expected 1",
                  body.cosine.place());
  }
  // What a joint holds may have neither: a wheel whose mass is counted with the frame's.
  const bool held = std::ranges::any_of(d.bodies.joints, [&](const BodyJoint& joint) {
    return &d.bodies.bodies[joint.first] == &body || &d.bodies.bodies[joint.second] == &body;
  });
  const auto check = [&](const PlacedExpression& value, const std::string& quantity) {
    if (!value) return;
    d.must_be(held ? GeometryFact::Kind::not_negative : GeometryFact::Kind::positive, unplaced(value),
              body.name + "-" + quantity,
              name + "found the " + quantity + " X, expected one " + (held ? "of 0 or more" : "above 0"),
              value.place());
  };
  check(body.mass, "mass");
  check(body.inertia, "inertia");
}

}  // namespace

}  // namespace bodies_in_motion

BodyGeometry derive_mechanism(const Bodies& bodies, Mechanism& mechanism, Mistakes& mistakes) {
  using namespace bodies_in_motion;
  Derivation derivation(bodies, mechanism, mistakes);
  check_divisors(derivation);
  for (const Body& body : bodies.bodies) check_body(derivation, body);
  for (const BodyContact& contact : bodies.contacts) derive_contact(derivation, contact);
  for (const BodyJoint& joint : bodies.joints) derive_joint(derivation, joint);
  for (const BodyFriction& friction : bodies.friction) derive_friction(derivation, friction);
  apply_forces(derivation);
  write_equations(derivation);
  draw_shapes(derivation);
  return std::move(derivation.geometry);
}

}  // namespace slipproof
