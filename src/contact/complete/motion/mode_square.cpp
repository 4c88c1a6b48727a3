#include "contact/complete/motion/mode_square.hpp"

#include <cmath>

#include "base/number/binary64.hpp"
#include "contact/complete/solve_near.hpp"

namespace slipproof {

namespace {

using Vector = std::vector<Rational>;
constexpr int inverse_bits = 34;

double power_above(double x) {
  return x > 0x1p-60 && std::isfinite(x) ? std::exp2(std::ceil(std::log2(x))) : 0x1p-60;
}

}  // namespace

std::vector<std::size_t> all_but(std::size_t count, const std::vector<bool>& without) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < count; ++i) {
    if (!without[i]) result.push_back(i);
  }
  return result;
}

ModeSquare::ModeSquare(const ExactContacts& contacts, const ContactPattern& mode, const std::vector<bool>& touching)
    : contacts(contacts),
      mode(mode),
      touching(touching),
      unknowns(contacts, mode, touching),
      equations(mode_equations<Rational>(contacts, contacts, mode, unknowns)) {
  drop_dependent();
}

/// Rows and columns of a derivative, divided by the size of the row and multiplied by that of the unknown, which are
/// powers of 2.
struct ModeSquare::Scaled {
  Eigen::MatrixXd matrix;
  std::vector<double> rows;

  Scaled(const Eigen::MatrixXd& derivative, const std::vector<std::size_t>& kept,
         const std::vector<std::size_t>& columns, const std::vector<double>& sizes)
      : matrix(kept.size(), columns.size()) {
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        const std::size_t column = columns[static_cast<std::size_t>(j)];
        matrix(i, j) = derivative(static_cast<Eigen::Index>(kept[static_cast<std::size_t>(i)]),
                                  static_cast<Eigen::Index>(column)) *
                       sizes[column];
      }
      rows.push_back(power_above(matrix.row(i).lpNorm<Eigen::Infinity>()));
      matrix.row(i) /= rows.back();
    }
  }
};

bool ModeSquare::pin(const Eigen::MatrixXd& derivative, const std::vector<double>& zero) {
  sizes = sizes_at(zero);
  std::vector<bool> held(unknowns.count(), false);
  for (std::size_t j = 0; j < held.size(); ++j) held[j] = is_touching(j);
  std::vector<std::size_t> free = all_but(held.size(), held);
  if (free.size() < kept.size()) return false;
  const Scaled scaled(derivative, kept, free, sizes);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled.matrix);
  held.assign(held.size(), true);
  for (std::size_t p = 0; p < kept.size(); ++p) {
    held[free[static_cast<std::size_t>(qr.colsPermutation().indices()[static_cast<Eigen::Index>(p)])]] = false;
  }
  left = all_but(held.size(), held);
  return left.empty() || invert(Scaled(derivative, kept, left, sizes));
}

bool ModeSquare::is_touching(std::size_t unknown) const {
  for (std::size_t k = 0; k < touching.size(); ++k) {
    if (touching[k] && unknowns.first[k] == unknown) return true;
  }
  return false;
}

bool ModeSquare::invert(const Scaled& scaled) {
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(scaled.matrix);
  if (lu.rcond() < 1e-12) return false;
  const Eigen::MatrixXd approximate = lu.inverse();
  for (std::size_t j = 0; j < left.size(); ++j) {
    Vector& own = inverse.emplace_back();
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const double x = approximate(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i));
      own.push_back(nearest_multiple(x, inverse_bits) * to_rational(sizes[left[j]] / scaled.rows[i]));
    }
  }
  return true;
}

/// Forces of a contact are as large as its normal force, those of friction as what it allows.
std::vector<double> ModeSquare::sizes_at(const std::vector<double>& zero) const {
  std::vector<double> result(zero.size(), 1);
  for (std::size_t k = 0; k < mode.size(); ++k) {
    const std::size_t first = unknowns.first[k];
    for (std::size_t t = 0; t < unknowns.forces(k); ++t) result[first + t] = power_above(zero[first]);
    if (!unknowns.slips_in_space(k)) continue;
    const double friction = std::hypot(zero[first + 1], zero[first + 2]);
    for (const std::size_t t : {1U, 2U}) result[first + t] = power_above(friction);
    result[first + 3] = power_above(zero[first + 3]);
  }
  return result;
}

/// Of the linear equations those that are combinations of others, constants included; rather those of contacts that
/// touch.
void ModeSquare::drop_dependent() {
  const std::vector<std::size_t> linear = linear_equations();
  RationalMatrix columns(unknowns.count() + 1, Vector(linear.size()));
  for (std::size_t e = 0; e < linear.size(); ++e) {
    for (const auto& [j, a] : equations[linear[e]].linear) {
      if (!is_touching(j)) columns[j][e] += a;
    }
    columns.back()[e] = equations[linear[e]].constant;
  }
  std::vector<bool> out(equations.size(), false);
  const Echelon echelon = linear.empty() ? Echelon() : eliminate(columns);
  std::size_t pivots = 0;
  for (std::size_t e = 0; e < linear.size(); ++e) {
    if (pivots < echelon.rank() && echelon.pivot_columns[pivots] == e) {
      ++pivots;
      continue;
    }
    out[linear[e]] = true;
    DependentEquation& own = dropped.emplace_back(DependentEquation{linear[e], {}});
    for (std::size_t p = 0; p < pivots; ++p) {
      if (echelon.rows[p][e].is_zero()) continue;
      own.combination.emplace_back(linear[echelon.pivot_columns[p]], Rational(echelon.rows[p][e], echelon.pivot));
    }
  }
  kept = all_but(equations.size(), out);
}

/// Those of contacts that touch last.
std::vector<std::size_t> ModeSquare::linear_equations() const {
  std::vector<std::size_t> result, last;
  for (std::size_t k = 0; k < mode.size(); ++k) {
    for (std::size_t e = unknowns.first[k]; e < unknowns.first[k + 1]; ++e) {
      if (!equations[e].products.empty()) continue;
      (!touching.empty() && touching[k] ? last : result).push_back(e);
    }
  }
  result.insert(result.end(), last.begin(), last.end());
  return result;
}

}  // namespace slipproof
