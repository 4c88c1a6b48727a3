// One branch of a proof under construction: the facts in force, what was derived from them, and the steps so far. A
// branch is closed when its steps end in a contradiction, or in a case distinction all of whose branches are closed.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proofs/branch/slack.hpp"

namespace slipproof::prove {

/// Most techniques are tried with few attempts first, and again with more where all of them failed.
enum class Pass : std::uint8_t { quick, thorough };

/// An equation used for elimination: of a variable, pivot * variable + rest = 0 with a pivot of known sign; of a
/// product of two variables that is a term of its own; or of terms, by a circle c^2 + s^2 - 1 = 0.
struct Rule {
  Fact equation;
  std::size_t variable;
  std::optional<std::size_t> second;  ///< the other variable of the product or circle
  Polynomial pivot;                   ///< positive
  WeightedProduct pivot_product;      ///< the facts that it is a product of
  Polynomial rest;
  int orientation;  ///< of the equation: pivot * variable + rest = orientation * equation
  bool is_circle = false;
};

/// The sign of an irreducible polynomial p, and the fact that says so.
struct KnownSign {
  int orientation = 1;  ///< orientation * p > 0 or >= 0 is the fact
  bool strict = true;
  std::string name;
};

struct State {
  Proof steps;
  std::vector<Fact> facts;
  std::vector<Fact> derived;  ///< signs that follow from the facts, for denominators
  std::vector<std::pair<std::string, Formula>> disjunctions;
  std::vector<Rule> rules;                    ///< in order of discovery
  std::map<std::string, KnownSign> signs;     ///< by text of an irreducible polynomial
  std::map<std::string, Pass> unknown_signs;  ///< searched without success, last in this pass

  /// A copy with the same facts and no steps.
  State branch() const {
    State result = *this;
    result.steps.clear();
    return result;
  }
};

/// Closes a branch, if it can.
using Close = std::function<bool(State& branch)>;

inline Rational absolute(const Rational& x) {
  return x < 0 ? Rational(-x) : x;
}

/// The last step of a branch: an identity that cannot be.
inline Step contradiction(Identity identity) {
  Step step;
  step.identities.push_back(std::move(identity));
  return step;
}

/// A fact that follows from those in force, by identities that its negation would make impossible.
inline Step have(const Fact& fact, std::vector<Identity> identities) {
  Step step;
  step.rule = Step::Rule::have;
  step.name = fact.name;
  step.polynomial = {fact.p};
  step.sign = fact.sign;
  step.identities = std::move(identities);
  return step;
}

}  // namespace slipproof::prove
