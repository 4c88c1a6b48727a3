#include "export/smtlib.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "export/integer_terms.hpp"
#include "prove/statement.hpp"

namespace slipproof {

namespace {

using prove::Formula;
using prove::Polynomial;
using prove::Ring;

/// What the language or a solver has taken gets another name: bars alone would not make it another symbol.
std::string symbol(const std::string& name) {
  static constexpr std::array taken{"let",  "as",  "par",   "exists", "forall", "match", "and", "or",  "not",  "xor",
                                    "true", "ite", "false", "abs",    "div",    "mod",   "pi",  "exp", "sqrt", "e"};
  const bool renamed = std::find(taken.begin(), taken.end(), name) != taken.end();
  if (renamed) return "|the variable " + name + "|";
  return name.find('\'') == std::string::npos ? name : "|" + name + "|";
}

std::string list(const std::string& operation, const std::vector<std::string>& operands, const char* none) {
  if (operands.empty()) return none;
  if (operands.size() == 1) return operands.front();
  std::string text = "(" + operation;
  for (const std::string& operand : operands) text += " " + operand;
  return text + ")";
}

std::string number(const Integer& value) {
  return value < 0 ? "(- " + Integer(-value).str() + ")" : value.str();
}

std::string term(const Polynomial& p) {
  const Integer scale = common_denominator(p);
  std::vector<std::string> sum;
  for (const prove::Term& t : p.terms()) {
    const Integer coefficient = numerator(Rational(t.coefficient * scale));
    std::vector<std::string> product;
    for (std::size_t i = 0; i < t.exponents.size(); ++i) {
      product.insert(product.end(), t.exponents[i], symbol(p.ring().name(i)));
    }
    if (coefficient != 1 || product.empty()) product.insert(product.begin(), number(coefficient));
    sum.push_back(list("*", product, "1"));
  }
  return list("+", sum, "0");
}

std::string sentence(const Formula& formula) {
  if (formula.kind == Formula::Kind::atom) {
    constexpr std::array<const char*, 3> relations{"=", ">", ">="};
    return fmt::format("({} {} 0)", relations[static_cast<std::size_t>(formula.sign)],
                       term(formula.polynomial.front()));
  }
  std::vector<std::string> parts;
  for (const Formula& part : formula.parts) parts.push_back(sentence(part));
  const bool conjunction = formula.kind == Formula::Kind::conjunction;
  return list(conjunction ? "and" : "or", parts, conjunction ? "true" : "false");
}

}  // namespace

std::string smtlib_text(const std::string& file, const std::string& text) {
  const prove::Statement statement(file, text);
  const Ring& ring = statement.ring();
  const std::size_t variables = ring.size() - statement.unknowns().size();
  const bool quantified = variables < ring.size();
  std::string out = "; The negation of this statement: unsat confirms it.\n";
  std::string line;
  for (std::istringstream lines(text); std::getline(lines, line);) out += "; " + line + '\n';
  out += fmt::format("(set-logic {})\n", quantified ? "NRA" : "QF_NRA");
  for (std::size_t i = 0; i < variables; ++i) out += fmt::format("(declare-const {} Real)\n", symbol(ring.name(i)));
  for (const auto& [name, formula] : statement.assumptions()) {
    out += fmt::format("; {}\n(assert {})\n", name, sentence(formula));
  }
  std::string negated = sentence(negation(statement.shown()));
  if (quantified) {
    std::vector<std::string> bound;
    for (const std::size_t i : statement.unknowns()) bound.push_back(fmt::format("({} Real)", symbol(ring.name(i))));
    negated = fmt::format("(forall ({}) {})", fmt::join(bound, " "), negated);
  }
  return out + fmt::format("; not what is shown\n(assert {})\n(check-sat)\n", negated);
}

}  // namespace slipproof
