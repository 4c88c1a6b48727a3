#include "base/algebra/sparse/sparse_basis.hpp"

#include <algorithm>
#include <limits>

namespace slipproof {

/// The rows that have no pivot yet, by column; and for each column the rows that may have an entry there.
class SparseBasis::Elimination {
 public:
  Elimination(SparseBasis& basis, const std::vector<const SparseVector*>& columns, Effort& effort)
      : basis_(basis), effort_(effort), rows_(basis.rows_), in_column_(columns.size()), done_(columns.size()) {
    for (std::uint32_t j = 0; j < columns.size(); ++j) {
      for (const auto& [row, value] : *columns[j]) {
        rows_[row].emplace_back(j, value);  // in ascending columns
        in_column_[j].push_back(row);
      }
    }
  }

  void run() {
    std::vector<bool> has_pivot(basis_.rows_);
    for (std::size_t k = 0; k < done_.size(); ++k) {
      const std::uint32_t column = shortest_column();
      done_[column] = true;
      if (in_column_[column].empty()) {
        basis_.dependent_.push_back(column);
        continue;
      }
      const std::uint32_t row = *std::ranges::min_element(
          in_column_[column], {}, [&](std::uint32_t i) { return std::pair(rows_[i].size(), i); });
      has_pivot[row] = true;
      eliminate(row, column);
    }
    std::ranges::sort(basis_.dependent_);
    for (std::size_t i = 0; i < has_pivot.size(); ++i) {
      if (!has_pivot[i]) basis_.free_rows_.push_back(i);
    }
  }

 private:
  std::uint32_t shortest_column() const {
    std::size_t least = std::numeric_limits<std::size_t>::max();
    std::uint32_t best = 0;
    for (std::uint32_t j = 0; j < done_.size(); ++j) {
      if (!done_[j] && in_column_[j].size() < least) best = j, least = in_column_[j].size();
    }
    return best;
  }

  void eliminate(std::uint32_t row, std::uint32_t column) {
    Pivot pivot{row, column, {}, std::move(rows_[row])};
    rows_[row].clear();
    const auto at = std::ranges::lower_bound(pivot.others, column, {}, &SparseVector::value_type::first);
    pivot.value = std::move(at->second);
    pivot.others.erase(at);
    for (const auto& [j, value] : pivot.others) std::erase(in_column_[j], row);
    for (const std::uint32_t i : in_column_[column]) {
      if (i != row) subtract(i, pivot);
    }
    basis_.pivots_.push_back(std::move(pivot));
  }

  /// Makes the entry of row i in the pivot's column 0.
  void subtract(std::uint32_t i, const Pivot& pivot) {
    SparseVector& row = rows_[i];
    const auto at = std::ranges::lower_bound(row, pivot.column, {}, &SparseVector::value_type::first);
    const Rational factor = at->second / pivot.value;
    row.erase(at);
    SparseVector sum;
    sum.reserve(row.size() + pivot.others.size());
    auto own = row.begin();
    for (const auto& [j, value] : pivot.others) {
      effort_.spend(4 * product_work(bit_count(factor) + bit_count(value)));
      for (; own != row.end() && own->first < j; ++own) sum.push_back(std::move(*own));
      const Rational less = factor * value;
      if (own == row.end() || own->first != j) {
        sum.emplace_back(j, -less);
        in_column_[j].push_back(i);
        continue;
      }
      Rational rest = own->second - less;
      ++own;
      if (rest.is_zero()) {
        std::erase(in_column_[j], i);
      } else {
        sum.emplace_back(j, std::move(rest));
      }
    }
    std::move(own, row.end(), std::back_inserter(sum));
    row = std::move(sum);
    basis_.steps_.push_back({i, pivot.row, factor});
  }

  SparseBasis& basis_;
  Effort& effort_;
  std::vector<SparseVector> rows_;
  std::vector<std::vector<std::uint32_t>> in_column_;
  std::vector<bool> done_;
};

SparseBasis::SparseBasis(std::size_t rows, const std::vector<const SparseVector*>& columns, Effort& effort)
    : rows_(rows), columns_(columns.size()) {
  Elimination(*this, columns, effort).run();
}

std::vector<Rational> SparseBasis::solve(std::vector<Rational> b) const {
  for (const Step& step : steps_) b[step.row] -= step.factor * b[step.from];
  std::vector<Rational> x(columns_);
  for (auto pivot = pivots_.rbegin(); pivot != pivots_.rend(); ++pivot) {
    Rational& sum = b[pivot->row];
    for (const auto& [j, value] : pivot->others) sum -= value * x[j];
    x[pivot->column] = sum / pivot->value;
  }
  return x;
}

std::vector<Rational> SparseBasis::solve_transposed(std::vector<Rational> c) const {
  std::vector<Rational> y(rows_);
  for (const Pivot& pivot : pivots_) {
    Rational& own = y[pivot.row];
    own = c[pivot.column] / pivot.value;
    if (own.is_zero()) continue;
    for (const auto& [j, value] : pivot.others) c[j] -= value * own;
  }
  for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) y[step->from] -= step->factor * y[step->row];
  return y;
}

}  // namespace slipproof
