#include "proofs/search/existence.hpp"

#include "base/expression/parser.hpp"
#include "base/input/diagnostic.hpp"
#include "proofs/branch/facts.hpp"
#include "proofs/branch/signs.hpp"
#include "proofs/rules/cases.hpp"
#include "proofs/rules/elimination.hpp"
#include "proofs/rules/pairs.hpp"
#include "proofs/rules/single_facts.hpp"
#include "proofs/rules/solution.hpp"
#include "proofs/rules/splits.hpp"
#include "proofs/search/instance.hpp"

namespace slipproof::prove {

namespace {

constexpr int splits_on_pivots = 3, splits_on_bounds = 2;

/// Reduces a negated conclusion, in the parts from its alternatives, to the failure of one of them.
void keep_alternative(Formula& failure, std::size_t alternative) {
  for (Formula& part : failure.parts) {
    if (part.kind != Formula::Kind::conjunction) continue;
    for (std::size_t i = 0; i < part.parts.size(); ++i) {
      if (i != alternative) part.parts[i] = {};  // true: no conjunct says nothing
    }
  }
}

/// Values for the unknowns, and what there is to know of them: by what they divide, and what they would have to meet.
struct Witness {
  std::vector<std::string> values;
  std::vector<Polynomial> divisors;
  Formula shown;
};

/// Nothing where the values, or what is to be shown of them, are longer than the format of certificates allows.
std::optional<Witness> witness_of(const Statement& statement, const std::vector<std::string>& values) {
  try {
    return Witness{values, statement.divisors(values), statement.shown(values)};
  } catch (const ExpressionError&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// States the values as a witness: now they fail to be what the conclusion asks for, or are not defined. With an
/// alternative of the conclusion it is made use of only that they fail for that one.
bool add_witness(Context& context, State& state, const std::string& name, const Witness& witness,
                 std::optional<std::size_t> alternative = std::nullopt) {
  const Statement& statement = context.statement();
  Step step;
  step.rule = Step::Rule::witness;
  step.name = name;
  for (std::size_t i = 0; i < witness.values.size(); ++i) {
    step.values.emplace_back(statement.ring().name(statement.unknowns()[i]), witness.values[i]);
  }
  state.steps.push_back(step);
  std::vector<Formula> failures;
  for (const Polynomial& divisor : witness.divisors) failures.push_back(atom(divisor, Sign::zero));
  Formula failure = negation(witness.shown);
  if (alternative) keep_alternative(failure, *alternative);
  failures.push_back(std::move(failure));
  return add_formula(context, state, step.name, combine(Formula::Kind::disjunction, std::move(failures)));
}

/// The unknown that the equations leave free, if it is only one.
std::optional<std::size_t> only_free_unknown(const Statement& statement, const std::vector<Quotient>& values) {
  std::optional<std::size_t> free;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t unknown = statement.unknowns()[i];
    if (!(values[i].numerator == Polynomial::variable(statement.ring(), unknown))) continue;
    if (free) return std::nullopt;
    free = unknown;
  }
  return free;
}

/// The values with one for the free unknown.
std::vector<std::string> texts(const std::vector<Quotient>& values, std::size_t free, const Quotient& value_of_free) {
  std::vector<std::string> result;
  for (const Quotient& value : values) {
    result.push_back(
        (substituted(value.numerator, free, value_of_free) / substituted(value.denominator, free, value_of_free))
            .text());
  }
  return result;
}

}  // namespace

bool Existence::close_by_witness(State& state, const std::vector<std::string>& values) {
  const auto witness = witness_of(statement(), values);
  if (!witness) return false;
  State attempt = state;
  if (!add_witness(context_, attempt, "goal", *witness) && !close_(attempt)) return false;
  state = std::move(attempt);
  return true;
}

/// Where nothing is given.
bool Existence::close_by_numbers(State& state) {
  const auto instance = find_instance(statement().ring(), statement().shown(),
                                      {.boundaries = statement().hints(), .attempts = context_.limits().instances});
  if (!instance) return false;
  std::vector<std::string> values;
  for (const Rational& value : *instance) values.push_back(value.str());
  return close_by_witness(state, values);
}

bool Existence::close_by_solution(State& state) {
  const auto values = solve_conclusion(context_, state).values;
  return values && close_by_witness(state, *values);
}

/// Finds values for each alternative of the conclusion such that not all of them fail. Splits, at most `splits` times,
/// on pivots of the equations whose sign is unknown.
bool Existence::close_by_alternatives(State& state, int splits) {
  const std::size_t count = alternatives_in(statement().shown())->parts.size();
  std::vector<Solution> solutions;
  for (std::size_t i = 0; i < count; ++i) {
    solutions.push_back(solve_conclusion(context_, state, i));
    if (!solutions.back().open_pivot || splits == 0) continue;
    return close_split(context_, state, *solutions.back().open_pivot, [&](State& branch) {
      return eliminate(context_, branch) || refute_single_fact(context_, branch, Pass::quick) ||
             close_by_alternatives(branch, splits - 1);
    });
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto& values = solutions[i].values;
    if (!values) continue;
    const auto witness = witness_of(statement(), *values);
    if (!witness) continue;
    const std::string name = context_.unused("goal" + std::to_string(i + 1));
    if (add_witness(context_, state, name, *witness, i)) return true;
  }
  return close_(state);
}

/// Where the conclusion's equations leave one unknown free. Splits, at most so often, on which of two bounds is the
/// stronger one.
bool Existence::close_by_bounds(State& state, int splits) {
  const std::vector<Quotient> values = solve_conclusion(context_, state).quotients;
  const auto free = only_free_unknown(statement(), values);
  if (!free) return false;
  const Bounds bounds = bounds_of(context_, state, *free, values);
  if (bounds.empty()) return false;
  for (const Quotient& candidate : bounds.candidates(statement().ring())) {
    if (close_by_witness(state, texts(values, *free, candidate))) return true;
  }
  return splits > 0 && close_by_stronger_bounds(state, bounds, splits - 1);
}

bool Existence::close_by_stronger_bounds(State& state, const Bounds& bounds, int splits) {
  for (const auto* side : {&bounds.lower, &bounds.upper}) {
    for (std::size_t i = 0; i < side->size(); ++i) {
      for (std::size_t k = i + 1; k < side->size(); ++k) {
        const Polynomial difference = sum((*side)[i], (*side)[k], -1).numerator;
        if (as_known_product(context_, state, difference)) continue;
        const auto close = [&](State& branch) { return close_by_bounds(branch, splits); };
        if (close_split(context_, state, difference, close)) return true;
      }
    }
  }
  return false;
}

/// By the simplest way that there may be; else by cases, then by splits on the statement's hints from this one on; or,
/// when these are at an end, by a contradiction, a value between bounds, or splits on pivots.
bool Existence::close_from(State& state, std::size_t hint, int pivots) {
  if (eliminate(context_, state) || refute_single_fact(context_, state, Pass::quick)) return true;
  drop_known_cases(context_, state);
  if (statement().unknowns().size() == statement().ring().size()) return close_by_numbers(state);
  const bool alternatives = alternatives_in(statement().shown()) != nullptr;
  if (alternatives && state.disjunctions.empty()) return close_by_alternatives(state, splits_on_pivots);
  if (!alternatives && close_by_solution(state)) return true;
  if (!state.disjunctions.empty()) {
    return close_cases(context_, state, 0, [&](State& branch) { return close_from(branch, hint, pivots); });
  }
  if (hint < statement().hints().size()) {
    return close_split(context_, state, statement().hints()[hint],
                       [&](State& branch) { return close_from(branch, hint + 1, pivots); });
  }
  return refute_pairs(context_, state, Pass::thorough).refuted || refute_single_fact(context_, state, Pass::thorough) ||
         (alternatives_in(statement().shown()) == nullptr &&
          (close_by_bounds(state, splits_on_bounds) || close_by_pivot(state, hint, pivots)));
}

/// Splits, at most so often, on a pivot of the conclusion's equations whose sign is not known.
bool Existence::close_by_pivot(State& state, std::size_t hint, int pivots) {
  if (pivots == 0) return false;
  const auto pivot = solve_conclusion(context_, state).open_pivot;
  if (!pivot) return false;
  return close_split(context_, state, *pivot, [&](State& branch) { return close_from(branch, hint, pivots - 1); });
}

}  // namespace slipproof::prove
