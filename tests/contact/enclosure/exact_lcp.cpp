#include "contact/exact/exact_lcp.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <thread>

#include "contact/exact/active_sets.hpp"
#include "lcp_problems.hpp"

using namespace lcp;

namespace {

Effort enough() {
  return Effort(10'000'000'000);
}

Rationals values(const ExactVector& x) {
  Rationals result;
  for (std::size_t i = 0; i < x.size(); ++i) result.push_back(x.at(i));
  return result;
}

std::optional<Rationals> exact_solution_from(const MixedProblem& p, std::vector<bool> active) {
  Effort effort = enough();
  const auto found = solve_lcp(p, std::move(active), effort);
  if (!found) return std::nullopt;
  const Rationals x = values(found->x);
  REQUIRE(obeys_law(p, x));
  REQUIRE(image(p, x) == values(found->w));
  for (std::size_t i = 0; i < x.size(); ++i) {
    REQUIRE(found->state(i) == sign(x[i]) - sign(found->w.at(i)));
    REQUIRE((found->active[i] ? found->w.sign(i) : found->x.sign(i)) == 0);
  }
  return x;
}

}  // namespace

TEST_CASE("linear systems are solved as by Cramer's rule") {
  Draw draw(1);
  int singular = 0;
  for (int i = 0; i < 500; ++i) {
    const std::size_t n = draw.size(1, 5);
    Matrix A = draw.matrix(n, n, -2, 2);
    std::vector<double> c = draw.vector(n, -3, 3);
    const bool is_even = i % 2 == 0;  // whole numbers, with singular matrices, or all bits and exponents
    for (std::size_t r = 0; r < n && !is_even; ++r) {
      for (double& x : A[r]) x = std::ldexp(x * draw.real(), draw.whole(-300, 300));
      c[r] = std::ldexp(draw.real(), draw.whole(-900, 900));
    }
    Rationals b;
    for (const double x : c) b.push_back(-to_rational(x));
    const auto expected = cramer(exact(A), b);
    Effort effort = enough();
    const auto found = exact_solution(sparse(A), c, effort);
    REQUIRE(found.has_value() == expected.has_value());
    singular += expected ? 0 : 1;
    if (!expected) continue;
    CHECK(values(*found) == *expected);
    CHECK(found->denominator > 0);
    CHECK(values(exact_rows(sparse(A), *found, c)) == Rationals(n));
    std::vector<double> other = draw.vector(n, -3, 3);
    CHECK(values(exact_rows(sparse(A), *found, other)) == image(problem(A, other), *expected));
  }
  CHECK(singular > 30);
  const double least = 0x1p-1074, greatest = 0x1.fffffffffffffp1023;
  Effort effort = enough();
  const auto extreme = exact_solution(sparse({{greatest, 0}, {least, least}}), std::vector<double>{-least, 0}, effort);
  REQUIRE(extreme);
  CHECK(extreme->at(0) == to_rational(least) / to_rational(greatest));
  CHECK(extreme->at(1) == -extreme->at(0));
}

TEST_CASE("problems with one solution are solved from any set") {
  Draw draw(2);
  for (int i = 0; i < 500; ++i) {
    const std::size_t n = draw.size(1, 5);
    const Matrix A = draw.definite(n, 1);
    const MixedProblem p = problem(A, draw.vector(n, -9, 9));
    const Enumerated all = enumerate(p, A);
    REQUIRE(all.solutions.size() == 1);
    CHECK(exact_solution_from(p, draw.set(n)) == *all.solutions.begin());
  }
  Matrix murty(14, std::vector<double>(14));  // pivoting one by one takes 2^14 steps from the empty set
  for (std::size_t i = 0; i < 14; ++i) {
    for (std::size_t j = 0; j <= i; ++j) murty[i][j] = i == j ? 1 : 2;
  }
  const MixedProblem p = problem(murty, std::vector<double>(14, -1));
  Rationals first(14);
  first[0] = 1;
  CHECK(exact_solution_from(p, std::vector<bool>(14)) == first);
}

TEST_CASE("pivots end where all at once go round in a circle") {
  // {1}, {2}, {3}, {1}: of Ben Gharbia and Gilbert (2012), a P-matrix.
  const MixedProblem p = problem({{1, 0, 2}, {2, 1, 0}, {0, 2, 1}}, {1, 1, 1});
  Effort effort = enough();
  CHECK(active_by_pivots(p, {true, false, false}, effort) == std::vector<bool>(3));
}

TEST_CASE("solutions are those that problems were built from") {
  Draw draw(3);
  for (const std::size_t n : {10U, 40U, 120U}) {
    const Matrix A = draw.definite(n, 1);
    Rationals x;
    std::vector<double> c;
    for (std::size_t i = 0; i < n; ++i) x.push_back(Rational(std::max(0, draw.whole(-8, 8)), 16));
    for (std::size_t i = 0; i < n; ++i) {
      double sum = x[i] == 0 ? std::max(0, draw.whole(-2, 8)) : 0;  // a few have x_i = w_i = 0
      for (std::size_t j = 0; j < n; ++j) sum -= A[i][j] * x[j].to_double();
      c.push_back(sum);
    }
    CHECK(exact_solution_from(problem(A, c), draw.set(n)) == x);
  }
}

TEST_CASE("powers of two at rows and columns change nothing else") {
  Draw draw(4);
  const std::size_t n = 30;
  const Matrix A = draw.definite(n, 1);
  const std::vector<double> c = draw.vector(n, -9, 9);
  const auto x = exact_solution_from(problem(A, c), std::vector<bool>(n));
  REQUIRE(x);
  Matrix scaled = A;
  std::vector<double> constant = c;
  std::vector<int> columns;
  for (std::size_t j = 0; j < n; ++j) columns.push_back(draw.whole(-100, 100));
  for (std::size_t i = 0; i < n; ++i) {
    const int row = draw.whole(-100, 100);
    for (std::size_t j = 0; j < n; ++j) scaled[i][j] = std::ldexp(A[i][j], row + columns[j]);
    constant[i] = std::ldexp(c[i], row);
  }
  std::vector<bool> active;
  for (const Rational& value : *x) active.push_back(value > 0);
  const auto y = exact_solution_from(problem(scaled, constant), active);
  REQUIRE(y);
  for (std::size_t j = 0; j < n; ++j) CHECK((*y)[j] * to_rational(std::ldexp(1, columns[j])) == (*x)[j]);
}

TEST_CASE("exact signs mend what floating point cannot see") {
  // x_1 = 2/3, and then w_2 = 2/3 - c, where c is 2/3 rounded up: x_2 must be a little more than 0.
  const double c = 0x1.5555555555556p-1;
  REQUIRE(to_rational(c) > Rational(2, 3));
  const MixedProblem p = problem({{3, 0}, {1, 1}}, {-2, -c});
  Effort effort = enough();
  const auto proposed = active_by_pivots(p, {true, false}, effort);
  REQUIRE(proposed);
  CHECK(*proposed == std::vector<bool>{true, false});  // else this tests nothing
  CHECK(!solve_active(p, *proposed, effort));
  const auto x = exact_solution_from(p, {true, false});
  REQUIRE(x);
  CHECK((*x)[0] == Rational(2, 3));
  CHECK((*x)[1] == to_rational(c) - Rational(2, 3));
}

TEST_CASE("any matrix: what is called a solution is one, and most that exist are found") {
  Draw draw(5);
  int found = 0, missed = 0, none = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::size_t n = draw.size(1, 4);
    const Matrix A = draw.matrix(n, n, -3, 3);
    const MixedProblem p = problem(A, draw.vector(n, -5, 5));
    const auto x = exact_solution_from(p, draw.set(n));  // holds it to the law
    const Enumerated all = enumerate(p, A);
    if (!all.singular && all.solutions.empty()) {
      CHECK(!x);
      ++none;
    } else {
      (x ? found : missed) += 1;
    }
  }
  CHECK(found > 1000);
  CHECK(missed < found / 2);
  CHECK(none > 100);
}

TEST_CASE("Lemke's method finds what pivots on the diagonal cannot") {
  // No set but {1, 2} has a regular matrix; that of a linear program.
  const MixedProblem p = problem({{0, -1}, {1, 0}}, {1, -2});
  Effort effort = enough();
  CHECK(!active_by_pivots(p, {true, false}, effort));
  CHECK(exact_solution_from(p, {true, false}) == Rationals{2, 1});
  // Copositive and strictly so, but no P-matrix: Lemke's method does not end in a ray (Cottle, Pang, Stone, 4.4.13).
  Draw draw(6);
  for (int i = 0; i < 300; ++i) {
    const std::size_t n = draw.size(2, 8);
    const MixedProblem q = problem(draw.matrix(n, n, 1, 9), draw.vector(n, -9, 9));
    const auto active = active_by_lemke(q, effort);
    REQUIRE(active);
    CHECK(solve_active(q, *active, effort));
  }
}

TEST_CASE("nothing is returned where there is nothing, or too little effort") {
  CHECK(!exact_solution_from(problem({{0}}, {-1}), {true}));
  CHECK(!exact_solution_from(problem({{-1}}, {-1}), {false}));
  CHECK(!exact_solution_from(problem({{1, -1}, {-1, 1}}, {-1, 0}), {true, true}));
  CHECK(!exact_solution_from(problem({{1}}, {-1}), {true, false}));
  CHECK(!exact_solution_from(problem({{1, 0}, {0, 1}}, {-1, -1}, {0.5}), {true, false}));  // friction
  CHECK(exact_solution_from(problem({}, {}), {}) == Rationals());
  Draw draw(7);
  const MixedProblem p = problem(draw.definite(30, 1), std::vector<double>(30, -1));
  Effort little(20'000), much = enough();
  CHECK(!solve_lcp(p, std::vector<bool>(30, true), little));
  CHECK(solve_lcp(p, std::vector<bool>(30, true), much));
}

TEST_CASE("several threads solve at once") {
  Draw draw(8);
  const std::size_t n = 60;
  const MixedProblem p = problem(draw.definite(n, 1), draw.vector(n, -9, 9));
  const auto expected = exact_solution_from(p, std::vector<bool>(n));
  REQUIRE(expected);
  std::vector<Rationals> found(4);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < found.size(); ++t) {
    threads.emplace_back([&, t] {
      Effort effort = enough();
      const auto solution = solve_lcp(p, std::vector<bool>(n, t % 2 == 0), effort);
      if (solution) found[t] = values(solution->x);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Rationals& x : found) CHECK(x == *expected);
}
