// Inside the checks: whether contacts of one body move as its points do.
//
// Gap and slip of a contact are velocities of a point of a body across and along the contact. Let n be the direction of
// N and t that of positive slip, as long as n. For each acceleration q the velocity of the point is the column w_q =
// (gap_q n + slip_q t) / |n|^2. For a rigid body with the translations x, y and the rotation phi, w_x and w_y are
// perpendicular and of one length, the factor of the contact, and w_phi differs between contacts at p and p' by that
// length times p - p' turned by a right angle. All of this is rational, for any turn of the axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof::mechanism_checks {

using Vector = std::array<Rational, 2>;

Rational dot(const Vector& a, const Vector& b);
Vector turned(const Vector& a);  ///< turned by a right angle, to the left
bool vanishes(const Vector& a);

/// A contact at a point, in the axes of the picture.
struct PlacedContact {
  Vector at, normal, along;          ///< `along` is across the normal and as long
  std::vector<Vector> translations;  ///< the velocities w of one or two translations
  Vector rotation;                   ///< w of the rotation; 0 without rotation
};

struct RigidMisfit {
  enum class Why : std::uint8_t {
    lengths,       ///< the translations are not perpendicular or not of one length
    translations,  ///< they are others than at the reference
    rotation,      ///< it is another one than at the reference
    mirrored       ///< fits only with a shift of the axes, and without one if the rotation had the other sign
  };
  std::size_t contact;
  Why why;
  bool in_gap;  ///< otherwise in the slip
  std::size_t reference;
};

/// The first contact that does not fit; the reference is one that fits without a shift of the axes, or the first.
std::optional<RigidMisfit> rigid_misfit(const std::vector<PlacedContact>& contacts);

}  // namespace slipproof::mechanism_checks
