#include "contact/linear/dense.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "floating/lanes/lane_vectors.hpp"
#include "floating/lanes/vector_kernel.hpp"

namespace slipproof {

namespace {

constexpr std::size_t strip = 32;  // rows or columns that are eliminated together

/// Rows `stride` numbers apart.
struct Part {
  double* first;
  std::size_t rows, columns, stride;
  double* row(std::size_t i) const { return first + i * stride; }
};

Part part(DenseMatrix& matrix, std::size_t row, std::size_t rows, std::size_t column, std::size_t columns) {
  return {matrix.value.data() + row * matrix.size + column, rows, columns, matrix.size};
}

/// C -= A B. A library's product adds in an order that depends on the registers, and fuses where they can; starts of a
/// search, and so verdicts, would depend on the processor. Here the products of an entry are subtracted one after the
/// other and rounded each, in registers of any width: the same bits.
struct SubtractProduct {
  template <int width>
  static void run(const Part& C, const Part& A, const Part& B) {
    for (std::size_t l = 0; l < A.columns; l += strip) {
      const std::size_t depth = std::min(strip, A.columns - l);
      for (std::size_t j = 0; j < C.columns; j += 2 * width) {
        Strip<width> packed{};
        const std::size_t columns = std::min<std::size_t>(2 * width, C.columns - j);
        for (std::size_t k = 0; k < depth; ++k) {
          std::memcpy(packed.data() + k * 2 * width, B.row(l + k) + j, columns * sizeof(double));
        }
        std::size_t i = 0;
        for (; i + 4 <= C.rows; i += 4)
          tile<width, 4>(C.row(i) + j, C.stride, columns, A.row(i) + l, A.stride, packed, depth);
        for (; i < C.rows; ++i) tile<width, 1>(C.row(i) + j, C.stride, columns, A.row(i) + l, A.stride, packed, depth);
      }
    }
  }

 private:
  template <int width>
  using Strip = std::array<double, strip * 2 * width>;

  /// A narrower tile is computed in a copy that is as wide as the others.
  template <int width, std::size_t rows>
  static void tile(double* c, std::size_t c_stride, std::size_t columns, const double* a, std::size_t a_stride,
                   const Strip<width>& b, std::size_t depth) {
    if (columns == 2 * width) return whole_tile<width, rows>(c, c_stride, a, a_stride, b, depth);
    std::array<double, rows * 2 * width> copy{};
    for (std::size_t r = 0; r < rows; ++r)
      std::memcpy(copy.data() + r * 2 * width, c + r * c_stride, columns * sizeof(double));
    whole_tile<width, rows>(copy.data(), 2 * width, a, a_stride, b, depth);
    for (std::size_t r = 0; r < rows; ++r)
      std::memcpy(c + r * c_stride, copy.data() + r * 2 * width, columns * sizeof(double));
  }

  template <int width, std::size_t rows>
  static void whole_tile(double* c, std::size_t c_stride, const double* a, std::size_t a_stride, const Strip<width>& b,
                         std::size_t depth) {
    using V = typename LaneTypes<width>::Numbers;
    V left[rows], right[rows];
#pragma GCC unroll 4
    for (std::size_t r = 0; r < rows; ++r) {
      std::memcpy(&left[r], c + r * c_stride, sizeof(V));
      std::memcpy(&right[r], c + r * c_stride + width, sizeof(V));
    }
    for (std::size_t k = 0; k < depth; ++k) {
      V b_left, b_right;
      std::memcpy(&b_left, b.data() + k * 2 * width, sizeof(V));
      std::memcpy(&b_right, b.data() + k * 2 * width + width, sizeof(V));
#pragma GCC unroll 4
      for (std::size_t r = 0; r < rows; ++r) {
        const V factor = in_all_lanes<V>(a[r * a_stride + k]);
        left[r] -= factor * b_left;
        right[r] -= factor * b_right;
      }
    }
#pragma GCC unroll 4
    for (std::size_t r = 0; r < rows; ++r) {
      std::memcpy(c + r * c_stride, &left[r], sizeof(V));
      std::memcpy(c + r * c_stride + width, &right[r], sizeof(V));
    }
  }
};

void subtract_product(const Part& C, const Part& A, const Part& B) {
  VectorKernel<SubtractProduct>::run(widest_registers(), C, A, B);
}

/// row -= factor * other
void subtract_row(double* row, double factor, const double* other, std::size_t size) {
  for (std::size_t j = 0; j < size; ++j) row[j] -= factor * other[j];
}

/// Gaussian elimination with partial pivoting, P A = L U, in blocks: most of its work is products.
class Elimination {
 public:
  explicit Elimination(DenseMatrix& matrix) : A_(matrix), n_(matrix.size), order_(n_) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (std::size_t b = 0; b < n_; b += strip) {
      const std::size_t end = std::min(b + strip, n_);
      for (std::size_t j = b; j < end; ++j) eliminate(j, end);
      for (std::size_t i = b; i < end; ++i) {
        for (std::size_t l = b; l < i; ++l) subtract_row(at(i, end), *at(i, l), at(l, end), n_ - end);
      }
      subtract_product(part(A_, end, n_ - end, end, n_ - end), part(A_, end, n_ - end, b, end - b),
                       part(A_, b, end - b, end, n_ - end));
    }
  }

  /// X with L U X = P.
  DenseMatrix inverse() {
    DenseMatrix X(n_);
    for (std::size_t i = 0; i < n_; ++i) X.row(i)[order_[i]] = 1;
    for (std::size_t b = 0; b < n_; b += strip) {
      const std::size_t end = std::min(b + strip, n_);
      subtract_product(part(X, b, end - b, 0, n_), part(A_, b, end - b, 0, b), part(X, 0, b, 0, n_));
      for (std::size_t i = b; i < end; ++i) {
        for (std::size_t l = b; l < i; ++l) subtract_row(X.row(i).data(), *at(i, l), X.row(l).data(), n_);
      }
    }
    for (std::size_t end = n_; end > 0;) {
      const std::size_t b = (end - 1) / strip * strip;
      subtract_product(part(X, b, end - b, 0, n_), part(A_, b, end - b, end, n_ - end), part(X, end, n_ - end, 0, n_));
      for (std::size_t i = end; i-- > b;) {
        for (std::size_t l = i + 1; l < end; ++l) subtract_row(X.row(i).data(), *at(i, l), X.row(l).data(), n_);
        for (double& x : X.row(i)) x /= *at(i, i);
      }
      end = b;
    }
    return X;
  }

 private:
  double* at(std::size_t i, std::size_t j) { return A_.value.data() + i * n_ + j; }

  /// Column j from the rows below, as far as column `end`.
  void eliminate(std::size_t j, std::size_t end) {
    std::size_t pivot = j;
    for (std::size_t i = j + 1; i < n_; ++i) {
      if (std::abs(*at(i, j)) > std::abs(*at(pivot, j))) pivot = i;
    }
    if (pivot != j) {
      std::ranges::swap_ranges(A_.row(j), A_.row(pivot));
      std::swap(order_[j], order_[pivot]);
    }
    for (std::size_t i = j + 1; i < n_; ++i) {
      *at(i, j) /= *at(j, j);
      subtract_row(at(i, j + 1), *at(i, j), at(j, j + 1), end - j - 1);
    }
  }

  DenseMatrix& A_;
  std::size_t n_;
  std::vector<std::size_t> order_;
};

}  // namespace

DenseMatrix approximate_inverse(DenseMatrix matrix) {
  return Elimination(matrix).inverse();
}

DenseMatrix absolute_defect(const DenseMatrix& R, const DenseMatrix& A) {
  DenseMatrix result(A.size), left = R, right = A;
  for (std::size_t i = 0; i < A.size; ++i) result.row(i)[i] = 1;
  subtract_product(part(result, 0, A.size, 0, A.size), part(left, 0, A.size, 0, A.size),
                   part(right, 0, A.size, 0, A.size));
  for (double& x : result.value) x = std::abs(x);
  return result;
}

}  // namespace slipproof
