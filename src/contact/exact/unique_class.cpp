#include "contact/exact/unique_class.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/algebra/elimination.hpp"
#include "base/number/binary64.hpp"
#include "base/rounding/exact_sum.hpp"
#include "contact/linear/definite.hpp"
#include "contact/linear/dominant.hpp"
#include "contact/problem/every_load.hpp"

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
      if (!all_positive(eliminated_once(left, k, previous), later, left[k][k])) return false;
      chosen_.pop_back();
    }
    return true;
  }
  /// The rows of the minor that is not positive.
  const std::vector<std::size_t>& chosen() const { return chosen_; }

 private:
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

/// Where row i of A or its column i has an entry, both of them.
std::map<std::size_t, std::pair<double, double>> row_and_column(const SparseMatrix& A, const SparseMatrix& across,
                                                                std::size_t i) {
  std::map<std::size_t, std::pair<double, double>> result;
  for (std::size_t k = A.starts[i]; k < A.starts[i + 1]; ++k) result[A.column[k]].first = A.value[k];
  for (std::size_t k = across.starts[i]; k < across.starts[i + 1]; ++k) {
    result[across.column[k]].second = across.value[k];
  }
  return result;
}

bool is_finite(const MixedProblem& problem) {
  const auto all = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
  };
  return all(problem.A.value) && all(problem.c) && all(problem.mu);
}

/// For a definite A. Throws TooMuchWork.
bool determinants_are_positive(const MixedProblem& problem, Effort& effort) {
  if (problem.contacts() > max_determinant_contacts) return false;
  if (problem.contacts() == 0) return true;
  const EveryLoad found = for_every_load(contact_problem(problem), effort);
  return found.verdict == EveryLoad::Verdict::unique && found.reason == EveryLoad::Reason::determinants;
}

/// Throws TooMuchWork.
std::optional<UniqueProof> prove_planar(const MixedProblem& problem, Effort& effort) {
  using Class = UniqueProof::Class;
  const auto lowered = lowered_by_friction(problem);
  auto factor = lowered ? definite_factor(*lowered, effort) : std::nullopt;
  if (factor) return UniqueProof{Class::bound, {}, std::move(*factor)};
  if (problem.contacts() > max_determinant_contacts) return std::nullopt;
  factor = definite_factor(problem.A, effort);
  if (!factor || !determinants_are_positive(problem, effort)) return std::nullopt;
  return UniqueProof{Class::determinants, {}, std::move(*factor)};
}

}  // namespace

std::optional<std::vector<std::size_t>> nonpositive_minor(const SparseMatrix& A) {
  std::vector<std::size_t> rows(A.rows);
  for (std::size_t i = 0; i < A.rows; ++i) rows[i] = i;
  Minors minors;
  if (minors.all_positive(integer_rows(A), rows, 1)) return std::nullopt;
  return minors.chosen();
}

std::string_view name(UniqueProof::Class kind) {
  switch (kind) {
    case UniqueProof::Class::dominant:
      return "H-matrix with positive diagonal";
    case UniqueProof::Class::definite:
      return name(EveryLoad::Reason::definite);
    case UniqueProof::Class::bound:
      return name(EveryLoad::Reason::bound);
    case UniqueProof::Class::determinants:
      return name(EveryLoad::Reason::determinants);
    default:
      return "P-matrix";
  }
}

bool is_complementarity(const MixedProblem& problem) {
  return problem.free == 0 && problem.dimension == 1 && is_finite(problem);
}

bool is_planar_friction(const MixedProblem& problem) {
  return problem.free == 0 && problem.dimension == 2 && is_finite(problem);
}

std::optional<SparseMatrix> lowered_by_friction(const MixedProblem& problem) {
  if (!has_positive_diagonal(problem.A)) return std::nullopt;
  const SparseMatrix across = transposed(problem.A);
  std::vector<ExactSum> skew(problem.size());  // twice what it takes
  std::vector<Rational> less(problem.size());  // the same of the symmetric part
  for (std::size_t i = 0; i < problem.contacts(); ++i) {
    const std::size_t normal = problem.normal(i);
    const double mu = problem.mu[i];
    ExactSum tangential;
    for (const auto& [j, pair] : row_and_column(problem.A, across, normal + 1)) {
      const auto [row, column] = pair;
      const double sign = row < column ? -1 : 1;
      for (ExactSum* sum : {&skew[j], &skew[normal]}) {
        if (row != column) sum->add(mu, sign * row), sum->add(mu, -sign * column);
      }
      if (j % 2 == 0) continue;
      const double together = row < -column ? -1 : 1;
      tangential.add(together * row), tangential.add(together * column);
    }
    less[normal] = to_rational(mu) * to_rational(mu) * tangential.value();
  }
  SparseMatrix result = problem.A;
  for (std::size_t j = 0; j < problem.size(); ++j) {
    const auto columns = result.columns_of(j);
    const auto place = std::lower_bound(columns.begin(), columns.end(), j) - columns.begin();
    double& entry = result.value[result.starts[j] + static_cast<std::size_t>(place)];
    entry = enclose(to_rational(entry) - (less[j] + skew[j].value()) / 2).lower;
  }
  return has_positive_diagonal(result) ? std::optional(std::move(result)) : std::nullopt;
}

bool proves(const UniqueProof& proof, const MixedProblem& problem) {
  const bool planar = proof.kind == UniqueProof::Class::bound || proof.kind == UniqueProof::Class::determinants;
  if (!(planar ? is_planar_friction(problem) : is_complementarity(problem))) return false;
  switch (proof.kind) {
    case UniqueProof::Class::bound: {
      const auto lowered = lowered_by_friction(problem);
      return lowered && is_definite(*lowered, proof.factor);
    }
    case UniqueProof::Class::determinants: {
      Effort effort(std::numeric_limits<Work>::max());
      return is_definite(problem.A, proof.factor) && determinants_are_positive(problem, effort);
    }
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
  if (!has_positive_diagonal(problem.A)) return std::nullopt;
  try {
    if (is_planar_friction(problem)) return prove_planar(problem, effort);
    if (!is_complementarity(problem)) return std::nullopt;
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
