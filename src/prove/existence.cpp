// Strategy for existence: the conclusion's equations solved for the unknowns.
#include "prove/state.hpp"

namespace slipproof::prove {

/// Solves the conclusion's equations for the unknowns, states the solution as a witness, and closes what is left.
bool Search::close_by_witness(State& state) {
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
  Step step;
  step.rule = Step::Rule::witness;
  step.name = "goal";
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
    for (const std::size_t other : statement_.unknowns()) {
      if (numerator.contains(other)) return false;
    }
    values.push_back(denominator.is_constant() ? numerator.scaled(1 / denominator.constant()).text()
                                               : "(" + numerator.text() + ")/(" + denominator.text() + ")");
    step.values.emplace_back(ring.name(unknown), values.back());
  }
  state.steps.push_back(step);
  std::vector<Formula> failures;
  for (const Polynomial& divisor : statement_.divisors(values)) failures.push_back(atom(divisor, Sign::zero));
  failures.push_back(negation(statement_.shown(values)));
  return add_formula(state, step.name, combine(Formula::Kind::disjunction, std::move(failures))) ||
         close(state, limits_.split_depth);
}

/// Proves existence: by a witness, or, where the signs of its pivots are not known, by splits on the statement's hints.
bool Search::close_existence(State& state, std::size_t hint) {
  if (eliminate(state) || refute_facts(state, false)) return true;
  State attempt = state;
  if (close_by_witness(attempt)) {
    state = std::move(attempt);
    return true;
  }
  if (hint == statement_.hints().size()) {
    std::vector<Polynomial> candidates;
    return refute_pairs(state, candidates, true) || refute_facts(state, true);
  }
  Step step;
  step.rule = Step::Rule::split;
  step.name = fresh();
  step.polynomial = {statement_.hints()[hint]};
  for (const int sign : {-1, 0, 1}) {
    State branch = state.branch();
    const Polynomial p = step.polynomial.front().scaled(sign < 0 ? -1 : 1);
    if (!add(branch, {step.name, p, sign == 0 ? Sign::zero : Sign::positive}) && !close_existence(branch, hint + 1)) {
      return false;
    }
    step.branches.push_back(std::move(branch.steps));
  }
  state.steps.push_back(std::move(step));
  return true;
}

}  // namespace slipproof::prove
