#include "contact/path/long_test.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/algebra/flint_matrix.hpp"
#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"
#include "contact/enclosure/fit.hpp"
#include "contact/linear/rounding.hpp"
#include "contact/path/long_number.hpp"
#include "contact/path/point.hpp"

namespace slipproof {

namespace {

using Eigen::Index;

/// So that no product of radii and scales underflows.
constexpr double least_radius = 0x1p-300;
constexpr int largest_exponent = 100;

}  // namespace

/// A block's derivative with rows and columns scaled, exactly.
struct LongTest::ScaledDerivative {
  std::vector<std::vector<std::pair<std::size_t, Rational>>> entries;  ///< of each equation, unknowns of the block
  std::vector<int> rows, columns;

  ScaledDerivative(const ModeSystem& system, const SystemBlock& block, std::span<const Rational> z)
      : rows(block.equations.size(), 0), columns(block.unknowns.size(), 0) {
    std::vector<std::size_t> place(system.size(), ModeSystem::none);
    for (std::size_t j = 0; j < block.unknowns.size(); ++j) place[block.unknowns[j]] = j;
    std::vector<double> largest(columns.size(), 0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      double size = 0;
      entries.emplace_back();
      for (auto& [unknown, value] : system.exact_derivative(block.equations[i], z)) {
        if (place[unknown] == ModeSystem::none || value.is_zero()) continue;
        const bool slips = system.place(unknown) == ModeSystem::none;  // a column of its own size: by its own scale
        if (!slips) size = std::max(size, std::abs(nearest_binary64(value)));
        entries.back().emplace_back(place[unknown], std::move(value));
      }
      rows[i] = exponent_to_one(size);
      for (auto& [j, value] : entries[i]) {
        value *= power_of_two(rows[i]);
        largest[j] = std::max(largest[j], std::abs(nearest_binary64(value)));
      }
    }
    for (std::size_t j = 0; j < columns.size(); ++j) columns[j] = exponent_to_one(largest[j]);
    for (auto& row : entries) {
      for (auto& [j, value] : row) value *= power_of_two(columns[j]);
    }
  }

  LongMatrix matrix() const {
    LongMatrix J = LongMatrix::Zero(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (const auto& [j, value] : entries[i])
        J(static_cast<Index>(i), static_cast<Index>(j)) = to_double_double(value);
    }
    return J;
  }
};

DependentPart dependent_in_long_numbers(const ModeSystem& system, const SystemBlock& block,
                                        std::span<const Rational> z) {
  LongMatrix J = LongTest::ScaledDerivative(system, block, z).matrix();
  // An equation that no unknown of the block is in holds or fails by its constant; an unknown that is in no equation
  // may have any value.
  if (J.size() == 0) return {block.equations, block.unknowns, true};
  for (std::size_t i = 0; i < block.equations.size(); ++i) {
    if (system.equations()[block.equations[i]].kind == ModeSystem::Kind::linear) continue;
    J.row(static_cast<Index>(i)) *= DoubleDouble(64);
  }
  Eigen::FullPivLU<LongMatrix> lu(J);
  lu.setThreshold(DoubleDouble(1e-26));
  DependentPart part;
  part.regular = true;
  const auto& rows = lu.permutationP().indices();  // row i goes to rows[i]
  const auto& columns = lu.permutationQ().indices();
  for (Index i = 0; i < rows.size(); ++i) {
    if (rows[i] >= lu.rank()) part.equations.push_back(block.equations[static_cast<std::size_t>(i)]);
  }
  for (Index j = lu.rank(); j < columns.size(); ++j) {
    part.unknowns.push_back(block.unknowns[static_cast<std::size_t>(columns[j])]);
  }
  std::sort(part.unknowns.begin(), part.unknowns.end());
  return part;
}

LongTest::LongTest(const ModeSystem& system, const SystemBlock& block, std::vector<Rational>& z, Inverse inverse)
    : system_(system),
      block_(block),
      z_(z),
      is_exact_(inverse == Inverse::exact),
      n_(block.unknowns.size()),
      defect_(n_),
      size_(n_) {}

std::optional<KrawczykBox> LongTest::run() {
  if (!improve() || !invert()) return std::nullopt;
  measure();
  radius_.assign(n_, 0);
  std::vector<double> bound = bound_with(1);
  for (int attempt = 0; attempt < 12; ++attempt) {
    for (std::size_t j = 0; j < n_; ++j) radius_[j] = std::max(1.25 * bound[j], least_radius);
    bound = bound_with(1);
    if (!inside(bound)) continue;
    KrawczykBox box{radius_, inside(bound_with(2))};
    for (std::size_t j = 0; j < n_; ++j) box.radius[j] = std::ldexp(box.radius[j], columns_[j]);
    return box;
  }
  return std::nullopt;
}

Rational LongTest::inverse(std::size_t unknown, std::size_t equation) const {
  return Rational(inverse_[unknown][equation]) * power_of_two(columns_[unknown] + rows_[equation] - digits_);
}

Rational LongTest::scaled_value(std::size_t equation) const {
  return system_.value(block_.equations[equation], z_) * power_of_two(rows_[equation]);
}

/// False where the derivative has no inverse.
bool LongTest::invert() {
  const ScaledDerivative J(system_, block_, z_);
  rows_ = J.rows;
  columns_ = J.columns;
  const auto too_large = [](int exponent) { return std::abs(exponent) > largest_exponent; };
  if (std::any_of(rows_.begin(), rows_.end(), too_large)) return false;
  if (std::any_of(columns_.begin(), columns_.end(), too_large)) return false;
  inverse_.assign(n_, std::vector<Integer>(n_));
  return is_exact_ ? invert_exactly(J) : invert_roughly(J);
}

/// The exact inverse, cut off after a fixed number of bits below 1.
bool LongTest::invert_exactly(const ScaledDerivative& J) {
  FlintRationalMatrix R(n_, n_);
  for (std::size_t i = 0; i < n_; ++i) {
    for (const auto& [j, value] : J.entries[i]) R.set(i, j, value);
  }
  if (fmpq_mat_inv(R.get(), R.get()) == 0) return false;
  digits_ = 320;
  for (std::size_t j = 0; j < n_; ++j) {
    for (std::size_t i = 0; i < n_; ++i) inverse_[j][i] = scaled_truncation(R.at(j, i), digits_);
  }
  return true;
}

/// 110 bits for the largest entry.
bool LongTest::invert_roughly(const ScaledDerivative& J) {
  const LongMatrix R = Eigen::PartialPivLU<LongMatrix>(J.matrix()).inverse();
  double largest = 0;
  for (Index i = 0; i < R.size(); ++i) {
    const double size = std::abs(R.data()[i].high);
    if (!std::isfinite(size)) return false;
    largest = std::max(largest, size);
  }
  digits_ = 110 + exponent_to_one(largest);
  for (std::size_t j = 0; j < n_; ++j) {
    for (std::size_t i = 0; i < n_; ++i) {
      inverse_[j][i] = scaled_truncation(exact_number(R(static_cast<Index>(j), static_cast<Index>(i))), digits_);
    }
  }
  return true;
}

/// R F, in unknowns: with 30 digits, or exactly.
std::vector<Rational> LongTest::newton_step() const {
  std::vector<Rational> F, step(n_);
  for (std::size_t i = 0; i < n_; ++i) F.push_back(scaled_value(i));
  for (std::size_t j = 0; j < n_; ++j) {
    DoubleDouble rough = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const Rational r = Rational(inverse_[j][i]) * power_of_two(-digits_);
      if (is_exact_) {
        step[j] += r * F[i];
      } else {
        rough += to_double_double(r) * to_double_double(F[i]);
      }
    }
    if (!std::isfinite(rough.high)) return {};
    if (!is_exact_) step[j] = exact_number(rough);
    step[j] *= power_of_two(columns_[j]);
  }
  return step;
}

/// Newton's method. Unknowns are kept with 190 bits, and with an exact inverse with 640.
bool LongTest::improve() {
  const int steps = is_exact_ ? 12 : 6, inverses = is_exact_ ? 12 : 2, kept = is_exact_ ? 640 : 190;
  const double converged = is_exact_ ? 1e-150 : 1e-45;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < steps; ++i) {
    if (i < inverses && !invert()) return false;
    const std::vector<Rational> step = newton_step();
    if (step.empty()) return false;
    double largest = 0;
    for (std::size_t j = 0; j < n_; ++j) {
      Rational& z = z_[block_.unknowns[j]];
      z -= step[j];
      const double size = upper_size(z);
      if (!std::isfinite(size)) return false;
      const int digits = kept + exponent_to_one(size);
      z = Rational(scaled_truncation(z, digits)) * power_of_two(-digits);
      if (size > 0) largest = std::max(largest, upper_size(step[j]) / size);
    }
    if (largest < converged || (!is_exact_ && largest > 0.1 * last)) break;
    last = largest;
  }
  return true;
}

/// An exact derivative times 2^digits, in integers.
struct LongTest::Derivative {
  std::vector<std::vector<std::pair<std::size_t, Integer>>> entries;  ///< of each equation
  std::size_t digits = 0;
};

LongTest::Derivative LongTest::derivative() const {
  const ScaledDerivative J(system_, block_, z_);
  Derivative result;
  for (const auto& row : J.entries) {
    for (const auto& [k, value] : row) result.digits = std::max(result.digits, denominator(value).bits() - 1);
  }
  for (const auto& row : J.entries) {
    result.entries.emplace_back();
    for (const auto& [k, value] : row) {
      result.entries.back().emplace_back(k, scaled_truncation(value, static_cast<int>(result.digits)));
    }
  }
  return result;
}

/// A row of I - R J, times 2^(digits_ + the derivative's).
std::vector<Integer> LongTest::defect_row(std::size_t j, const Derivative& J) const {
  std::vector<Integer> row(n_);
  row[j] = Integer(1) << (static_cast<std::size_t>(digits_) + J.digits);
  for (std::size_t i = 0; i < n_; ++i) {
    const Integer& r = inverse_[j][i];
    if (r.is_zero()) continue;
    for (const auto& [k, value] : J.entries[i]) row[k].subtract_product(r, value);
  }
  return row;
}

/// R + (I - R J) R in place of R, whose defect is the square (Schulz), with 50 bits more.
void LongTest::refine_inverse(const Derivative& J) {
  constexpr std::size_t more = 50, kept = 160;  // bits
  for (auto& row : inverse_) {
    for (Integer& r : row) r <<= more;
  }
  digits_ += static_cast<int>(more);
  const std::size_t all = static_cast<std::size_t>(digits_) + J.digits, dropped = all > kept ? all - kept : 0;
  std::vector<std::vector<Integer>> refined;
  for (std::size_t j = 0; j < n_; ++j) {
    stop_if_asked();
    const std::vector<Integer> defect = defect_row(j, J);
    std::vector<Integer> sum(n_);
    for (std::size_t k = 0; k < n_; ++k) {
      const Integer factor = defect[k] >> dropped;
      if (factor.is_zero()) continue;
      for (std::size_t i = 0; i < n_; ++i) sum[i].add_product(factor, inverse_[k][i]);
    }
    for (std::size_t i = 0; i < n_; ++i) (sum[i] >>= all - dropped) += inverse_[j][i];
    refined.push_back(std::move(sum));
  }
  inverse_ = std::move(refined);
}

void LongTest::measure() {
  const Derivative J = derivative();
  refine_inverse(J);
  std::vector<Rational> F;
  for (std::size_t i = 0; i < n_; ++i) F.push_back(scaled_value(i));
  const Rational unit = power_of_two(-digits_ - static_cast<int>(J.digits)), unit_of_inverse = power_of_two(-digits_);
  step_.clear();
  for (std::size_t j = 0; j < n_; ++j) {
    stop_if_asked();
    const std::vector<Integer> row = defect_row(j, J);
    for (std::size_t k = 0; k < n_; ++k) defect_.row(j)[k] = row[k].is_zero() ? 0 : upper_size(Rational(row[k]) * unit);
    Rational step = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      if (inverse_[j][i].is_zero()) continue;
      const Rational r = Rational(inverse_[j][i]) * unit_of_inverse;
      step += r * F[i];
      size_.row(j)[i] = upper_size(r);
    }
    step_.push_back(upper_size(step));
  }
}

std::vector<double> LongTest::bound_with(double order) const {
  std::vector<double> all(system_.size(), 0), bent(n_), bound(n_);
  for (std::size_t j = 0; j < n_; ++j) all[block_.unknowns[j]] = std::ldexp(radius_[j], columns_[j]);
  for (std::size_t i = 0; i < n_; ++i) {
    bent[i] = order * std::ldexp(system_.second_order(block_.equations[i], all), rows_[i]) * (1 + 0x1p-40);
  }
  for (std::size_t j = 0; j < n_; ++j) {
    double sum = step_[j];
    for (std::size_t k = 0; k < n_; ++k) sum += defect_.row(j)[k] * radius_[k] + size_.row(j)[k] * bent[k];
    bound[j] = rounded_up(sum, 2 * n_) + underflow_of(2 * n_);
  }
  return bound;
}

bool LongTest::inside(const std::vector<double>& bound) const {
  for (std::size_t j = 0; j < n_; ++j) {
    if (!(bound[j] < radius_[j])) return false;
  }
  return true;
}

}  // namespace slipproof
