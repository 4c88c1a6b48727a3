// Strategy: case splits, on disjunctions and on the signs of polynomials.
#include "prove/state.hpp"

namespace slipproof::prove {

bool Search::close_cases(State& state, std::size_t which, const Close& close) {
  const auto [name, formula] = state.disjunctions[which];
  Step step;
  step.rule = Step::Rule::cases;
  step.name = name;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    State branch = state.branch();
    branch.disjunctions.erase(branch.disjunctions.begin() + static_cast<std::ptrdiff_t>(which));
    if (!add_formula(branch, name + "." + std::to_string(i + 1), formula.parts[i]) && !close(branch)) return false;
    step.branches.push_back(std::move(branch.steps));
  }
  state.steps.push_back(std::move(step));
  return true;
}

bool Search::close_split(State& state, const Polynomial& p, const Close& close) {
  return close_split(state, p, [&](State& branch, const Fact&) { return close(branch); });
}

bool Search::close_split(State& state, const Polynomial& p, const CloseSigned& close) {
  Step step;
  step.rule = Step::Rule::split;
  step.name = fresh();
  step.polynomial = {p};
  for (const int sign : {-1, 0, 1}) {
    State branch = state.branch();
    const Fact fact{step.name, sign < 0 ? -p : p, sign == 0 ? Sign::zero : Sign::positive};
    if (!add(branch, fact) && !close(branch, fact)) return false;
    step.branches.push_back(std::move(branch.steps));
  }
  state.steps.push_back(std::move(step));
  return true;
}

/// Variables of unknown sign, and differences of variables of equal sign: the order of a, b, c decides much that is
/// symmetric in them.
std::vector<Polynomial> Search::plain_candidates(State& state) {
  const Ring& ring = statement_.ring();
  std::set<std::size_t> variables;
  for (const Fact& fact : state.facts) {
    if (fact.sign == Sign::zero) continue;
    for (const std::size_t variable : fact.p.variables()) {
      if (fact.p.degree(variable) > 1) variables.insert(variable);
    }
  }
  std::vector<Polynomial> result;
  const auto propose = [&](const Polynomial& p) {
    const KnownSign* sign = sign_of(state, p);
    if (sign == nullptr || !sign->strict) result.push_back(p);
  };
  for (const std::size_t v : variables) propose(Polynomial::variable(ring, v));
  for (const std::size_t v : variables) {
    for (const std::size_t w : variables) {
      if (v < w) propose(Polynomial::variable(ring, v) - Polynomial::variable(ring, w));
    }
  }
  return result;
}

std::vector<Polynomial> Search::split_candidates(State& state, const std::vector<Polynomial>& from_pairs) {
  std::vector<Polynomial> result;
  std::vector<std::pair<std::size_t, Polynomial>> counted;
  const auto propose = [&](const Polynomial& p, std::size_t weight = 1) {
    if (p.is_constant()) return;
    for (auto& [count, other] : counted) {
      if (other == p) {
        count += weight;
        return;
      }
    }
    if (state.signs.contains(p.text()) && state.signs.at(p.text()).strict) return;
    counted.emplace_back(weight, p);
  };
  for (const Polynomial& hint : statement_.hints()) {
    Fact reduced{"", hint, Sign::zero};
    State scratch = state.branch();
    for (const Rule& rule : state.rules) reduce(scratch, rule, reduced);
    for (const auto& [factor, exponent] : factored(reduced.p).factors) {
      propose(factor, 1000);
    }
  }
  for (const Fact& fact : state.facts) {
    if (fact.sign == Sign::zero) {
      const Factorization& factors = factored(fact.p);
      for (const auto& [factor, exponent] : factors.factors) {
        if (factors.factors.size() > 1) propose(factor);
      }
      const std::size_t last = fact.p.variables().back();
      if (fact.p.degree(last) == 1) {
        for (const auto& [factor, exponent] : factored(fact.p.coefficient(last, 1)).factors) propose(factor, 5000);
      }
    } else {
      const Factorization& factors = factored(fact.p);
      if (factors.factors.size() > 1) {
        for (const auto& [factor, exponent] : factors.factors) propose(factor);
      }
    }
  }
  for (const Polynomial& p : from_pairs) propose(p);
  std::stable_sort(counted.begin(), counted.end(), [](const auto& x, const auto& y) {
    return x.first != y.first ? x.first > y.first : x.second.length() < y.second.length();
  });
  for (auto& [count, p] : counted) result.push_back(std::move(p));
  return result;
}

}  // namespace slipproof::prove
