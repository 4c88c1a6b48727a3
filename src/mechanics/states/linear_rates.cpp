#include "mechanics/states/linear_rates.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace slipproof::bodies_in_motion {

namespace {

Quotient inverse(const Quotient& x) {
  return {x.under, x.over};
}

Quotient negative(const Quotient& x) {
  return {-x.over, x.under};
}

}  // namespace

LinearRates::LinearRates(const Quotients& quotients, std::size_t unknowns)
    : quotients_(quotients), unknowns_(unknowns), determinant_(quotients.number(1)) {}

Quotient LinearRates::product(const Quotient& x, const Quotient& y) const {
  return Quotients::shortened(Quotients::combined(Operation::multiply, x, y));
}

void LinearRates::reduce(RateEquation& equation) const {
  for (const Pivot& pivot : pivots_) {
    const auto found = equation.terms.find(pivot.unknown);
    if (found == equation.terms.end()) continue;
    const Quotient factor = negative(found->second);
    equation.terms.erase(found);
    const auto sum = [&](const Quotient& x, const Quotient& y) {
      return Quotients::shortened(Quotients::combined(Operation::add, x, product(factor, y)));
    };
    for (const auto& [unknown, term] : pivot.equation.terms) {
      if (unknown == pivot.unknown) continue;
      const auto [place, added] = equation.terms.try_emplace(unknown, quotients_.number(0));
      place->second = sum(place->second, term);
      if (place->second.over.is_zero()) equation.terms.erase(place);
    }
    equation.rest = sum(equation.rest, pivot.equation.rest);
  }
}

std::optional<Quotient> LinearRates::insert(RateEquation equation) {
  reduce(equation);
  if (equation.terms.empty()) return equation.rest;
  const auto effort = [](const auto& entry) {
    const Quotient& x = entry.second;
    const bool constant = x.over.is_constant() && x.under.is_constant();
    return std::tuple(constant ? 0 : x.over.length() + x.under.length(), entry.first);
  };
  const auto best = std::ranges::min_element(equation.terms, {}, effort);
  const std::size_t unknown = best->first;
  determinant_ = product(determinant_, best->second);
  const Quotient scale = inverse(best->second);
  for (auto& [index, term] : equation.terms) term = product(term, scale);
  equation.rest = product(equation.rest, scale);
  pivots_.push_back({unknown, std::move(equation)});
  return std::nullopt;
}

std::vector<std::size_t> LinearRates::undetermined() {
  std::vector<std::size_t> result;
  for (std::size_t i = unknowns_; i-- > 0 && pivots_.size() < unknowns_;) {
    if (!insert({{{i, quotients_.number(1)}}, quotients_.number(0)})) result.push_back(i);
  }
  return result;
}

std::vector<Quotient> LinearRates::values() const {
  std::vector<Quotient> result(unknowns_, quotients_.number(0));
  for (auto pivot = pivots_.rbegin(); pivot != pivots_.rend(); ++pivot) {
    Quotient sum = pivot->equation.rest;
    for (const auto& [unknown, term] : pivot->equation.terms) {
      if (unknown == pivot->unknown) continue;
      sum = Quotients::shortened(Quotients::combined(Operation::add, sum, product(term, result[unknown])));
    }
    result[pivot->unknown] = negative(sum);
  }
  return result;
}

}  // namespace slipproof::bodies_in_motion
