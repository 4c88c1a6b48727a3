// The claims that need no enclosure (FORMAT.md, a function for each). All of them read all of it before they judge,
// and return in words what is established.
#pragma once

#include <span>

#include "proofs/check_contact/laws.hpp"

namespace slipproof::check_contact {

inline std::string eps(const Problem& problem, Reader& reader) {
  const Number bound = reader.number(), moved = reader.number();
  const Vector point = reader.numbers("point", problem.size());
  const Vector motion = reader.numbers("motion", problem.size());
  const Vector& answer = problem.the_answer();
  require(bound.sign() >= 0, "BOUND is negative");
  require(moved.sign() >= 0, "MOVED is negative");
  for (std::size_t i = 0; i < problem.free; ++i) require(motion[i].sign() == 0, "row", i, "w^ is not 0");
  for (std::size_t k = 0; k < problem.contacts(); ++k) check_law(problem, k, point, motion);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    require(abs(motion[i] - problem.motion(i, point)) <= bound, "row", i, "w^ is farther than BOUND from A x^ + c");
    require(abs(point[i] - answer[i]) <= moved, "component", i, "x^ is farther than MOVED from the answer");
  }
  return "a solution of a problem whose constant differs by at most " + decimal(bound) + ", within " + decimal(moved) +
         " of the answer";
}

/// The numbers from low to high.
struct Range {
  Number low, high;
  bool misses_zero() const { return low.sign() > 0 || high.sign() < 0; }
};

inline Range around(const Number& middle, const Number& radius) {
  return {middle - radius, middle + radius};
}
/// Whether none of them is farther than this from x.
inline bool is_near(const Range& range, const Number& x, const Number& distance) {
  return range.low >= x - distance && range.high <= x + distance;
}
inline Range operator+(const Range& x, const Range& y) {
  return {x.low + y.low, x.high + y.high};
}
inline Range operator-(const Range& x, const Range& y) {
  return {x.low - y.high, x.high - y.low};
}
inline Range operator*(const Range& x, const Range& y) {
  return {std::min({x.low * y.low, x.low * y.high, x.high * y.low, x.high * y.high}),
          std::max({x.low * y.low, x.low * y.high, x.high * y.low, x.high * y.high})};
}
inline Range square(const Range& x) {
  const auto [low, high] = std::minmax({square(x.low), square(x.high)});
  return {x.misses_zero() ? low : Number(0), high};
}

/// Whether contact k fails its law for all forces r and motions u in these ranges.
inline bool fails(const Problem& problem, std::size_t k, std::span<const Range> r, std::span<const Range> u) {
  bool open = u[0].high.sign() >= 0, stick = r[0].high.sign() >= 0, slide = stick && !u[0].misses_zero();
  Range force, product;
  for (std::size_t i = 0; i < problem.dimension; ++i) {
    open = open && !r[i].misses_zero();
    stick = stick && !u[i].misses_zero();
    if (i == 0) continue;
    force = force + square(r[i]);
    product = product + r[i] * u[i];
  }
  const auto limit = [&](const Number& normal) { return square(problem.mu[k] * std::max(normal, Number(0))); };
  const bool in_cone = force.low <= limit(r[0].high);
  const bool at_edge = in_cone && force.high >= limit(r[0].low);
  const bool parallel = problem.dimension < 3 || !(r[1] * u[2] - r[2] * u[1]).misses_zero();
  return !open && !(stick && in_cone) && !(slide && at_edge && parallel && product.low.sign() <= 0);
}

inline std::string none_within(const Problem& problem, Reader& reader) {
  const Number rho = reader.number();
  require(rho.sign() >= 0, "RHO is negative");
  problem.require_coulomb();
  const Vector& x = problem.the_answer();
  const std::string nowhere = "no solution within " + decimal(rho) + " of the answer, by ";
  std::vector<Range> forces, motions;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    Number reach;
    for (const auto& [j, a] : problem.A[i]) reach += abs(a) * rho;
    motions.push_back(around(problem.motion(i, x), reach));
    forces.push_back(around(x[i], rho));
    if (i < problem.free && motions[i].misses_zero()) return nowhere + "row " + std::to_string(i);
  }
  const auto of = [&](std::span<const Range> ranges, std::size_t k) { return ranges.subspan(problem.normal(k)); };
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    if (fails(problem, k, of(forces, k), of(motions, k))) return nowhere + "contact " + std::to_string(k);
  }
  throw Rejected("every row and every contact may hold within RHO");
}

/// g . x <= 0 for all x that are 0 in the first components, any number in the other free ones, and in the cones.
inline void check_falls(const Problem& problem, const Vector& g, std::size_t zeros) {
  for (std::size_t j = zeros; j < problem.free; ++j) require(g[j].sign() == 0, "column", j, "g is not 0");
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const std::size_t normal = problem.normal(k);
    require(g[normal].sign() <= 0, "contact", k, "g_N is positive");
    Number tangential;
    for (std::size_t j = normal + 1; j < normal + problem.dimension; ++j) tangential += square(g[j]);
    require(square(problem.mu[k]) * tangential <= square(g[normal]), "contact", k, "m |g_T| exceeds |g_N|");
  }
}

inline std::string no_solution(const Problem& problem, Reader& reader) {
  const Vector y = reader.numbers("multipliers", problem.size());
  problem.require_coulomb();
  Vector g(problem.size());
  Number work;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (i >= problem.free) {
      const bool normal = (i - problem.free) % problem.dimension == 0;
      require(!normal || y[i].sign() >= 0, "row", i, "the multiplier of a normal row is negative");
      require(normal || y[i].sign() == 0, "row", i, "the multiplier of a tangential row is not 0");
    }
    for (const auto& [j, a] : problem.A[i]) g[j] += a * y[i];
    work += y[i] * problem.c[i];
  }
  check_falls(problem, g, 0);
  require(work.sign() < 0, "c . y is not negative");
  return "no solution";
}

/// The first V unknowns are accelerations, which are 0 at rest; A x + c of the others is 0 where it balances.
inline std::string rest(const Problem& problem, Reader& reader) {
  const std::size_t accelerations = reader.index(problem.free + 1);
  Vector x(accelerations);
  for (Number& force : reader.numbers("forces", problem.size() - accelerations)) x.push_back(std::move(force));
  problem.require_coulomb();
  for (std::size_t i = 0; i < problem.size(); ++i) {
    require(problem.motion(i, x).sign() == 0, "row", i, "it does not vanish at rest");
  }
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const std::size_t normal = problem.normal(k);
    require(x[normal].sign() >= 0, "contact", k, "r_N is negative");
    Number tangential;
    for (std::size_t j = normal + 1; j < normal + problem.dimension; ++j) tangential += square(x[j]);
    require(tangential <= square(problem.mu[k] * x[normal]), "contact", k, "|r_T| exceeds m r_N");
  }
  return "it can rest";
}

inline std::string no_rest(const Problem& problem, Reader& reader) {
  const std::size_t accelerations = reader.index(problem.free + 1);
  const Vector y = reader.numbers("multipliers", accelerations);
  problem.require_coulomb();
  Vector g(problem.size());
  Number work;
  for (std::size_t i = 0; i < accelerations; ++i) {
    for (const auto& [j, a] : problem.A[i]) g[j] += a * y[i];
    work += y[i] * problem.c[i];
  }
  check_falls(problem, g, accelerations);
  require(work.sign() < 0, "c . y is not negative");
  return "it cannot rest";
}

/// d > 0 and a_ii d_i > the sum of the other |a_ij| d_j, which says that a_ii > 0.
inline void check_dominant(const Matrix& A, const Vector& d) {
  for (std::size_t i = 0; i < A.size(); ++i) {
    require(d[i].sign() > 0, "row", i, "d is not positive");
    Number excess;
    for (const auto& [j, a] : A[i]) excess += (j == i ? a : -abs(a)) * d[j];
    require(excess.sign() > 0, "row", i, "the diagonal does not dominate");
  }
}

/// Adds d x x^T to a matrix, or to its entries on and above the diagonal.
inline void add_square(Matrix& to, const Number& d, const Row& x, bool upper = false) {
  for (auto i = x.begin(); i != x.end(); ++i) {
    const Number multiple = d * i->second;
    for (auto j = upper ? i : x.begin(); j != x.end(); ++j) to[i->first][j->first] += multiple * j->second;
  }
}

/// Takes L L^T from a matrix.
inline void subtract_square(Matrix& from, const Matrix& L) {
  Matrix columns(L.size());
  for (std::size_t i = 0; i < L.size(); ++i) {
    for (const auto& [k, l] : L[i]) columns[k][i] = l;
  }
  for (const Row& column : columns) add_square(from, -1, column);
}

/// A + A^T - L L^T.
inline Matrix remainder(const Matrix& A, const Matrix& L) {
  Matrix result(A.size());
  for (std::size_t i = 0; i < A.size(); ++i) {
    require(L[i].empty() || L[i].rbegin()->first <= i, "row", i, "an entry stands above the diagonal");
    for (const auto& [j, a] : A[i]) result[i][j] += a, result[j][i] += a;
  }
  subtract_square(result, L);
  return result;
}

/// Each row has its diagonal entry at least the sum of the absolute values of the others: it is semidefinite, where it
/// is symmetric (Gershgorin).
inline void check_semidefinite(const Matrix& matrix) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    Number excess;
    for (const auto& [j, a] : matrix[i]) excess += j == i ? a : -abs(a);
    require(excess.sign() >= 0, "row", i, "the diagonal is less than the others");
  }
}

/// `bound`: A less what mu takes from its diagonal.
inline Matrix lowered(const Problem& problem) {
  Matrix result = problem.A;
  for (std::size_t i = 0; i < problem.contacts(); ++i) {
    const std::size_t normal = problem.normal(i), tangent = normal + 1;
    const Number half_mu = problem.mu[i] / 2;
    for (std::size_t j = 0; j < problem.size(); ++j) {
      const Number a = problem.entry(j, tangent), b = problem.entry(tangent, j), skew = half_mu * abs(a - b);
      result[j][j] += -skew;
      result[normal][normal] += -skew;
      if (j % 2 == 1) result[normal][normal] += -(problem.mu[i] * half_mu * abs(a + b));
    }
  }
  return result;
}

/// A square matrix without its row and column p.
inline std::vector<Vector> without(std::vector<Vector> m, std::size_t p) {
  const auto place = static_cast<std::ptrdiff_t>(p);
  m.erase(m.begin() + place);
  for (Vector& row : m) row.erase(row.begin() + place);
  return m;
}

/// What elimination leaves of it after its first row, whose pivot is to be positive.
inline std::vector<Vector> eliminated(std::vector<Vector> m, std::size_t contact) {
  require(m[0][0].sign() > 0, "contact", contact, "the determinant of a mode in which it is the last is not positive");
  for (std::size_t i = 1; i < m.size(); ++i) {
    const Number share = m[i][0] / m[0][0];
    for (std::size_t j = 1; j < m.size(); ++j) m[i][j] += -(share * m[0][j]);
  }
  return without(std::move(m), 0);
}

/// All modes of the contacts k, k + 1, ..., where m is what elimination left of their rows and columns in one mode of
/// the contacts before them. The determinant of a mode is the product of its pivots. For `stick` the first of its two
/// pivots is the mean of those of `slide+` and `slide-`.
inline void check_modes(const Problem& problem, const std::vector<Vector>& m, std::size_t k) {
  if (k == problem.contacts()) return;
  check_modes(problem, without(without(m, 0), 0), k + 1);
  for (const int direction : {1, -1}) {
    std::vector<Vector> slides = m;
    for (Vector& row : slides) row[0] += -(direction * problem.mu[k] * row[1]);
    check_modes(problem, eliminated(without(std::move(slides), 1), k), k + 1);
  }
  if (problem.mu[k].sign() > 0) check_modes(problem, eliminated(eliminated(m, k), k), k + 1);
}

inline constexpr std::size_t kMaxDeterminantContacts = 8;  ///< there are 4^K modes

inline void check_determinants(const Problem& problem) {
  require(problem.contacts() <= kMaxDeterminantContacts, "there are more than 8 contacts");
  std::vector<Vector> dense(problem.size());
  for (std::size_t i = 0; i < problem.size(); ++i) {
    for (std::size_t j = 0; j < problem.size(); ++j) dense[i].push_back(problem.entry(i, j));
  }
  check_modes(problem, dense, 0);
}

inline std::string unique(const Problem& problem, Reader& reader) {
  std::string kind;
  for (const char* name : {"dominant", "definite", "bound", "determinants"}) {
    if (kind.empty() && reader.accept(name)) kind = name;
  }
  if (kind.empty()) reader.refuse("'dominant', 'definite', 'bound' or 'determinants'");
  const bool planar = kind == "bound" || kind == "determinants";
  const std::size_t n = problem.size();
  Matrix L;
  Vector d(n, 1);
  if (kind == "dominant") d = reader.numbers(n);
  if (kind != "dominant") L = reader.entries(n, n);
  problem.require_coulomb();
  require(problem.free == 0, "the problem has free unknowns");
  require(problem.dimension == (planar ? 2 : 1), "the class is not one of this dimension");
  const Matrix A = kind == "bound" ? lowered(problem) : problem.A;
  check_dominant(kind == "dominant" ? A : remainder(A, L), d);
  if (kind == "determinants") check_determinants(problem);
  return "one solution, whatever the constant, by " + (kind == "bound" ? "a bound on mu"
                                                       : planar        ? "the mode determinants"
                                                                       : "a " + kind + " matrix");
}

}  // namespace slipproof::check_contact
