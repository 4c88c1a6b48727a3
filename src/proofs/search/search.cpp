#include "proofs/search/search.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "proofs/branch/facts.hpp"
#include "proofs/rules/cases.hpp"
#include "proofs/rules/elimination.hpp"
#include "proofs/rules/pairs.hpp"
#include "proofs/rules/products.hpp"
#include "proofs/rules/single_facts.hpp"
#include "proofs/rules/splits.hpp"
#include "proofs/rules/squares.hpp"
#include "proofs/search/existence.hpp"
#include "proofs/sums/refute.hpp"
#include "proofs/sums/semidefinite.hpp"

namespace slipproof::prove {

namespace {

/// Disjunctions of more parts are mostly negated conclusions.
constexpr std::size_t few_cases = 4;

/// Products of so many hypotheses are looked at in the end.
constexpr unsigned highest_product_degree = 3;

/// Whether a sample clearly meets all facts, and nothing else is left: then they do not contradict each other.
bool hopeless(Context& context, const State& state) {
  SampleSet inside = SampleSet::all();
  for (const Fact& fact : state.facts) {
    if (fact.sign == Sign::zero) return false;
    inside &= context.signs_at_samples(fact.p).positive;
  }
  return state.disjunctions.empty() && !inside.empty();
}

bool has_circle(const Formula& formula) {
  if (formula.kind == Formula::Kind::atom) return formula.sign == Sign::zero && is_circle(formula.polynomial.front());
  return formula.kind == Formula::Kind::conjunction &&
         std::any_of(formula.parts.begin(), formula.parts.end(), has_circle);
}

std::string shown(const Fact& fact) {
  constexpr std::size_t longest = 300;
  std::string p = fact.p.text();
  if (p.size() > longest) p.replace(longest, p.npos, "...");
  return fact.name + ": " + p + (fact.sign == Sign::zero ? " = 0" : fact.sign == Sign::positive ? " > 0" : " >= 0");
}

}  // namespace

Search::Search(const Statement& statement, const Limits& limits) : context_(statement, limits) {}

void Search::keep_leftover(const State& state) {
  leftover_.facts.clear();
  for (const Fact& fact : state.facts) leftover_.facts.push_back(shown(fact));
}

/// Closes the state, with so many splits one within the other: on success its steps end in a contradiction, or in a
/// case distinction all of whose branches do.
bool Search::close(State& state, int depth) {
  if (eliminate(context_, state)) return true;
  drop_known_cases(context_, state);
  if (refute_single_fact(context_, state, Pass::quick)) return true;
  if (!state.disjunctions.empty()) return close_disjunctions(state, depth);
  if (hopeless(context_, state)) {
    keep_leftover(state);
    return false;
  }
  if (refute_pairs(context_, state, Pass::quick).refuted) return true;
  if (refute_single_fact(context_, state, Pass::thorough)) return true;
  const PairsResult pairs = refute_pairs(context_, state, Pass::thorough);
  if (pairs.refuted || refute_products(context_, state)) return true;
  if (context_.reach.sums_of_squares &&
      refute_by_sums_of_squares(context_, state, [&](State& branch) { return close(branch, depth); })) {
    return true;
  }
  if (leftover_.facts.empty() || depth == context_.reach.split_depth) keep_leftover(state);
  return depth > 0 && close_by_splits(state, depth, pairs.open);
}

/// Opens one disjunction, and so on in its branches.
bool Search::close_disjunctions(State& state, int depth) {
  const NextCases next = next_cases(context_, state);
  if (!next.impossible && state.disjunctions[next.index].second.parts.size() > few_cases) {  // try without
    State bare = state;
    bare.disjunctions.clear();
    if (close(bare, std::min(depth, 1))) {
      state = std::move(bare);
      return true;
    }
  }
  return close_cases(context_, state, next.index,
                     [&](State& branch) { return close(branch, next.impossible ? 0 : depth); });
}

bool Search::close_by_splits(State& state, int depth, const std::vector<Polynomial>& open_factors) {
  const Close shallower = [&](State& branch) { return close(branch, depth - 1); };
  const auto close_by_any = [&](const std::vector<Polynomial>& proposed) {
    const auto tried = std::min(proposed.size(), static_cast<std::size_t>(context_.limits().split_candidates));
    return std::any_of(proposed.begin(), proposed.begin() + static_cast<std::ptrdiff_t>(tried),
                       [&](const Polynomial& p) { return close_split(context_, state, p, shallower); });
  };
  if (close_by_any(split_candidates(context_, state, open_factors))) return true;
  if (context_.reach.product_degree == 1) return false;
  return close_squares(context_, state, shallower) || close_by_any(plain_candidates(context_, state));
}

/// Splits so often, then as often as the limits allow.
bool Search::search_deeper(const State& start, State& closed, int first_depth) {
  const Statement& statement = context_.statement();
  int& depth = context_.reach.split_depth;
  const auto close_fully = [&](State& state) { return close(state, depth); };
  for (depth = std::min(context_.limits().split_depth, first_depth);; ++depth) {
    closed = start;
    const bool found = statement.unknowns().empty()
                           ? add_formula(context_, closed, "goal", negation(statement.shown())) || close_fully(closed)
                           : Existence(context_, close_fully).close(closed);
    if (found || depth >= context_.limits().split_depth) return found;
  }
}

std::optional<Proof> Search::search() {
  State start;
  const auto& assumptions = context_.statement().assumptions();
  bool closed = std::any_of(assumptions.begin(), assumptions.end(),
                            [&](const auto& named) { return add_formula(context_, start, named.first, named.second); });
  closed = closed || eliminate(context_, start);
  unsigned& degree = context_.reach.product_degree;
  for (degree = 1; !closed; ++degree) {
    if (degree > (context_.limits().products > 0 ? highest_product_degree : 1)) return std::nullopt;
    State state;
    closed = search_deeper(start, state, 1);
    if (closed) start = std::move(state);
  }
  prune(start.steps);
  return std::move(start.steps);
}

/// Without products of hypotheses, and with sums of squares at the leaves.
std::optional<Proof> Search::search_with_sums() {
  context_.reach = {.sums_of_squares = true};
  State start, closed;
  for (const auto& [name, formula] : context_.statement().assumptions()) {
    if (add_formula(context_, start, name, formula)) return std::nullopt;  // and it would have been found before
  }
  eliminate(context_, start);
  if (!search_deeper(start, closed, 0)) return std::nullopt;
  prune(closed.steps);
  return std::move(closed.steps);
}

/// Few steps without the equations of circles: what they shorten may lose a sum that is plainly positive. Then a tenth
/// of the steps with them.
std::optional<Proof> Search::search_with_circles() {
  Budget& budget = context_.budget();
  for (const bool circles : {false, true}) {
    budget.renew(context_.limits().steps / (circles ? 10 : 100));
    std::optional<Proof> proof;
    try {
      Search anew(context_.statement(), context_.limits());
      anew.context_.reach.circles = circles;
      proof = anew.search();
    } catch (const Budget::Spent&) {
      // As if it had not been tried.
    }
    steps_ += budget.spent();
    if (proof) return proof;
  }
  return std::nullopt;
}

std::optional<Proof> Search::prove() {
  const Limits& limits = context_.limits();
  Budget& budget = context_.budget();
  budget.watch(limits.tick);
  std::optional<Proof> proof;
  const auto& assumptions = context_.statement().assumptions();
  if (std::any_of(assumptions.begin(), assumptions.end(), [](const auto& named) { return has_circle(named.second); }))
    proof = search_with_circles();
  if (!proof) {
    budget.renew(limits.steps - std::min(limits.steps, steps_));
    try {
      proof = search();
    } catch (const Budget::Spent&) {
      leftover_.exhausted = true;
      leftover_.facts.insert(leftover_.facts.begin(), fmt::format("no step left of {}", limits.steps));
    }
    steps_ += budget.spent();
  }
  if (!proof && limits.sums_of_squares && limits.products > 0 && sums::has_semidefinite_solver()) {
    budget.renew(limits.steps / 2);
    try {
      Search anew(context_.statement(), limits);  // what the end of the steps interrupted is not remembered
      proof = anew.search_with_sums();
    } catch (const Budget::Spent&) {
      // As without it.
    }
    if (proof) steps_ += budget.spent();
  }
  budget.lift();
  return proof;
}

}  // namespace slipproof::prove
