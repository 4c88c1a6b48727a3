// Inside the derivation of a mechanism from bodies: what its parts share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanics/bodies/derive.hpp"
#include "mechanics/bodies/frame.hpp"

namespace slipproof::bodies_in_motion {

/// A load on a body: a force or a couple that no contact or joint exerts.
struct Load {
  SceneVector force, moment;  ///< about its centre of mass

  /// Adds a force at an arm from the centre of mass; a couple.
  void push(const SceneVector& arm, const SceneVector& by);
  void turn(const SceneVector& couple) { moment = moment + couple; }
};

struct Derivation {
  Derivation(const Bodies& scene, Mechanism& result, Mistakes& list);

  const Bodies& bodies;
  Mechanism& mechanism;
  Mistakes& mistakes;
  std::vector<Frame> frames;
  std::vector<Load> loads;
  std::vector<Load> carried;  ///< what a body gives to armatures, as its own inertia takes it
  BodyGeometry geometry;

  bool in_space() const { return bodies.dimension == 3; }
  static PlacedExpression derived(const Expression& expression, Place place);
  /// The coordinates that a vector has: two, in space three.
  std::vector<PlacedExpression> derived(const SceneVector& vector, Place place) const;
  /// `name` as of GeometryFact; an X in the text stands for the value.
  void must_vanish(const Expression& value, std::string name, std::string what, Place place);
  void must_be(GeometryFact::Kind kind, const Expression& value, std::string name, std::string what, Place place,
               bool somewhere = false);
  void must_have_length_1(const SceneVector& vector, const std::string& name, Place place);
  /// The length of the vector between what an element, called by its kind and name, keeps apart; null, and a report,
  /// where it is not rational.
  Expression distance(const SceneVector& between, const std::string& kind, const std::string& name, Place place);
  /// Two directions of length 1, across a direction of length 1 and each other: first x second is the direction. In the
  /// plane the first is the direction turned clockwise. In space their entries are rational; nothing, where no such
  /// ones are known for all parameters.
  struct Across {
    SceneVector first, second;
  };
  std::optional<Across> across(const SceneVector& direction) const;
};

void derive_contact(Derivation& derivation, const BodyContact& contact);
void derive_joint(Derivation& derivation, const BodyJoint& joint);
/// Of the rotor that a joint drives.
void derive_armature(Derivation& derivation, const BodyJoint& joint);
void derive_friction(Derivation& derivation, const BodyFriction& friction);
void draw_shapes(Derivation& derivation);

}  // namespace slipproof::bodies_in_motion
