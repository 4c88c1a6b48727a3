// Contacts of points and discs with lines and discs; in space of points and spheres with planes and spheres.
//
// An observer on the body that has the line sees it at rest with normal n and directions t, and the centre P of a disc
// of radius R move with velocity v and acceleration a. So the distance n.(P - Q) - R has the second derivative n.a. The
// material points that touch slide by t.v + R (t x n).(w - w'), where w and w' are the spins of the disc and of the
// observer: its derivative is t.a + R (t x n).(alpha - alpha' - w' x w), what the observer sees of the turning. In the
// plane t x n is the axis out of it, and w' x w is 0.
//
// Two discs have their normal along r = P - P', of length D: R + R' if they touch. Then |r| has the second derivative
// n.r'' + sum (t.r')^2/D, and with W = R w + R' w' the sliding t.r' + (t x n).W has the first derivative t.r'' - (t.r')
// (n.r')/D + (t x n).W' +- (s.r') (W.n)/D, where s is the other direction: n turns by (t.r')/D towards t, and the
// directions turn with it and not about it. In the plane W.n is 0. A ring has a negative R', and D is negative: the
// normal points out of its material.
#include "mechanics/bodies/identity.hpp"
#include "mechanics/bodies/parts.hpp"
#include "mechanics/bodies/sure_sign.hpp"

namespace slipproof::bodies_in_motion {

namespace {

/// A direction in which slip counts.
struct Tangent {
  SceneVector along, about;   ///< `about` = along x normal: a turn about it slides along
  Expression velocity, slip;  ///< of the material points that touch, and its derivative
};

/// Distance, velocities and accelerations of one contact.
struct Touch {
  SceneVector place, normal;  ///< where it touches; the direction of N
  Expression distance, opening, gap;
  std::vector<Tangent> tangents;  ///< one, in space two
};

const std::string& contact_name(const Derivation& d, const BodyContact& contact) {
  return d.mechanism.contacts[contact.contact].name;
}

/// A direction of the file, in the axes of the scene.
SceneVector given_tangent(Derivation& d, const BodyContact& contact, const Frame& on, const SceneVector& normal,
                          const PlacedVector& given, const std::string& key) {
  const SceneVector along = on.in_scene(unplaced(given));
  d.must_have_length_1(along, contact_name(d, contact) + ": " + key, given.place);
  const bool is_along = is_literal_zero(moment(normal, along)) && !is_literal_zero(along) && !is_literal_zero(normal);
  if (d.in_space() && is_along) {
    d.mistakes.add(given.place, contact_name(d, contact) + ": " + key +
                                    ": found a direction along the normal, expected one across it");
  }
  d.must_vanish(dot(along, normal), contact_name(d, contact) + (d.in_space() ? "-tangent" : "-slip-direction"),
                key + ": found a direction that makes the cosine X with the normal, expected one along the " +
                    (d.in_space() ? "plane" : "line"),
                given.place);
  return along;
}

/// Of contacts with friction, in the plane of all: pictures show the direction.
std::vector<Tangent> tangents(Derivation& d, const BodyContact& contact, const Frame& on, const SceneVector& normal) {
  if (!d.in_space()) {
    const auto [clockwise, inward] = *d.across(normal);
    if (!contact.slip_direction) return {{clockwise, -inward, {}, {}}};
    const SceneVector along = given_tangent(d, contact, on, normal, contact.slip_direction, "slip_direction");
    return {{along, dot(along, clockwise) * -inward, {}, {}}};
  }
  if (d.mechanism.contacts[contact.contact].frictionless()) return {};
  SceneVector first, second;
  if (contact.tangent) {
    first = given_tangent(d, contact, on, normal, contact.tangent, "tangent");
    second = moment(normal, first);
  } else if (const auto chosen = d.across(normal)) {
    first = chosen->first, second = chosen->second;
  } else {
    d.mistakes.add(contact.place, "contact " + contact_name(d, contact) +
                                      ": missing tangent, a direction across the normal in the axes of `on`: the "
                                      "normal may point anywhere, so that none is rational for all parameters");
    return {};
  }
  return {{first, -second, {}, {}}, {second, first, {}, {}}};
}

Touch on_line(Derivation& d, const BodyContact& contact) {
  const Frame &of = d.frames[contact.of], &on = d.frames[contact.on];
  const MovingPoint centre(of, unplaced(contact.point));
  const RelativePoint seen(centre, on);
  const Expression radius = unplaced(contact.radius);
  Touch touch;
  touch.normal = on.in_scene(unplaced(contact.normal));
  d.must_have_length_1(touch.normal, contact_name(d, contact) + ": normal", contact.normal.place);
  touch.tangents = tangents(d, contact, on, touch.normal);
  touch.place = centre.place - radius * touch.normal;
  if (contact.through) {
    const SceneVector from = on.at + on.in_scene(unplaced(contact.through));
    touch.distance = minus(dot(touch.normal, centre.place - from), radius);
  }
  touch.opening = dot(touch.normal, seen.velocity);
  touch.gap = dot(touch.normal, seen.acceleration);
  const SceneVector spin = of.spin - on.spin, turning = of.turning - on.turning - cross(on.spin, of.spin);
  for (Tangent& t : touch.tangents) {
    const SceneVector rim = t.about * radius;
    t.velocity = plus(dot(t.along, seen.velocity), dot(rim, spin));
    t.slip = plus(dot(t.along, seen.acceleration), dot(rim, turning));
  }
  return touch;
}

/// The distance of two centres, negative in a ring.
Expression between_centres(Derivation& d, const BodyContact& contact, const SceneVector& between,
                           const Expression& radii) {
  const bool is_open = d.mechanism.contacts[contact.contact].start == ElementKind::Start::open;
  if (!is_open) return radii;
  const Expression distance = d.distance(between, "contact", contact_name(d, contact), contact.place);
  if (!distance) return radii;
  const Signs signs = sure_signs(d.mechanism, unplaced(contact.on_radius));
  return !signs.negative                  ? distance
         : !signs.zero && !signs.positive ? negative_of(distance)
                                          : times(make(Operation::signum, {radii}), distance);
}

Touch on_disc(Derivation& d, const BodyContact& contact) {
  const Frame &of = d.frames[contact.of], &on = d.frames[contact.on];
  const MovingPoint centre(of, unplaced(contact.point)), other(on, unplaced(contact.on_point));
  const Expression radius = unplaced(contact.radius), on_radius = unplaced(contact.on_radius);
  const Expression radii = plus(radius, on_radius);
  const SceneVector between = centre.place - other.place, velocity = centre.velocity - other.velocity,
                    acceleration = centre.acceleration - other.acceleration;
  const Expression apart = between_centres(d, contact, between, radii);
  Touch touch;
  touch.normal = between / apart;
  touch.tangents = tangents(d, contact, on, touch.normal);
  touch.place = centre.place - radius * touch.normal;
  // |r|^2 - D^2, over what turns it into the distance near 0; its sign is that of the distance where D > 0
  touch.distance = quotient_of(minus(dot(between, between), make_power(radii, 2)), times(make_number(2), radii));
  touch.opening = dot(touch.normal, velocity);
  const auto squares = [&](const SceneVector& one) { return times(dot(one, velocity), dot(one, velocity)); };
  Expression across = zero_literal();
  if (d.in_space()) {  // |r'|^2 - (n.r')^2, which needs no directions
    across = minus(dot(velocity, velocity), squares(touch.normal));
  } else {
    across = squares(touch.tangents[0].along);
  }
  touch.gap = plus(dot(touch.normal, acceleration), over(across, apart));
  const SceneVector spin = radius * of.spin + on_radius * on.spin,
                    turning = radius * of.turning + on_radius * on.turning;
  for (Tangent& t : touch.tangents) {
    const Expression along = dot(t.along, velocity);
    t.velocity = plus(along, dot(t.about, spin));
    const Expression turned = over(times(along, touch.opening), apart);
    t.slip = plus(minus(dot(t.along, acceleration), turned), dot(t.about, turning));
    // The other direction: about = along x normal is the opposite of it, or it.
    t.slip = minus(t.slip, over(times(dot(t.about, velocity), dot(spin, touch.normal)), apart));
  }
  return touch;
}

void add_rolling(Derivation& d, const BodyContact& contact, const MechanismContact& touched) {
  MechanismFriction& rolling = d.mechanism.friction[*contact.rolling];
  const Frame &of = d.frames[contact.of], &on = d.frames[contact.on];
  const Place place = contact.rolling_resistance.place();
  const Expression normal = make_symbol(d.mechanism.unknowns[touched.normal].symbol);
  rolling.slip = d.derived(minus(of.turning.z, on.turning.z), place);
  rolling.static_limit = rolling.kinetic_limit = d.derived(times(unplaced(contact.rolling_resistance), normal), place);
  d.geometry.velocities.push_back(
      {d.mechanism.contacts.size() + *contact.rolling, nullptr, nullptr, minus(of.spin.z, on.spin.z), false, place});
}

void check_restitution(Derivation& d, const BodyContact& contact, const PlacedExpression& given,
                       const std::string& key) {
  if (!given) return;
  const Expression e = unplaced(given);
  const std::string& name = contact_name(d, contact);
  const auto hold = [&](const Expression& value, const std::string& found) {
    d.must_be(GeometryFact::Kind::not_negative, value, name + "-restitution",
              "contact " + name + ": " + key + ": found " + found + ", expected 0 to 1", given.place(), true);
  };
  hold(e, "X");
  hold(minus(make_number(1), e), "e with 1 - e = X");
}

/// Of the sliding velocity in space, along the two directions: a number where its length is one.
void add_sliding(Derivation& d, const std::vector<Tangent>& tangents, ElementVelocity& velocity) {
  velocity.sliding = tangents[0].velocity;
  if (tangents.size() < 2) return;
  velocity.second = tangents[1].velocity;
  const Expression &first = velocity.sliding, &second = velocity.second;
  if (is_literal_zero(first) && is_literal_zero(second)) return;
  velocity.speed = root_of_square(d.mechanism, plus(times(first, first), times(second, second))).value_or(nullptr);
}

}  // namespace

void derive_contact(Derivation& d, const BodyContact& contact) {
  MechanismContact& result = d.mechanism.contacts[contact.contact];
  const Touch touch = contact.on_radius ? on_disc(d, contact) : on_line(d, contact);
  result.gap = d.derived(touch.gap, contact.place);
  result.at = d.derived(touch.place, contact.place);
  result.direction = d.derived(touch.normal, contact.place);
  ElementVelocity velocity{contact.contact, touch.distance, touch.opening, nullptr, contact.state_given, contact.place};
  if (!touch.tangents.empty()) {
    if (!result.slip_name.empty()) result.slip = d.derived(touch.tangents[0].slip, contact.place);
    result.slip_direction = d.derived(touch.tangents[0].along, contact.place);
    if (!result.frictionless()) add_sliding(d, touch.tangents, velocity);
  }
  if (result.second && touch.tangents.size() == 2) {
    result.second->slip = d.derived(touch.tangents[1].slip, contact.place);
    result.second->direction = d.derived(touch.tangents[1].along, contact.place);
  }
  d.geometry.velocities.push_back(std::move(velocity));
  check_restitution(d, contact, contact.restitution, "restitution");
  check_restitution(d, contact, contact.tangential_restitution, "tangential_restitution");
  if (contact.rolling) add_rolling(d, contact, result);
}

void derive_friction(Derivation& d, const BodyFriction& friction) {
  const Frame &first = d.frames[friction.first], &second = d.frames[friction.second];
  d.mechanism.friction[friction.friction].slip = d.derived(minus(first.turning.z, second.turning.z), friction.place);
  d.geometry.velocities.push_back({d.mechanism.contacts.size() + friction.friction, nullptr, nullptr,
                                   minus(first.spin.z, second.spin.z), friction.state_given, friction.place});
}

}  // namespace slipproof::bodies_in_motion
