// Statements (proofs/FORMAT.md) as text: read into lines, with every mistake and its place; and built line by line,
// with one printer.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "proofs/statement/statement_line.hpp"

namespace slipproof {

/// `name` is the theorem's name and that of its files, without extension.
struct NamedStatement {
  std::string name;
  std::string text;
  bool refutes = false;  ///< where the statement is false, its claim is wrong (and does not merely lack a value)
};

/// A line after `theorem`.
struct Directive {
  enum class Kind : std::uint8_t { real, let, define, assume, exists, show };
  Kind kind = Kind::show;
  std::size_t line = 0;            ///< line in the file, from 1
  std::vector<std::string> names;  ///< the variables; or the one name that is abbreviated or assumed
  Expression body;                 ///< an expression of `let`, otherwise a formula; null of `real` and `exists`
};

/// A line `# split: EXPRESSION`: a comment to the checker, to the prover a polynomial worth a case split.
struct SplitHint {
  std::size_t line = 0;
  Expression expression;
};

struct StatementText {
  std::string theorem;
  std::string fingerprint;  ///< FNV-1a of the lines that count, in hexadecimal
  std::vector<Directive> directives;
  std::vector<SplitHint> hints;
};

/// The largest number of variables in all lines `real` and `exists` of a statement.
constexpr std::size_t max_statement_variables = 64;

/// Reads the content of a file. Throws InputError with the first mistake of every line.
StatementText read_statement(const std::string& file, std::string_view text);

/// The statement that a formula of one line holds for all real values of its variables; they are declared in the order
/// of the formula, which is the last line, after `formula_prefix`.
std::string formula_statement(std::string_view formula);
inline constexpr std::string_view formula_prefix = "show ";

/// A value of an unknown, an expression in the names from before `exists`. Throws ExpressionError.
Expression parse_witness_value(const StatementText& statement, std::string_view value);

/// The parts joined by `and` or `or`, without null ones; parts that are joined by the same word are continued. Null if
/// there is no part; a single part itself.
Expression joined_by(Operation word, const std::vector<Expression>& parts);
inline Expression conjoined(const std::vector<Expression>& parts) {
  return joined_by(Operation::logical_and, parts);
}
inline Expression disjoined(const std::vector<Expression>& parts) {
  return joined_by(Operation::logical_or, parts);
}

/// Brackets that the printer would leave out: `{formula}`; as a side of a comparison `(number)`. A reader drops them.
Expression braced(const Expression& formula);
Expression bracketed(const Expression& number);
/// `x*y`, without blanks, as a side of a comparison. Brackets a factor only if bracketed() made it.
Expression tight_product(const Expression& x, const Expression& y);

/// Whether a formula contains `or`.
bool has_cases(const Expression& formula);

std::string formula_text(const Expression& formula);

/// A statement that is built line by line, and printed once.
class WrittenStatement {
 public:
  WrittenStatement() = default;
  /// The comment is printable ASCII.
  WrittenStatement(std::string theorem, std::string comment)
      : theorem_(std::move(theorem)), comment_(std::move(comment)) {}

  void add(Directive::Kind kind, std::string name, Expression body) {
    lines_.emplace_back(Directive{kind, 0, {std::move(name)}, std::move(body)});
  }
  void add(const std::vector<Directive>& lines) { lines_.insert(lines_.end(), lines.begin(), lines.end()); }
  /// Adds a line `real` or `exists`; none without names.
  void declare(Directive::Kind kind, std::vector<std::string> names);
  /// Adds lines `# split: EXPRESSION`; none for null.
  void add_hints(const std::vector<Expression>& hints);
  void show(Expression formula) { lines_.emplace_back(Directive{Directive::Kind::show, 0, {}, std::move(formula)}); }

  /// Variables and unknowns that it declares.
  std::size_t variables() const;
  std::string text() const;

 private:
  std::string theorem_, comment_;
  std::vector<std::variant<Directive, SplitHint>> lines_;
};

}  // namespace slipproof
