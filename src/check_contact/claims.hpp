// The claims that need no enclosure (FORMAT.md, a function for each). All of them read all of it before they judge,
// and return in words what is established.
#pragma once

#include "check_contact/problem.hpp"

namespace slipproof::check_contact {

/// Contact k obeys the law, of which |u_T| r_T = -m r_N u_T says without roots: where u_T is not 0, r_T is antiparallel
/// to it, and |r_T| = m r_N.
inline void check_law(const Problem& problem, std::size_t k, const Vector& x, const Vector& w) {
  const std::size_t normal = problem.normal(k);
  require(w[normal].sign() >= 0, "contact", k, "u_N is negative");
  require(x[normal].sign() >= 0, "contact", k, "r_N is negative");
  require((x[normal] * w[normal]).sign() == 0, "contact", k, "neither u_N nor r_N is 0");
  Number force, motion, product;
  for (std::size_t i = normal + 1; i < normal + problem.dimension; ++i) {
    force += square(x[i]);
    motion += square(w[i]);
    product += x[i] * w[i];
  }
  const Number limit = square(problem.mu[k] * x[normal]);
  require(force <= limit, "contact", k, "the force is outside of the friction cone");
  if (motion.sign() == 0) return;
  require(force == limit, "contact", k, "it slides with a force inside of the friction cone");
  require(product.sign() <= 0, "contact", k, "friction drives the sliding");
  if (problem.dimension < 3) return;
  const Number cross = x[normal + 1] * w[normal + 2] - x[normal + 2] * w[normal + 1];
  require(cross.sign() == 0, "contact", k, "friction is not parallel to the sliding");
}

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
inline bool fails(const Problem& problem, std::size_t k, const std::vector<Range>& r, const std::vector<Range>& u) {
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
  const auto of = [&](const std::vector<Range>& ranges, std::size_t k) {
    const auto begin = ranges.begin() + static_cast<std::ptrdiff_t>(problem.normal(k));
    return std::vector<Range>(begin, begin + static_cast<std::ptrdiff_t>(problem.dimension));
  };
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    if (fails(problem, k, of(forces, k), of(motions, k))) return nowhere + "contact " + std::to_string(k);
  }
  throw Rejected("every row and every contact may hold within RHO");
}

inline std::string no_solution(const Problem& problem, Reader& reader) {
  const Vector y = reader.numbers("multipliers", problem.size());
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
  for (std::size_t j = 0; j < problem.free; ++j) require(g[j].sign() == 0, "column", j, "g is not 0");
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const std::size_t normal = problem.normal(k);
    require(g[normal].sign() <= 0, "contact", k, "g_N is positive");
    Number tangential;
    for (std::size_t j = normal + 1; j < normal + problem.dimension; ++j) tangential += square(g[j]);
    require(square(problem.mu[k]) * tangential <= square(g[normal]), "contact", k, "m |g_T| exceeds |g_N|");
  }
  require(work.sign() < 0, "c . y is not negative");
  return "no solution";
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

/// A + A^T - L L^T.
inline Matrix remainder(const Matrix& A, const Matrix& L) {
  Matrix result(A.size()), columns(A.size());
  for (std::size_t i = 0; i < A.size(); ++i) {
    for (const auto& [j, a] : A[i]) result[i][j] += a, result[j][i] += a;
    for (const auto& [k, l] : L[i]) columns[k][i] = -l;
  }
  for (std::size_t i = 0; i < A.size(); ++i) {
    for (const auto& [k, l] : L[i]) {
      for (const auto& [j, minus] : columns[k]) result[i][j] += l * minus;
    }
  }
  return result;
}

inline std::string unique(const Problem& problem, Reader& reader) {
  const std::size_t n = problem.size();
  const bool is_definite = reader.accept("definite");
  if (!is_definite && !reader.accept("dominant")) reader.refuse("'dominant' or 'definite'");
  Matrix L;
  Vector d(n, 1);
  if (is_definite) L = reader.entries(n, n);
  if (!is_definite) d = reader.numbers(n);
  require(problem.free == 0 && problem.dimension == 1, "the problem has free unknowns or friction");
  for (std::size_t i = 0; i < L.size(); ++i) {
    require(L[i].empty() || L[i].rbegin()->first <= i, "row", i, "an entry stands above the diagonal");
  }
  check_dominant(is_definite ? remainder(problem.A, L) : problem.A, d);
  return std::string("one solution, whatever the constant, by a ") + (is_definite ? "definite" : "dominant") +
         " matrix";
}

}  // namespace slipproof::check_contact
