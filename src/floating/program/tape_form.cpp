#include "floating/program/tape_form.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace slipproof {

namespace {

/// An entry to divide by and how suitable it is: first entries that cannot vanish, then those with the least fill-in.
struct PivotChoice {
  std::tuple<TapeBuilder::Doubt, std::size_t, std::size_t, std::size_t> cost;  ///< the last two are row and column

  TapeBuilder::Doubt doubt() const { return std::get<0>(cost); }
  std::size_t row() const { return std::get<2>(cost); }
  std::size_t column() const { return std::get<3>(cost); }
};

std::size_t entries(const TapeForm& form) {
  return static_cast<std::size_t>(std::count_if(form.coefficients.begin(), form.coefficients.end(),
                                                [](TapeRef c) { return c != TapeBuilder::zero; }));
}

/// Nothing if all coefficients are literal zeros.
std::optional<PivotChoice> best_pivot(const TapeBuilder& tape, const std::vector<TapeForm>& equations) {
  std::vector<std::size_t> columns;
  for (const TapeForm& equation : equations) {
    columns.resize(equation.coefficients.size(), 0);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      columns[i] += equation.coefficients[i] == TapeBuilder::zero ? 0 : 1;
    }
  }
  std::optional<PivotChoice> best;
  for (std::size_t row = 0; row < equations.size(); ++row) {
    const std::size_t in_row = entries(equations[row]);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const TapeRef entry = equations[row].coefficients[i];
      if (entry == TapeBuilder::zero) continue;
      TapeBuilder::Doubt doubt = tape.doubt_as_divisor(entry);
      // If an unknown must be 0, nothing is divided.
      const bool is_zero = in_row == 1 && equations[row].constant == TapeBuilder::zero;
      if (is_zero && doubt <= TapeBuilder::Doubt::one_sign) doubt = TapeBuilder::Doubt::literal;
      const PivotChoice choice{{doubt, (in_row - 1) * (columns[i] - 1), row, i}};
      if (!best || choice.cost < best->cost) best = choice;
    }
  }
  return best;
}

}  // namespace

void TapeElimination::eliminate(std::vector<TapeForm>& equations, TapeBuilder::Doubt most) {
  while (eliminate_one(equations, most)) {
  }
}

bool TapeElimination::eliminate_one(std::vector<TapeForm>& equations, TapeBuilder::Doubt most) {
  const auto best = best_pivot(*tape_, equations);
  if (!best || best->doubt() > most) return false;
  Row row{std::move(equations[best->row()]), best->column()};
  equations.erase(equations.begin() + static_cast<std::ptrdiff_t>(best->row()));
  const TapeRef pivot = row.form.coefficients[row.unknown];
  if (tape_->doubt_as_divisor(pivot) != TapeBuilder::Doubt::literal) pivots_.push_back(pivot);
  const auto divide = [&](TapeRef& x) { x = tape_->divide_often(x, pivot); };
  std::for_each(row.form.coefficients.begin(), row.form.coefficients.end(), divide);
  divide(row.form.constant);
  for (TapeForm& equation : equations) replace(equation, row);
  rows_.push_back(std::move(row));
  return true;
}

/// Replaces an unknown by the row that determines it.
void TapeElimination::replace(TapeForm& form, const Row& row) const {
  const TapeRef factor = std::exchange(form.coefficients[row.unknown], TapeBuilder::zero);
  if (factor == TapeBuilder::zero) return;
  const auto reduce = [&](TapeRef& x, TapeRef by) {
    if (by != TapeBuilder::zero) x = tape_->subtract(x, tape_->multiply(factor, by));
  };
  for (std::size_t i = 0; i < form.coefficients.size(); ++i) {
    if (i != row.unknown) reduce(form.coefficients[i], row.form.coefficients[i]);
  }
  reduce(form.constant, row.form.constant);
}

TapeForm TapeElimination::reduced(TapeForm form) const {
  for (const Row& row : rows_) replace(form, row);
  return form;
}

bool TapeElimination::is_determined(std::size_t unknown) const {
  return std::any_of(rows_.begin(), rows_.end(), [unknown](const Row& row) { return row.unknown == unknown; });
}

TapeSolution::TapeSolution(TapeElimination known, std::vector<TapeForm> equations, std::size_t unknowns)
    : tape_(known.tape()), rows_(std::move(known)), unknowns_(unknowns) {
  using Doubt = TapeBuilder::Doubt;
  rows_.eliminate(equations, Doubt::literal);
  while (!find_core(equations) && rows_.eliminate_one(equations, Doubt::looks_like_zero)) {
    rows_.eliminate(equations, Doubt::literal);
  }
  pivots_ = rows_.pivots();
  for (const TapeForm& left : equations) {
    if (entries(left) == 0 && left.constant != TapeBuilder::zero) residuals_.push_back(left.constant);
  }
}

/// If at most two equations are left, they are solved by determinants, which needs no division.
bool TapeSolution::find_core(const std::vector<TapeForm>& equations) {
  std::vector<const TapeForm*> left;
  for (const TapeForm& equation : equations) {
    if (entries(equation) > 0) left.push_back(&equation);
  }
  if (left.size() > 2) return false;
  if (!left.empty()) choose_core(left);
  if (!left.empty() && core_.empty()) return false;
  for (std::size_t i = 0; i < unknowns_; ++i) {
    if (!rows_.is_determined(i) && std::find(core_.begin(), core_.end(), i) == core_.end()) free_.push_back(i);
  }
  for (const TapeForm* equation : left) equations_.push_back(by_core(*equation));
  std::vector<TapeRef> side;
  for (const SolvedForm& equation : equations_) side.push_back(equation.constant);
  values_ = solved(side);
  for (std::size_t k = 0; k < free_.size(); ++k) {
    for (std::size_t i = 0; i < side.size(); ++i) side[i] = equations_[i].free[k];
    slopes_.push_back(solved(side));
  }
  return true;
}

/// Chooses the unknowns whose determinant is least likely to vanish; none if all determinants look like 0.
void TapeSolution::choose_core(const std::vector<const TapeForm*>& rows) {
  TapeBuilder::Doubt doubt = TapeBuilder::Doubt::looks_like_zero;
  const auto& x = rows.front()->coefficients;
  for (std::size_t j = 0; j < unknowns_; ++j) {
    if (rows.size() == 1 && is_better(x[j], doubt)) {
      core_ = {j};
      divisor_ = x[j];
    }
    for (std::size_t i = 0; i < j && rows.size() == 2; ++i) {
      const auto& y = rows.back()->coefficients;
      const TapeRef found = minor(x[i], y[j], x[j], y[i]);
      if (!is_better(found, doubt)) continue;
      core_ = {i, j};
      divisor_ = found;
    }
  }
}

bool TapeSolution::is_better(TapeRef divisor, TapeBuilder::Doubt& doubt) const {
  if (divisor == TapeBuilder::zero || tape_.doubt_as_divisor(divisor) >= doubt) return false;
  doubt = tape_.doubt_as_divisor(divisor);
  return true;
}

/// a b - c d
TapeRef TapeSolution::minor(TapeRef a, TapeRef b, TapeRef c, TapeRef d) const {
  return tape_.subtract(tape_.multiply(a, b), tape_.multiply(c, d));
}

/// The solution of equations with these constants, computed as solve_core() does.
std::vector<TapeRef> TapeSolution::solved(const std::vector<TapeRef>& side) const {
  if (side.empty()) return {};
  if (side.size() == 1) return {tape_.negate(side[0])};
  const auto &x = equations_[0].core, &y = equations_[1].core;
  return {minor(x[1], side[1], side[0], y[1]), minor(side[0], y[0], x[0], side[1])};
}

SolvedForm TapeSolution::by_core(const TapeForm& form) const {
  SolvedForm result;
  result.constant = form.constant;
  for (const std::size_t i : core_) result.core.push_back(form.coefficients[i]);
  for (const std::size_t i : free_) result.free.push_back(form.coefficients[i]);
  return result;
}

TapeRef TapeSolution::at_solution(const SolvedForm& form, TapeRef own, const std::vector<TapeRef>& values) const {
  TapeRef sum = tape_.multiply(own, divisor_);
  for (std::size_t i = 0; i < values.size(); ++i) sum = tape_.add(sum, tape_.multiply(form.core[i], values[i]));
  return sum;
}

TapeRef TapeSolution::numerator(const SolvedForm& form) const {
  return at_solution(form, form.constant, values_);
}

SolvedForm TapeSolution::on(const TapeForm& form) const {
  SolvedForm result = by_core(rows_.reduced(form));
  // What an equation of the core says needs no proof.
  const bool vanishes = std::any_of(equations_.begin(), equations_.end(), [&](const SolvedForm& equation) {
    return equation.constant == result.constant && equation.core == result.core && equation.free == result.free;
  });
  result.no_constant = vanishes || numerator(result) == TapeBuilder::zero;
  for (std::size_t k = 0; k < free_.size(); ++k) {
    result.no_slope.push_back(vanishes || at_solution(result, result.free[k], slopes_[k]) == TapeBuilder::zero);
  }
  return result;
}

}  // namespace slipproof
