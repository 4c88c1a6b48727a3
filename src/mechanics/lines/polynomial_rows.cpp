#include "mechanics/lines/polynomial_rows.hpp"

#include <algorithm>
#include <iterator>

namespace slipproof {

namespace {

/// So many combinations of a mode's conditions are looked at.
constexpr std::size_t max_combinations = 1000;

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

Conditions::Conditions(std::vector<PolynomialRow> given, CriticalSet& found) : found_(found) {
  for (std::size_t i = 0; i < given.size(); ++i) left_.insert({{i}, std::move(given[i])});
}

bool Conditions::eliminate(std::size_t column) {
  std::vector<Combination> with;
  std::set<Combination> all;
  left_.swap(all);
  while (!all.empty()) {
    auto next = all.extract(all.begin());
    if (next.value().row[column].is_zero()) {
      left_.insert(std::move(next));
    } else {
      found_.add(next.value().row[column]);
      with.push_back(std::move(next.value()));
    }
  }
  ++eliminated_;
  for (std::size_t i = 0; i < with.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      combine(with[k], with[i], column);
      if (left_.size() > max_combinations) return false;
    }
  }
  return true;
}

void Conditions::combine(const Combination& x, const Combination& y, std::size_t column) {
  Combination both;
  std::ranges::set_union(x.of, y.of, std::back_inserter(both.of));
  if (both.of.size() > eliminated_ + 1) return;
  for (std::size_t j = 0; j < x.row.size(); ++j) {
    both.row.push_back(x.row[column] * y.row[j] - y.row[column] * x.row[j]);
  }
  make_primitive(both.row, found_);
  const auto first = std::ranges::find_if(both.row, [](const auto& entry) { return !entry.is_zero(); });
  if (first == both.row.end()) return;
  if (first->coefficient(first->degree()) < 0) {
    for (IntegerPolynomial& entry : both.row) entry = -std::move(entry);
  }
  left_.insert(std::move(both));
}

std::vector<PolynomialRow> Conditions::rows() const {
  std::set<PolynomialRow> rows;
  for (const Combination& combination : left_) rows.insert(combination.row);
  return {rows.begin(), rows.end()};
}

}  // namespace slipproof
