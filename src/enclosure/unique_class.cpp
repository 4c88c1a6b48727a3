#include "enclosure/unique_class.hpp"

#include <algorithm>
#include <cmath>

#include "enclosure/definite.hpp"
#include "enclosure/dominant.hpp"
#include "number/bareiss.hpp"
#include "number/binary64.hpp"

namespace slipproof {

namespace {

/// All principal minors, by elimination without fractions: where the rows of `chosen` are eliminated, the entries on
/// the diagonal are the minors of `chosen` and one row more, so that each minor costs one step on what is left of the
/// matrix. Where all minors so far are positive no pivot is 0.
class Minors {
 public:
  bool all_positive(const IntegerMatrix& left, const std::vector<std::size_t>& rows, const Integer& previous) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      chosen_.push_back(rows[k]);
      if (left[k][k].sign() <= 0) return false;
      const std::vector<std::size_t> later(rows.begin() + static_cast<std::ptrdiff_t>(k) + 1, rows.end());
      if (!all_positive(eliminated(left, k, previous), later, left[k][k])) return false;
      chosen_.pop_back();
    }
    return true;
  }
  /// The rows of the minor that is not positive.
  const std::vector<std::size_t>& chosen() const { return chosen_; }

 private:
  /// What is left after row k, without the rows before it.
  static IntegerMatrix eliminated(const IntegerMatrix& m, std::size_t k, const Integer& previous) {
    IntegerMatrix result;
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      auto& row = result.emplace_back();
      for (std::size_t j = k + 1; j < m.size(); ++j) {
        row.push_back((m[k][k] * m[i][j] - m[i][k] * m[k][j]) / previous);
      }
    }
    return result;
  }

  std::vector<std::size_t> chosen_;
};

/// Each row times what makes it integer: this multiplies minors by positive numbers.
IntegerMatrix integer_rows(const SparseMatrix& A) {
  IntegerMatrix result;
  for (std::size_t i = 0; i < A.rows; ++i) {
    std::vector<Rational> row(A.columns);
    for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) row[A.column[k]] = to_rational(A.value[k]);
    result.push_back(clear_denominators(row));
  }
  return result;
}

}  // namespace

std::optional<std::vector<std::size_t>> nonpositive_minor(const SparseMatrix& A) {
  std::vector<std::size_t> rows(A.rows);
  for (std::size_t i = 0; i < A.rows; ++i) rows[i] = i;
  Minors minors;
  if (minors.all_positive(integer_rows(A), rows, 1)) return std::nullopt;
  return minors.chosen();
}

bool is_complementarity(const MixedProblem& problem) {
  const auto finite = [](double x) { return std::isfinite(x); };
  return problem.free == 0 && problem.dimension == 1 &&
         std::all_of(problem.A.value.begin(), problem.A.value.end(), finite) &&
         std::all_of(problem.c.begin(), problem.c.end(), finite);
}

bool proves(const UniqueProof& proof, const MixedProblem& problem) {
  if (!is_complementarity(problem)) return false;
  switch (proof.kind) {
    case UniqueProof::Class::dominant:
      return is_dominant(problem.A, proof.scale);
    case UniqueProof::Class::definite:
      return is_definite(problem.A, proof.factor);
    case UniqueProof::Class::p_matrix:
      return problem.size() <= max_minors_size && !nonpositive_minor(problem.A);
  }
  return false;
}

std::optional<UniqueProof> prove_unique(const MixedProblem& problem, Effort& effort) {
  if (!is_complementarity(problem) || !has_positive_diagonal(problem.A)) return std::nullopt;
  try {
    if (auto scale = dominant_scale(problem.A, effort)) {
      return UniqueProof{UniqueProof::Class::dominant, std::move(*scale), {}};
    }
    if (auto factor = definite_factor(problem.A, effort)) {
      return UniqueProof{UniqueProof::Class::definite, {}, std::move(*factor)};
    }
    if (problem.size() > max_minors_size) return std::nullopt;
    effort.spend(Work{1'000} << problem.size());
    if (!nonpositive_minor(problem.A)) return UniqueProof{UniqueProof::Class::p_matrix, {}, {}};
  } catch (const TooMuchWork&) {
  }
  return std::nullopt;
}

}  // namespace slipproof
