#include "prove/search.hpp"

#include <fmt/format.h>

#include "prove/state.hpp"

namespace slipproof::prove {

namespace {

/// Which variables the hypotheses say to be positive.
std::vector<bool> positive_variables(const Statement& statement) {
  std::vector<bool> result(statement.ring().size());
  const std::function<void(const Formula&)> visit = [&](const Formula& formula) {
    if (formula.kind == Formula::Kind::conjunction) {
      for (const Formula& part : formula.parts) visit(part);
    } else if (formula.kind == Formula::Kind::atom && formula.sign == Sign::positive) {
      const std::vector<std::size_t> variables = formula.polynomial.front().variables();
      if (variables.size() != 1) return;
      if (formula.polynomial.front() == Polynomial::variable(statement.ring(), variables[0])) {
        result[variables[0]] = true;
      }
    }
  };
  for (const auto& [name, formula] : statement.assumptions()) visit(formula);
  return result;
}

}  // namespace

Search::Search(const Statement& statement, const Limits& limits)
    : statement_(statement),
      limits_(limits),
      samples_(statement.ring(), positive_variables(statement)),
      budget_(statement.ring().budget()) {}

std::string Search::unused(const std::string& name) {
  const auto& assumptions = statement_.assumptions();
  const bool taken =
      std::any_of(assumptions.begin(), assumptions.end(), [&](const auto& named) { return named.first == name; });
  return taken ? fresh() : name;
}

std::string Search::fresh() {
  return unused("e" + std::to_string(++counter_));
}

void Search::keep_leftover(const State& state) {
  leftover_.facts.clear();
  for (const Fact& fact : state.facts) {
    constexpr std::size_t shown = 300;
    std::string p = fact.p.text();
    if (p.size() > shown) p.replace(shown, p.npos, "...");
    leftover_.facts.push_back(fact.name + ": " + p +
                              (fact.sign == Sign::zero       ? " = 0"
                               : fact.sign == Sign::positive ? " > 0"
                                                             : " >= 0"));
  }
}

/// Whether a sample clearly meets all facts, and nothing else is left: then they do not contradict each other.
bool Search::hopeless(const State& state) {
  SampleSet inside = SampleSet::all();
  for (const Fact& fact : state.facts) {
    if (fact.sign == Sign::zero) return false;
    inside &= signs_at_samples(fact.p).positive;
  }
  return state.disjunctions.empty() && !inside.empty();
}

/// Whether elimination alone makes a sign condition evidently false.
bool Search::refuted_by_rules(State& state, const Formula& formula) {
  if (formula.kind != Formula::Kind::atom) return evident(formula) == false;
  Fact fact{"", formula.polynomial.front(), formula.sign};
  State scratch;
  for (const Rule& rule : state.rules) {
    budget_.spend(fact.p.length());
    reduce(scratch, rule, fact);
  }
  return evident(atom(fact.p, fact.sign)) == false;
}

/// Closes the state: on success its steps end in a contradiction or a split all of whose branches do.
bool Search::close(State& state, int depth) {
  if (eliminate(state)) return true;
  drop_known_cases(state);
  if (refute_facts(state, false)) return true;
  if (!state.disjunctions.empty()) {
    for (std::size_t i = 0; i < state.disjunctions.size(); ++i) {
      if (evident(state.disjunctions[i].second) != false) continue;
      return close_cases(state, i, [&](State& branch) { return close(branch, 0); });
    }
    for (std::size_t i = 0; i < state.disjunctions.size(); ++i) {
      const auto& parts = state.disjunctions[i].second.parts;
      if (!std::all_of(parts.begin(), parts.end(),
                       [&](const Formula& part) { return refuted_by_rules(state, part); })) {
        continue;
      }
      return close_cases(state, i, [&](State& branch) { return close(branch, 0); });
    }
    // Alternatives that can be opened one at a time: the shortest first.
    std::size_t which = 0;
    for (std::size_t i = 1; i < state.disjunctions.size(); ++i) {
      if (state.disjunctions[i].second.parts.size() < state.disjunctions[which].second.parts.size()) which = i;
    }
    if (state.disjunctions[which].second.parts.size() > 4) {  // long ones are mostly negated conclusions: try without
      State bare = state;
      bare.disjunctions.clear();
      if (close(bare, std::min(depth, 1))) {
        state = std::move(bare);
        return true;
      }
    }
    return close_cases(state, which, [&](State& branch) { return close(branch, depth); });
  }
  if (hopeless(state)) {
    keep_leftover(state);
    return false;
  }
  std::vector<Polynomial> candidates;
  if (refute_pairs(state, candidates, false)) return true;
  if (refute_facts(state, true)) return true;
  candidates.clear();
  if (refute_pairs(state, candidates, true)) return true;
  if (refute_products(state)) return true;
  if (leftover_.facts.empty() || depth == limits_.split_depth) keep_leftover(state);
  if (depth == 0) return false;
  const Close shallower = [&](State& branch) { return close(branch, depth - 1); };
  const auto close_by_any = [&](const std::vector<Polynomial>& proposed) {
    for (std::size_t i = 0; i < proposed.size() && i < static_cast<std::size_t>(limits_.split_candidates); ++i) {
      if (close_split(state, proposed[i], shallower)) return true;
    }
    return false;
  };
  if (close_by_any(split_candidates(state, candidates))) return true;
  return product_degree_ > 1 && (close_squares(state, shallower) || close_by_any(plain_candidates(state)));
}

std::optional<Proof> Search::prove() {
  budget_.renew(limits_.steps);
  budget_.watch(limits_.tick);
  try {
    auto proof = search();
    budget_.lift();
    return proof;
  } catch (const Budget::Spent&) {
    budget_.lift();
    leftover_.exhausted = true;
    leftover_.facts.insert(leftover_.facts.begin(), fmt::format("no step left of {}", limits_.steps));
    return std::nullopt;
  }
}

/// Splits once, then as often as the limits allow.
bool Search::search_deeper(const State& start, State& closed) {
  const int deepest = limits_.split_depth;
  bool found = false;
  for (limits_.split_depth = std::min(deepest, 1);; ++limits_.split_depth) {
    closed = start;
    if (statement_.unknowns().empty()) {
      found = add_formula(closed, "goal", negation(statement_.shown())) || close(closed, limits_.split_depth);
    } else {
      found = close_existence(closed, 0);
    }
    if (found || limits_.split_depth >= deepest) break;
  }
  limits_.split_depth = deepest;
  return found;
}

std::optional<Proof> Search::search() {
  State start;
  bool closed = false;
  for (const auto& [name, formula] : statement_.assumptions()) closed = closed || add_formula(start, name, formula);
  closed = closed || eliminate(start);
  for (product_degree_ = 1; !closed; ++product_degree_) {
    if (product_degree_ > (limits_.products > 0 ? 3U : 1U)) return std::nullopt;
    State state;
    closed = search_deeper(start, state);
    if (closed) start = std::move(state);
  }
  prune(start.steps);
  return std::move(start.steps);
}

}  // namespace slipproof::prove
