// Patterns whose motions are all one that is known.
#pragma once

#include "contact/complete/complete.hpp"

namespace slipproof {

/// A problem in all numbers that a search needs. `exact` must outlive it.
struct SearchProblem {
  const ExactContacts& exact;
  const IntegerContacts integers;
  const FloatingContacts floating;

  explicit SearchProblem(const ExactContacts& contacts) : exact(contacts), integers(contacts), floating(contacts) {}
};

/// Bounds that prove that all motions of a pattern are this one: of u in each row, where the pattern's equations
/// determine it; else of forces and slips, in the box in which the motion is alone. Nothing where they were not found.
/// Adds the programs that it solves.
std::optional<std::vector<PatternNode::Bound>> bounds_to_motion(const SearchProblem& problem,
                                                                const ContactPattern& pattern,
                                                                const SpatialMotion& motion, std::size_t& programs);

/// Where u is.
struct VelocityBox {
  std::vector<Rational> low, high;

  static VelocityBox of(const SpatialMotion& motion);
  void add(const VelocityBox& other);
  bool contains(const VelocityBox& other) const;
  /// Whether it has velocities within so much of these.
  bool is_near(std::span<const double> u, double distance) const;
  bool overlaps(const VelocityBox& other) const;
  VelocityBox widened(const Rational& distance) const;
};

/// Where u is in all motions that count as this one of the list.
VelocityBox place_of(const CompleteSolutions& found, std::size_t motion);

/// Where u is in all motions of a pattern, and bounds that prove it, of each row that is not 0 by definition.
struct BoundedVelocities {
  VelocityBox box;
  std::vector<PatternNode::Bound> bounds;
};

/// Nothing where a bound was not found, or is beyond `limits`, if these are given. Adds the programs that it solves.
std::optional<BoundedVelocities> bound_velocities(const SearchProblem& problem, const ContactPattern& pattern,
                                                  const VelocityBox* limits, std::size_t& programs);

}  // namespace slipproof
