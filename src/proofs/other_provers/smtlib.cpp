#include "proofs/other_provers/smtlib.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "proofs/other_provers/certificate_reader.hpp"
#include "proofs/other_provers/integer_terms.hpp"
#include "proofs/statement/statement.hpp"

namespace slipproof {

namespace {

using prove::Polynomial;
using prove::Ring;

/// What the language or a solver has taken gets another name: bars alone would not make it another symbol.
std::string symbol(const std::string& name) {
  static constexpr std::array taken{"let",  "as",   "par",  "exists", "forall", "match", "and",   "or",    "not",
                                    "xor",  "true", "ite",  "false",  "abs",    "div",   "mod",   "pi",    "exp",
                                    "sqrt", "e",    "push", "pop",    "echo",   "exit",  "reset", "assert"};
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
  for (const Term& t : p.terms()) {
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

std::string sentence(const prove::Formula& formula) {
  if (formula.kind == prove::Formula::Kind::atom) {
    constexpr std::array<const char*, 3> relations{"=", ">", ">="};
    return fmt::format("({} {} 0)", relations[static_cast<std::size_t>(formula.sign)],
                       term(formula.polynomial.front()));
  }
  std::vector<std::string> parts;
  for (const prove::Formula& part : formula.parts) parts.push_back(sentence(part));
  const bool conjunction = formula.kind == prove::Formula::Kind::conjunction;
  return list(conjunction ? "and" : "or", parts, conjunction ? "true" : "false");
}

/// Everything but the negated conclusion.
std::string beginning(const prove::Statement& statement, const std::string& text, std::size_t variables,
                      const char* logic) {
  const Ring& ring = statement.ring();
  std::string out, line;
  for (std::istringstream lines(text); std::getline(lines, line);) out += "; " + line + '\n';
  out += fmt::format("(set-logic {})\n", logic);
  for (std::size_t i = 0; i < variables; ++i) out += fmt::format("(declare-const {} Real)\n", symbol(ring.name(i)));
  for (const auto& [name, formula] : statement.assumptions()) {
    out += fmt::format("; {}\n(assert {})\n", name, sentence(formula));
  }
  return out;
}

std::string ending(const std::string& negated) {
  return fmt::format("; not what is shown\n(assert {})\n(check-sat)\n", negated);
}

}  // namespace

std::string smtlib_text(const std::string& file, const std::string& text) {
  const prove::Statement statement(file, text);
  const std::vector<std::size_t>& unknowns = statement.unknowns();
  std::string negated = sentence(negation(statement.shown()));
  if (!unknowns.empty()) {
    std::vector<std::string> bound;
    for (const std::size_t i : unknowns) bound.push_back(fmt::format("({} Real)", symbol(statement.ring().name(i))));
    negated = fmt::format("(forall ({}) {})", fmt::join(bound, " "), negated);
  }
  return "; The negation of this statement: unsat confirms it.\n" +
         beginning(statement, text, statement.ring().size() - unknowns.size(), unknowns.empty() ? "QF_NRA" : "NRA") +
         ending(negated);
}

std::string smtlib_witness_text(const std::string& file, const std::string& text, const std::string& certificate_file,
                                const std::string& certificate) {
  const prove::Statement statement(file, text);
  if (statement.unknowns().empty()) return "";
  const prove::Proof proof = read_certificate(statement, certificate_file, certificate);
  const auto step = std::find_if(proof.begin(), proof.end(),
                                 [](const prove::Step& s) { return s.rule == prove::Step::Rule::witness; });
  if (step == proof.end()) return "";
  std::string out =
      "; That these values of the unknowns are not defined or violate the conclusion: unsat confirms the\n"
      "; statement.\n";
  std::vector<std::string> values;
  for (const auto& [unknown, value] : step->values) {
    out += fmt::format(";   {} = {}\n", unknown, value);
    values.push_back(value);
  }
  std::vector<prove::Formula> failures;
  for (const Polynomial& divisor : statement.divisors(values)) failures.push_back(atom(divisor, prove::Sign::zero));
  failures.push_back(negation(statement.shown(values)));
  return out + beginning(statement, text, statement.ring().size() - statement.unknowns().size(), "QF_NRA") +
         ending(sentence(combine(prove::Formula::Kind::disjunction, std::move(failures))));
}

}  // namespace slipproof
