// Replaces variables by the slack of a hypothesis, in one polynomial after another.
#pragma once

#include "proofs/branch/memo.hpp"

namespace slipproof::prove {

/// variable = numerator / denominator, where the variable's own name now means the slack.
struct Replacement {
  std::size_t variable;
  Polynomial numerator, denominator;

  std::size_t length() const { return numerator.length() + denominator.length(); }
};

class Replacements {
 public:
  /// Solves `slack`, which must be linear in the variable, for it. A denominator of one term is monic; otherwise its
  /// leading coefficient is positive.
  Replacement solved(const Polynomial& slack, std::size_t variable) {
    return solved_.get([&] { return solve(slack, variable); }, variable, slack);
  }

  /// denominator^d p in the new coordinates, for p of degree d in the variable.
  Polynomial applied(const Replacement& r, const Polynomial& p) {
    return applied_.get([&] { return substitute(p, r.variable, r.numerator, r.denominator); }, r.variable, p,
                        r.numerator, r.denominator);
  }

 private:
  static Replacement solve(const Polynomial& slack, std::size_t variable) {
    Polynomial c = slack.coefficient(variable, 1);
    Polynomial numerator = Polynomial::variable(slack.ring(), variable) - slack.coefficient(variable, 0);
    Rational leading = c.leading_coefficient();
    if (c.length() > 1) leading = leading < 0 ? -1 : 1;
    if (leading != 1) {
      c = c.scaled(1 / leading);
      numerator = numerator.scaled(1 / leading);
    }
    return {variable, std::move(numerator), std::move(c)};
  }

  Memo<Replacement, 1> solved_;
  Memo<Polynomial, 3> applied_;
};

}  // namespace slipproof::prove
