#include "proofs/branch/context.hpp"

#include <algorithm>
#include <functional>

namespace slipproof::prove {

namespace {

/// Factoring cannot be stopped; what is longer is taken for irreducible.
constexpr std::size_t longest_factored = 2'000;

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

/// The search tries factors in this order.
Factorization short_ones_first(Factorization factorization) {
  std::sort(factorization.factors.begin(), factorization.factors.end(), [](const auto& x, const auto& y) {
    return x.first.length() != y.first.length() ? x.first.length() < y.first.length() : x.first.text() < y.first.text();
  });
  return factorization;
}

}  // namespace

Context::Context(const Statement& statement, const Limits& limits)
    : statement_(statement), limits_(limits), samples_(statement.ring(), positive_variables(statement)) {}

std::string Context::unused(const std::string& name) {
  const auto& assumptions = statement_.assumptions();
  const bool taken =
      std::any_of(assumptions.begin(), assumptions.end(), [&](const auto& named) { return named.first == name; });
  return taken ? fresh() : name;
}

std::string Context::fresh() {
  return unused("e" + std::to_string(++counter_));
}

const Factorization& Context::factored(const Polynomial& p) {
  const auto [entry, added] = factorizations_.try_emplace(p.text());
  if (added) {
    budget().spend(p.length() * 8);
    entry->second = p.length() > longest_factored ? p.as_irreducible() : short_ones_first(p.factors());
  }
  return entry->second;
}

const BothSigns& Context::both_signs(const Polynomial& p) {
  const std::string& text = p.text();
  if (const auto found = signed_.find(text); found != signed_.end()) return found->second;
  budget().spend(p.length() * 4);
  return signed_.emplace(text, BothSigns{p, -p, samples_.signs(p)}).first->second;
}

Polynomial Context::slope(const Polynomial& p, std::size_t variable) {
  return slopes_.get([&] { return p.coefficient(variable, 1); }, variable, p);
}

Polynomial Context::without(std::size_t variable, const Polynomial& lower, const Polynomial& upper) {
  const auto sum = [&] {
    return lower.coefficient(variable, 0) * -slope(upper, variable) +
           upper.coefficient(variable, 0) * slope(lower, variable);
  };
  return sums_.get(sum, variable, lower, upper);
}

SampleSet Context::fails(const Fact& fact) {
  const SignPattern& pattern = signs_at_samples(fact.p);
  return fact.sign == Sign::zero ? pattern.negative | pattern.positive : pattern.negative;
}

}  // namespace slipproof::prove
