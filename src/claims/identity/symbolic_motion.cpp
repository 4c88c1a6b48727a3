#include "claims/identity/symbolic_motion.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "mechanics/mechanism/system.hpp"

namespace slipproof {

namespace {

using SymbolicRow = std::vector<ReducedFraction>;  ///< coefficients of the unknowns, then the right-hand side

/// The elimination gives up if a function has more terms.
constexpr std::size_t max_terms = 2'000;

bool is_zero(const ReducedFraction& x) {
  return x.numerator.is_zero();
}

std::size_t terms(const SymbolicNumber& x) {
  return x.polynomial() == nullptr ? 1 : x.polynomial()->terms().size();
}
std::size_t terms(const ReducedFraction& x) {
  return terms(x.numerator) + terms(x.denominator);
}

/// The coefficients of the mechanism; nothing if one has no value for all parameters.
std::optional<MechanismSystem<SymbolicValue>> system_in(const CompiledSetting& setting, SymbolicEvaluator& paper) {
  const CompiledMechanism& compiled = setting.maker().compiled();
  SymbolicEvaluator at(compiled.scope(), paper.field());
  if (!put_scene(setting, paper, at, [](const SymbolicValue&) { return true; })) return std::nullopt;
  return system_of(setting.mechanism(), compiled, setting.kinds(), at);
}

/// Gauss-Jordan elimination.
class Elimination {
 public:
  Elimination(std::size_t unknowns, std::vector<SymbolicNumber>& divisors)
      : unknowns_(unknowns), divisors_(divisors), row_of_(unknowns) {}

  /// False if, for all parameters, the unknowns are not determined or the equations contradict each other.
  bool solve(std::vector<SymbolicRow> rows) {
    rows_ = std::move(rows);
    std::vector<bool> used(rows_.size());
    for (std::size_t step = 0; step < unknowns_; ++step) {
      const auto pivot = simplest_pivot(used);
      if (!pivot) return false;
      const auto [r, column] = *pivot;
      used[r] = true;
      row_of_[column] = r;
      const ReducedFraction factor = rows_[r][column];
      determinant_ = determinant_ * factor;
      if (rows_.size() != unknowns_) divisors_.push_back(factor.numerator);
      for (ReducedFraction& x : rows_[r]) x = x / factor;
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (i != r && !subtract(rows_[i], rows_[r], column)) return false;
      }
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!used[i] && !is_zero(rows_[i].back())) return false;
    }
    if (rows_.size() == unknowns_) divisors_.push_back(determinant_.numerator);
    return true;
  }

  const ReducedFraction& value(std::size_t unknown) const { return rows_[*row_of_[unknown]].back(); }

 private:
  std::optional<std::pair<std::size_t, std::size_t>> simplest_pivot(const std::vector<bool>& used) const {
    std::optional<std::pair<std::size_t, std::size_t>> best;
    std::size_t least = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (used[i]) continue;
      const auto entries = std::count_if(rows_[i].begin(), rows_[i].end(), [](const auto& x) { return !is_zero(x); });
      for (std::size_t j = 0; j < unknowns_; ++j) {
        if (is_zero(rows_[i][j]) || row_of_[j]) continue;
        const std::size_t cost = terms(rows_[i][j]) * static_cast<std::size_t>(entries);
        if (!best || cost < least) best = {i, j}, least = cost;
      }
    }
    return best;
  }

  /// False if the row becomes too large.
  bool subtract(SymbolicRow& row, const SymbolicRow& pivot, std::size_t column) const {
    if (is_zero(row[column])) return true;
    const ReducedFraction factor = row[column];
    for (std::size_t j = 0; j < row.size(); ++j) {
      if (is_zero(pivot[j])) continue;
      row[j] = row[j] - factor * pivot[j];
      if (terms(row[j]) > max_terms) return false;
    }
    return true;
  }

  std::size_t unknowns_;
  std::vector<SymbolicNumber>& divisors_;
  std::vector<SymbolicRow> rows_;
  std::vector<std::optional<std::size_t>> row_of_;  ///< by unknown
  ReducedFraction determinant_ = SymbolicNumber(1);
};

}  // namespace

SymbolicMotion symbolic_motion(const CompiledSetting& setting, const MechanismMode& mode, SymbolicEvaluator& paper) {
  SymbolicMotion result;
  if (!has_mode(setting.kinds(), mode)) return result;
  const auto system = system_in(setting, paper);
  if (!system) return result;
  const std::size_t unknowns = setting.unknowns();
  ReducedFraction load;
  if (setting.scene().load) {
    const auto value = paper.number(*setting.scene().load).number;
    if (!value) return result;
    load = value->value();
  }
  const auto keep_divisors = [&](const SymbolicValue& x) {
    for (const MultiPolynomial& divisor : x.divisors()) result.divisors.emplace_back(divisor);
  };
  const auto row_of = [&](const FormRow<SymbolicValue>& form) {
    for (const SymbolicValue& x : form.entries) keep_divisors(x);
    SymbolicRow row;
    for (std::size_t i = 0; i < unknowns; ++i) row.push_back(form.entries[i].value());
    row.push_back(-(form.entries[unknowns].value() * load + form.entries[unknowns + 1].value()));
    return row;
  };
  std::vector<SymbolicRow> rows;
  for (const auto& equation : system->equations) rows.push_back(row_of(equation));
  for (std::size_t i = 0; i < mode.size(); ++i) {
    for (const StateEquation e : equations(system->elements[i].kind, mode[i])) {
      rows.push_back(row_of(form_of(system->elements[i], mode[i], e)));
    }
  }
  Elimination elimination(unknowns, result.divisors);
  if (!elimination.solve(std::move(rows))) return result;
  std::size_t quantity = 0;
  for (const auto* forms : {&system->accelerations, &system->forces}) {
    for (const auto& form : *forms) {
      const SymbolicRow row = row_of(form);
      ReducedFraction value = -row.back();
      for (std::size_t i = 0; i < unknowns; ++i) {
        if (!is_zero(row[i])) value = value + row[i] * elimination.value(i);
      }
      paper.set(setting.quantity_slot(quantity++), SymbolicValue(std::move(value)));
    }
  }
  result.found = true;
  return result;
}

}  // namespace slipproof
