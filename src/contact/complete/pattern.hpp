// What is decided about each contact, and what a vector proves about all motions for which that holds.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/complete/contacts.hpp"

namespace slipproof {

/// A direction in the tangential plane, (x, y) / length, with x^2 + y^2 = length^2 exactly and length > 0. In the plane
/// y = 0 and x = +-length.
struct Direction {
  Integer x = 1, y = 0, length = 1;

  /// One with short numbers within about 2^-bits of an angle in radians, measured from the first tangent.
  static Direction near(double angle, int bits);
  /// One with numbers so short that it can hardly be within 1e-10 of an angle by chance; nothing if there is none.
  static std::optional<Direction> short_at(double angle);
  double angle() const;
  bool operator==(const Direction&) const = default;
};

/// a x b, up to the positive factor of the lengths: its sign tells on which side of a b lies.
Integer cross(const Direction& a, const Direction& b);

/// What is decided about a contact. These are disjoint unless one contains another, and `any` is all of the law:
///   open    r = 0, u_N > 0
///   closed  r_N >= 0, u_N = 0         contains stick and slip
///   stick   u = 0, |r_T| <= mu r_N
///   slip    r_N >= 0, u_N = 0, u_T = |u_T| d, not 0, and r_T = -mu r_N d, for a direction d from `from` to `to`
/// So what kinematics closes is never open, with or without a force. Without friction closed is all there is to decide:
/// r_T = 0, and u_T may be anything.
struct ContactState {
  enum class Kind : std::uint8_t { any, open, closed, stick, slip };
  Kind kind = Kind::any;
  Direction from, to;  ///< slip: an arc, counterclockwise, below half a turn

  double width() const;                    ///< of the arc, in radians, about
  std::array<Rational, 2> middle() const;  ///< the sum of the arc's ends: its middle, up to length
  bool operator==(const ContactState&) const = default;
};

using ContactPattern = std::vector<ContactState>;

/// All contacts stick, or are closed where they have no friction.
ContactPattern rest_pattern(const ExactContacts& contacts);

/// Whether nothing but a direction is left to decide about a contact.
bool is_decided(const ExactContacts& contacts, const ContactPattern& pattern, std::size_t contact);
/// About any contact.
bool is_decided(const ExactContacts& contacts, const ContactPattern& pattern);

/// A linear form of velocities and forces: the sum of u[i] u_i + r[i] r_i.
struct ContactForm {
  std::vector<std::pair<std::size_t, Rational>> u, r;
};

/// What holds for all motions of a pattern.
struct ProvedBound {
  Rational value;       ///< the form is at least this
  bool strict = false;  ///< and more than this
};

/// Whether y proves a lower bound of the form over the pattern: if at each contact
///   (f - y) . u >= 0   for all u that the state allows, and
///   (h + W^T y) . r >= 0   for all r that it allows,
/// then f . u + h . r = (f - y) . u + (h + W^T y) . r + y . q >= y . q. Exact; quadratic in the size.
/// MATHEMATICS.md has the conditions for each state.
std::optional<ProvedBound> lower_bound(const ExactContacts& contacts, const IntegerContacts& integers,
                                       const ContactPattern& pattern, const ContactForm& form,
                                       std::span<const Rational> y);

/// Whether y proves that the pattern has no motion at all: 0 is bounded by more than 0.
bool proves_empty(const ExactContacts& contacts, const IntegerContacts& integers, const ContactPattern& pattern,
                  std::span<const Rational> y);

}  // namespace slipproof
