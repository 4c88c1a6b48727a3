// A statement as a theorem of Coq, and the steps that bring it to the normal form of proofs/FORMAT.md.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/expression/expression.hpp"
#include "proofs/other_provers/coq_formula.hpp"
#include "proofs/statement/statement.hpp"

namespace slipproof::coq {

/// The expression in the statement's words, which are Coq's too.
std::string text(const Expression& e);

/// `Theorem NAME : ... .`, line by line what the statement says, with each division guarded.
std::string theorem(const prove::Statement& statement);

/// Writes tactics that introduce the lines of a statement and prove its formulas equivalent to their normal forms.
class Normalizer {
 public:
  explicit Normalizer(const prove::Statement& statement);

  /// Introduces variables, an abbreviation, or an assumption: its normal form, taken apart by an introduction pattern.
  void introduce(const Directive& line, const std::string& pattern = {});
  /// Gives an unknown of `exists` its value, an expression in the variables; a divisor of it has been shown not to
  /// vanish by the hypothesis that `non_zero` names for it.
  void give_value(const std::string& unknown, const Expression& value,
                  const std::vector<std::pair<prove::Polynomial, std::string>>& non_zero);
  /// The normal form of a formula.
  Formula normal(const Expression& formula) const;
  /// The divisors of an expression, without repetition.
  std::vector<prove::Polynomial> divisors(const Expression& expression) const;
  /// The formula as it is written in the theorem, with the condition that its divisors are not zero before each
  /// comparison.
  std::string proposition(const Expression& formula, bool inner = false) const;
  /// Tactics for the goal `formula <-> normal(formula)`.
  void prove_same(const Expression& formula);
  /// Takes the tactics written so far.
  std::string take() { return std::move(script_); }

 private:
  struct Divisor {
    prove::Polynomial polynomial;   ///< zero where the divisor is
    prove::Polynomial denominator;  ///< of the divisor's own value
    Expression expression;          ///< null if it occurs only in a witness
  };
  struct Value {
    prove::Polynomial numerator, denominator;
    std::vector<Divisor> divisors;
    bool divides = false;  ///< though it may be by a constant
  };
  struct Link {
    Expression left, right;
    Relation relation;
  };

  static void merge(std::vector<Divisor>& divisors, const std::vector<Divisor>& more);
  static std::vector<Link> links(const Expression& comparison);
  /// Where unknowns have been given values, an expression has another value as the theorem reads, before they have.
  Value value(const Expression& e, bool in_theorem = false) const;
  Formula normal(const Link& link) const;
  std::string proposition(const Link& link) const;
  void prove_same(const Link& link);
  void prove_guards(const Expression& difference, const std::vector<Divisor>& divisors);
  void prove_fraction(const Expression& e);
  void prove_ring();
  bool is_non_zero(const prove::Polynomial& divisor) const;
  std::string non_zero(const prove::Polynomial& divisor) const;
  std::string add_non_zero(const prove::Polynomial& divisor);
  void state_fraction(const std::string& name, const Expression& body);

  const prove::Statement& statement_;
  std::map<std::string, Value> values_;
  std::map<std::string, Value> theorem_values_;  ///< of the unknowns with values, and the abbreviations since
  std::map<std::string, Formula> formulas_;
  std::map<std::string, std::vector<prove::Polynomial>> premises_;  ///< of the fact about a fraction's value
  std::vector<std::string> transparent_;                            ///< abbreviations of polynomials
  std::vector<std::pair<prove::Polynomial, std::string>> non_zero_;
  std::string script_;
};

}  // namespace slipproof::coq
