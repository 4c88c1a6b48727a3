#include "proofs/rules/cases.hpp"

#include <algorithm>

#include "proofs/branch/facts.hpp"
#include "proofs/branch/reduction.hpp"
#include "proofs/branch/signs.hpp"

namespace slipproof::prove {

namespace {

/// Whether the known signs of factors make p > 0, or p >= 0.
bool has_sign(Context& context, State& state, const Polynomial& p, Sign wanted) {
  const Factorization& factors = context.factored(p);
  int orientation = factors.constant > 0 ? 1 : -1;
  for (const auto& [factor, exponent] : factors.factors) {
    const KnownSign* sign = sign_of(context, state, factor);
    if (sign == nullptr || (wanted == Sign::positive && !sign->strict)) return false;
    if (exponent % 2 == 1) orientation *= sign->orientation;
  }
  return orientation > 0;
}

bool is_non_zero(Context& context, State& state, const Polynomial& p) {
  const auto& factors = context.factored(p).factors;
  return std::all_of(factors.begin(), factors.end(), [&](const auto& factor) {
    const KnownSign* sign = sign_of(context, state, factor.first);
    return sign != nullptr && sign->strict;
  });
}

/// Whether the known signs of factors make the formula true; it is not searched for one that is false for a sample
/// outside of `excluded`.
bool implied(Context& context, State& state, const Formula& formula, const SampleSet& excluded) {
  const auto follows = [&](const Formula& part) { return implied(context, state, part, excluded); };
  if (formula.kind == Formula::Kind::conjunction) {
    return std::all_of(formula.parts.begin(), formula.parts.end(), follows);
  }
  if (formula.kind == Formula::Kind::disjunction) {
    if (const Polynomial* p = non_zero_polynomial(formula)) return is_non_zero(context, state, *p);
    return std::any_of(formula.parts.begin(), formula.parts.end(), follows);
  }
  const Polynomial& p = formula.polynomial.front();
  if (p.is_constant()) return evident(formula) == true;
  if (formula.sign == Sign::zero || !excluded.contains(context.signs_at_samples(p).negative)) return false;
  return has_sign(context, state, p, formula.sign);
}

/// Whether elimination alone makes a sign condition evidently false.
bool refuted_by_rules(Context& context, const State& state, const Formula& formula) {
  if (formula.kind != Formula::Kind::atom) return evident(formula) == false;
  Fact fact{"", formula.polynomial.front(), formula.sign};
  State scratch;
  for (const Rule& rule : state.rules) {
    context.budget().spend(fact.p.length());
    reduce(context, scratch, rule, fact);
  }
  return evident(atom(fact.p, fact.sign)) == false;
}

}  // namespace

void drop_known_cases(Context& context, State& state) {
  SampleSet excluded;
  for (const Fact& fact : state.facts) {
    if (fact.sign != Sign::zero) excluded |= fact.fails;
  }
  std::erase_if(state.disjunctions, [&](const auto& named) { return implied(context, state, named.second, excluded); });
}

NextCases next_cases(Context& context, const State& state) {
  const auto& disjunctions = state.disjunctions;
  const auto index = [&](auto found) { return static_cast<std::size_t>(found - disjunctions.begin()); };
  const auto evidently_false = std::find_if(disjunctions.begin(), disjunctions.end(),
                                            [](const auto& named) { return evident(named.second) == false; });
  if (evidently_false != disjunctions.end()) return {index(evidently_false), true};
  const auto refuted = std::find_if(disjunctions.begin(), disjunctions.end(), [&](const auto& named) {
    return std::all_of(named.second.parts.begin(), named.second.parts.end(),
                       [&](const Formula& part) { return refuted_by_rules(context, state, part); });
  });
  if (refuted != disjunctions.end()) return {index(refuted), true};
  const auto shortest = std::min_element(disjunctions.begin(), disjunctions.end(), [](const auto& x, const auto& y) {
    return x.second.parts.size() < y.second.parts.size();
  });
  return {index(shortest), false};
}

bool close_cases(Context& context, State& state, std::size_t index, const Close& close) {
  const auto [name, formula] = state.disjunctions[index];
  Step step;
  step.rule = Step::Rule::cases;
  step.name = name;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    State branch = state.branch();
    branch.disjunctions.erase(branch.disjunctions.begin() + static_cast<std::ptrdiff_t>(index));
    const std::string part = name + "." + std::to_string(i + 1);
    if (!add_formula(context, branch, part, formula.parts[i]) && !close(branch)) return false;
    step.branches.push_back(std::move(branch.steps));
  }
  state.steps.push_back(std::move(step));
  return true;
}

}  // namespace slipproof::prove
