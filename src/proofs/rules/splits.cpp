#include "proofs/rules/splits.hpp"

#include <algorithm>
#include <set>

#include "proofs/branch/facts.hpp"
#include "proofs/branch/reduction.hpp"
#include "proofs/branch/signs.hpp"

namespace slipproof::prove {

namespace {

/// Polynomials with the weights of all that proposed them.
class Ballot {
 public:
  static constexpr std::size_t of_pivot = 5000, of_hint = 1000, of_factor = 1;

  explicit Ballot(const State& state) : state_(state) {}

  void propose(const Polynomial& p, std::size_t weight) {
    if (p.is_constant()) return;
    for (auto& [count, other] : counted_) {
      if (other == p) {
        count += weight;
        return;
      }
    }
    if (state_.signs.contains(p.text()) && state_.signs.at(p.text()).strict) return;
    counted_.emplace_back(weight, p);
  }

  void propose(const Factorization& factors, std::size_t weight) {
    for (const auto& [factor, exponent] : factors.factors) propose(factor, weight);
  }

  /// The heaviest first, then the shortest.
  std::vector<Polynomial> result() && {
    std::stable_sort(counted_.begin(), counted_.end(), [](const auto& x, const auto& y) {
      return x.first != y.first ? x.first > y.first : x.second.length() < y.second.length();
    });
    std::vector<Polynomial> result;
    for (auto& [count, p] : counted_) result.push_back(std::move(p));
    return result;
  }

 private:
  const State& state_;
  std::vector<std::pair<std::size_t, Polynomial>> counted_;
};

/// As the equations of the state have it.
Polynomial reduced(Context& context, const State& state, const Polynomial& p) {
  Fact fact{"", p, Sign::zero};
  State scratch = state.branch();
  for (const Rule& rule : state.rules) reduce(context, scratch, rule, fact);
  return fact.p;
}

/// The variables of inequalities that are not linear in them.
std::set<std::size_t> variables_of_degree_above_one(const State& state) {
  std::set<std::size_t> result;
  for (const Fact& fact : state.facts) {
    if (fact.sign == Sign::zero) continue;
    for (const std::size_t variable : fact.p.variables()) {
      if (fact.p.degree(variable) > 1) result.insert(variable);
    }
  }
  return result;
}

}  // namespace

bool close_split(Context& context, State& state, const Polynomial& p, const Close& close) {
  return close_split(context, state, p, [&](State& branch, const Fact&) { return close(branch); });
}

bool close_split(Context& context, State& state, const Polynomial& p, const CloseSigned& close) {
  Step step;
  step.rule = Step::Rule::split;
  step.name = context.fresh();
  step.polynomial = {p};
  for (const int sign : {-1, 0, 1}) {
    State branch = state.branch();
    const Fact fact{step.name, sign < 0 ? -p : p, sign == 0 ? Sign::zero : Sign::positive};
    if (!add(context, branch, fact) && !close(branch, fact)) return false;
    step.branches.push_back(std::move(branch.steps));
  }
  state.steps.push_back(std::move(step));
  return true;
}

std::vector<Polynomial> split_candidates(Context& context, const State& state, const std::vector<Polynomial>& open) {
  Ballot ballot(state);
  for (const Polynomial& hint : context.statement().hints()) {
    ballot.propose(context.factored(reduced(context, state, hint)), Ballot::of_hint);
  }
  for (const Fact& fact : state.facts) {
    const Factorization& factors = context.factored(fact.p);
    if (factors.factors.size() > 1) ballot.propose(factors, Ballot::of_factor);
    if (fact.sign != Sign::zero) continue;
    const std::size_t last = fact.p.variables().back();
    if (fact.p.degree(last) != 1) continue;
    ballot.propose(context.factored(fact.p.coefficient(last, 1)), Ballot::of_pivot);
  }
  for (const Polynomial& p : open) ballot.propose(p, Ballot::of_factor);
  return std::move(ballot).result();
}

std::vector<Polynomial> plain_candidates(Context& context, State& state) {
  const Ring& ring = context.ring();
  std::vector<Polynomial> result;
  const auto propose = [&](const Polynomial& p) {
    const KnownSign* sign = sign_of(context, state, p);
    if (sign == nullptr || !sign->strict) result.push_back(p);
  };
  const std::set<std::size_t> variables = variables_of_degree_above_one(state);
  for (const std::size_t v : variables) propose(Polynomial::variable(ring, v));
  for (const std::size_t v : variables) {
    for (const std::size_t w : variables) {
      if (v < w) propose(Polynomial::variable(ring, v) - Polynomial::variable(ring, w));
    }
  }
  return result;
}

}  // namespace slipproof::prove
