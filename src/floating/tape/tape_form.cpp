#include "floating/tape/tape_form.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace slipproof {

namespace {

/// An entry to divide by, and how well it suits: first what cannot vanish, then what fills in least.
struct PivotChoice {
  std::tuple<int, std::size_t, std::size_t, std::size_t> cost;  ///< the last two are row and column
};

std::size_t entries(const TapeForm& form) {
  return static_cast<std::size_t>(std::count_if(form.coefficients.begin(), form.coefficients.end(),
                                                [](TapeRef c) { return c != TapeBuilder::zero; }));
}

std::vector<std::size_t> entries_of_columns(const std::vector<TapeForm>& equations, std::size_t unknowns) {
  std::vector<std::size_t> counts(unknowns, 0);
  for (const TapeForm& equation : equations) {
    for (std::size_t i = 0; i < unknowns; ++i) counts[i] += equation.coefficients[i] == TapeBuilder::zero ? 0 : 1;
  }
  return counts;
}

/// Nothing where all coefficients are literal zeros.
std::optional<PivotChoice> best_pivot(const TapeBuilder& tape, const std::vector<TapeForm>& equations,
                                      std::size_t unknowns) {
  const std::vector<std::size_t> columns = entries_of_columns(equations, unknowns);
  std::optional<PivotChoice> best;
  for (std::size_t row = 0; row < equations.size(); ++row) {
    const std::size_t in_row = entries(equations[row]);
    for (std::size_t i = 0; i < unknowns; ++i) {
      const TapeRef entry = equations[row].coefficients[i];
      if (entry == TapeBuilder::zero) continue;
      const PivotChoice choice{{tape.doubt_as_divisor(entry), (in_row - 1) * (columns[i] - 1), row, i}};
      if (!best || choice.cost < best->cost) best = choice;
    }
  }
  return best;
}

}  // namespace

TapeSolution::TapeSolution(TapeBuilder& tape, std::vector<TapeForm> equations, std::size_t unknowns) : tape_(tape) {
  eliminate(std::move(equations));
  substitute_back(unknowns);
}

void TapeSolution::eliminate(std::vector<TapeForm> equations) {
  const std::size_t unknowns = equations.empty() ? 0 : equations.front().coefficients.size();
  while (const auto best = best_pivot(tape_, equations, unknowns)) {
    const std::size_t place = std::get<2>(best->cost), unknown = std::get<3>(best->cost);
    rows_.push_back({std::move(equations[place]), unknown});
    equations.erase(equations.begin() + static_cast<std::ptrdiff_t>(place));
    const TapeRef pivot = rows_.back().form.coefficients[unknown];
    if (tape_.doubt_as_divisor(pivot) > 0) pivots_.push_back(pivot);
    eliminate_with(rows_.back(), equations);
  }
  for (const TapeForm& left : equations) {
    if (left.constant != TapeBuilder::zero) residuals_.push_back(left.constant);
  }
}

void TapeSolution::eliminate_with(const Row& row, std::vector<TapeForm>& equations) {
  const TapeRef pivot = row.form.coefficients[row.unknown];
  for (TapeForm& equation : equations) {
    const TapeRef entry = std::exchange(equation.coefficients[row.unknown], TapeBuilder::zero);
    if (entry == TapeBuilder::zero) continue;
    const TapeRef factor = tape_.divide(entry, pivot);
    const auto reduce = [&](TapeRef& x, TapeRef by) {
      if (by != TapeBuilder::zero) x = tape_.subtract(x, tape_.multiply(factor, by));
    };
    for (std::size_t i = 0; i < equation.coefficients.size(); ++i) {
      if (i != row.unknown) reduce(equation.coefficients[i], row.form.coefficients[i]);
    }
    reduce(equation.constant, row.form.constant);
  }
}

void TapeSolution::substitute_back(std::size_t unknowns) {
  std::vector<bool> fixed(unknowns, false);
  for (const Row& row : rows_) fixed[row.unknown] = true;
  for (std::size_t i = 0; i < unknowns; ++i) {
    if (!fixed[i]) free_.push_back(i);
  }
  values_.assign(unknowns, {TapeBuilder::zero, std::vector<TapeRef>(free_.size(), TapeBuilder::zero)});
  for (std::size_t k = 0; k < free_.size(); ++k) values_[free_[k]].slopes[k] = TapeBuilder::one;
  for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
    TapeForm rest = row->form;
    const TapeRef pivot = std::exchange(rest.coefficients[row->unknown], TapeBuilder::zero);
    FreeForm value = on(rest);
    const auto settle = [&](TapeRef& x) { x = tape_.negate(tape_.divide(x, pivot)); };
    settle(value.constant);
    for (TapeRef& slope : value.slopes) settle(slope);
    values_[row->unknown] = std::move(value);
  }
}

FreeForm TapeSolution::on(const TapeForm& form) const {
  FreeForm result{form.constant, std::vector<TapeRef>(free_.size(), TapeBuilder::zero)};
  for (std::size_t i = 0; i < form.coefficients.size(); ++i) {
    const TapeRef c = form.coefficients[i];
    if (c == TapeBuilder::zero) continue;
    const auto add = [&](TapeRef& x, TapeRef y) { x = tape_.add(x, tape_.multiply(c, y)); };
    add(result.constant, values_[i].constant);
    for (std::size_t k = 0; k < free_.size(); ++k) add(result.slopes[k], values_[i].slopes[k]);
  }
  return result;
}

}  // namespace slipproof
