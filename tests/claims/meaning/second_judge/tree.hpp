// Expressions of a claims file as proofs/MEANING.md has them ("Values"): trees that print themselves as claims text and
// have a value, or none. Nothing here knows of src/claims/reading.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof::meaning {

enum class Op {
  number,
  symbol,
  negate,
  add,
  subtract,
  multiply,
  divide,
  power,
  absolute,
  signum,
  minimum,
  maximum,
  truth,
  chain,
  negation,
  conjunction,
  disjunction
};

struct Node;
using Tree = std::shared_ptr<const Node>;

struct Node {
  Op op = Op::truth;
  std::vector<Tree> parts;
  std::vector<std::string> relations;  ///< of a chain, one less than parts
  Rational number;
  std::string symbol;
  int exponent = 0;
  bool truth = false;
};

Tree number(const Rational& value);
Tree symbol(const std::string& name);
Tree truth(bool value);
Tree power(Tree base, int exponent);
Tree chain(std::vector<Tree> parts, std::vector<std::string> relations);
Tree compare(Tree left, const std::string& relation, Tree right);
Tree make(Op op, std::vector<Tree> parts);

Tree plus(Tree x, Tree y);
Tree minus(Tree x, Tree y);
Tree times(Tree x, Tree y);
Tree over(Tree x, Tree y);

/// With parentheses around everything, so that no rule of precedence is shared with those who read it.
std::string text(const Tree& tree);

/// Symbols in the text itself; those in definitions do not count.
std::set<std::string> symbols(const Tree& tree);

/// What symbols stand for: `values`, and `definitions` for which their trees stand.
struct Names {
  std::map<std::string, Rational> values;
  std::map<std::string, Tree> definitions;
};

/// Nothing: undefined.
using Number = std::optional<Rational>;
using Truth = std::optional<bool>;

Number number_of(const Tree& tree, const Names& names);
Truth truth_of(const Tree& tree, const Names& names);

/// Whether a number stands in a relation, `<`, `<=`, ..., to zero.
bool stands(const Rational& difference, const std::string& relation);

/// The rules for truth values.
Truth negation(Truth x);
Truth conjunction(Truth x, Truth y);
Truth disjunction(Truth x, Truth y);

inline bool is_true(Truth x) {
  return x == true;
}
inline bool is_false(Truth x) {
  return x == false;
}

/// Base to an integer power; nothing for a negative power of zero.
Number to_power(const Rational& base, int exponent);

/// A condition that is left out is true.
inline Tree or_true(const Tree& condition) {
  return condition ? condition : truth(true);
}
inline bool any(const std::vector<Truth>& truths, Truth wanted) {
  return std::find(truths.begin(), truths.end(), wanted) != truths.end();
}

}  // namespace slipproof::meaning
