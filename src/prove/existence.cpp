// Strategies for existence: numbers, or the conclusion's equations solved for the unknowns.
#include "prove/instance.hpp"
#include "prove/state.hpp"

namespace slipproof::prove {

namespace {

constexpr auto all_alternatives = static_cast<std::size_t>(-1);

/// The disjunction that the conclusion has as a part, such as one of contact modes; nullptr if it has none.
const Formula* alternatives_in(const Formula& shown) {
  for (const Formula& part : shown.parts) {
    if (part.kind == Formula::Kind::disjunction && non_zero_polynomial(part) == nullptr) return &part;
  }
  return nullptr;
}

}  // namespace

std::string Quotient::text() const {
  return denominator.is_constant() ? numerator.scaled(1 / denominator.constant()).text()
                                   : "(" + numerator.text() + ")/(" + denominator.text() + ")";
}

/// Divides by the factors of the denominator that the numerator has, too.
void Search::cancel(Quotient& value) {
  const Factorization factors = factored(value.denominator);
  for (const auto& [factor, exponent] : factors.factors) {
    for (unsigned i = 0; i < exponent; ++i) {
      const auto shorter = value.numerator.divided_by(factor);
      if (!shorter) break;
      value = {*shorter, *value.denominator.divided_by(factor)};
    }
  }
}

/// The unknowns as quotients, from the equations of the conclusion (where it has alternatives, with those of one); 0
/// where these leave one free.
Search::Solution Search::solve_conclusion(const State& state, std::size_t alternative) {
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
  const Formula shown = statement_.shown();
  collect(shown);
  if (const Formula* alternatives = alternatives_in(shown)) collect(alternatives->parts.at(alternative));
  eliminate(solving, statement_.unknowns().front());
  Solution solution;
  for (const Fact& fact : std::vector<Fact>(solving.facts)) {
    for (const std::size_t unknown : statement_.unknowns()) {
      if (fact.sign != Sign::zero || fact.p.degree(unknown) != 1) continue;
      const Polynomial pivot = fact.p.coefficient(unknown, 1);
      if (pivot.is_constant() || pivot.variables().back() >= statement_.unknowns().front()) continue;
      for (const auto& [factor, exponent] : factored(pivot).factors) {
        const KnownSign* sign = sign_of(solving, factor);
        if (sign == nullptr || !sign->strict) solution.open_pivot = factor;
      }
    }
  }
  for (const std::size_t unknown : statement_.unknowns()) {
    // unknown = numerator / denominator: reduce the unknown itself with a mark for its pivots.
    Quotient value{Polynomial::variable(ring, unknown), Polynomial(ring, 1)};
    for (const Rule& rule : solving.rules) {
      if (rule.second || !value.numerator.contains(rule.variable)) continue;
      value.denominator *= power(rule.pivot, value.numerator.degree(rule.variable));
      value.numerator = substitute(value.numerator, rule.variable, -rule.rest, rule.pivot);
      cancel(value);
    }
    solution.quotients.push_back(std::move(value));
  }
  std::vector<std::string> values;
  for (Quotient value : solution.quotients) {
    for (const std::size_t free : statement_.unknowns()) {
      value.numerator = value.numerator.coefficient(free, 0);
      if (value.denominator.contains(free)) return solution;
    }
    values.push_back(value.text());
  }
  solution.values = std::move(values);
  return solution;
}

/// States the values as a witness. Of a conclusion with alternatives it is made use of only that these values fail for
/// one of them, unless it is to be all.
bool Search::add_witness(State& state, const std::string& name, const std::vector<std::string>& values,
                         std::size_t alternative) {
  Step step;
  step.rule = Step::Rule::witness;
  step.name = name;
  for (std::size_t i = 0; i < values.size(); ++i) {
    step.values.emplace_back(statement_.ring().name(statement_.unknowns()[i]), values[i]);
  }
  state.steps.push_back(step);
  std::vector<Formula> failures;
  for (const Polynomial& divisor : statement_.divisors(values)) failures.push_back(atom(divisor, Sign::zero));
  Formula failure = negation(statement_.shown(values));
  for (Formula& part : failure.parts) {
    if (part.kind != Formula::Kind::conjunction || alternative == all_alternatives) continue;
    for (std::size_t i = 0; i < part.parts.size(); ++i) {
      if (i != alternative) part.parts[i] = {};  // true: no conjunct says nothing
    }
  }
  failures.push_back(std::move(failure));
  return add_formula(state, step.name, combine(Formula::Kind::disjunction, std::move(failures)));
}

bool Search::close_by_witness(State& state, const std::vector<std::string>& values) {
  return add_witness(state, "goal", values, all_alternatives) || close(state, limits_.split_depth);
}

/// Values for each alternative of the conclusion: not all of them fail. Splits, at most so often, on pivots of the
/// equations whose sign is not known.
bool Search::close_by_alternatives(State& state, int splits) {
  const std::size_t count = alternatives_in(statement_.shown())->parts.size();
  std::vector<Solution> solutions;
  for (std::size_t i = 0; i < count; ++i) {
    solutions.push_back(solve_conclusion(state, i));
    if (!solutions.back().open_pivot || splits == 0) continue;
    return close_split(state, *solutions.back().open_pivot, [&](State& branch) {
      return eliminate(branch) || refute_facts(branch, false) || close_by_alternatives(branch, splits - 1);
    });
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto& values = solutions[i].values;
    if (values && add_witness(state, unused("goal" + std::to_string(i + 1)), *values, i)) return true;
  }
  return close(state, limits_.split_depth);
}

/// Proves existence: by numbers where nothing is given; by the solution of the conclusion's equations; or, where the
/// signs of its pivots are not known, by cases and by splits on the statement's hints; or by a value between bounds.
bool Search::close_existence(State& state, std::size_t hint) {
  if (eliminate(state) || refute_facts(state, false)) return true;
  drop_known_cases(state);
  if (statement_.unknowns().size() == statement_.ring().size()) {
    const auto instance = find_instance(statement_.ring(), statement_.shown(), {statement_.hints(), limits_.instances});
    if (!instance) return false;
    std::vector<std::string> values;
    for (const Rational& value : *instance) values.push_back(value.str());
    return close_by_witness(state, values);
  }
  if (alternatives_in(statement_.shown()) != nullptr) {
    if (state.disjunctions.empty()) return close_by_alternatives(state, 3);
  } else if (const auto values = solve_conclusion(state).values) {
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
    return refute_pairs(state, candidates, true) || refute_facts(state, true) ||
           (alternatives_in(statement_.shown()) == nullptr && close_by_bounds(state, 2));
  }
  return close_split(state, statement_.hints()[hint], [&](State& branch) { return close_existence(branch, hint + 1); });
}

}  // namespace slipproof::prove
