// All solutions of a contact problem, however they were found: exact ones of a small problem in the plane (small.hpp),
// or boxes that hold those of a problem in space.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/number/rational.hpp"
#include "contact/complete/pattern.hpp"
#include "contact/judge/verdict.hpp"
#include "mechanics/kernel/polyhedron.hpp"

namespace slipproof {

/// A solution, or a family of solutions of one mode.
struct FoundSolution {
  std::vector<std::string> modes;  ///< `slip+/lift`: all that give it
  ContactPattern states;           ///< of the contacts in the first of them, if a tree of patterns has found it
  /// Forces and velocities of the contacts, without free unknowns, by contact and component. Where they are known
  /// exactly, each range is a point. Of a family: one of its solutions, the nearest to the answer if one is given.
  std::vector<Range> r, u;
  /// Velocities of all solutions that count as this one, if they are not all those of `u`; and and others among
  /// them, whose velocities differ for sure: then they are a continuum that moves in different ways.
  std::vector<Range> around;
  std::vector<FoundSolution> others;
  std::size_t open_directions = 0;  ///< of a family: along how many directions there are others
  bool strict = false;              ///< no condition of one of its modes holds with equality
  bool exists = true;               ///< it is proved that a solution is within r and u
  bool one_motion = true;           ///< and that all others there have its velocities
  bool alone = true;                ///< and that there are no others, but those of its family
  bool may_be_open = false;         ///< it is not known whether its forces are, though open_directions is 0
  bool moves = false;               ///< of a family of a small problem: its velocities differ

  bool is_family() const { return open_directions > 0 || !others.empty(); }
};

struct AllSolutions {
  std::size_t dimension = 1;  ///< components of a contact in r and u
  std::vector<FoundSolution> solutions;
  std::vector<std::string> unexamined;  ///< where others may be
  std::optional<double> open_speed;     ///< there no component of u is larger, in absolute value

  /// Whether it is proved that there is no other.
  bool complete() const { return unexamined.empty(); }
  bool none() const { return complete() && solutions.empty(); }
  /// What a search leaves that is not complete: `found 2, and 3 patterns stay open, the first stick/slip`.
  std::string open_words() const;
  bool one() const;
  /// Whether two with different velocities are known. With friction, those with the same ones are one motion, by other
  /// forces; without it, in dimension 1, forces themselves are asked for.
  bool several_motions() const;
  /// Whether it is proved that all are one motion.
  bool one_motion() const;
  std::size_t families() const;
  /// Whether each is the only one where it is.
  bool are_points() const;
  /// Those of no family.
  std::size_t singles() const { return solutions.size() - families(); }

  /// The verdict on an answer that is, within the tolerance, this one of the solutions; null: it is near none.
  ContactVerdict verdict(const FoundSolution* meant) const;
};

/// Of an answer that is near no solution, or whose mode alone was tried: the mode that it claims, or suggests, and why
/// that has no solution near it.
struct OwnMode {
  std::string mode;
  bool claimed = false;
  std::optional<std::string> violated;  ///< the condition that all solutions of the mode's equations break
  Rational margin = 0;                  ///< its left-hand side, negative
  std::string reason;                   ///< where no condition is violated
};

/// Ranges that are points.
std::vector<Range> points(const std::vector<Rational>& values);
/// The points of ranges that are points.
std::vector<Rational> values_of(const std::vector<Range>& points);

}  // namespace slipproof
