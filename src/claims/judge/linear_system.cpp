#include "claims/judge/linear_system.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "claims/judge/linear.hpp"

namespace slipproof {

namespace {

/// row -= factor * pivot row, from `column` on.
void subtract(std::vector<Rational>& row, const std::vector<Rational>& pivot, std::size_t column) {
  if (row[column].is_zero()) return;
  const Rational factor = row[column] / pivot[column];
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (!pivot[j].is_zero()) row[j] -= factor * pivot[j];
  }
}

/// Gaussian elimination in the order of `columns`; moves the pivot rows to the front. Returns the columns of the
/// pivots.
std::vector<std::size_t> eliminate(LinearRows& rows, const std::vector<std::size_t>& columns) {
  std::vector<std::size_t> pivots;
  for (const std::size_t column : columns) {
    const std::size_t rank = pivots.size();
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const auto& row) { return !row[column].is_zero(); });
    if (pivot == rows.end()) continue;
    std::swap(rows[rank], *pivot);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) subtract(rows[i], rows[rank], column);
    pivots.push_back(column);
  }
  return pivots;
}

std::vector<std::size_t> all_columns(const LinearRows& rows) {
  std::vector<std::size_t> columns(rows.empty() ? 0 : rows.front().size());
  std::iota(columns.begin(), columns.end(), std::size_t{0});
  return columns;
}

}  // namespace

std::optional<LinearRows> linear_rows(const CompiledSetting& setting, const std::vector<Rational>& values,
                                      const std::vector<Program>& equations) {
  Evaluator<Linear, LinearField> evaluator(setting.scope());
  const LinearField field;
  for (std::size_t k = 0; k < values.size(); ++k) {
    evaluator.set(CompiledSetting::parameter_slot(k), field.constant(values[k]));
  }
  const std::size_t unknowns = setting.unknowns();
  for (std::size_t i = 0; i < unknowns; ++i) evaluator.set(setting.unknown_slot(i), Linear::variable(i, unknowns + 1));
  evaluator.set(CompiledSetting::force_slot(), Linear::variable(unknowns, unknowns + 1));
  LinearRows rows;
  for (const Program& equation : equations) {
    const Program::Instruction& root = equation.code()[equation.root()];
    const auto x = evaluator.number(equation, root.first), y = evaluator.number(equation, root.second);
    if (!x.number || !y.number) return std::nullopt;
    Linear difference = *x.number - *y.number;
    if (!difference.linear) return std::nullopt;
    difference.coefficients.resize(unknowns + 1);
    difference.coefficients.push_back(std::move(difference.constant));
    rows.push_back(std::move(difference.coefficients));
  }
  return rows;
}

bool has_solution(const LinearRows& rows) {
  LinearRows echelon = rows;
  const auto pivots = eliminate(echelon, all_columns(rows));
  return pivots.empty() || pivots.back() != rows.front().size() - 1;  // the constant alone: 1 = 0
}

bool follows(const LinearRows& rows, const LinearRows& given) {
  LinearRows echelon = given;
  const auto pivots = eliminate(echelon, all_columns(given));
  return std::all_of(rows.begin(), rows.end(), [&](std::vector<Rational> row) {
    for (std::size_t i = 0; i < pivots.size(); ++i) subtract(row, echelon[i], pivots[i]);
    return std::all_of(row.begin(), row.end(), [](const Rational& x) { return x.is_zero(); });
  });
}

bool equivalent(const LinearRows& left, const LinearRows& right, const std::vector<bool>& occurs) {
  std::vector<std::size_t> eliminated;
  for (std::size_t j = 0; j < occurs.size(); ++j) {
    if (!occurs[j]) eliminated.push_back(j);
  }
  LinearRows rest = left;
  const std::size_t rank = eliminate(rest, eliminated).size();
  rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(rank));
  return follows(right, rest) && follows(rest, right);
}

}  // namespace slipproof
