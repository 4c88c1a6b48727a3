// Joints: what stays 0, in the order in which the reader made links for it, and what springs do.
#include "mechanics/bodies/parts.hpp"

namespace slipproof::bodies_in_motion {

namespace {

/// From the second end to the first of a rod, rope or spring.
struct Span {
  PlanarVector first_arm, second_arm;  ///< from the centres of mass
  PlanarVector along;                  ///< of length 1
  Expression length, rate, growth;     ///< of its ends' distance, with its first and second derivatives
};

class JointDerivation {
 public:
  JointDerivation(Derivation& derivation, const BodyJoint& joint)
      : d_(derivation), joint_(joint), first_(d_.frames[joint.first]), second_(d_.frames[joint.second]) {}

  void derive() {
    switch (joint_.kind) {
      case BodyJoint::Kind::pin:
        return pin();
      case BodyJoint::Kind::weld:
        pin();
        return no_turning();
      case BodyJoint::Kind::slider:
        return slider();
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

  void pin() {
    const MovingPoint first = first_end(), second = second_end();
    if (joint_.to) {
      const PlanarVector apart = first.place - second.place;
      d_.must_vanish(apart.x, joint_.name + "-meets",
                     name() + "its two points are X apart along x, expected the same place", joint_.to.place);
      d_.must_vanish(apart.y, joint_.name + "-meets",
                     name() + "its two points are X apart along y, expected the same place", joint_.to.place);
    }
    const PlanarVector velocity = first.velocity - second.velocity;
    has_no_velocity(velocity.x, "its points to move apart along x by");
    has_no_velocity(velocity.y, "its points to move apart along y by");
    const PlanarVector zero = first.acceleration - second.acceleration;
    stays_zero(zero.x);
    stays_zero(zero.y);
  }

  /// Where neither body turns freely there is no link, and what is prescribed must agree, for every load.
  void no_turning() {
    has_no_velocity(minus(first_.spin, second_.spin), "a relative spin of");
    const Expression turning = minus(first_.turning, second_.turning);
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

  /// The second body's point stays on a line of the first, and both turn alike.
  void slider() {
    const PlanarVector axis = first_.in_scene(unplaced(joint_.axis)), across = turned(axis);
    d_.must_have_length_1(axis, name() + "axis", joint_.axis.place);
    const MovingPoint first = first_end(), second = second_end();
    if (joint_.to) {
      d_.must_vanish(dot(across, second.place - first.place), joint_.name + "-meets",
                     name() + "its second point is X beside the axis, expected it on the axis", joint_.to.place);
    }
    const RelativePoint seen(second, first_);
    has_no_velocity(dot(across, seen.velocity), "its second point to leave the axis by");
    stays_zero(negative_of(dot(across, seen.acceleration)));
    no_turning();
  }

  /// The distance of the ends of a slack rope, shorter than its length.
  Expression slack_length(const PlanarVector& between, const Expression& length) {
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
    const PlanarVector between = first.place - second.place;
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
    result.along = {share(between.x), share(between.y)};
    const PlanarVector velocity = first.velocity - second.velocity;
    const Expression across = dot(turned(result.along), velocity);
    result.rate = dot(result.along, velocity);
    const Expression square = times(across, across);
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
    contact.at = d_.derived(first.place, joint_.place);
    contact.direction = d_.derived(-rope.along, joint_.place);
    d_.geometry.velocities.push_back(
        {*joint_.contact, nullptr, negative_of(rope.rate), nullptr, joint_.state_given, joint_.place});
  }

  void spring() {
    const Span spring = span();
    const PlanarVector pull = unplaced(joint_.tension) * spring.along;
    d_.push(joint_.first, spring.first_arm, -pull);
    d_.push(joint_.second, spring.second_arm, pull);
  }

  void gear() {
    const Frame& carrier = d_.frames[joint_.carrier];
    const Expression ratio = unplaced(joint_.ratio);
    const auto ahead = [&](Expression Frame::*turning) {
      return minus(minus(second_.*turning, carrier.*turning), times(ratio, minus(first_.*turning, carrier.*turning)));
    };
    const Expression rate = ahead(&Frame::spin), gap = ahead(&Frame::turning);
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

}  // namespace

void derive_joint(Derivation& derivation, const BodyJoint& joint) {
  JointDerivation(derivation, joint).derive();
}

}  // namespace slipproof::bodies_in_motion
