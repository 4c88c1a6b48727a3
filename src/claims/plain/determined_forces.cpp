#include "claims/plain/determined_forces.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/algebra/polynomial.hpp"
#include "base/expression/parser.hpp"

namespace slipproof {

namespace {

/// Eliminates without divisions, so that the entries stay polynomials in the symbols of the paper.
class ForceColumns {
 public:
  using Row = std::vector<MultiPolynomial>;
  using Coefficients =
      std::vector<std::vector<Expression>>;  ///< of the forces in each equation, in the paper's symbols

  ForceColumns(const Coefficients& coefficients, std::size_t columns, const PlainSigns& signs)
      : signs_(signs), ring_(symbols_of(coefficients)), columns_(columns) {
    // Some mechanisms have long products: a bound on the work, in steps of the ring.
    ring_.budget().renew(1'000'000);
    for (const std::vector<Expression>& row : coefficients) add_row(row);
  }

  bool independent() {
    for (std::size_t left = columns_; left > 0; --left) {
      const auto pivot = find_pivot();
      if (!pivot) return false;
      eliminate(pivot->first, pivot->second);
    }
    return true;
  }

 private:
  static std::vector<std::string> symbols_of(const Coefficients& coefficients) {
    std::set<std::string> all;
    for (const std::vector<Expression>& row : coefficients) {
      for (const Expression& e : row) std::ranges::copy(symbols(e), std::inserter(all, all.end()));
    }
    return {all.begin(), all.end()};
  }

  /// Leaves out an equation with a coefficient that is no polynomial; the others may suffice.
  void add_row(const std::vector<Expression>& coefficients) {
    Row row;
    for (const Expression& coefficient : coefficients) {
      const auto entry = MultiPolynomial::parse(ring_, to_string(coefficient));
      if (!entry) return;
      row.push_back(*entry);
    }
    rows_.push_back(std::move(row));
  }

  bool never_zero(const MultiPolynomial& entry) const {
    if (entry.is_zero()) return false;
    const auto positive = [&](const MultiPolynomial& p) {
      return signs_.positive(parse_expression(p.text(), Sort::number));
    };
    return positive(entry) || positive(-entry);
  }

  /// A row and a column, in a row with as few other entries as there are.
  std::optional<std::pair<std::size_t, std::size_t>> find_pivot() const {
    std::vector<std::size_t> order(rows_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto entries = [&](std::size_t row) {
      return std::ranges::count_if(rows_[row], [](const MultiPolynomial& p) { return !p.is_zero(); });
    };
    std::ranges::stable_sort(order, {}, entries);
    for (const std::size_t row : order) {
      for (std::size_t column = 0; column < columns_; ++column) {
        if (never_zero(rows_[row][column])) return std::pair(row, column);
      }
    }
    return std::nullopt;
  }

  void eliminate(std::size_t row, std::size_t column) {
    const Row by = std::move(rows_[row]);
    rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(row));
    for (Row& other : rows_) {
      if (other[column].is_zero()) continue;
      const MultiPolynomial factor = other[column];
      for (std::size_t i = 0; i < columns_; ++i) other[i] = other[i] * by[column] - factor * by[i];
    }
  }

  const PlainSigns& signs_;
  PolynomialRing ring_;
  std::size_t columns_;
  std::vector<Row> rows_;
};

}  // namespace

bool plainly_determine_forces(const Family& scene, const PlainSigns& signs) {
  const Mechanism& mechanism = *scene.mechanism;
  ForceColumns::Coefficients coefficients;
  for (const MechanismEquation& equation : mechanism.equations) {
    std::vector<Expression>& row = coefficients.emplace_back();
    for (std::size_t i = mechanism.accelerations; i < mechanism.unknowns.size(); ++i) {
      row.push_back(scene.in_family(equation.form.coefficient(i)));
    }
  }
  try {
    return ForceColumns(coefficients, mechanism.unknowns.size() - mechanism.accelerations, signs).independent();
  } catch (const Budget::Spent&) {
    return false;
  }
}

}  // namespace slipproof
