// How far an answer is from solving its problem, contact by contact, exactly; and what it solves instead.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contact/enclosure/fit.hpp"
#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Something that an answer violates. Contacts count from 0; `row` is meant where there is no contact.
struct Violation {
  std::optional<std::size_t> contact;
  std::size_t row = 0;
  std::string condition;  ///< `u_n >= 0`, `|r_t| <= mu r_n`
  double amount = 0;      ///< upper bound
  double effect = 0;      ///< the same as a velocity: what a force is wrong by changes velocities
};

/// Upper bounds, which include their own rounding errors.
struct Residual {
  /// Backward error: the problem whose constants differ by at most `change` in each component is solved exactly by a
  /// point at most `moved` from the answer in each component. Forces just outside of their cones are moved into them.
  double change = 0, moved = 0;
  /// Size of velocities at contacts: the largest |q_i| (sizes.hpp); if all are 0, the size that the forces give.
  double scale = 1;
  /// The largest change of a row over the size of its kind: `scale`, or for a free row its own.
  double relative = 0;
  std::vector<FittedContact> contacts;
  std::vector<Violation> worst;  ///< the largest effect first, ten at most

  double backward_error() const { return relative; }
};

/// `x` is finite and has the problem's size, `w` is A x + c (`exact_rows`). Linear in the nonzeros of A; exact except
/// for the bounds.
Residual residual(const MixedProblem& problem, std::span<const double> x, std::span<const Rational> w,
                  const ContactLaw& law);
/// The residual under the problem's own law.
inline Residual residual(const MixedProblem& problem, std::span<const double> x, std::span<const Rational> w) {
  return residual(problem, x, w, problem.law);
}

/// The largest |u_i - (A x + c)_i| of contacts, rounded up; `w` is A x + c.
double velocity_error(const MixedProblem& problem, std::span<const Rational> w, std::span<const double> u);

/// For each contact, the approximate size of the change of u with r: the norm of its block of A, or of the Delassus
/// matrix with the free rows replaced by their diagonal. Never 0.
std::vector<double> contact_scales(const MixedProblem& problem);

}  // namespace slipproof
