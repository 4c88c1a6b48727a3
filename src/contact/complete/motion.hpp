// Motions that are proved to exist: exactly where a mode's equations are linear, in a box where a contact slips in
// space.
#pragma once

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

/// The unknowns of a mode, for each contact in turn: none where it is open; r_N without friction, and where it slips in
/// the plane, as r_T follows; r where it sticks; r_N, d_1, d_2 and v where it slips in space, with r_T = -mu r_N d,
/// u_T = v d and |d| = 1. In these small coefficients and small speeds are as good as others.
struct ModeUnknowns {
  std::vector<std::size_t> first;  ///< of each contact, and at last how many there are

  ModeUnknowns(const ExactContacts& contacts, const ContactPattern& mode);
  std::size_t count() const { return first.back(); }
  std::size_t of(std::size_t contact) const { return first[contact + 1] - first[contact]; }
};

struct SpatialMotion {
  ContactPattern mode;              ///< of each contact open, closed, stick or slip; in space arcs mean nothing
  std::vector<Rational> r, u;       ///< a point: forces, and W r + q
  std::vector<Rational> r_radius;   ///< a motion exists with r this near; all 0 where the point is one
  std::vector<Rational> u_radius;   ///< what r_radius makes of u
  std::vector<Rational> center;     ///< the point in the mode's unknowns
  std::vector<Rational> radius;     ///< within which one exists; empty where the point is a motion
  RationalMatrix inverse;           ///< of the derivative, approximately; empty where the point is a motion
  std::vector<Rational> alone;      ///< no other motion of this mode is within these; empty where that is not proved
  std::size_t open_directions = 0;  ///< of forces that the equations leave open

  bool is_exact() const { return inverse.empty(); }
};

/// Whether r with u = W r + q satisfies Coulomb's law exactly.
bool satisfies_law(const ExactContacts& contacts, std::span<const Rational> r, std::span<const Rational> u);
std::vector<Rational> velocities(const ExactContacts& contacts, std::span<const Rational> r);

/// The motion that Newton's method finds from a point, in the mode of a pattern in which nothing is left to decide but
/// directions. Nothing where it finds none, or none that can be proved.
std::optional<SpatialMotion> find_motion(const ExactContacts& exact, const FloatingContacts& contacts,
                                         const ContactPattern& mode, const ProposedPoint& start);

}  // namespace slipproof
