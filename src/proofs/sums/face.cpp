#include "proofs/sums/face.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "base/number/simplest.hpp"

namespace slipproof::prove::sums {

namespace {

using Eigen::MatrixXd;
using Spectrum = Eigen::SelfAdjointEigenSolver<MatrixXd>;

Spectrum spectrum_of(const DenseBlock& block) {
  const auto size = static_cast<Eigen::Index>(std::lround(std::sqrt(static_cast<double>(block.size()))));
  return Spectrum(Eigen::Map<const MatrixXd>(block.data(), size, size));
}

/// The simplest number near x, if it is simple.
std::optional<Rational> guessed(double x) {
  constexpr double within = 2e-3;
  constexpr int tallest = 64;
  if (!std::isfinite(x) || std::fabs(x) > tallest) return std::nullopt;
  if (std::fabs(x) < within) return Rational(0);
  const Rational result = simplest_between(to_rational(x - within), to_rational(x + within));
  if (height(result) > tallest) return std::nullopt;
  return result;
}

/// Rows e_p + the others, for a pivot p of each: the row space of `vectors`.
struct PivotForm {
  std::vector<Eigen::Index> pivots;
  MatrixXd rows;
};

PivotForm pivot_form(MatrixXd vectors) {
  PivotForm result;
  for (Eigen::Index k = 0; k < vectors.rows(); ++k) {
    Eigen::Index row = 0, column = 0;
    vectors.bottomRows(vectors.rows() - k).cwiseAbs().maxCoeff(&row, &column);
    vectors.row(k).swap(vectors.row(k + row));
    vectors.row(k) /= vectors(k, column);
    for (Eigen::Index i = 0; i < vectors.rows(); ++i) {
      if (i != k) vectors.row(i) -= Eigen::RowVectorXd(vectors.row(k)) * vectors(i, column);
    }
    result.pivots.push_back(column);
  }
  result.rows = std::move(vectors);
  return result;
}

/// What is orthogonal to the kernel, in the basis.
std::optional<std::vector<Polynomial>> orthogonal_basis(const std::vector<Polynomial>& basis, const MatrixXd& kernel) {
  const PivotForm form = pivot_form(kernel.transpose());
  std::vector<Polynomial> result;
  for (std::size_t f = 0; f < basis.size(); ++f) {
    const auto column = static_cast<Eigen::Index>(f);
    if (std::find(form.pivots.begin(), form.pivots.end(), column) != form.pivots.end()) continue;
    Polynomial sum = basis[f];
    for (std::size_t k = 0; k < form.pivots.size(); ++k) {
      const auto factor = guessed(form.rows(static_cast<Eigen::Index>(k), column));
      if (!factor) return std::nullopt;
      sum -= basis[static_cast<std::size_t>(form.pivots[k])].scaled(*factor);
    }
    result.push_back(std::move(sum));
  }
  return result;
}

}  // namespace

std::optional<Ansatz> restricted_to_face(const Ansatz& ansatz, const MatrixPoint& point, double threshold) {
  std::vector<Spectrum> spectra;
  double largest = 0;
  for (const DenseBlock& block : point.blocks) {
    spectra.push_back(spectrum_of(block));
    largest = std::max(largest, spectra.back().eigenvalues().maxCoeff());
  }
  Ansatz result{{}, ansatz.multiples};
  bool smaller = false, strict = false;
  for (std::size_t b = 0; b < spectra.size(); ++b) {
    const auto in_kernel = (spectra[b].eigenvalues().array() <= threshold * largest).count();
    Block block = ansatz.blocks[b];
    if (in_kernel > 0) {
      auto basis = orthogonal_basis(block.basis, spectra[b].eigenvectors().leftCols(in_kernel));
      if (!basis) return std::nullopt;
      block.basis = std::move(*basis);
      smaller = true;
    }
    if (block.basis.empty()) continue;
    strict = strict || block.strict;
    result.blocks.push_back(std::move(block));
  }
  return smaller && strict ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace slipproof::prove::sums
