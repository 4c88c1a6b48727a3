// Contacts of points and discs with lines and discs.
//
// An observer on the body that has the line sees it at rest with normal n and direction t, and the centre P of a disc
// of radius R move with velocity v and acceleration a. So the distance n.(P - Q) - R has the second derivative n.a. The
// material points that touch slide by t.v + R (w - w'), where w and w' are the spins of the disc and of the observer:
// its derivative is t.a + R (alpha - alpha').
//
// Two discs have their normal along r = P - P', of length D: R + R' if they touch. Then |r| has the second derivative
// n.r'' + (t.r')^2/D, and the sliding t.r' + R w + R' w' the first derivative t.r'' - (t.r') (n.r')/D + R alpha + R'
// alpha', because t turns by -(t.r')/D. A ring has a negative R', and D is negative: the normal points out of its
// material.
#include "mechanics/bodies/parts.hpp"
#include "mechanics/bodies/sure_sign.hpp"

namespace slipproof::bodies_in_motion {

namespace {

/// Distance, velocities and accelerations of one contact.
struct Touch {
  PlanarVector place, normal, along;  ///< where it touches; the directions of N and of positive slip
  Expression distance, opening, sliding, gap, slip;
};

/// +1 or -1: the direction in which slip counts, over the normal turned clockwise.
struct Sense {
  PlanarVector along;
  Expression sign;
};

const std::string& contact_name(const Derivation& d, const BodyContact& contact) {
  return d.mechanism.contacts[contact.contact].name;
}

Sense sense(Derivation& d, const BodyContact& contact, const Frame& on, const PlanarVector& normal) {
  const PlanarVector clockwise = -turned(normal);
  if (!contact.slip_direction) return {clockwise, make_number(1)};
  const PlanarVector along = on.in_scene(unplaced(contact.slip_direction));
  const Place place = contact.slip_direction.place;
  d.must_have_length_1(along, contact_name(d, contact) + ": slip_direction", place);
  d.must_vanish(
      dot(along, normal), contact_name(d, contact) + "-slip-direction",
      "slip_direction: found a direction that makes the cosine X with the normal, expected one along the line", place);
  return {along, dot(along, clockwise)};
}

Touch on_line(Derivation& d, const BodyContact& contact) {
  const Frame &of = d.frames[contact.of], &on = d.frames[contact.on];
  const MovingPoint centre(of, unplaced(contact.point));
  const RelativePoint seen(centre, on);
  const Expression radius = unplaced(contact.radius);
  Touch touch;
  touch.normal = on.in_scene(unplaced(contact.normal));
  d.must_have_length_1(touch.normal, contact_name(d, contact) + ": normal", contact.normal.place);
  const Sense where = sense(d, contact, on, touch.normal);
  touch.along = where.along;
  touch.place = centre.place - radius * touch.normal;
  if (contact.through) {
    const PlanarVector from = on.at + on.in_scene(unplaced(contact.through));
    touch.distance = minus(dot(touch.normal, centre.place - from), radius);
  }
  const Expression rim = times(where.sign, radius);
  touch.opening = dot(touch.normal, seen.velocity);
  touch.sliding = plus(dot(touch.along, seen.velocity), times(rim, minus(of.spin, on.spin)));
  touch.gap = dot(touch.normal, seen.acceleration);
  touch.slip = plus(dot(touch.along, seen.acceleration), times(rim, minus(of.turning, on.turning)));
  return touch;
}

/// The distance of two centres, negative in a ring.
Expression between_centres(Derivation& d, const BodyContact& contact, const PlanarVector& between,
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
  const PlanarVector between = centre.place - other.place, velocity = centre.velocity - other.velocity,
                     acceleration = centre.acceleration - other.acceleration;
  const Expression apart = between_centres(d, contact, between, radii);
  Touch touch;
  touch.normal = {over(between.x, apart), over(between.y, apart)};
  const Sense where = sense(d, contact, on, touch.normal);
  touch.along = where.along;
  touch.place = centre.place - radius * touch.normal;
  // |r|^2 - D^2, over what turns it into the distance near 0; its sign is that of the distance where D > 0
  touch.distance = quotient_of(minus(dot(between, between), make_power(radii, 2)), times(make_number(2), radii));
  const Expression across = dot(touch.along, velocity), opening = dot(touch.normal, velocity);
  const auto rims = [&](const Expression& x, const Expression& y) {
    return times(where.sign, plus(times(radius, x), times(on_radius, y)));
  };
  touch.opening = opening;
  touch.sliding = plus(across, rims(of.spin, on.spin));
  touch.gap = plus(dot(touch.normal, acceleration), over(times(across, across), apart));
  touch.slip =
      plus(minus(dot(touch.along, acceleration), over(times(across, opening), apart)), rims(of.turning, on.turning));
  return touch;
}

void add_rolling(Derivation& d, const BodyContact& contact, const MechanismContact& touched) {
  MechanismFriction& rolling = d.mechanism.friction[*contact.rolling];
  const Frame &of = d.frames[contact.of], &on = d.frames[contact.on];
  const Place place = contact.rolling_resistance.place();
  const Expression normal = make_symbol(d.mechanism.unknowns[touched.normal].symbol);
  rolling.slip = d.derived(minus(of.turning, on.turning), place);
  rolling.static_limit = rolling.kinetic_limit = d.derived(times(unplaced(contact.rolling_resistance), normal), place);
  d.geometry.velocities.push_back(
      {d.mechanism.contacts.size() + *contact.rolling, nullptr, nullptr, minus(of.spin, on.spin), false, place});
}

}  // namespace

void derive_contact(Derivation& d, const BodyContact& contact) {
  MechanismContact& result = d.mechanism.contacts[contact.contact];
  const Touch touch = contact.on_radius ? on_disc(d, contact) : on_line(d, contact);
  result.gap = d.derived(touch.gap, contact.place);
  if (!result.slip_name.empty()) result.slip = d.derived(touch.slip, contact.place);
  result.at = d.derived(touch.place, contact.place);
  result.direction = d.derived(touch.normal, contact.place);
  result.slip_direction = d.derived(touch.along, contact.place);
  d.geometry.velocities.push_back({contact.contact, touch.distance, touch.opening,
                                   result.frictionless() ? nullptr : touch.sliding, contact.state_given,
                                   contact.place});
  if (contact.rolling) add_rolling(d, contact, result);
}

void derive_friction(Derivation& d, const BodyFriction& friction) {
  const Frame &first = d.frames[friction.first], &second = d.frames[friction.second];
  d.mechanism.friction[friction.friction].slip = d.derived(minus(first.turning, second.turning), friction.place);
  d.geometry.velocities.push_back({d.mechanism.contacts.size() + friction.friction, nullptr, nullptr,
                                   minus(first.spin, second.spin), friction.state_given, friction.place});
}

}  // namespace slipproof::bodies_in_motion
