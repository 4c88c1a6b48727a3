// The mechanism that follows from bodies: equations of motion, gaps, slips and links, and what must hold of the scene.
#pragma once

#include <string>
#include <vector>

#include "mechanics/bodies/bodies.hpp"

namespace slipproof {

/// A redundant statement in a scene of bodies, which must be consistent: a contact is closed, the ends of a joint meet.
struct GeometryFact {
  enum class Kind : std::uint8_t { zero, not_zero, positive, not_negative };
  Kind kind = Kind::zero;
  Expression value;
  std::string name;  ///< name of the assumption if it does not hold everywhere: `axle-meets`
  std::string what;  ///< "the ends of the joint axle are X apart", with X for the value
  Place place;
};

/// The velocities of an element before the motion.
struct ElementVelocity {
  std::size_t element = 0;  ///< contacts, then friction elements
  Expression distance;      ///< distance at a contact; null if unknown, and for a friction element
  Expression opening;       ///< of a contact
  Expression sliding;       ///< null: frictionless
  bool state_given = false;
  Place place;
  Expression second = nullptr;  ///< of a contact in space: the sliding along its second direction,
  Expression speed = nullptr;   ///< and how fast it slides, >= 0; null where no rational expression says it
};

struct BodyGeometry {
  std::vector<GeometryFact> facts;
  std::vector<ElementVelocity> velocities;
};

/// Fills in equations, gaps, slips, links, limits of rolling resistance, and pictures; the elements, with their names,
/// friction and forces, are there. The equations are Newton's and Euler's: forces of contacts and joints come in by
/// virtual work, as in every file with [motion]. Gaps are second derivatives of distances, slips first derivatives of
/// the sliding velocity of the material points that touch (Coriolis and centripetal terms included). Reports distances
/// that are not rational. Linear in the scene.
BodyGeometry derive_mechanism(const Bodies& bodies, Mechanism& mechanism, Mistakes& mistakes);

}  // namespace slipproof
