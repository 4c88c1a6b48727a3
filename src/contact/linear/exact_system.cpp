#include "contact/linear/exact_system.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/algebra/elimination.hpp"
#include "base/algebra/flint_matrix.hpp"
#include "base/algebra/sparse/sparse_basis.hpp"
#include "base/number/binary64.hpp"
#include "base/number/flint_memory.hpp"

namespace slipproof {

namespace {

/// mantissa 2^exponent, the mantissa odd, or 0.
struct Dyadic {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

Dyadic dyadic(double x) {
  if (x == 0) return {};
  int exponent = 0;
  const auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(m));
  return {m / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

/// Mean number of entries of a row up to which elimination is tried in a sparse order first.
constexpr std::size_t sparse_row = 20;

constexpr int no_exponent = std::numeric_limits<int>::max();

/// Calls visit(row, column, entry) for each entry that is not 0.
template <class Visit>
void each_entry(const SparseMatrix& A, const std::vector<Dyadic>& entries, const Visit& visit) {
  for (std::size_t i = 0; i < A.rows; ++i) {
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) {
      if (entries[k].mantissa != 0) visit(i, A.column[k], entries[k]);
    }
  }
}

std::vector<Dyadic> dyadics(std::span<const double> values) {
  std::vector<Dyadic> result;
  result.reserve(values.size());
  for (const double x : values) result.push_back(dyadic(x));
  return result;
}

/// (R A C) y = -R c s in integers, R, C and s being powers of two, R and C one for each row and column: x = C y / s.
/// Each row is multiplied until it is integer, and then each column divided by what its entries have in common: the
/// fewer bits A has, the fewer the solution has.
class IntegerSystem {
 public:
  IntegerSystem(const SparseMatrix& A, std::span<const double> c)
      : n_(A.rows), matrix_(n_, n_), constant_(n_, 1), row_(n_, no_exponent), column_(n_, no_exponent) {
    const std::vector<Dyadic> entries = dyadics(A.value);
    each_entry(A, entries,
               [&](std::size_t i, std::size_t, const Dyadic& a) { row_[i] = std::min(row_[i], a.exponent); });
    each_entry(A, entries, [&](std::size_t i, std::size_t j, const Dyadic& a) {
      column_[j] = std::min(column_[j], a.exponent - row_[i]);
    });
    each_entry(A, entries, [&](std::size_t i, std::size_t j, const Dyadic& a) {
      matrix_.set(i, j, a.mantissa, a.exponent - row_[i] - column_[j]);
    });
    const auto is_none = [](int exponent) { return exponent == no_exponent; };
    has_zeros_ = std::any_of(row_.begin(), row_.end(), is_none) || std::any_of(column_.begin(), column_.end(), is_none);
    if (!has_zeros_) set_constant(dyadics(c));
  }

  /// Whether a row or a column has no entries.
  bool has_zeros() const { return has_zeros_; }

  /// Bound on the bits of a numerator of the solution, the determinant of A with a column replaced by the constants
  /// (Hadamard).
  std::size_t solution_bits() {
    double bits = static_cast<double>(std::abs(fmpz_mat_max_bits(constant_.get())));
    for (std::size_t i = 0; i < n_; ++i) {
      std::size_t longest = 0;
      for (std::size_t j = 0; j < n_; ++j) longest = std::max<std::size_t>(longest, fmpz_bits(matrix_.at(i, j)));
      bits += static_cast<double>(longest) + std::log2(static_cast<double>(n_)) / 2;
    }
    return static_cast<std::size_t>(bits);
  }

  std::optional<ExactVector> solution() {
    FlintMatrix residues(n_, 1);
    Integer modulus;
    if (fmpz_mat_solve_dixon(residues.get(), modulus.flint(), matrix_.get(), constant_.get()) == 0) return std::nullopt;
    FlintRationalMatrix y(n_, 1);
    if (fmpq_mat_set_fmpz_mat_mod_fmpz(y.get(), residues.get(), modulus.flint()) == 0) return std::nullopt;
    std::vector<Rational> values;
    for (std::size_t j = 0; j < n_; ++j) values.push_back(y.at(j, 0));
    return unscaled(values);
  }

 private:
  void set_constant(const std::vector<Dyadic>& c) {
    int lowest = no_exponent;
    for (std::size_t i = 0; i < n_; ++i) {
      if (c[i].mantissa != 0) lowest = std::min(lowest, c[i].exponent - row_[i]);
    }
    if (lowest == no_exponent) return;
    all_ = lowest;
    for (std::size_t i = 0; i < n_; ++i) {
      if (c[i].mantissa != 0) constant_.set(i, 0, -c[i].mantissa, c[i].exponent - row_[i] - all_);
    }
  }

  ExactVector unscaled(const std::vector<Rational>& y) const {
    ExactVector x;
    for (const Rational& value : y) {  // most have the same
      const Integer& d = denominator(value);
      if (!Integer(x.denominator % d).is_zero()) x.denominator = lcm(x.denominator, d);
    }
    int lowest = 0;
    for (const int c : column_) lowest = std::min(lowest, all_ - c);
    for (std::size_t j = 0; j < n_; ++j) {
      x.numerators.push_back(integer_times(y[j], x.denominator) << static_cast<unsigned>(all_ - column_[j] - lowest));
    }
    x.denominator <<= static_cast<unsigned>(-lowest);
    return x;
  }

  std::size_t n_;
  FlintMatrix matrix_, constant_;
  std::vector<int> row_, column_;  ///< exponents: a_ij = matrix_ij 2^(row_i + column_j)
  int all_ = 0;                    ///< -c_i = constant_i 2^(row_i + all)
  bool has_zeros_ = false;
};

}  // namespace

ExactVector exact_rows(const SparseMatrix& A, const ExactVector& x, std::span<const double> c) {
  const std::vector<Dyadic> entries = dyadics(A.value), constants = dyadics(c);
  std::vector<int> lowest(A.rows, 0);  // exponents of the rows' sums, whose terms are integers then
  each_entry(A, entries,
             [&](std::size_t i, std::size_t, const Dyadic& a) { lowest[i] = std::min(lowest[i], a.exponent); });
  for (std::size_t i = 0; i < A.rows; ++i) lowest[i] = std::min(lowest[i], constants[i].exponent);
  std::vector<Integer> sums(A.rows);
  const auto add = [&](std::size_t i, const Dyadic& factor, const Integer& to) {
    const Integer whole = Integer(factor.mantissa) << static_cast<unsigned>(factor.exponent - lowest[i]);
    sums[i].add_product(whole, to);
  };
  each_entry(A, entries, [&](std::size_t i, std::size_t j, const Dyadic& a) { add(i, a, x.numerators[j]); });
  int least = 0;
  for (std::size_t i = 0; i < A.rows; ++i) {
    if (constants[i].mantissa != 0) add(i, constants[i], x.denominator);
    least = std::min(least, lowest[i]);
  }
  for (std::size_t i = 0; i < A.rows; ++i) sums[i] <<= static_cast<unsigned>(lowest[i] - least);
  return {std::move(sums), x.denominator << static_cast<unsigned>(-least)};
}

namespace {

/// By elimination in a sparse order, within an effort in proportion to the entries; nothing where A is singular.
std::optional<ExactVector> solved_sparsely(const SparseMatrix& A, std::span<const double> c) {
  constexpr Work of_entry = 2'000;
  Effort effort(of_entry * A.entries());
  std::vector<SparseVector> columns(A.columns);
  std::vector<Rational> right;
  for (std::size_t i = 0; i < A.rows; ++i) {
    for (std::size_t e = A.starts[i]; e < A.starts[i + 1]; ++e) {
      if (A.value[e] != 0) columns[A.column[e]].emplace_back(static_cast<std::uint32_t>(i), to_rational(A.value[e]));
    }
    right.push_back(to_rational(-c[i]));
  }
  std::vector<const SparseVector*> all;
  for (const SparseVector& column : columns) all.push_back(&column);
  const SparseBasis basis(A.rows, all, effort);
  if (!basis.dependent().empty()) return std::nullopt;
  return over_one_denominator(basis.solve(std::move(right)));
}

}  // namespace

ExactVector over_one_denominator(const std::vector<Rational>& x) {
  ExactVector result;
  for (const Rational& value : x) {  // most have the same
    if (!Integer(result.denominator % denominator(value)).is_zero()) {
      result.denominator = lcm(result.denominator, denominator(value));
    }
  }
  for (const Rational& value : x) result.numerators.push_back(integer_times(value, result.denominator));
  return result;
}

std::optional<ExactVector> exact_solution(const SparseMatrix& A, std::span<const double> c, Effort& effort) {
  const Work n = A.rows;
  if (n == 0) return ExactVector();
  if (A.entries() <= sparse_row * A.rows) {
    try {
      return solved_sparsely(A, c);
    } catch (const TooMuchWork&) {  // it fills in: densely, then
    }
  }
  give_back_flint_memory_at_end();  // tens of megabytes here
  effort.spend(times(n, n));
  IntegerSystem system(A, c);
  if (system.has_zeros()) return std::nullopt;
  // An inverse modulo a word, then two products with a vector for each word of numerators and denominators together.
  const Work words = 2 * system.solution_bits() / 60 + 1;
  effort.spend(plus(times(n * n, n), times(5 * n * n, words)));
  return system.solution();
}

}  // namespace slipproof
