// Statements (proofs/FORMAT.md) as text: their lines, and every mistake in them with its place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/statement/statement_line.hpp"

namespace slipproof {

/// `name` is the theorem's name and that of its files, without extension.
struct NamedStatement {
  std::string name;
  std::string text;
  bool refutes = false;  ///< at a bicycle where it is false, its claim is wrong (and does not just lack a value)
};

/// A line after `theorem`.
struct Directive {
  enum class Kind : std::uint8_t { real, let, define, assume, exists, show };
  Kind kind = Kind::show;
  std::size_t line = 0;            ///< of the file, from 1
  std::vector<std::string> names;  ///< of the variables; of what is abbreviated or assumed: one
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

/// Of a statement, in all its lines `real` and `exists`.
constexpr std::size_t max_statement_variables = 64;

/// Reads the content of a file. Throws InputError with the first mistake of every line.
StatementText read_statement(const std::string& file, std::string_view text);

/// The statement that a formula of one line holds for all real values of its variables; they are declared in the order
/// of the formula, which is the last line, after `formula_prefix`.
std::string formula_statement(std::string_view formula);
inline constexpr std::string_view formula_prefix = "show ";

/// A value of an unknown, an expression in the names from before `exists`. Throws ExpressionError.
Expression parse_witness_value(const StatementText& statement, std::string_view value);

}  // namespace slipproof
