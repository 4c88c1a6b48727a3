// What an error is relative to: one rule for every answer that is judged.
//
// Components of a solution have kinds: quantities of one unit, such as m/s^2, 1/s^2, N, N m. Nothing is compared across
// kinds, so no verdict depends on the units of the numbers. The yardstick of a kind is the largest exact quantity of
// that kind: a component of the solution that is determined, or a known term of its equations, such as a weight. For
// components that the equations leave open it includes the answer's own values, as nothing else is known about their
// size.
//
// The error of a component is relative to its exact value; if that is 0, or left open, to the yardstick of its kind. If
// the yardstick is 0, too, then only 0 is right, and everything else has the error 1.
//
// Example: forces (N, S) = (1000, 0) in newtons, and an answer (1000.001, 1e-6): the errors are 1e-6 and 1e-9. In
// kilonewtons they are the same, and accelerations of 1e9 m/s^2 in the same solution change nothing.
#pragma once

#include <vector>

#include "base/algebra/linear_program.hpp"

namespace slipproof {

/// The distance of an answer from a solution: the largest errors of a component.
struct Distance {
  Rational relative;  ///< relative error as above, to be compared with a tolerance
  Rational scaled;    ///< relative to the yardstick of its kind, if that is larger: separates inaccurate from wrong
};

/// Whether a solution is the one that an answer means, rather than another one: one within the tolerance before one
/// that is not, then the nearest by `scaled`.
bool is_nearer(const Distance& solution, const Distance& other, const Rational& tolerance);

/// The largest quantity of each kind.
class Yardsticks {
 public:
  explicit Yardsticks(std::size_t kinds) : largest_(kinds) {}

  void take(std::size_t kind, const Rational& quantity);
  const Rational& operator[](std::size_t kind) const { return largest_[kind]; }

 private:
  std::vector<Rational> largest_;  ///< >= 0
};

/// A solver's value of one component, and the exact one.
struct ComparedComponent {
  Rational answer, exact;
  Rational yardstick;  ///< of its kind; of an open component not below |answer|
  bool open = false;   ///< the equations leave it open: `exact` is that of one solution among many
};

/// Puts a component's errors into `distance`; whether its relative error is the largest until now.
bool compare(const ComparedComponent& component, Distance& distance);

/// A component of infinitely many solutions, as a form over their parameters t, and what the solver says of it.
struct OpenComponent {
  AffineForm form;
  Rational answer;
  Rational yardstick;  ///< of its kind; not below |answer|
};

/// The parameters of the solution nearest to an answer: an exact linear program minimizes the largest error as
/// compare() measures it. The solutions are those t where every condition is >= 0; there must be one. All forms have as
/// many coefficients as there are parameters. Without components returns some solution. Throws TooMuchWork.
std::vector<Rational> nearest_solution(const std::vector<OpenComponent>& components,
                                       const std::vector<AffineForm>& conditions, std::size_t parameters,
                                       Effort& effort);

}  // namespace slipproof
