#include "proofs/rules/solution.hpp"

#include "proofs/branch/facts.hpp"
#include "proofs/branch/signs.hpp"
#include "proofs/rules/elimination.hpp"

namespace slipproof::prove {

namespace {

void add_equations(Context& context, State& state, const Formula& formula) {
  if (formula.kind == Formula::Kind::atom && formula.sign == Sign::zero) {
    add(context, state, {context.fresh(), formula.polynomial.front(), Sign::zero});
  }
  if (formula.kind == Formula::Kind::conjunction) {
    for (const Formula& part : formula.parts) add_equations(context, state, part);
  }
}

/// The facts of the state and the equations, without the unknowns that they determine.
State solved(Context& context, const State& state, std::size_t alternative) {
  State result = state.branch();
  result.disjunctions.clear();
  const Formula shown = context.statement().shown();
  add_equations(context, result, shown);
  if (const Formula* alternatives = alternatives_in(shown)) {
    add_equations(context, result, alternatives->parts.at(alternative));
  }
  eliminate(context, result, context.statement().unknowns().front());
  return result;
}

/// Of a pivot in what is left of the equations.
std::optional<Polynomial> open_pivot(Context& context, State& solving) {
  const std::vector<std::size_t>& unknowns = context.statement().unknowns();
  std::optional<Polynomial> result;
  for (const Fact& fact : solving.facts) {
    for (const std::size_t unknown : unknowns) {
      if (fact.sign != Sign::zero || fact.p.degree(unknown) != 1) continue;
      const Polynomial pivot = fact.p.coefficient(unknown, 1);
      if (pivot.is_constant() || pivot.variables().back() >= unknowns.front()) continue;
      for (const auto& [factor, exponent] : context.factored(pivot).factors) {
        const KnownSign* sign = sign_of(context, solving, factor);
        if (sign == nullptr || !sign->strict) result = factor;
      }
    }
  }
  return result;
}

/// The unknown itself, reduced by the rules: numerator / denominator, the pivots in the denominator.
Quotient value_of(Context& context, const State& solving, std::size_t unknown) {
  Quotient value{Polynomial::variable(context.ring(), unknown), Polynomial(context.ring(), 1)};
  for (const Rule& rule : solving.rules) {
    if (rule.second || !value.numerator.contains(rule.variable)) continue;
    value.denominator *= power(rule.pivot, value.numerator.degree(rule.variable));
    value.numerator = substitute(value.numerator, rule.variable, -rule.rest, rule.pivot);
    cancel(context, value);
  }
  return value;
}

/// With 0 for the unknowns that are free; nothing where a denominator depends on one.
std::optional<std::vector<std::string>> values_of(const std::vector<Quotient>& quotients,
                                                  const std::vector<std::size_t>& unknowns) {
  std::vector<std::string> values;
  for (Quotient value : quotients) {
    for (const std::size_t free : unknowns) {
      value.numerator = value.numerator.coefficient(free, 0);
      if (value.denominator.contains(free)) return std::nullopt;
    }
    values.push_back(value.text());
  }
  return values;
}

}  // namespace

const Formula* alternatives_in(const Formula& shown) {
  for (const Formula& part : shown.parts) {
    if (part.kind == Formula::Kind::disjunction && non_zero_polynomial(part) == nullptr) return &part;
  }
  return nullptr;
}

Solution solve_conclusion(Context& context, const State& state, std::size_t alternative) {
  State solving = solved(context, state, alternative);
  Solution solution;
  solution.open_pivot = open_pivot(context, solving);
  const std::vector<std::size_t>& unknowns = context.statement().unknowns();
  for (const std::size_t unknown : unknowns) solution.quotients.push_back(value_of(context, solving, unknown));
  solution.values = values_of(solution.quotients, unknowns);
  return solution;
}

}  // namespace slipproof::prove
