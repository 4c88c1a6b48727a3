// Complementarity problems for tests, and what the definitions say about them: everything here is slow and plain.
#pragma once

#include <initializer_list>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include "base/number/binary64.hpp"
#include "contact/problem/mixed_problem.hpp"
#include "contact/problem/solutions.hpp"

namespace lcp {

using namespace slipproof;
using Matrix = std::vector<std::vector<double>>;
using Rationals = std::vector<Rational>;

inline SparseMatrix sparse(const Matrix& rows) {
  std::vector<double> flat;
  for (const auto& row : rows) flat.insert(flat.end(), row.begin(), row.end());
  return from_dense(rows.size(), rows.empty() ? 0 : rows[0].size(), flat);
}

/// Without friction, or planar with the coefficients given.
inline MixedProblem problem(const Matrix& A, std::vector<double> c, std::vector<double> mu = {}) {
  MixedProblem result;
  result.dimension = mu.empty() ? 1 : 2;
  result.A = sparse(A);
  result.mu = mu.empty() ? std::vector<double>(c.size()) : std::move(mu);
  result.c = std::move(c);
  return result;
}

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  std::size_t size(int low, int high) { return static_cast<std::size_t>(whole(low, high)); }
  /// 53 random bits from -1 to 1.
  double real() { return static_cast<double>(static_cast<std::int64_t>(engine_()) >> 10) * 0x1p-53; }
  Matrix matrix(std::size_t rows, std::size_t columns, int low, int high) {
    Matrix result(rows, std::vector<double>(columns));
    for (auto& row : result) {
      for (double& x : row) x = whole(low, high);
    }
    return result;
  }
  std::vector<double> vector(std::size_t n, int low, int high) { return matrix(1, n, low, high)[0]; }
  std::vector<bool> set(std::size_t n) {
    std::vector<bool> result;
    for (std::size_t i = 0; i < n; ++i) result.push_back(whole(0, 1) == 1);
    return result;
  }
  /// B^T B, the identity times `more`, and a skew part, in integers.
  Matrix definite(std::size_t n, int more) {
    const Matrix B = matrix(n, n, -3, 3), skew = matrix(n, n, -3, 3);
    Matrix result = B;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        double x = i == j ? more : i < j ? skew[i][j] : -skew[j][i];
        for (std::size_t k = 0; k < n; ++k) x += B[k][i] * B[k][j];
        result[i][j] = x;
      }
    }
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

/// The determinant by the first row; n! steps.
inline Rational expansion(const std::vector<Rationals>& m) {
  if (m.empty()) return 1;
  Rational result = 0;
  for (std::size_t j = 0; j < m.size(); ++j) {
    std::vector<Rationals> rest;
    for (std::size_t i = 1; i < m.size(); ++i) {
      rest.emplace_back();
      for (std::size_t k = 0; k < m.size(); ++k) {
        if (k != j) rest.back().push_back(m[i][k]);
      }
    }
    result += (j % 2 == 0 ? 1 : -1) * m[0][j] * expansion(rest);
  }
  return result;
}

inline std::vector<Rationals> exact(const Matrix& A) {
  std::vector<Rationals> result;
  for (const auto& row : A) {
    result.emplace_back();
    for (const double x : row) result.back().push_back(to_rational(x));
  }
  return result;
}

/// The rows and columns in a set of bits.
inline std::vector<Rationals> part(const std::vector<Rationals>& A, unsigned set) {
  std::vector<Rationals> result;
  for (std::size_t i = 0; i < A.size(); ++i) {
    if ((set >> i & 1U) == 0) continue;
    result.emplace_back();
    for (std::size_t j = 0; j < A.size(); ++j) {
      if ((set >> j & 1U) != 0) result.back().push_back(A[i][j]);
    }
  }
  return result;
}

/// By Cramer's rule; nothing if singular.
inline std::optional<Rationals> cramer(const std::vector<Rationals>& A, const Rationals& b) {
  const Rational d = expansion(A);
  if (d == 0) return std::nullopt;
  Rationals x;
  for (std::size_t j = 0; j < A.size(); ++j) {
    auto replaced = A;
    for (std::size_t i = 0; i < A.size(); ++i) replaced[i][j] = b[i];
    x.push_back(expansion(replaced) / d);
  }
  return x;
}

/// A x + c.
inline Rationals image(const MixedProblem& p, const Rationals& x) {
  Rationals w;
  for (std::size_t i = 0; i < p.size(); ++i) {
    w.push_back(to_rational(p.c[i]));
    for (std::size_t k = p.A.starts[i]; k < p.A.starts[i + 1]; ++k) {
      w.back() += to_rational(p.A.value[k]) * x[p.A.column[k]];
    }
  }
  return w;
}

/// The law of mixed_problem.hpp, without free unknowns, in dimension 1 or 2.
inline bool obeys_law(const MixedProblem& p, const Rationals& x) {
  const Rationals w = image(p, x);
  for (std::size_t k = 0; k < p.contacts(); ++k) {
    const std::size_t i = p.normal(k);
    if (x[i] < 0 || w[i] < 0 || x[i] * w[i] != 0) return false;
    if (p.dimension == 1) continue;
    const Rational limit = to_rational(p.mu[k]) * x[i], &force = x[i + 1], &slip = w[i + 1];
    if (abs(force) > limit || abs(slip) * force != -limit * slip) return false;
  }
  return true;
}

struct Enumerated {
  std::set<Rationals> solutions;
  bool singular = false;  ///< some set of active components has a singular matrix
};

/// All solutions of a small LCP by its 2^n sets of active components.
inline Enumerated enumerate(const MixedProblem& p, const Matrix& dense) {
  const std::vector<Rationals> A = exact(dense);
  Enumerated result;
  for (unsigned set = 0; set < 1U << p.size(); ++set) {
    Rationals b;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if ((set >> i & 1U) != 0) b.push_back(-to_rational(p.c[i]));
    }
    const auto in = cramer(part(A, set), b);
    if (!in) {
      result.singular = true;
      continue;
    }
    Rationals x(p.size());
    for (std::size_t i = 0, k = 0; i < p.size(); ++i) {
      if ((set >> i & 1U) != 0) x[i] = (*in)[k++];
    }
    if (obeys_law(p, x)) result.solutions.insert(x);
  }
  return result;
}

/// The solutions of a small problem in the plane or without friction; of a continuum two.
struct SolutionCount {
  enum class Kind { none, one, several, continuum, unknown };
  Kind kind = Kind::unknown;
  std::vector<Rationals> solutions;
};

inline SolutionCount count_solutions(const MixedProblem& problem, Effort& effort) {
  const auto small = eliminated(problem);
  if (!small) return {};
  const ContactSolver solver(small->problem);
  const auto all = solver.all(effort);
  if (!all) return {};
  using enum SolutionCount::Kind;
  SolutionCount result;
  for (const ContactSolution& solution : all->solutions) result.solutions.push_back(small->with_free(solution.z));
  if (all->continua.empty()) {
    result.kind = result.solutions.empty() ? none : all->one() ? one : several;
  } else {
    result.kind = continuum;
    for (const Rationals& z : all->continua.front().two(effort)) result.solutions.push_back(small->with_free(z));
  }
  return result;
}

}  // namespace lcp
