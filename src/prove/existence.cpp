// Strategies for existence: numbers, or the conclusion's equations solved for the unknowns.
#include "prove/instance.hpp"
#include "prove/state.hpp"

namespace slipproof::prove {

/// The unknowns as quotients, from the equations of the conclusion; 0 where these leave one free.
std::optional<std::vector<std::string>> Search::solve_conclusion(const State& state) {
  const Ring& ring = statement_.ring();
  State solving = state.branch();
  solving.disjunctions.clear();
  const std::function<void(const Formula&)> collect = [&](const Formula& formula) {
    if (formula.kind == Formula::Kind::atom && formula.sign == Sign::zero) {
      add(solving, {fresh(), formula.polynomial.front(), Sign::zero});
    }
    if (formula.kind == Formula::Kind::conjunction) {
      for (const Formula& part : formula.parts) collect(part);
    }
  };
  collect(statement_.shown());
  eliminate(solving, statement_.unknowns().front());
  std::vector<std::string> values;
  for (const std::size_t unknown : statement_.unknowns()) {
    // unknown = numerator / denominator: reduce the unknown itself with a mark for its pivots.
    Polynomial numerator = Polynomial::variable(ring, unknown);
    Polynomial denominator(ring, 1);
    for (const Rule& rule : solving.rules) {
      if (rule.second || !numerator.contains(rule.variable)) continue;
      const std::size_t degree = numerator.degree(rule.variable);
      Polynomial reduced = numerator.coefficient(rule.variable, degree);
      Polynomial pivots(ring, 1);
      for (std::size_t k = degree; k-- > 0;) {
        pivots *= rule.pivot;
        reduced = -(reduced * rule.rest) + numerator.coefficient(rule.variable, k) * pivots;
      }
      numerator = std::move(reduced);
      denominator *= pivots;
      // Cancel what both have in common.
      for (const auto& [factor, exponent] : factored(denominator).factors) {
        for (unsigned i = 0; i < exponent; ++i) {
          const auto shorter = numerator.divided_by(factor);
          if (!shorter) break;
          numerator = *shorter;
          denominator = *denominator.divided_by(factor);
        }
      }
    }
    for (const std::size_t free : statement_.unknowns()) {
      numerator = numerator.coefficient(free, 0);
      if (denominator.contains(free)) return std::nullopt;
    }
    values.push_back(denominator.is_constant() ? numerator.scaled(1 / denominator.constant()).text()
                                               : "(" + numerator.text() + ")/(" + denominator.text() + ")");
  }
  return values;
}

/// States the values as a witness, and closes what is left.
bool Search::close_by_witness(State& state, const std::vector<std::string>& values) {
  Step step;
  step.rule = Step::Rule::witness;
  step.name = "goal";
  for (std::size_t i = 0; i < values.size(); ++i) {
    step.values.emplace_back(statement_.ring().name(statement_.unknowns()[i]), values[i]);
  }
  state.steps.push_back(step);
  std::vector<Formula> failures;
  for (const Polynomial& divisor : statement_.divisors(values)) failures.push_back(atom(divisor, Sign::zero));
  failures.push_back(negation(statement_.shown(values)));
  return add_formula(state, step.name, combine(Formula::Kind::disjunction, std::move(failures))) ||
         close(state, limits_.split_depth);
}

/// Proves existence: by numbers where nothing is given; by the solution of the conclusion's equations; or, where the
/// signs of its pivots are not known, by cases and by splits on the statement's hints.
bool Search::close_existence(State& state, std::size_t hint) {
  if (eliminate(state) || refute_facts(state, false)) return true;
  if (statement_.unknowns().size() == statement_.ring().size()) {
    const auto instance =
        find_instance(statement_.ring(), statement_.shown(), statement_.hints(), limits_.instances, budget_);
    if (!instance) return false;
    std::vector<std::string> values;
    for (const Rational& value : *instance) values.push_back(value.str());
    return close_by_witness(state, values);
  }
  if (const auto values = solve_conclusion(state)) {
    State attempt = state;
    if (close_by_witness(attempt, *values)) {
      state = std::move(attempt);
      return true;
    }
  }
  if (!state.disjunctions.empty()) {
    return close_cases(state, 0, [&](State& branch) { return close_existence(branch, hint); });
  }
  if (hint == statement_.hints().size()) {
    std::vector<Polynomial> candidates;
    return refute_pairs(state, candidates, true) || refute_facts(state, true);
  }
  return close_split(state, statement_.hints()[hint], [&](State& branch) { return close_existence(branch, hint + 1); });
}

}  // namespace slipproof::prove
