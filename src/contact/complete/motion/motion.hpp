// Motions that are proved to exist: exactly where a mode's equations are linear, in a box where a contact slips in
// space.
#pragma once

#include <algorithm>
#include <functional>

#include "contact/complete/program/pattern_program.hpp"

namespace slipproof {

/// F_i(z) = constant + sum of linear terms + sum of products of two unknowns.
template <class T>
struct ModeEquation {
  struct Product {
    std::size_t i, j;
    T coefficient;
  };
  T constant{};
  std::vector<std::pair<std::size_t, T>> linear;
  std::vector<Product> products;
};

/// The unknowns of a mode, for each contact in turn: none where it is open; r_N without friction, and where it touches
/// without a force; r where it sticks, and where it slips in the plane; where it slips in space r and s, with
/// u_T = -s r_T. Those of the claim `enclosure` (src/proofs/check_contact/FORMAT.md).
struct ModeUnknowns {
  std::vector<std::size_t> first;  ///< of each contact, and at last how many there are

  /// `touching` has the open contacts whose u_N is 0, or is empty.
  ModeUnknowns(const ExactContacts& contacts, const ContactPattern& mode, const std::vector<bool>& touching = {});
  std::size_t count() const { return first.back(); }
  std::size_t of(std::size_t contact) const { return first[contact + 1] - first[contact]; }
  /// How many of them, the first ones, are components of r.
  std::size_t forces(std::size_t contact) const { return std::min<std::size_t>(of(contact), 3); }
  bool slips_in_space(std::size_t contact) const { return of(contact) == 4; }
};

/// An equation of a mode as a linear combination of others.
struct DependentEquation {
  std::size_t equation;
  std::vector<std::pair<std::size_t, Rational>> combination;
};

struct SpatialMotion {
  ContactPattern mode;              ///< of each contact open, closed, stick or slip; in space arcs mean nothing
  std::vector<bool> touching;       ///< open contacts with u_N = 0; empty: none
  std::vector<Rational> r, u;       ///< a point: forces, and W r + q
  std::vector<Rational> r_radius;   ///< a motion exists with r this near; all 0 where the point is one
  std::vector<Rational> u_radius;   ///< what r_radius makes of u
  std::vector<Rational> center;     ///< the point in the mode's unknowns
  std::vector<Rational> radius;     ///< within which one exists, of pinned ones 0; empty where the point is a motion
  std::vector<std::size_t> pinned;  ///< unknowns that the equations leave open, held at the center
  std::vector<DependentEquation> dropped;  ///< as many
  RationalMatrix inverse;  ///< of the derivative without these, approximately; empty where the point is a motion
  Integer alone = 0;       ///< no other motion of this mode is within so many radii; 0 where that is not proved
  std::size_t open_directions = 0;  ///< of forces that the equations leave open

  bool is_exact() const { return radius.empty(); }
  /// Whether it differs from another for sure.
  bool differs(const SpatialMotion& other) const;
};

/// In how many directions the forces of these contacts move nothing: W does not see them.
std::size_t open_directions(const ExactContacts& contacts, const std::vector<bool>& pressed);

/// With these forces, if they satisfy the law.
std::optional<SpatialMotion> exact_motion(const ExactContacts& contacts, const ContactPattern& mode,
                                          std::vector<Rational> r);

/// Whether r with u = W r + q satisfies Coulomb's law exactly.
bool satisfies_law(const ExactContacts& contacts, std::span<const Rational> r, std::span<const Rational> u);
/// W r: what forces change of velocities.
std::vector<Rational> velocity_changes(const ExactContacts& contacts, std::span<const Rational> r);
/// W r + q.
std::vector<Rational> velocities(const ExactContacts& contacts, std::span<const Rational> r);

struct MotionCandidate {
  bool is_known = false;                ///< it need not be proved once more
  std::optional<SpatialMotion> motion;  ///< nothing where there is none, none that can be proved, or a known one
};

/// The motion that Newton's method finds from a point, in the mode of a pattern in which nothing is left to decide but
/// directions. `is_known` says of velocities, up to rounding, whether they are those of a motion that is known.
MotionCandidate find_motion(const ExactContacts& exact, const FloatingContacts& contacts, const ContactPattern& mode,
                            const ProposedPoint& start, const std::function<bool(std::span<const double> u)>& is_known);

}  // namespace slipproof
