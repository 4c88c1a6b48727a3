// What the strategies of a search share: facts in force, rules, signs, and the steps so far.
#pragma once

#include <algorithm>
#include <map>
#include <set>

#include "prove/search.hpp"

namespace slipproof::prove {

/// An equation used to eliminate: of a variable, pivot * variable + rest = 0 with a pivot of known sign; or of a
/// product of two variables that stands alone in it.
struct Search::Rule {
  Fact equation;
  std::size_t variable;
  std::optional<std::size_t> second;  ///< the other variable of the product
  Polynomial pivot;                   ///< positive
  Rational pivot_constant;            ///< pivot = pivot_constant * product of the facts in pivot_product
  Product pivot_product;
  Polynomial rest;
  int orientation;  ///< of the equation: pivot * variable + rest = orientation * equation
};

struct Search::KnownSign {
  int orientation = 1;  ///< orientation * p > 0 or >= 0 is the fact
  bool strict = true;
  std::string name;
};

struct Search::State {
  Proof steps;
  std::vector<Fact> facts;
  std::vector<Fact> derived;  ///< signs that follow from the facts, for denominators
  std::vector<std::pair<std::string, Formula>> disjunctions;
  std::vector<Rule> rules;
  std::map<std::string, KnownSign> signs;     ///< by the text of an irreducible polynomial
  std::map<std::string, bool> unknown_signs;  ///< searched without success; whether thoroughly

  State branch() const {
    State result = *this;
    result.steps.clear();
    return result;
  }
};

inline Rational absolute(const Rational& x) {
  return x < 0 ? Rational(-x) : x;
}

inline Step contradiction(Identity identity) {
  Step step;
  step.identities.push_back(std::move(identity));
  return step;
}

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
