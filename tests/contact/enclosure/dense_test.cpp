// Products and inverses of dense matrices against plain loops.
#include "contact/linear/dense.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/number/dice.hpp"

using namespace slipproof;

namespace {

DenseMatrix random_matrix(Dice& dice, std::size_t n) {
  DenseMatrix matrix(n);
  for (double& x : matrix.value) x = dice.number(-999, 999) / 7.0;
  return matrix;
}

/// Each product is rounded, and subtracted after the one before it.
double plain_defect(const DenseMatrix& R, const DenseMatrix& A, std::size_t i, std::size_t j) {
  double left = i == j ? 1 : 0;
  for (std::size_t k = 0; k < A.size; ++k) left -= R.row(i)[k] * A.row(k)[j];
  return std::abs(left);
}

}  // namespace

TEST_CASE("a dense defect has the bits of a plain loop, in the registers of this machine") {
  for (const std::size_t n : {1U, 2U, 3U, 4U, 5U, 7U, 8U, 9U, 15U, 16U, 17U, 31U, 32U, 33U, 66U, 101U}) {
    CAPTURE(n);
    Dice dice(31, n);
    const DenseMatrix A = random_matrix(dice, n), R = random_matrix(dice, n), defect = absolute_defect(R, A);
    bool same = true;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) same = same && defect.row(i)[j] == plain_defect(R, A, i, j);
    }
    CHECK(same);
  }
}

TEST_CASE("a dense inverse is one, and where there is none it is not finite or its defect is large") {
  for (const std::size_t n : {1U, 2U, 3U, 5U, 16U, 31U, 32U, 33U, 64U, 65U, 130U}) {
    CAPTURE(n);
    Dice dice(32, n);
    DenseMatrix A = random_matrix(dice, n);
    for (std::size_t i = 0; i < n; ++i) std::swap(A.row(i)[i], A.row(i)[n - 1 - i]);  // pivots away from the diagonal
    const std::vector<double> defect = absolute_defect(approximate_inverse(A), A).value;
    CHECK(*std::ranges::max_element(defect) < 1e-8);
    std::ranges::copy(A.row(0), A.row(n - 1).begin());  // two rows alike
    if (n == 1) A.row(0)[0] = 0;
    const std::vector<double> none = absolute_defect(approximate_inverse(A), A).value;
    CHECK(std::ranges::any_of(none, [](double x) { return !(x < 0.01); }));
  }
}
