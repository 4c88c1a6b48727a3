#include "mechanics/states/places.hpp"

#include "mechanics/bodies/frame.hpp"
#include "mechanics/bodies/identity.hpp"
#include "mechanics/mechanism/algebra.hpp"
#include "mechanics/mechanism/names.hpp"

namespace slipproof {

namespace bodies_in_motion {

namespace {

class Places {
  using Kind = BodyJoint::Kind;

 public:
  Places(Bodies& bodies, const Mechanism& mechanism, Mistakes& mistakes)
      : bodies_(bodies), mechanism_(mechanism), mistakes_(mistakes), stages_(bodies.bodies.size()) {}

  void place_all() {
    for (std::size_t i = 0; i < bodies_.bodies.size(); ++i) place(i);
    for (const BodyJoint& joint : bodies_.guides) {
      if (joint.kind == Kind::slider || joint.kind == Kind::hinge) place_guides(joint);
    }
  }

 private:
  enum class Stage { unseen, begun, done };

  /// False, and a report, if it cannot be.
  bool place(std::size_t index) {
    const Body& body = bodies_.bodies[index];
    if (!body.by || stages_[index] == Stage::done) return true;
    if (stages_[index] == Stage::begun)
      return refuse(index, "found bodies that are placed by one another in a circle, expected `at` for one of them");
    stages_[index] = Stage::begun;
    const BodyJoint* joint = joint_of(index);
    const bool fine = joint != nullptr && place(joint->first == index ? joint->second : joint->first);
    if (fine) place_by(*joint, index);
    stages_[index] = Stage::done;
    return fine;
  }

  bool refuse(std::size_t index, const std::string& message) {
    const Body& body = bodies_.bodies[index];
    mistakes_.add(body.by->joint.at(0), "body " + body.name + ": by: " + message);
    return false;
  }

  /// The joint that a body names; null, and a report, if it cannot place the body.
  const BodyJoint* joint_of(std::size_t index) {
    const std::string& name = bodies_.bodies[index].by->joint.text();
    std::vector<std::string_view> known;
    for (const auto* joints : {&bodies_.joints, &bodies_.guides}) {
      for (const BodyJoint& joint : *joints) {
        known.push_back(joint.name);
        if (joint.name == name) return fits(joint, index) ? &joint : nullptr;
      }
    }
    refuse(index, unknown_name("joint", name, known));
    return nullptr;
  }

  bool fits(const BodyJoint& joint, std::size_t index) {
    const Body& body = bodies_.bodies[index];
    const std::string found = "found the " + std::string(name(joint.kind)) + " " + joint.name;
    const bool slides = joint.kind == Kind::slider || joint.kind == Kind::cylindrical;
    const bool turns = joint.kind == Kind::pin || joint.kind == Kind::hinge || joint.kind == Kind::cylindrical;
    if (joint.first != index && joint.second != index)
      return refuse(index, found + ", which joins other bodies, expected one of this body");
    if (!slides && !turns && joint.kind != Kind::weld && joint.kind != Kind::ball)
      return refuse(index, found + ", which leaves the place open, expected `at`");
    if (joint.ring) return refuse(index, found + " in a ring, whose centre depends on where it touches, expected `at`");
    if (!joint.to)
      return refuse(index, found + " without `to`, expected it: the joint's point in the axes of its second body");
    if (turns && !body.cosine)
      return refuse(index, found + ", expected an angle beside it: of the second body against the first");
    if (turns && (body.turn_axis || body.quaternion[0]))
      return refuse(index, found + ", which has an axis, expected `angle` in place of `turn`");
    if (joint.kind == Kind::ball && !body.quaternion[0] && !body.turn_axis)
      return refuse(index, found + ", expected `turn` beside it: of the second body against the first");
    if (slides && !body.by->displacement)
      return refuse(index, found + ", expected a displacement beside it: of the second body's point along the axis");
    if (!slides && body.by->displacement) return refuse(index, found + ", which has no displacement, expected none");
    return true;
  }

  static PlacedExpression derived(const Expression& expression, Place place) {
    return {folded(expression), PlacedText("", place)};
  }
  PlacedVector derived(const SceneVector& vector, Place place) const {
    PlacedVector result{derived(vector.x, place), derived(vector.y, place), {}, place};
    if (bodies_.dimension == 3) result.z = derived(vector.z, place);
    return result;
  }

  void place_by(const BodyJoint& joint, std::size_t index) {
    Body& body = bodies_.bodies[index];
    const bool second = joint.second == index;
    const Frame other(bodies_.bodies[second ? joint.first : joint.second]);
    if (bodies_.dimension == 3 && body.cosine && !body.turn_axis) body.turn_axis = joint.axis;
    const Turn against(body);
    body.rotation.assign(9, zero_literal());
    for (std::size_t j = 0; j < 3; ++j) {
      const SceneVector column =
          simplified(other.in_scene(second ? against.in_scene(axis(j)) : against.in_body(axis(j))));
      for (std::size_t i = 0; i < 3; ++i) body.rotation[3 * i + j] = folded(column[i]);
    }
    const SceneVector on_first = unplaced(joint.at) + unplaced(body.by->displacement) * unplaced(joint.axis),
                      on_second = unplaced(joint.to);
    const SceneVector there = other.at + other.in_scene(second ? on_first : on_second);
    body.at = derived(there - Turn(body).in_scene(second ? on_second : on_first), body.by->joint.at(0));
  }

  /// Points of the second body, half the length ahead of `to` and behind, in space half the width to both sides; of a
  /// hinge also the centres of its rings.
  void place_guides(const BodyJoint& joint) {
    const Frame first(bodies_.bodies[joint.first]), second(bodies_.bodies[joint.second]);
    const auto in_second = [&](const SceneVector& own) { return simplified(second.in_body(first.in_scene(own))); };
    const SceneVector axis = unplaced(joint.axis), middle = second_point(joint, first, second);
    const auto half = [](const PlacedExpression& size) { return folded(quotient_of(unplaced(size), make_number(2))); };
    const auto times = [](int side, const Expression& size) {
      return side == 0 ? zero_literal() : side > 0 ? size : negative_of(size);
    };
    for (const BodyJoint::Guide& guide : joint.guides) {
      BodyContact& contact = bodies_.contacts[guide.contact];
      const Expression ahead = times(guide.ahead, half(joint.length)), across = times(guide.across, half(joint.width));
      SceneVector point = middle + ahead * in_second(axis);
      if (guide.across != 0) point = point + across * in_second(moment(unplaced(joint.normal), axis));
      contact.point = derived(point, joint.place);
      if (contact.on_radius) contact.on_point = derived(unplaced(joint.at) + ahead * axis, joint.place);
    }
  }
  SceneVector second_point(const BodyJoint& joint, const Frame& first, const Frame& second) const {
    if (joint.to) return unplaced(joint.to);
    return simplified(second.in_body(first.at + first.in_scene(unplaced(joint.at)) - second.at));
  }

  SceneVector simplified(const SceneVector& vector) const {
    return {shortened(mechanism_, vector.x), shortened(mechanism_, vector.y), shortened(mechanism_, vector.z)};
  }

  Bodies& bodies_;
  const Mechanism& mechanism_;
  Mistakes& mistakes_;
  std::vector<Stage> stages_;
};

}  // namespace

}  // namespace bodies_in_motion

void place_bodies(Bodies& bodies, const Mechanism& mechanism, Mistakes& mistakes) {
  bodies_in_motion::Places(bodies, mechanism, mistakes).place_all();
}

}  // namespace slipproof
