// The forces with which a motion exists whose velocities are known exactly: one motion, by whatever forces.
//
// With u fixed each contact has a cone of forces: none where u_N > 0, a ray against the slip, all of the friction cone
// where it sticks. The forces of a motion are the points of the product of these cones at which W r + q = u, a convex
// set. Rational rays of the cones make that a linear program. It finds forces that are of the motion for sure, and that
// press wherever some do, so far as these rays can tell; in the plane, and where contacts slide or have no friction,
// they are all of the cones.
#pragma once

#include "base/algebra/linear_program.hpp"
#include "contact/complete/motion/motion.hpp"

namespace slipproof {

/// These components at one contact, 0 elsewhere.
std::vector<Rational> force_on(const ExactContacts& contacts, std::size_t contact, std::vector<Rational> components);

/// Sums of weights >= 0 times given rays, wherever W r + q = u.
class ForcesAlong {
 public:
  ForcesAlong(const ExactContacts& contacts, std::span<const Rational> u, std::vector<std::vector<Rational>> rays);

  /// Forces whose least weight is the greatest, up to 1; nothing if one is always negative, or if that takes too many
  /// pivots.
  std::optional<std::vector<Rational>> most_even() const;
  /// Forces in which each weight is positive that can be; nothing as above. At most one program for each ray.
  std::optional<std::vector<Rational>> most_open() const;

 private:
  /// Weights with the greatest least one of some, up to 1.
  std::optional<std::vector<Rational>> greatest(std::size_t first_ray, std::size_t rays) const;
  std::vector<Rational> sum(const std::vector<Rational>& weights) const;

  std::vector<std::vector<Rational>> rays_;
  std::vector<AffineForm> weights_;  ///< of the rays, over the open ones
  std::size_t open_ = 0, size_ = 0;
  bool exist_ = false;
};

struct ForceFamily {
  std::vector<Rational> r;          ///< one of them
  std::size_t open_directions = 0;  ///< along which there are others for sure, with the same velocities
  bool are_all = true;              ///< and along no more
};

/// With u = 0 at all contacts, by forces that are sums of the rays of forces_at(), for up to five contacts.
std::optional<SpatialMotion> rest_by_short_forces(const ExactContacts& contacts);

/// The motion in whose box this one is, by forces that press also where it touches; nothing where none are found.
std::optional<SpatialMotion> pressing_motion(const ExactContacts& contacts, const SpatialMotion& motion);

/// Of a motion that is_exact(): its own forces, if there are none that are open along more directions.
ForceFamily forces_at(const ExactContacts& contacts, const SpatialMotion& motion);

}  // namespace slipproof
