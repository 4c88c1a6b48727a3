// The state shared by all branches of a search: the statement, the limits and the budget, new names for facts, and
// cached results about polynomials, since the same polynomials recur in many branches.
#pragma once

#include <map>
#include <string>

#include "proofs/branch/samples.hpp"
#include "proofs/branch/slack.hpp"
#include "proofs/statement/limits.hpp"

namespace slipproof::prove {

/// The extent of the present attempt; the search begins with a small one.
struct Reach {
  int split_depth = 0;          ///< nested splits
  unsigned product_degree = 1;  ///< degree of the products in linear programs; 1: no products
  bool sums_of_squares = false;
  bool circles = false;  ///< whether the equations of circles shorten facts
};

/// A polynomial and its negative, as the same two objects at each request, so that cached results are found by their
/// identities.
struct BothSigns {
  Polynomial p, negated;
  SignPattern at_samples;  ///< samples at which p is positive, and negative
};

/// For one thread at a time, like the ring's budget.
class Context {
 public:
  /// The statement must outlive it.
  Context(const Statement& statement, const Limits& limits);

  const Statement& statement() const { return statement_; }
  const Ring& ring() const { return statement_.ring(); }
  const Limits& limits() const { return limits_; }
  SlackEffort thorough_slack() const { return {limits_.slack_depth, limits_.slack_attempts}; }
  Budget& budget() const { return statement_.ring().budget(); }

  /// A name that no hypothesis has.
  std::string fresh();
  /// This name, or a fresh one where an assumption has it.
  std::string unused(const std::string& name);

  /// The factors of p, short ones first. The reference stays valid. One that is too long counts as irreducible.
  const Factorization& factored(const Polynomial& p);
  /// The reference stays valid.
  const BothSigns& both_signs(const Polynomial& p);
  /// The reference stays valid.
  const SignPattern& signs_at_samples(const Polynomial& p) { return both_signs(p).at_samples; }
  Replacements& replacements() { return replacements_; }
  /// The coefficient of a variable in p, which is linear in it; the same object at each call.
  Polynomial slope(const Polynomial& p, std::size_t variable);
  /// upper times the slope of lower, minus lower times the slope of upper: both are linear in the variable, which
  /// drops out. The same one at each call.
  Polynomial without(std::size_t variable, const Polynomial& lower, const Polynomial& upper);
  /// The samples for which the fact is false.
  SampleSet fails(const Fact& fact);

  Reach reach;  ///< set by who searches deeper and deeper

 private:
  const Statement& statement_;
  Limits limits_;
  Samples samples_;
  std::map<std::string, BothSigns> signed_;  ///< by text of a polynomial, as the next ones
  std::map<std::string, Factorization> factorizations_;
  Replacements replacements_;
  Memo<Polynomial, 1> slopes_;
  Memo<Polynomial, 2> sums_;
  int counter_ = 0;
};

}  // namespace slipproof::prove
