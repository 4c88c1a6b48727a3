#include "proofs/other_provers/coq_formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace slipproof::coq {

namespace {

std::string non_negative_power(const std::string& base, unsigned long exponent) {
  return exponent == 1 ? base : fmt::format("{}^{}", base, exponent);
}

}  // namespace

std::string name(const std::string& statement_name) {
  static constexpr std::array taken{"as",      "at",    "cofix", "do",   "else",   "end",   "exists",
                                    "exists2", "fix",   "for",   "fun",  "forall", "IF",    "if",
                                    "in",      "let",   "match", "mod",  "Prop",   "Set",   "real",
                                    "SProp",   "Steps", "then",  "Type", "using",  "where", "with"};
  const bool renamed = std::find(taken.begin(), taken.end(), statement_name) != taken.end();
  if (renamed) return statement_name + "'0";
  std::string result;
  for (const char c : statement_name) result += c == '.' ? "'_" : c == '\'' ? "''" : std::string(1, c);
  return result;
}

std::string text(const prove::Polynomial& p, const Integer& scale) {
  std::string result;
  for (const Term& term : p.terms()) {
    Integer coefficient = numerator(Rational(term.coefficient * scale));
    std::string product;
    for (std::size_t i = 0; i < term.exponents.size(); ++i) {
      if (term.exponents[i] == 0) continue;
      product += (product.empty() ? "" : "*") + non_negative_power(name(p.ring().name(i)), term.exponents[i]);
    }
    const bool negative = coefficient < 0;
    if (negative) coefficient = -coefficient;
    const std::string magnitude = product.empty()    ? coefficient.str()
                                  : coefficient == 1 ? product
                                                     : coefficient.str() + "*" + product;
    result += result.empty() ? (negative ? "- " : "") : negative ? " - " : " + ";
    result += magnitude;
  }
  return result.empty() ? "0" : result;
}

Formula atom(std::string polynomial, prove::Sign sign) {
  return {Formula::Kind::atom, std::move(polynomial), sign, {}};
}

Formula combine(Formula::Kind kind, std::vector<Formula> parts) {
  if (parts.size() == 1) return Formula(std::move(parts.front()));
  return {kind, {}, prove::Sign::zero, std::move(parts)};
}

Formula non_zero(const std::string& polynomial) {
  return combine(Formula::Kind::disjunction,
                 {atom(polynomial, prove::Sign::positive), atom("- (" + polynomial + ")", prove::Sign::positive)});
}

Formula negation(const Formula& formula) {
  if (formula.kind == Formula::Kind::atom) {
    if (formula.sign == prove::Sign::zero) return non_zero(formula.polynomial);
    const bool strict = formula.sign == prove::Sign::positive;
    return atom("- (" + formula.polynomial + ")", strict ? prove::Sign::non_negative : prove::Sign::positive);
  }
  const bool conjunction = formula.kind == Formula::Kind::conjunction;
  Formula result{conjunction ? Formula::Kind::disjunction : Formula::Kind::conjunction, {}, prove::Sign::zero, {}};
  for (const Formula& part : formula.parts) result.parts.push_back(negation(part));
  return result;
}

std::string text(const Formula& formula, bool inner) {
  if (formula.kind == Formula::Kind::atom) {
    if (formula.sign == prove::Sign::zero) return formula.polynomial + " = 0";
    return (formula.sign == prove::Sign::positive ? "0 < " : "0 <= ") + formula.polynomial;
  }
  const bool conjunction = formula.kind == Formula::Kind::conjunction;
  if (formula.parts.empty()) return conjunction ? "True" : "False";
  std::string result;
  for (const Formula& part : formula.parts) {
    result += (result.empty() ? "" : conjunction ? " /\\ " : " \\/ ") + text(part, true);
  }
  return inner ? "(" + result + ")" : result;
}

std::string right_nested(const std::string& function, const std::vector<std::string>& operands) {
  std::string result = operands.back();
  for (std::size_t i = operands.size() - 1; i-- > 0;)
    result = fmt::format("{} ({}) ({})", function, operands[i], result);
  return result;
}

std::string either(const Formula& formula) {
  if (formula.kind == Formula::Kind::atom) {
    constexpr std::array<const char*, 3> lemmas{"zero_or", "positive_or", "non_negative_or"};
    return fmt::format("Steps.{} ({})", lemmas[static_cast<std::size_t>(formula.sign)], formula.polynomial);
  }
  const bool conjunction = formula.kind == Formula::Kind::conjunction;
  if (formula.parts.empty()) return conjunction ? "Steps.either_true" : "Steps.either_false";
  std::vector<std::string> parts;
  for (const Formula& part : formula.parts) parts.push_back(either(part));
  return right_nested(conjunction ? "Steps.either_and" : "Steps.either_or", parts);
}

}  // namespace slipproof::coq
