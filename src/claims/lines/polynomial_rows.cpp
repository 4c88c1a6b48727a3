#include "claims/lines/polynomial_rows.hpp"

#include <algorithm>

namespace slipproof {

namespace {

/// The largest number of conditions from which undetermined forces are eliminated.
constexpr std::size_t max_forms = 400;

/// Divides by the common factor of all entries; where that vanishes, the row differs.
void make_primitive(PolynomialRow& row, CriticalSet& found) {
  IntegerPolynomial common(0);
  for (const IntegerPolynomial& x : row) {
    if (!x.is_zero()) common = common.is_zero() ? x : gcd(common, x);
  }
  if (common.is_zero() || common.is_one()) return;
  found.add(common);
  for (IntegerPolynomial& x : row) x = exact_quotient(x, common);
}

/// Eliminates the entry in the column. Returns the polynomial by which the row was multiplied.
IntegerPolynomial subtract_from(PolynomialRow& row, const PolynomialRow& pivot, std::size_t column) {
  const IntegerPolynomial common = gcd(row[column], pivot[column]);
  const IntegerPolynomial mine = exact_quotient(pivot[column], common), other = exact_quotient(row[column], common);
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (!mine.is_one() && !row[j].is_zero()) row[j] = mine * row[j];
    if (!pivot[j].is_zero()) row[j] = std::move(row[j]) - other * pivot[j];
  }
  return mine;
}

}  // namespace

SolvedRows::SolvedRows(std::vector<PolynomialRow> rows, std::size_t unknowns, CriticalSet& found)
    : unknowns_(unknowns), rows_(std::move(rows)), pivot_row_(unknowns), found_(found) {
  for (PolynomialRow& row : rows_) make_primitive(row, found_);
  std::vector<bool> used(rows_.size());
  while (const auto pivot = next_pivot(used)) {
    const auto [r, column] = *pivot;
    used[r] = true;
    pivot_row_[column] = r;
    found_.add(rows_[r][column]);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (i != r) subtract(rows_[i], rows_[r], column);
    }
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!used[i]) add_rest(rows_[i]);
  }
  for (std::size_t j = 0; j < unknowns_; ++j) {
    if (!pivot_row_[j]) free_.push_back(j);
  }
}

IntegerPolynomial SolvedRows::reduce(PolynomialRow& form) const {
  IntegerPolynomial factor(1);
  for (std::size_t j = 0; j < unknowns_; ++j) {
    if (form[j].is_zero() || !pivot_row_[j]) continue;
    factor = factor * subtract_from(form, rows_[*pivot_row_[j]], j);
  }
  return factor;
}

/// The entry of lowest degree in the sparsest row.
std::optional<std::pair<std::size_t, std::size_t>> SolvedRows::next_pivot(const std::vector<bool>& used) const {
  std::optional<std::pair<std::size_t, std::size_t>> best;
  std::pair<long, std::ptrdiff_t> least{};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (used[i]) continue;
    const auto entries = std::count_if(rows_[i].begin(), rows_[i].end(), [](const auto& x) { return !x.is_zero(); });
    for (std::size_t j = 0; j < unknowns_; ++j) {
      if (rows_[i][j].is_zero() || pivot_row_[j]) continue;
      const std::pair<long, std::ptrdiff_t> cost{rows_[i][j].degree(), entries};
      if (!best || cost < least) best = {i, j}, least = cost;
    }
  }
  return best;
}

void SolvedRows::subtract(PolynomialRow& row, const PolynomialRow& pivot, std::size_t column) {
  if (row[column].is_zero()) return;
  subtract_from(row, pivot, column);
  make_primitive(row, found_);
}

/// Adds a row without unknowns: it determines the force, or is a contradiction.
void SolvedRows::add_rest(const PolynomialRow& row) {
  const IntegerPolynomial &slope = row[unknowns_], &constant = row[unknowns_ + 1];
  if (slope.is_zero() && constant.is_zero()) return;
  found_.add(Affine<IntegerPolynomial>(constant, slope));
  solvable_ = solvable_ && !slope.is_zero();
}

/// Eliminates an unknown from conditions, whatever their signs; false if that gives too many.
bool eliminate(std::vector<PolynomialRow>& forms, std::size_t unknown, CriticalSet& found) {
  std::vector<PolynomialRow> result, with;
  for (PolynomialRow& form : forms) {
    (form[unknown].is_zero() ? result : with).push_back(std::move(form));
  }
  for (const PolynomialRow& form : with) found.add(form[unknown]);
  if (result.size() + with.size() * (with.size() + 1) / 2 > max_forms) return false;
  for (std::size_t i = 0; i < with.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      PolynomialRow combined;
      for (std::size_t j = 0; j < with[i].size(); ++j) {
        combined.push_back(with[k][unknown] * with[i][j] - with[i][unknown] * with[k][j]);
      }
      make_primitive(combined, found);
      result.push_back(std::move(combined));
    }
  }
  forms = std::move(result);
  return true;
}

}  // namespace slipproof
