// Exact matrices and vectors in binary64.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "base/algebra/elimination.hpp"
#include "base/number/binary64.hpp"

namespace slipproof::test {

inline Eigen::MatrixXd dense(const RationalMatrix& matrix, Eigen::Index rows) {
  Eigen::MatrixXd result(rows, matrix.empty() ? 0 : static_cast<Eigen::Index>(matrix[0].size()));
  for (Eigen::Index i = 0; i < result.rows() && result.cols() > 0; ++i) {
    for (Eigen::Index j = 0; j < result.cols(); ++j) {
      result(i, j) = nearest_binary64(matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    }
  }
  return result;
}

inline Eigen::VectorXd dense(const std::vector<Rational>& vector) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(vector.size()));
  for (Eigen::Index i = 0; i < result.size(); ++i) result(i) = nearest_binary64(vector[static_cast<std::size_t>(i)]);
  return result;
}

}  // namespace slipproof::test
