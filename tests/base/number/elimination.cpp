#include "base/algebra/elimination.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "base/algebra/integer_polynomial.hpp"

using namespace slipproof;

namespace {

class Matrices {
 public:
  std::size_t below(std::size_t n) { return engine_() % n; }
  /// Small numbers, many of them 0; some rows are sums of others.
  RationalMatrix next(std::size_t rows, std::size_t columns) {
    RationalMatrix matrix(rows, std::vector<Rational>(columns));
    for (std::size_t i = 0; i < rows; ++i) {
      const bool depends = i > 1 && below(4) == 0;
      for (std::size_t j = 0; j < columns; ++j) {
        matrix[i][j] = depends ? matrix[i - 1][j] - 2 * matrix[i - 2][j] : entry();
      }
    }
    return matrix;
  }

 private:
  Rational entry() { return below(3) == 0 ? Rational(0) : Rational(Integer(below(19)) - 9, Integer(1 + below(4))); }
  std::mt19937_64 engine_{11};
};

/// The sum over all permutations.
Rational leibniz(const RationalMatrix& m) {
  std::vector<std::size_t> order(m.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  Rational sum = 0;
  do {
    Rational term = 1;
    for (std::size_t i = 0; i < order.size(); ++i) {
      term *= m[i][order[i]];
      for (std::size_t k = 0; k < i; ++k) term *= order[k] > order[i] ? -1 : 1;
    }
    sum += term;
  } while (std::ranges::next_permutation(order).found);
  return sum;
}

bool is_combination(std::vector<Rational> row, const Echelon& echelon) {
  for (std::size_t i = 0; i < echelon.rank(); ++i) {
    const Rational factor = row[echelon.pivot_columns[i]] / Rational(echelon.pivot);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] -= factor * Rational(echelon.rows[i][j]);
  }
  return std::ranges::all_of(row, [](const Rational& x) { return x.is_zero(); });
}

}  // namespace

TEST_CASE("elimination: the form is reduced, spans the rows, and has the rank of the largest minor that is not 0") {
  Matrices matrices;
  for (int round = 0; round < 300; ++round) {
    const std::size_t rows = 1 + matrices.below(6), columns = 1 + matrices.below(6);
    const RationalMatrix matrix = matrices.next(rows, columns);
    const Echelon echelon = eliminate(matrix);
    REQUIRE(std::ranges::is_sorted(echelon.pivot_columns));
    CHECK(echelon.pivot != 0);
    for (std::size_t i = 0; i < rows; ++i) {
      CHECK(is_combination(matrix[i], echelon));
      for (std::size_t k = 0; k < echelon.rank(); ++k) {
        CHECK(echelon.rows[i][echelon.pivot_columns[k]] == (i == k ? echelon.pivot : Integer(0)));
      }
      const std::size_t first = i < echelon.rank() ? echelon.pivot_columns[i] : columns;
      CHECK(std::all_of(echelon.rows[i].begin(), echelon.rows[i].begin() + static_cast<std::ptrdiff_t>(first),
                        [](const Integer& x) { return x.is_zero(); }));
    }
    RationalMatrix transposed(columns, std::vector<Rational>(rows));
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) transposed[j][i] = matrix[i][j];
    }
    CHECK(eliminate(transposed).rank() == echelon.rank());
    if (rows == columns) CHECK((echelon.rank() == rows) == !leibniz(matrix).is_zero());
  }
  CHECK(eliminate(RationalMatrix()).rank() == 0);
}

TEST_CASE("elimination: right-hand sides have solutions if they add no rank") {
  const Echelon solvable = eliminate(RationalMatrix{{1, 2, 5}, {2, 4, 10}, {1, 3, 7}});
  CHECK((solvable.rank() == 2 && solvable.rank(2) == 2));
  CHECK(Rational(solvable.rows[0][2], solvable.pivot) == 1);
  CHECK(Rational(solvable.rows[1][2], solvable.pivot) == 2);
  const Echelon none = eliminate(RationalMatrix{{1, 2, 5}, {2, 4, 11}});
  CHECK((none.rank() == 2 && none.rank(2) == 1));
}

TEST_CASE("determinants of numbers, of polynomials, and by steps of Bareiss's are those of Leibniz's sum") {
  Matrices matrices;
  for (int round = 0; round < 200; ++round) {
    const std::size_t size = 1 + matrices.below(5);
    const RationalMatrix constant = matrices.next(size, size), slope = matrices.next(size, size);
    CHECK(determinant(constant) == leibniz(constant));
    std::vector<std::vector<IntegerPolynomial>> lines(size);
    RationalMatrix at_two = constant;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        lines[i].emplace_back(numerator(constant[i][j]), numerator(slope[i][j]));
        at_two[i][j] = numerator(constant[i][j]) + 2 * numerator(slope[i][j]);
      }
    }
    const IntegerPolynomial p = determinant(lines);
    Rational value = 0;
    for (long power = p.degree(); power >= 0; --power) value = 2 * value + p.coefficient(power);
    CHECK(value == leibniz(at_two));
    IntegerMatrix left;
    for (const auto& row : at_two) left.push_back(clear_denominators(row));
    Integer previous = 1;
    while (left.size() > 1 && !left[0][0].is_zero()) {
      IntegerMatrix next = eliminated_once(left, 0, previous);
      previous = left[0][0];
      left = std::move(next);
    }
    if (left.size() == 1) CHECK(Rational(left[0][0]) == leibniz(at_two));
  }
}
