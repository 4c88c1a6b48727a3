#include "claims/judge/linear_system.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/algebra/elimination.hpp"
#include "claims/judge/linear.hpp"

namespace slipproof {

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
  const Echelon echelon = eliminate(rows);
  return rows.empty() || echelon.rank(rows.front().size() - 1) == echelon.rank();
}

bool follows(const LinearRows& rows, const LinearRows& given) {
  LinearRows all = given;
  all.insert(all.end(), rows.begin(), rows.end());
  return eliminate(all).rank() == eliminate(given).rank();
}

bool equivalent(const LinearRows& left, const LinearRows& right, const std::vector<bool>& occurs) {
  if (left.empty()) return follows(right, left);
  std::vector<std::size_t> order(left.front().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto kept =
      std::stable_partition(order.begin(), order.end(), [&](std::size_t j) { return j < occurs.size() && !occurs[j]; });
  LinearRows ordered(left.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    for (const std::size_t j : order) ordered[i].push_back(left[i][j]);
  }
  const Echelon echelon = eliminate(ordered);
  LinearRows rest;
  for (std::size_t i = echelon.rank(static_cast<std::size_t>(kept - order.begin())); i < echelon.rank(); ++i) {
    rest.emplace_back(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) rest.back()[order[k]] = Rational(echelon.rows[i][k]);
  }
  return follows(right, rest) && follows(rest, right);
}

}  // namespace slipproof
