// Linear equations in velocities, with quotients of polynomials as coefficients: elimination, one equation after the
// other.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "mechanics/bodies/quotients.hpp"

namespace slipproof::bodies_in_motion {

/// The sum of terms[i] * x_i + rest, which is 0. Terms that are identically 0 are left out.
struct RateEquation {
  std::map<std::size_t, Quotient> terms;
  Quotient rest;
};

/// Example: x_0 - l x_1 = 0, then x_1 - w = 0 leave x_0 = l w and x_1 = w; the further equation x_0 - v = 0 says
/// nothing of them and leaves l w - v. No pivot is identically 0.
class LinearRates {
 public:
  /// Unknowns with a low number are eliminated first.
  LinearRates(const Quotients& quotients, std::size_t unknowns);

  /// What remains of an equation that follows from those before or contradicts them; nothing if it says something new.
  std::optional<Quotient> insert(RateEquation equation);
  /// Unknowns that the equations do not determine, so that they would be determined with these given. Ends the use of
  /// insert().
  std::vector<std::size_t> undetermined();
  /// The values; all unknowns must be determined.
  std::vector<Quotient> values() const;
  /// Of the equations that said something new, apart from its sign.
  const Quotient& determinant() const { return determinant_; }

 private:
  struct Pivot {
    std::size_t unknown;
    RateEquation equation;  ///< with the coefficient 1 at the unknown
  };
  void reduce(RateEquation& equation) const;
  Quotient product(const Quotient& x, const Quotient& y) const;

  const Quotients& quotients_;
  std::size_t unknowns_;
  std::vector<Pivot> pivots_;  ///< none has the unknown of one before it
  Quotient determinant_;
};

}  // namespace slipproof::bodies_in_motion
