#include "mechanics/bodies/derive.hpp"

#include <algorithm>

#include "base/expression/cases.hpp"
#include "mechanics/bodies/frame.hpp"
#include "mechanics/bodies/identity.hpp"
#include "mechanics/bodies/parts.hpp"
#include "mechanics/bodies/sure_sign.hpp"

namespace slipproof {

namespace bodies_in_motion {

Derivation::Derivation(const Bodies& scene, Mechanism& result, Mistakes& list)
    : bodies(scene),
      mechanism(result),
      mistakes(list),
      frames(bodies_in_motion::frames(scene)),
      loads(scene.bodies.size()),
      carried(scene.bodies.size()) {}

PlacedExpression Derivation::derived(const Expression& expression, Place place) {
  return {expression, PlacedText("", place)};
}

std::vector<PlacedExpression> Derivation::derived(const SceneVector& vector, Place place) const {
  std::vector<PlacedExpression> result;
  for (std::size_t i = 0; i < bodies.dimension; ++i) result.push_back(derived(vector[i], place));
  return result;
}

void Derivation::must_be(GeometryFact::Kind kind, const Expression& value, std::string name, std::string what,
                         Place place, bool somewhere) {
  if (kind == GeometryFact::Kind::zero && is_literal_zero(value)) return;
  geometry.facts.push_back({kind, value, std::move(name), std::move(what), place, somewhere});
}

void Derivation::must_vanish(const Expression& value, std::string name, std::string what, Place place) {
  must_be(GeometryFact::Kind::zero, value, std::move(name), std::move(what), place);
}

void Derivation::must_have_length_1(const SceneVector& vector, const std::string& name, Place place) {
  if (is_literal_zero(vector)) {
    mistakes.add(place, name + ": found a vector of length 0, expected one of length 1");
    return;
  }
  must_vanish(minus(dot(vector, vector), make_number(1)), name + "-has-length-1",
              name + ": found a vector whose length squared is 1 plus X, expected one of length 1", place);
}

Expression Derivation::distance(const SceneVector& between, const std::string& kind, const std::string& name,
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

void Load::push(const SceneVector& arm, const SceneVector& by) {
  force = force + by;
  moment = moment + bodies_in_motion::moment(arm, by);
}

/// Where a coordinate is 0, an axis is one of them. Otherwise x and y, turned as z is turned into the direction n:
/// x - n.x (z + n)/(1 + n.z), or the same from another axis with which n makes no angle of half a turn.
std::optional<Derivation::Across> Derivation::across(const SceneVector& n) const {
  const SceneVector z = axis(2);
  if (!in_space()) return Across{-cross(z, n), -z};
  if (is_literal_zero(n.y)) return Across{moment(axis(1), n), axis(1)};
  if (is_literal_zero(n.x)) return Across{axis(0), moment(n, axis(0))};
  if (is_literal_zero(n.z)) return Across{moment(z, n), z};
  for (std::size_t i : {2U, 0U, 1U}) {
    for (const bool backward : {false, true}) {
      const Expression along = backward ? negative_of(n[i]) : n[i];
      if (sure_signs(mechanism, along).negative) continue;
      const SceneVector from = backward ? -axis(i) : axis(i), both = (from + n) / plus(make_number(1), along);
      const SceneVector own = axis((i + 1) % 3), first = own - n[(i + 1) % 3] * both;
      return Across{first, moment(n, first)};
    }
  }
  return std::nullopt;
}

namespace {

void apply_forces(Derivation& d) {
  for (const BodyForce& force : d.bodies.forces) {
    const Frame& frame = d.frames[force.on];
    const SceneVector arm = frame.in_scene(unplaced(force.at));
    const SceneVector is = force.follows ? frame.in_scene(unplaced(force.is)) : unplaced(force.is);
    d.loads[force.on].push(arm, is);
    if (force.back_on) d.loads[*force.back_on].push(frame.at + arm - d.frames[*force.back_on].at, -is);
  }
  for (const BodyTorque& torque : d.bodies.torques) {
    const SceneVector given = unplaced(torque.is);
    const SceneVector is = torque.follows ? d.frames[torque.on].in_scene(given) : given;
    d.loads[torque.on].turn(is);
    if (torque.back_on) d.loads[*torque.back_on].turn(-is);
  }
}

/// The inertia in the axes of the scene: R I R^T.
std::array<SceneVector, 3> inertia_in_scene(const Body& body, const Frame& frame) {
  std::array<SceneVector, 3> rows;  // I R^T, then its columns turned
  for (std::size_t i = 0; i < 3; ++i) {
    SceneVector row;
    for (std::size_t j = 0; j < 3; ++j) row = row + unplaced(body.inertia.at(std::min(i, j), std::max(i, j))) * axis(j);
    rows[i] = frame.in_scene(row);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const SceneVector column = frame.in_scene({rows[0][j], rows[1][j], rows[2][j]});
    for (std::size_t i = 0; i < 3; ++i) (j == 0 ? rows[i].x : j == 1 ? rows[i].y : rows[i].z) = column[i];
  }
  return rows;
}

/// inertia . accelerations = push, for one unknown of a body.
void add_equation(Derivation& d, const Body& body, std::size_t unknown, const Expression& inertial,
                  const Expression& push, Place place) {
  const Body::Unknown& one = body.unknowns[unknown];
  if (one.symbol.empty()) return;
  MechanismEquation equation;
  equation.name = one.symbol;
  equation.left = d.derived(one.negated ? negative_of(inertial) : inertial, place);
  equation.right = d.derived(one.negated ? negative_of(push) : push, place);
  d.mechanism.equations.push_back(std::move(equation));
}

/// Newton, and Euler about the centre of mass: J alpha = M - omega x J omega.
void write_equations(Derivation& d) {
  d.mechanism.by_virtual_work = true;
  const SceneVector gravity = unplaced(d.bodies.gravity);
  for (std::size_t i = 0; i < d.bodies.bodies.size(); ++i) {
    const Body& body = d.bodies.bodies[i];
    if (body.is_prescribed()) continue;
    const Frame& frame = d.frames[i];
    const SceneVector push = unplaced(body.mass) * gravity + d.loads[i].force;
    const SceneVector inertial = unplaced(body.mass) * frame.acceleration + d.carried[i].force;
    for (std::size_t k = 0; k < 3; ++k) add_equation(d, body, k, inertial[k], push[k], body.mass.place());
    if (!body.turns_freely()) continue;
    const auto inertia = inertia_in_scene(body, frame);
    const auto along = [&](const SceneVector& turning) {
      return SceneVector{dot(inertia[0], turning), dot(inertia[1], turning), dot(inertia[2], turning)};
    };
    const SceneVector turning = along(frame.turning) + d.carried[i].moment,
                      couple = d.loads[i].moment - moment(frame.spin, along(frame.spin));
    for (std::size_t k = 0; k < 3; ++k) add_equation(d, body, 3 + k, turning[k], couple[k], body.inertia.place());
  }
}

/// What the file divides by is not 0, wherever its quotients are multiplied by 0. Where a velocity was found from
/// others (find_velocities()), that is known.
void check_divisors(Derivation& d) {
  const auto check = [&](const PlacedExpression& placed, const std::string& key) {
    if (!placed || placed.text.text().empty()) return;
    for (const Expression& divisor : divisors(placed.expression)) {
      d.must_be(GeometryFact::Kind::not_zero, unplaced(PlacedExpression{divisor, placed.text}), key + "-divides",
                key + ": found a division by X, expected one by another number", placed.place(divisor));
    }
  };
  for (const MechanismDefinition& one : d.mechanism.definitions) check(one.expression, one.symbol);
  visit_expressions(
      d.bodies, [&](const PlacedExpression& placed, std::string_view key, bool) { check(placed, std::string(key)); });
}

void check_turn(Derivation& d, const Body& body) {
  if (body.turn_axis)
    d.must_have_length_1(unplaced(body.turn_axis), "body " + body.name + ": axis", body.turn_axis.place);
  if (!body.quaternion[0]) return;
  Expression square = zero_literal();
  for (const PlacedExpression& part : body.quaternion) square = plus(square, times(unplaced(part), unplaced(part)));
  d.must_be(GeometryFact::Kind::positive, square, body.name + "-turn",
            "body " + body.name + ": found a quaternion of length 0, expected w x y z", body.quaternion[0].place());
}

/// No moment of inertia is larger than the other two together. With the principal minors of S = (trace I)/2 - I: the
/// second moments of the mass, which are no less than 0.
void check_inertia(Derivation& d, const Body& body, bool held) {
  const auto own = [&](std::size_t i, std::size_t j) { return unplaced(body.inertia.at(i, j)); };
  const auto more = [&](std::size_t i) {
    const Expression a = own((i + 1) % 3, (i + 1) % 3), b = own((i + 2) % 3, (i + 2) % 3), c = own(i, i);
    return same(a, c) ? b : same(b, c) ? a : minus(plus(a, b), c);
  };
  const std::array<Expression, 3> moments{more(0), more(1), more(2)};
  const std::string name = "body " + body.name + ": ";
  constexpr std::array<std::string_view, 3> axes{"xx", "yy", "zz"};
  for (std::size_t i = 0; i < 3; ++i) {
    const PlacedExpression& entry = body.inertia.entries[i];
    d.must_be(GeometryFact::Kind::not_negative, moments[i], body.name + "-inertia-" + std::string(axes[i]),
              name + "found the moment of inertia " + std::string(axes[i]) +
                  " larger than the other two together, which no body has: their sum less it is X, expected 0 or more",
              entry.place(), true);
    d.must_be(held ? GeometryFact::Kind::not_negative : GeometryFact::Kind::positive, own(i, i), body.name + "-inertia",
              name + "found the inertia X, expected one " + (held ? "of 0 or more" : "above 0"), entry.place());
  }
  const Expression xy = own(0, 1), xz = own(0, 2), yz = own(1, 2), four = make_number(4);
  if (is_literal_zero(xy) && is_literal_zero(xz) && is_literal_zero(yz)) return;
  const auto minor = [&](std::size_t i, std::size_t j, const Expression& mixed) {
    return minus(times(moments[i], moments[j]), times(four, times(mixed, mixed)));
  };
  const std::string fits =
      name + "found products of inertia that are too large for its moments by X, expected a body's";
  const auto hold = [&](const Expression& value) {
    d.must_be(GeometryFact::Kind::not_negative, value, body.name + "-inertia", fits, body.inertia.place(), true);
  };
  hold(minor(0, 1, xy)), hold(minor(0, 2, xz)), hold(minor(1, 2, yz));
  // The determinant of twice S, whose mixed entries are -2 xy and so on.
  const Expression mixed = times(make_number(-16), times(xy, times(xz, yz)));
  const Expression taken =
      plus(plus(times(moments[0], times(yz, yz)), times(moments[1], times(xz, xz))), times(moments[2], times(xy, xy)));
  hold(plus(times(moments[0], times(moments[1], moments[2])), minus(mixed, times(four, taken))));
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
  if (!d.in_space()) return check(body.inertia.entries[2], "inertia");
  check_turn(d, body);
  if (body.turns_freely()) check_inertia(d, body, held);
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
  for (const auto* joints : {&bodies.joints, &bodies.guides}) {
    for (const BodyJoint& joint : *joints) derive_armature(derivation, joint);
  }
  for (const BodyFriction& friction : bodies.friction) derive_friction(derivation, friction);
  apply_forces(derivation);
  write_equations(derivation);
  draw_shapes(derivation);
  return std::move(derivation.geometry);
}

}  // namespace slipproof
