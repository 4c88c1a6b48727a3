// A line of a statement (proofs/FORMAT.md), read from left to right: words, expressions and formulas.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/expression/expression.hpp"
#include "base/expression/parser.hpp"

namespace slipproof {

/// The names that a statement has given so far.
struct GivenNames {
  std::set<std::string, std::less<>> values;    ///< variables, unknowns, and what `let` abbreviates
  std::set<std::string, std::less<>> formulas;  ///< names that `define` abbreviates
};

/// Trees for expressions and formulas. In the place of a formula, a formula's name is a symbol and `false` the truth
/// value. A conjunction or disjunction has as many operands as the text joins, and each pair of braces is a node of its
/// own: the names of its parts as hypotheses depend on this. All functions throw ExpressionError with the column of the
/// first mistake.
class StatementLine {
 public:
  /// Splits a line into words. The arguments must outlive the object.
  StatementLine(std::string_view line, const GivenNames& given);

  bool at_end() const { return next_ == tokens_.size(); }
  std::string name();  ///< reads a name
  std::string take() { return std::string(tokens_.at(next_++).text); }
  bool accept(std::string_view token);
  void expect(std::string_view token);
  void expect_end() const;
  Expression expression();
  Expression formula();
  std::size_t column() const;                                 ///< column of the next word, from 1
  [[noreturn]] void fail(const std::string& expected) const;  ///< found ..., expected ...

 private:
  struct Token {
    std::string_view text;
    std::size_t column;
  };

  std::string_view peek() const { return at_end() ? std::string_view() : tokens_[next_].text; }
  Expression conjunction();
  Expression unit();
  Expression comparison();
  Expression product();
  Expression power();
  Expression base();
  int exponent();
  template <class Read>
  Expression nested(const char* closing, Read read);
  Expression joined(Operation operation, std::vector<Expression> parts, std::size_t column) const;
  Expression sum();
  void count_operator();

  std::vector<Token> tokens_;
  const GivenNames& given_;
  std::size_t next_ = 0, end_ = 1;
  int nesting_ = 0, operators_ = 0;
};

/// The parts of a conjunction or disjunction; of anything else itself.
std::vector<Expression> joined_parts(const Expression& formula);

}  // namespace slipproof
