#include "contact/complete/program/column_program.hpp"

#ifdef SLIPPROOF_CLP

#include <cmath>
#include <coin/ClpSimplexPrimal.hpp>

namespace slipproof {

/// Columns: two slacks for each row, then the others.
struct ColumnProgram::Clp {
  ClpSimplex simplex;
  bool finite = true;  ///< all numbers; Clp ends the process for others
};

ColumnProgram::ColumnProgram(const std::vector<double>& right_side, const std::vector<bool>& free_rows,
                             const std::vector<Column>& columns)
    : clp_(std::make_unique<Clp>()), rows_(right_side.size()) {
  const std::size_t all = 2 * rows_ + columns.size();
  std::vector<int> starts{0}, rows;
  std::vector<double> values, costs(all), lower(all), upper(all, COIN_DBL_MAX);
  const auto add = [&](int row, double value) {
    rows.push_back(row);
    values.push_back(value);
  };
  for (std::size_t i = 0; i < rows_; ++i) {
    for (const double side : {1.0, -1.0}) {
      costs[starts.size() - 1] = 1;
      add(static_cast<int>(i), side);
      starts.push_back(static_cast<int>(rows.size()));
    }
  }
  for (const Column& column : columns) {
    for (const Entry& entry : column) {
      add(entry.row, entry.value);
      clp_->finite = clp_->finite && std::isfinite(entry.value);
    }
    starts.push_back(static_cast<int>(rows.size()));
  }
  std::vector<double> row_lower = right_side, row_upper = right_side;
  for (std::size_t i = 0; i < rows_; ++i) {
    if (free_rows[i]) row_lower[i] = -COIN_DBL_MAX, row_upper[i] = COIN_DBL_MAX;
  }
  ClpSimplex& simplex = clp_->simplex;
  simplex.setLogLevel(0);
  simplex.loadProblem(static_cast<int>(all), static_cast<int>(rows_), starts.data(), rows.data(), values.data(),
                      lower.data(), upper.data(), costs.data(), row_lower.data(), row_upper.data());
  simplex.scaling(0);
  simplex.setMaximumIterations(2000);
  begin_with_slacks();
}

void ColumnProgram::begin_with_slacks() {
  ClpSimplex& simplex = clp_->simplex;
  simplex.createStatus();
  for (int i = 0; i < simplex.numberColumns(); ++i) {
    const bool is_free = simplex.columnLower()[i] == -COIN_DBL_MAX;
    simplex.setColumnStatus(i, is_free ? ClpSimplex::isFree : ClpSimplex::atLowerBound);
  }
  for (int row = 0; row < static_cast<int>(rows_); ++row) {
    const double right_side = simplex.rowUpper()[row];
    const bool is_free = right_side == COIN_DBL_MAX;
    simplex.setRowStatus(row, is_free ? ClpSimplex::basic : ClpSimplex::isFixed);
    if (!is_free) simplex.setColumnStatus(2 * row + (right_side >= 0 ? 0 : 1), ClpSimplex::basic);
  }
}

bool ColumnProgram::solve(double tolerance) {
  if (!clp_->finite) return false;
  clp_->simplex.setPrimalTolerance(tolerance);
  clp_->simplex.setDualTolerance(tolerance);
  // Its own way on from here, where this gives up, is the dual method, which may end the process with an assertion.
  auto& simplex = static_cast<ClpSimplexPrimal&>(clp_->simplex);
  if (simplex.primal(0, 0) == 0) return true;
  begin_with_slacks();
  return simplex.primal(0, 0) == 0;
}

void ColumnProgram::make_free(std::size_t column) {
  const int i = static_cast<int>(2 * rows_ + column);
  clp_->simplex.setColumnBounds(i, -COIN_DBL_MAX, COIN_DBL_MAX);
  clp_->simplex.setColumnStatus(i, ClpSimplex::isFree);
}

void ColumnProgram::allow_pivots(int most) {
  clp_->simplex.setMaximumIterations(most);
}

void ColumnProgram::set_cost(std::size_t column, double cost) {
  clp_->finite = clp_->finite && std::isfinite(cost);
  if (!clp_->finite) return;
  clp_->simplex.setObjectiveCoefficient(static_cast<int>(2 * rows_ + column), cost);
}

void ColumnProgram::bound_slacks(double most) {
  for (int i = 0; i < static_cast<int>(2 * rows_); ++i) {
    clp_->simplex.setColumnBounds(i, 0, most);
    clp_->simplex.setObjectiveCoefficient(i, 0);
  }
}

double ColumnProgram::least() const {
  return clp_->simplex.objectiveValue();
}

double ColumnProgram::value(std::size_t column) const {
  return clp_->simplex.getColSolution()[2 * rows_ + column];
}

bool ColumnProgram::is_basic(std::size_t column) const {
  return clp_->simplex.getColumnStatus(static_cast<int>(2 * rows_ + column)) == ClpSimplex::basic;
}

double ColumnProgram::price(std::size_t row) const {
  return clp_->simplex.getRowPrice()[row];
}

}  // namespace slipproof

#else

#include <stdexcept>

namespace slipproof {

struct ColumnProgram::Clp {};

ColumnProgram::ColumnProgram(const std::vector<double>& right_side, const std::vector<bool>&,
                             const std::vector<Column>&)
    : rows_(right_side.size()) {
  throw std::runtime_error("all solutions in space need linear programs, and this build is without Clp");
}

bool ColumnProgram::solve(double) {
  return false;
}
void ColumnProgram::make_free(std::size_t) {}
void ColumnProgram::allow_pivots(int) {}
bool ColumnProgram::is_basic(std::size_t) const {
  return false;
}
void ColumnProgram::set_cost(std::size_t, double) {}
void ColumnProgram::bound_slacks(double) {}
double ColumnProgram::least() const {
  return 0;
}
double ColumnProgram::value(std::size_t) const {
  return 0;
}
double ColumnProgram::price(std::size_t) const {
  return 0;
}

}  // namespace slipproof

#endif

namespace slipproof {
ColumnProgram::~ColumnProgram() = default;
}  // namespace slipproof
