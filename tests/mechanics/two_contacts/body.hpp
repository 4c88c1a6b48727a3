// A plane rigid body of mass 1 on two contacts, as proofs/two-contacts has it, and the sets of its motions. Modes have
// two letters, one for each contact: S sticks, + and - slip, O opens.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mechanics/elements/element.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof::test::two_contacts {

using Modes = std::set<std::string>;
std::string text(const Modes& modes);  ///< "SS SO ++"

/// What is below the contacts: nothing moves, a belt below the first one, or belts below both. On a belt a contact
/// slides with positive slip.
enum class Below { rest, belt, belts };
inline constexpr std::array<Below, 3> all_below{Below::rest, Below::belt, Below::belts};

struct Body {
  Below below = Below::rest;
  Rational inertia;
  struct Contact {
    Rational x, y, mu;
    MechanismValues::Circle normal;
  };
  std::array<Contact, 2> contacts;
  std::array<Rational, 3> load;  ///< force to the right, force upwards, moment

  bool slides(std::size_t contact) const { return below == Below::belts || (below == Below::belt && contact == 0); }
  /// The first normal points up; half the angle of the second one, from the x-axis, has this tangent.
  void set_normals(const Rational& tan_half);
};

/// The strict motions of a body.
struct Found {
  Modes modes;            ///< each mode with a strict motion
  bool boundary = false;  ///< a motion is strict in no mode, or in several, or there is a continuum
};

/// By the library, from proofs/two-contacts/body.toml.
class Library {
 public:
  Library();
  Library(const Library&) = delete;
  Found solve(const Body& body);

 private:
  Mechanism mechanism_;
  ProblemMaker maker_;
  MechanismValues values_;
};

/// By Cramer's rule from the laws of a rigid body and of friction, which this writes down a second time. Continua and
/// boundaries are not looked for. Nothing where a body or its load is special: both normals and the tangent of a
/// contact depend on each other, or both edges of the first cone and the first one of the second, or the determinant of
/// a mode is 0, or the forces of two contacts that stick end at an edge of each.
/// Each mode has its index (proofs/two-contacts/README.md).
using Indices = std::map<std::string, int>;
std::optional<Indices> by_cramers_rule(const Body& body);
Modes modes_of(const Indices& indices);
/// What the indices add up to: 1 where nothing moves below the contacts.
int sum(const Indices& indices);
/// Whether both contacts slip to the same side in the motion that keeps them closed.
bool slip_alike(const Body& body);

/// Coefficients of friction of contact one at which a mode's determinant is 0, those that are positive.
std::vector<Rational> thresholds(const Body& body);

/// Other names of the same motions: + and - of a contact exchanged, the contacts exchanged.
Modes flipped(const Modes& modes, std::size_t contact);
Modes exchanged(const Modes& modes);

}  // namespace slipproof::test::two_contacts
