// Sparse linear programs against the dense ones.
#include "base/algebra/sparse/sparse_program.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "base/algebra/linear_program.hpp"
#include "base/number/dice.hpp"

using namespace slipproof;

namespace {

Rational often_zero(Dice& dice) {
  return dice.chance(2) ? Rational(dice.number(-3, 3)) : Rational(0);
}

SparseProgram drawn_program(Dice& dice) {
  const int rows = dice.number(1, 5), columns = dice.number(1, 8);
  SparseProgram program;
  for (int i = 0; i < rows; ++i) program.right_side.push_back(often_zero(dice));
  for (int j = 0; j < columns; ++j) {
    ProgramColumn column{{}, Rational(dice.number(-1, 3)), dice.chance(6)};
    for (int i = 0; i < rows; ++i) {
      Rational value = often_zero(dice);
      if (!value.is_zero()) column.entries.emplace_back(static_cast<std::uint32_t>(i), std::move(value));
    }
    program.columns.push_back(std::move(column));
  }
  return program;
}

LinearOptimum dense_optimum(const SparseProgram& program) {
  const std::size_t n = program.columns.size();
  AffineForm objective{0, std::vector<Rational>(n)};
  std::vector<AffineForm> constraints;
  for (std::size_t j = 0; j < n; ++j) {
    objective.coefficients[j] = program.columns[j].cost;
    if (program.columns[j].is_free) continue;
    constraints.push_back({0, std::vector<Rational>(n)});
    constraints.back().coefficients[j] = 1;
  }
  for (std::uint32_t i = 0; i < program.rows(); ++i) {
    AffineForm row{-program.right_side[i], std::vector<Rational>(n)};
    for (std::size_t j = 0; j < n; ++j) {
      for (const auto& [at, value] : program.columns[j].entries) {
        if (at == i) row.coefficients[j] = value;
      }
    }
    constraints.push_back(row);
    row.constant = -row.constant;
    for (Rational& value : row.coefficients) value = -value;
    constraints.push_back(row);
  }
  return minimize(objective, constraints);
}

void check_multipliers(const SparseProgram& program, const SparseOptimum& found, bool costs) {
  for (const ProgramColumn& column : program.columns) {
    Rational rest = costs ? column.cost : Rational(0);
    for (const auto& [row, value] : column.entries) rest -= value * found.y[row];
    CHECK(rest.sign() >= 0);
    if (column.is_free) CHECK(rest.is_zero());
  }
}

void check_feasible(const SparseProgram& program, const SparseOptimum& found) {
  std::vector<Rational> sum(program.rows());
  for (std::size_t j = 0; j < program.columns.size(); ++j) {
    if (!program.columns[j].is_free) CHECK(found.x[j].sign() >= 0);
    for (const auto& [row, value] : program.columns[j].entries) sum[row] += value * found.x[j];
  }
  CHECK(sum == program.right_side);
}

}  // namespace

TEST_CASE("sparse programs have the optima of dense ones, with multipliers that prove them") {
  std::array<int, 3> kinds{};
  for (std::uint64_t round = 0; round < 2000; ++round) {
    Dice dice(20261127, round);
    const SparseProgram program = drawn_program(dice);
    std::vector<std::size_t> basis;
    for (std::size_t j = 0; j < program.columns.size() && basis.size() < program.rows(); ++j) {
      if (dice.chance(2)) basis.push_back(j);
    }
    Effort effort(unlimited);
    const SparseOptimum found = minimize(program, basis, effort);
    const LinearOptimum expected = dense_optimum(program);
    ++kinds[static_cast<std::size_t>(found.kind)];
    Rational pushed, cost;
    for (std::size_t i = 0; i < program.rows(); ++i) pushed += program.right_side[i] * found.y[i];
    for (std::size_t j = 0; j < program.columns.size(); ++j) cost += program.columns[j].cost * found.x[j];
    if (expected.kind == LinearOptimum::Kind::infeasible) {
      REQUIRE(found.kind == SparseOptimum::Kind::infeasible);
      check_multipliers(program, found, false);
      CHECK(pushed.sign() > 0);
      continue;
    }
    check_feasible(program, found);
    if (expected.kind == LinearOptimum::Kind::unbounded) {
      REQUIRE(found.kind == SparseOptimum::Kind::unbounded);
      Rational slope;
      for (std::size_t j = 0; j < program.columns.size(); ++j) {
        slope += program.columns[j].cost * found.direction[j];
        if (!program.columns[j].is_free) CHECK(found.direction[j].sign() >= 0);
      }
      CHECK(slope.sign() < 0);
    } else {
      REQUIRE(found.kind == SparseOptimum::Kind::optimal);
      CHECK(cost == expected.value);
      CHECK(pushed == expected.value);
      check_multipliers(program, found, true);
    }
  }
  CHECK(std::ranges::min(kinds) > 100);
}

TEST_CASE("a basis that is singular is repaired") {
  const SparseProgram program{{1, 2}, {{{{0, 1}}, 2, false}, {{{0, 2}}, 1, false}, {{{1, 1}}, 1, false}}};
  Effort effort(unlimited);
  const SparseOptimum found = minimize(program, {0, 1}, effort);
  REQUIRE(found.kind == SparseOptimum::Kind::optimal);
  CHECK(found.x == std::vector<Rational>{0, Rational(1) / 2, 2});
}

TEST_CASE("sparse programs stop at a limit of effort") {
  Dice dice(7, 0);
  SparseProgram program;
  std::vector<std::size_t> basis;
  for (std::size_t j = 0; j < 40; ++j) {
    program.right_side.emplace_back(dice.number(1, 9));
    ProgramColumn column;
    for (std::uint32_t i = 0; i < 40; ++i) column.entries.emplace_back(i, dice.number(1, 9));
    program.columns.push_back(std::move(column));
    basis.push_back(j);
  }
  Effort effort(1000);
  CHECK_THROWS_AS(minimize(program, basis, effort), TooMuchWork);
}
