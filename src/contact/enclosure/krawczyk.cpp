#include "contact/enclosure/krawczyk.hpp"

#include <algorithm>
#include <cmath>

#include "base/algebra/union_find.hpp"
#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"
#include "contact/enclosure/ball.hpp"
#include "contact/linear/rounding.hpp"

namespace slipproof {

namespace {

double dot(std::span<const double> a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t j = 0; j < b.size(); ++j) sum += a[j] * b[j];
  return sum;
}

double absolute_dot(std::span<const double> a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t j = 0; j < b.size(); ++j) sum += std::abs(a[j]) * b[j];
  return sum;
}

/// The test for one block. |R F| <= `step` + |R| `residual_error`, and all that multiplies |R| is summed up first.
class KrawczykTest {
 public:
  KrawczykTest(const ModeSystem& system, const SystemBlock& block, std::span<const double> z)
      : system_(system), block_(block), n_(block.unknowns.size()), J_(block_derivative(system, block, z, &errors_)) {
    const std::vector<double> x = system.x_at(z);
    for (const std::size_t e : block.equations) F_.push_back(system.nearest_value(e, z, x));
    defect_ = absolute_defect(block.inverse, J_);
    for (std::size_t j = 0; j < n_; ++j) step_.push_back(std::abs(dot(block.inverse.row(j), F_)));
  }

  std::optional<KrawczykBox> run() {
    radius_.assign(n_, 0);
    std::vector<double> bound = bound_with(1);
    for (int attempt = 0; attempt < 12; ++attempt) {
      for (std::size_t j = 0; j < n_; ++j) radius_[j] = std::max(1.25 * bound[j], 0x1p-900);
      bound = bound_with(1);
      if (inside(bound)) return KrawczykBox{radius_, inside(bound_with(2))};
    }
    return std::nullopt;
  }

 private:
  /// The bound on |K - z| of contact/MATHEMATICS.md; `order` times the terms of second order: 1 for a zero, 2 for its
  /// uniqueness.
  std::vector<double> bound_with(double order) const {
    stop_if_asked();
    const std::vector<double> all = radius_of_all();
    const double underflow = underflow_of(n_);
    double sum_of_radii = 0;
    for (const double r : radius_) sum_of_radii += r;
    std::vector<double> inner(n_, 0);
    for (const DerivativeError& e : errors_) inner[e.equation] += e.amount * radius_[e.unknown];
    for (std::size_t i = 0; i < n_; ++i) {
      double error = inner[i] + gamma_of(n_) * std::abs(F_[i]);  // of the sums R F, and of F's own rounding
      error += gamma_of(n_) * absolute_dot(J_.row(i), radius_);
      error += order * system_.second_order(block_.equations[i], all);
      inner[i] = rounded_up(error, n_) + underflow;
    }
    std::vector<double> bound(n_);
    for (std::size_t j = 0; j < n_; ++j) {
      const double sum = step_[j] + dot(defect_.row(j), radius_) + gamma_of(n_) * radius_[j] +
                         absolute_dot(block_.inverse.row(j), inner);
      bound[j] = rounded_up(sum, n_) + underflow * (1 + sum_of_radii);
    }
    return bound;
  }

  std::vector<double> radius_of_all() const {
    std::vector<double> all(system_.size(), 0);
    for (std::size_t j = 0; j < n_; ++j) all[block_.unknowns[j]] = radius_[j];
    return all;
  }

  /// Strictly, which makes R invertible, too; false where anything is NaN.
  bool inside(const std::vector<double>& bound) const {
    for (std::size_t j = 0; j < n_; ++j) {
      if (!(bound[j] < radius_[j])) return false;
    }
    return true;
  }

  const ModeSystem& system_;
  const SystemBlock& block_;
  const std::size_t n_;
  std::vector<DerivativeError> errors_;
  DenseMatrix J_, defect_;
  std::vector<double> F_, step_, radius_;
};

}  // namespace

std::vector<SystemBlock> blocks_of(const ModeSystem& system, std::span<const double> z, const std::vector<bool>& pinned,
                                   const std::vector<bool>& dropped) {
  UnionFind parts(2 * system.size());  // unknowns, then equations
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (dropped[i]) continue;
    for (const auto& entry : system.derivative(i, z)) {
      if (entry.value != 0 && !pinned[entry.unknown]) parts.join(system.size() + i, entry.unknown);
    }
  }
  std::vector<std::size_t> block_of(2 * system.size(), ModeSystem::none);
  std::vector<SystemBlock> blocks;
  const auto block = [&](std::size_t i) -> SystemBlock& {
    std::size_t& number = block_of[parts.find(i)];
    if (number == ModeSystem::none) {
      number = blocks.size();
      blocks.emplace_back();
    }
    return blocks[number];
  };
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (!pinned[i]) block(i).unknowns.push_back(i);
  }
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (!dropped[i]) block(system.size() + i).equations.push_back(i);
  }
  return blocks;
}

DenseMatrix block_derivative(const ModeSystem& system, const SystemBlock& block, std::span<const double> z,
                             std::vector<DerivativeError>* errors) {
  DenseMatrix J(block.unknowns.size());
  std::vector<std::size_t> place(system.size(), ModeSystem::none);
  for (std::size_t j = 0; j < block.unknowns.size(); ++j) place[block.unknowns[j]] = j;
  for (std::size_t i = 0; i < block.equations.size(); ++i) {
    for (const auto& entry : system.derivative(block.equations[i], z)) {
      const std::size_t j = place[entry.unknown];
      if (j == ModeSystem::none) continue;  // pinned
      J.row(i)[j] = entry.value;
      if (errors != nullptr && entry.error > 0) errors->push_back({i, j, entry.error});
    }
  }
  return J;
}

std::vector<double> newton_step(const ModeSystem& system, const SystemBlock& block, std::span<const double> z,
                                std::span<const double> x) {
  std::vector<double> F, step;
  for (const std::size_t e : block.equations) F.push_back(system.nearest_value(e, z, x));
  if (block.sparse) {
    for (std::size_t i = 0; i < F.size(); ++i) F[i] *= block.sparse->rows[i];
    step = block.sparse->factor.solve(F);
    for (std::size_t j = 0; j < step.size(); ++j) step[j] *= block.sparse->columns[j];
    return step;
  }
  for (std::size_t j = 0; j < block.unknowns.size(); ++j) step.push_back(dot(block.inverse.row(j), F));
  return step;
}

std::optional<KrawczykBox> krawczyk(const ModeSystem& system, const SystemBlock& block, std::span<const double> z) {
  return KrawczykTest(system, block, z).run();
}

}  // namespace slipproof
