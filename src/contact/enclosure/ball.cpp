#include "contact/enclosure/ball.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"
#include "contact/enclosure/fit.hpp"
#include "contact/linear/rounding.hpp"

namespace slipproof {

namespace {

/// The power of 2 that brings a size near 1.
double to_one(double size) {
  return std::ldexp(1.0, exponent_to_one(size));
}

/// An upper bound on the Euclidean norm, also where squares underflow.
double norm_above(std::span<const double> values) {
  double sum = 0;
  bool zero = true;
  for (const double v : values) {
    sum += v * v;
    zero = zero && v == 0;
  }
  return zero ? 0 : std::sqrt(rounded_up(sum, values.size()) + underflow_of(values.size())) * (1 + 0x1p-50);
}

/// One step of Newton's method, kept apart from z: what is left is far below the last place of z.
std::vector<double> correction_at(const ModeSystem& system, const SystemBlock& block, std::span<const double> z) {
  std::vector<double> correction = newton_step(system, block, z, system.x_at(z));
  for (double& d : correction) d = -d;
  return correction;
}

std::vector<Rational> corrected(const SystemBlock& block, std::span<const double> z,
                                std::span<const double> correction) {
  std::vector<Rational> exact = to_rationals(z);
  for (std::size_t j = 0; j < correction.size(); ++j) exact[block.unknowns[j]] += to_rational(correction[j]);
  return exact;
}

/// How far the block's equations are from 0: the norm of D F, evaluated without rounding.
double defect_at(const ModeSystem& system, const SystemBlock& block, const std::vector<Rational>& exact,
                 const SparseInverse& inverse) {
  std::vector<double> defects;
  for (std::size_t i = 0; i < block.equations.size(); ++i) {
    if (i % 1024 == 0) stop_if_asked();
    const double size = upper_size(system.value(block.equations[i], exact));
    defects.push_back(size == 0 ? 0 : inverse.rows[i] * size + std::numeric_limits<double>::denorm_min());
  }
  return norm_above(defects);
}

}  // namespace

bool is_large_and_sparse(const ModeSystem& system, const SystemBlock& block, std::span<const double> z,
                         std::size_t large) {
  if (large == 0) return block.unknowns.size() == block.equations.size();
  const std::size_t n = block.unknowns.size();
  if (n < large || n != block.equations.size()) return false;
  std::size_t entries = 0;
  for (const std::size_t e : block.equations) {
    entries += system.derivative(e, z).size();
    if (entries > n * n / 20) return false;
  }
  return true;
}

std::shared_ptr<const SparseInverse> sparse_inverse(const ModeSystem& system, const SystemBlock& block,
                                                    std::span<const double> z) {
  const std::size_t n = block.unknowns.size();
  std::vector<std::size_t> place(system.size(), ModeSystem::none);
  for (std::size_t j = 0; j < n; ++j) place[block.unknowns[j]] = j;
  std::vector<MatrixEntry> entries, twice;
  std::vector<double> rows(n, 0), columns(n, 0), errors;
  std::vector<DerivativeError> changed;
  for (std::size_t i = 0; i < n; ++i) {
    for (const auto& e : system.derivative(block.equations[i], z)) {
      const std::size_t j = place[e.unknown];
      if (j == ModeSystem::none) continue;  // pinned
      entries.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), e.value});
      if (e.error > 0) changed.push_back({i, j, e.error});
      rows[i] = std::max(rows[i], std::abs(e.value));
    }
  }
  for (double& r : rows) r = to_one(r);
  for (const MatrixEntry& e : entries) columns[e.column] = std::max(columns[e.column], std::abs(e.value) * rows[e.row]);
  for (double& c : columns) c = to_one(c);
  for (MatrixEntry& e : entries) e.value *= rows[e.row] * columns[e.column];
  for (const DerivativeError& e : changed) errors.push_back(e.amount * rows[e.equation] * columns[e.unknown]);
  const auto scaled = [](double x) { return std::isfinite(x) && (x == 0 || std::abs(x) > 0x1p-1000); };
  if (!std::all_of(entries.begin(), entries.end(), [&](const MatrixEntry& e) { return scaled(e.value); })) return {};
  SparseMatrix matrix = sparse_matrix(n, n, std::move(entries), twice);
  auto factor = SparseFactor::of(matrix);
  if (!factor || !(guessed_singular_value(n, *factor) > 1e-13)) return {};
  return std::make_shared<const SparseInverse>(
      SparseInverse{std::move(matrix), std::move(rows), std::move(columns), norm_above(errors), std::move(*factor)});
}

std::optional<KrawczykBox> enclose_in_ball(const ModeSystem& system, const SystemBlock& block,
                                           std::span<const double> z) {
  const SparseInverse& inverse = *block.sparse;
  const auto least = least_singular_value(inverse.matrix, inverse.factor);
  if (!least || !(*least > 2 * inverse.error)) return std::nullopt;
  const double s = (*least - inverse.error) * (1 - 0x1p-50);

  const std::vector<double> correction = correction_at(system, block, z);
  const double defect = defect_at(system, block, corrected(block, z, correction), inverse);

  // |D Q(E y)| <= curvature |y|^2: each contact has three such terms at most, in unknowns of its own.
  std::vector<double> unit(system.size(), 0);
  for (std::size_t j = 0; j < block.unknowns.size(); ++j) unit[block.unknowns[j]] = inverse.columns[j];
  double curvature = 0;
  for (std::size_t i = 0; i < block.equations.size(); ++i) {
    curvature = std::max(curvature, inverse.rows[i] * system.second_order(block.equations[i], unit) * (1 + 0x1p-40));
  }
  curvature *= 2;  // above the root of 3
  // The derivative at z + correction is another one than at z, by 2 curvature times the correction at most.
  std::vector<double> moved;
  for (std::size_t j = 0; j < correction.size(); ++j) moved.push_back(correction[j] / inverse.columns[j]);
  const double slope = s - 2 * curvature * norm_above(moved) * (1 + 0x1p-40);
  if (!(slope > 0)) return std::nullopt;
  const double radius = std::max(defect / slope * (1 + 0x1p-20), 0x1p-900);
  if (!((slope - curvature * radius) * (1 - 0x1p-50) * radius >= defect)) return std::nullopt;
  KrawczykBox box;
  box.unique = 2 * curvature * radius < slope * (1 - 0x1p-50);
  for (std::size_t j = 0; j < correction.size(); ++j) {
    box.radius.push_back((std::abs(correction[j]) + inverse.columns[j] * radius) * (1 + 0x1p-50) + 0x1p-1060);
  }
  return box;
}

std::optional<BallProof> prove_in_ball(const Enclosure& box) {
  const ModeSystem& system = box.system;
  std::vector<bool> pinned(system.size(), false), dropped(system.size(), false);
  for (const std::size_t j : box.pinned) pinned[j] = true;
  for (const DroppedEquation& d : box.dropped) dropped[d.equation] = true;
  SystemBlock whole;
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (!pinned[i]) whole.unknowns.push_back(i);
    if (!dropped[i]) whole.equations.push_back(i);
  }
  whole.sparse = sparse_inverse(system, whole, box.center);
  if (!whole.sparse) return std::nullopt;
  const SparseInverse& inverse = *whole.sparse;
  auto singular = prove_singular_value(inverse.matrix, inverse.factor);
  if (!singular) return std::nullopt;
  BallProof proof;
  proof.center = corrected(whole, box.center, correction_at(system, whole, box.center));
  const double defect = defect_at(system, whole, proof.center, inverse);
  // Not so small that its square underflows, even where the center is exact.
  const double scale = std::ldexp(1.0, std::ilogb(std::max(defect / singular->value, 0x1p-300)) + 2);
  proof.radius.assign(system.size(), 1);
  for (std::size_t j = 0; j < whole.unknowns.size(); ++j) proof.radius[whole.unknowns[j]] = inverse.columns[j] * scale;
  std::vector<double> moved = proof.radius, bends;
  for (const std::size_t j : box.pinned) moved[j] = 0;
  for (std::size_t i = 0; i < whole.equations.size(); ++i) {
    proof.rows.push_back(inverse.rows[i] / scale);
    bends.push_back(proof.rows[i] * system.second_order(whole.equations[i], moved) * (1 + 0x1p-40));
  }
  proof.least = singular->value;
  proof.defect = defect / scale;
  proof.bend = norm_above(bends);
  proof.grid = singular->grid;
  proof.order = std::move(singular->order);
  if (!(proof.defect + proof.bend < proof.least)) return std::nullopt;
  return proof;
}

}  // namespace slipproof
