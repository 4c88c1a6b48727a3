// How far an answer is from solving its problem, contact by contact, exactly; and what it solves instead.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contact/enclosure/mixed_problem.hpp"

namespace slipproof {

/// The way in which a contact obeys its law. Where mu = 0, and in dimension 1, what is closed sticks.
enum class ContactFit : std::uint8_t { open, stick, slide };

/// The friction that engines with a linear complementarity solver compute with, in place of the cone.
enum class FrictionLaw : std::uint8_t {
  cone,     ///< |r_T| <= mu r_N, Euclidean
  box,      ///< |r_T1| <= mu r_N and |r_T2| <= mu r_N, each direction for itself
  diamond,  ///< |r_T1| + |r_T2| <= mu r_N, with the largest dissipation
};
/// `friction cone`, `box pyramid |t1| <= mu n, |t2| <= mu n`, ...
std::string_view name(FrictionLaw law);

/// The nearest way in which one contact could obey its law.
struct FittedContact {
  ContactFit fit = ContactFit::open;
  std::vector<Rational> r, u;  ///< which obey the law exactly, `dimension` of each
  double moved = 0;            ///< upper bound on |r - the answer's|, the largest component
  double change = 0;           ///< the same of u - the answer's A x + c
};

/// Something that an answer violates. Contacts count from 0; `row` is meant where there is no contact.
struct Violation {
  std::optional<std::size_t> contact;
  std::size_t row = 0;
  std::string condition;  ///< `u_n >= 0`, `|r_t| <= mu r_n`
  double amount = 0;      ///< upper bound
  double effect = 0;      ///< the same as a velocity: what a force is wrong by changes velocities
};

/// All bounds are upper bounds, and pay for their own rounding.
struct Residual {
  /// With constants changed by at most `change` in each component the problem is solved exactly by a point that is at
  /// most `moved` away from the answer in each component: forces just outside of their cones are moved back.
  double change = 0, moved = 0;
  double scale = 1;  ///< of contacts: the largest |q_i| (sizes.hpp); if all are 0, what the forces give
  /// The largest change of a row over the size of its kind: `scale`, or for a free row its own.
  double relative = 0;
  std::vector<FittedContact> contacts;
  std::vector<Violation> worst;  ///< the largest effect first, ten at most

  double backward_error() const { return relative; }
};

/// `x` is finite and has the problem's size, `w` is A x + c (`exact_rows`). Linear in the nonzeros of A; exact except
/// for the bounds.
Residual residual(const MixedProblem& problem, std::span<const double> x, std::span<const Rational> w,
                  FrictionLaw law = FrictionLaw::cone);

/// A rational point of the unit circle within 1e-15 of the direction (x, y), which is not (0, 0).
std::pair<Rational, Rational> unit_direction(double x, double y);

/// For each contact how much u changes with r, roughly: the norm of its block of A, or of the Delassus matrix as the
/// diagonal of the free rows would give it. Never 0.
std::vector<double> contact_scales(const MixedProblem& problem);

}  // namespace slipproof
