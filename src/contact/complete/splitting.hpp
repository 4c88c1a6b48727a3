// How the tree of patterns branches.
#pragma once

#include "contact/complete/motion/motion.hpp"

namespace slipproof {

/// How far a point is from the law at a contact: 0 where it obeys it.
double violation(const FloatingContacts& contacts, std::size_t contact, const ProposedPoint& point);

/// What linear programs leave of a contact's arc: from where to where, as shares of its angle.
struct ShrunkArc {
  std::size_t contact;
  std::array<double, 2> left;
};

/// The widest arc, if much of it can be cut off. `program` is that of the pattern, and its relaxation has a point.
std::optional<ShrunkArc> shrink_widest_arc(const ContactPattern& pattern, PatternProgram& program);

/// A pattern as several, which differ in one contact and together have all of its motions.
struct PatternSplit {
  std::size_t contact = 0;
  std::vector<ContactPattern> children;  ///< empty if nothing can be split
};

/// `point` is a point of its relaxation, `shrunk` what shrink_widest_arc() found. Arcs are cut beside known motions.
PatternSplit split_pattern(const ExactContacts& exact, const FloatingContacts& contacts, const ContactPattern& pattern,
                           const ProposedPoint& point, const std::optional<ShrunkArc>& shrunk,
                           const std::vector<SpatialMotion>& motions);

}  // namespace slipproof
