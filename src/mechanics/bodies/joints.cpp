// Joints: what stays 0, in the order in which the reader made links for it, what springs do, and rotors that joints
// drive.
//
// A rotor with the armature a has the kinetic energy a q'^2/2 for the rate q' of its joint. By virtual work the joint
// bears a q'' on its second body and -a q'' on its first: about the axis of a hinge, along that of a slider. A ball's
// rotor turns alike about all axes, with the vector of the relative spin for q'. About a hinge's axis s, q'' is
// s.(alpha - alpha'): the relative spin is along s, so that the turning of s adds nothing.
#include <array>

#include "mechanics/bodies/parts.hpp"

namespace slipproof::bodies_in_motion {

namespace {

/// From the second end to the first of a rod, rope or spring.
struct Span {
  SceneVector first_arm, second_arm;  ///< from the centres of mass
  SceneVector along;                  ///< of length 1
  Expression length, rate, growth;    ///< of its ends' distance, with its first and second derivatives
};

class JointDerivation {
 public:
  JointDerivation(Derivation& derivation, const BodyJoint& joint)
      : d_(derivation), joint_(joint), first_(d_.frames[joint.first]), second_(d_.frames[joint.second]) {}

  void derive() {
    switch (joint_.kind) {
      case BodyJoint::Kind::pin:
      case BodyJoint::Kind::ball:
        return meet();
      case BodyJoint::Kind::hinge:
        meet();
        return turn_about_axis();
      case BodyJoint::Kind::universal:
        meet();
        return axes_stay_square();
      case BodyJoint::Kind::weld:
        meet();
        return no_turning();
      case BodyJoint::Kind::slider:
        stay_on_axis();
        return no_turning();
      case BodyJoint::Kind::cylindrical:
        stay_on_axis();
        return turn_about_axis();
      case BodyJoint::Kind::rod:
        return rod();
      case BodyJoint::Kind::rope:
        return rope();
      case BodyJoint::Kind::spring:
        return spring();
      case BodyJoint::Kind::gear:
        return gear();
    }
  }

 private:
  std::string name() const { return "joint " + joint_.name + ": "; }

  void stays_zero(const Expression& zero) {
    d_.mechanism.links[joint_.links[next_++]].zero = d_.derived(zero, joint_.place);
  }
  void has_no_velocity(const Expression& velocity, const std::string& what) {
    d_.must_vanish(velocity, joint_.name + "-velocity",
                   name() + "the velocities do not fit it: found " + what + " X, expected 0", joint_.place);
  }

  /// Where the ends are: `to` is the same place if left out.
  MovingPoint first_end() const { return {first_, unplaced(joint_.at)}; }
  MovingPoint second_end() const {
    if (joint_.to) return {second_, unplaced(joint_.to)};
    return {second_, second_.in_body(first_end().place - second_.at)};
  }

  static constexpr std::array<const char*, 3> axes{"x", "y", "z"};

  /// The two points are the same.
  void meet() {
    const MovingPoint first = first_end(), second = second_end();
    const SceneVector apart = first.place - second.place, velocity = first.velocity - second.velocity;
    for (std::size_t i = 0; i < 3 && joint_.to; ++i) {
      d_.must_vanish(apart[i], joint_.name + "-meets",
                     name() + "its two points are X apart along " + axes[i] + ", expected the same place",
                     joint_.to.place);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      has_no_velocity(velocity[i], "its points to move apart along " + std::string(axes[i]) + " by");
    }
    const SceneVector zero = first.acceleration - second.acceleration;
    for (std::size_t i = 0; i < d_.bodies.dimension; ++i) stays_zero(zero[i]);
  }

  SceneVector axis_in_scene() {
    const SceneVector axis = first_.in_scene(unplaced(joint_.axis));
    d_.must_have_length_1(axis, name() + "axis", joint_.axis.place);
    return axis;
  }
  /// Directions across the axis that turn with the first body: one in the plane, two in space.
  std::vector<SceneVector> across_axis(const SceneVector& axis) {
    if (!d_.in_space()) return {cross(bodies_in_motion::axis(2), axis)};
    const auto own = d_.across(unplaced(joint_.axis));
    if (own) return {first_.in_scene(own->first), first_.in_scene(own->second)};
    d_.mistakes.add(joint_.axis.place,
                    name() +
                        "axis: found one that may point anywhere, expected one along a plane of the body's axes, "
                        "or one whose coordinates do not change their sign");
    return {axis, axis};
  }
  /// Both bodies have one direction in common, and turn about it.
  void turn_about_axis() {
    for (const SceneVector& across : across_axis(axis_in_scene())) {
      has_no_velocity(dot(across, first_.spin - second_.spin), "a relative spin across the axis of");
      turning_stays_zero(dot(across, first_.turning - second_.turning - cross(second_.spin, first_.spin)));
    }
  }

  /// A direction a of the first is across a direction c of the second: a.c = 0 has the first derivative s.(a x c), with
  /// the relative spin s.
  void axes_stay_square() {
    const SceneVector a = axis_in_scene(), c = second_.in_scene(unplaced(joint_.to_axis));
    d_.must_have_length_1(c, name() + "to_axis", joint_.to_axis.place);
    d_.must_vanish(dot(a, c), joint_.name + "-is-square",
                   name() + "found axes that make an angle with the cosine X, expected a right angle",
                   joint_.to_axis.place);
    const SceneVector both = moment(a, c), spin = first_.spin - second_.spin;
    has_no_velocity(dot(spin, both), "a relative spin across both axes of");
    const SceneVector change = moment(cross(first_.spin, a), c) + moment(a, cross(second_.spin, c));
    turning_stays_zero(plus(dot(first_.turning - second_.turning, both), dot(spin, change)));
  }

  /// Both turn alike.
  void no_turning() {
    const SceneVector turning = first_.turning - second_.turning;
    const std::size_t from = d_.in_space() ? 0 : 2;
    for (std::size_t i = from; i < 3; ++i) {
      has_no_velocity(minus(first_.spin[i], second_.spin[i]), "a relative spin of");
    }
    for (std::size_t i = from; i < 3; ++i) turning_stays_zero(turning[i]);
  }
  /// Where neither body turns freely there is no link, and what is prescribed must agree, for every load.
  void turning_stays_zero(const Expression& turning) {
    if (next_ < joint_.links.size()) return stays_zero(turning);
    const std::string found = name() + "the prescribed turning does not fit it: found ";
    const std::string load = d_.mechanism.load ? d_.mechanism.load->symbol : "";
    if (!load.empty() && !is_linear_in(turning, load)) {
      d_.mistakes.add(joint_.place, found + in_quotes(to_string(turning)) + ", expected 0");
      return;
    }
    const auto vanishes = [&](const Expression& value, const std::string& times) {
      d_.must_vanish(value, joint_.name + "-turning", found + "a relative turning of X" + times + ", expected 0",
                     joint_.place);
    };
    const Expression still = substitute(turning, load, zero_literal());
    vanishes(still, "");
    vanishes(minus(substitute(turning, load, make_number(1)), still), " times " + load);
  }

  /// The second body's point stays on a line of the first.
  void stay_on_axis() {
    const SceneVector axis = axis_in_scene();
    const MovingPoint first = first_end(), second = second_end();
    const RelativePoint seen(second, first_);
    for (const SceneVector& across : across_axis(axis)) {
      if (joint_.to) {
        d_.must_vanish(dot(across, second.place - first.place), joint_.name + "-meets",
                       name() + "its second point is X beside the axis, expected it on the axis", joint_.to.place);
      }
      has_no_velocity(dot(across, seen.velocity), "its second point to leave the axis by");
      stays_zero(negative_of(dot(across, seen.acceleration)));
    }
  }

  /// The distance of the ends of a slack rope, shorter than its length.
  Expression slack_length(const SceneVector& between, const Expression& length) {
    const Expression distance = d_.distance(between, "joint", joint_.name, joint_.length.place());
    if (!distance) return length;
    d_.must_be(GeometryFact::Kind::not_negative, minus(length, distance), joint_.name + "-is-slack",
               name() + "length: found a slack rope that is X longer than the distance of its ends, expected 0 or more",
               joint_.length.place());
    return distance;
  }

  /// Its direction is exact only where its length is: given, or plain from the coordinates.
  Span span() {
    const MovingPoint first = first_end(), second = second_end();
    const SceneVector between = first.place - second.place;
    Span result;
    result.first_arm = first.place - first_.at;
    result.second_arm = second.place - second_.at;
    result.length = unplaced(joint_.length);
    const Place place = joint_.length.place();
    d_.must_be(GeometryFact::Kind::positive, result.length, joint_.name + "-length-is-positive",
               name() + "length: found X, expected one above 0", place);
    if (joint_.state_given) {
      result.length = slack_length(between, result.length);
    } else {
      d_.must_vanish(minus(dot(between, between), make_power(result.length, 2)), joint_.name + "-length",
                     name() + "length: the square of the distance of its ends is X more than that of the length",
                     place);
    }
    const auto share = [&](const Expression& x) {  // the length is not 0
      if (same(x, result.length)) return make_number(1);
      if (same(x, negative_of(result.length))) return make_number(-1);
      return over(x, result.length);
    };
    result.along = {share(between.x), share(between.y), share(between.z)};
    const SceneVector velocity = first.velocity - second.velocity;
    result.rate = dot(result.along, velocity);
    Expression square = zero_literal();  // of the velocity across it
    for (std::size_t i = 0; i < 3; ++i) {
      const Expression across = dot(cross(axis(i), result.along), velocity);
      square = plus(square, times(across, across));
    }
    result.growth = plus(dot(result.along, first.acceleration - second.acceleration), over(square, result.length));
    return result;
  }

  /// Its force is positive where it pulls.
  void rod() {
    const Span bar = span();
    has_no_velocity(bar.rate, "its ends to move apart by");
    stays_zero(negative_of(bar.growth));
  }

  void rope() {
    const MovingPoint first = first_end(), second = second_end();
    const Span rope = span();
    MechanismContact& contact = d_.mechanism.contacts[*joint_.contact];
    contact.gap = d_.derived(negative_of(rope.growth), joint_.place);
    const bool pulls_first = joint_.first != ground;  // else pictures would show what pulls the ground
    contact.at = d_.derived(pulls_first ? first.place : second.place, joint_.place);
    contact.direction = d_.derived(pulls_first ? -rope.along : rope.along, joint_.place);
    d_.geometry.velocities.push_back(
        {*joint_.contact, nullptr, negative_of(rope.rate), nullptr, joint_.state_given, joint_.place});
  }

  void spring() {
    const Span spring = span();
    const SceneVector pull = unplaced(joint_.tension) * spring.along;
    d_.loads[joint_.first].push(spring.first_arm, -pull);
    d_.loads[joint_.second].push(spring.second_arm, pull);
  }

  /// About axes of the carrier; in the plane about the one out of it.
  void gear() {
    const Frame& carrier = d_.frames[joint_.carrier];
    const Expression ratio = unplaced(joint_.ratio);
    const auto axis_of = [&](const PlacedVector& given, const std::string& key) {
      if (!d_.in_space()) return axis(2);
      const SceneVector result = carrier.in_scene(unplaced(given));
      d_.must_have_length_1(result, name() + key, given.place);
      return result;
    };
    const SceneVector first_axis = axis_of(joint_.axis, "axis"),
                      second_axis = axis_of(joint_.to_axis ? joint_.to_axis : joint_.axis, "to_axis");
    const auto ahead = [&](const SceneVector& second, const SceneVector& first) {
      return minus(dot(second_axis, second), times(ratio, dot(first_axis, first)));
    };
    const auto turning = [&](const Frame& wheel) {
      return wheel.turning - carrier.turning - cross(carrier.spin, wheel.spin);
    };
    const Expression rate = ahead(second_.spin - carrier.spin, first_.spin - carrier.spin),
                     gap = ahead(turning(second_), turning(first_));
    if (joint_.contact) {
      d_.mechanism.contacts[*joint_.contact].gap = d_.derived(gap, joint_.place);
      d_.geometry.velocities.push_back({*joint_.contact, nullptr, rate, nullptr, joint_.state_given, joint_.place});
      return;
    }
    has_no_velocity(rate, "the second body to turn ahead of the ratio by");
    stays_zero(gap);
  }

  Derivation& d_;
  const BodyJoint& joint_;
  const Frame &first_, &second_;
  std::size_t next_ = 0;
};

/// What bears a slider's rotor: the place of the second end, and how the first body sees it move.
void derive_sliding_armature(Derivation& d, const BodyJoint& joint, const SceneVector& axis) {
  const Frame &first = d.frames[joint.first], &second = d.frames[joint.second];
  const SceneVector at = first.at + first.in_scene(unplaced(joint.at));
  const MovingPoint end(second, joint.to ? unplaced(joint.to) : second.in_body(at - second.at));
  const SceneVector force = times(unplaced(joint.armature), dot(axis, RelativePoint(end, first).acceleration)) * axis;
  d.carried[joint.second].push(end.place - second.at, force);
  d.carried[joint.first].push(end.place - first.at, -force);
}

}  // namespace

void derive_joint(Derivation& derivation, const BodyJoint& joint) {
  JointDerivation(derivation, joint).derive();
}

void derive_armature(Derivation& d, const BodyJoint& joint) {
  if (!joint.armature) return;
  const Frame &first = d.frames[joint.first], &second = d.frames[joint.second];
  const Expression armature = unplaced(joint.armature);
  d.must_be(GeometryFact::Kind::not_negative, armature, joint.name + "-armature",
            "joint " + joint.name + ": found the armature X, expected one of 0 or more", joint.armature.place());
  const SceneVector along = joint.axis ? first.in_scene(unplaced(joint.axis)) : axis(2);
  if (joint.kind == BodyJoint::Kind::slider) return derive_sliding_armature(d, joint, along);
  const SceneVector turning = second.turning - first.turning;
  const SceneVector couple = joint.kind == BodyJoint::Kind::ball ? armature * (turning - cross(first.spin, second.spin))
                                                                 : times(armature, dot(along, turning)) * along;
  d.carried[joint.second].turn(couple);
  d.carried[joint.first].turn(-couple);
}

}  // namespace slipproof::bodies_in_motion
