// Where the equations are singular, rounding makes up an inverse: the bounds have to see through it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/number/dice.hpp"
#include "contact/enclosure/krawczyk.hpp"
#include "contact/judge/judge.hpp"

using namespace slipproof;

namespace {

/// A linear complementarity problem whose matrix is exactly singular, its rank one less than its size; integers.
MixedProblem singular_problem(Dice& dice, std::size_t n) {
  std::vector<double> A(n * n);
  for (double& a : A) a = dice.number(-99, 99);
  for (std::size_t j = 0; j < n; ++j) {  // the last row is a combination of the others
    A[(n - 1) * n + j] = 0;
    for (std::size_t i = 0; i + 1 < n; ++i) A[(n - 1) * n + j] += static_cast<double>(1 + i % 7) * A[i * n + j];
  }
  MixedProblem problem;
  problem.dimension = 1;
  problem.A = from_dense(n, n, A);
  problem.mu.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) problem.c.push_back(dice.number(-9, 9));
  return problem;
}

SystemBlock whole_block(const ModeSystem& system, std::span<const double> z) {
  SystemBlock block;
  block.unknowns.resize(system.size());
  std::iota(block.unknowns.begin(), block.unknowns.end(), std::size_t{0});
  block.equations = block.unknowns;
  block.inverse = approximate_inverse(block_derivative(system, block, z));
  return block;
}

}  // namespace

TEST_CASE("a singular matrix is never enclosed, whatever inverse rounding makes up") {
  int made_up = 0;
  for (int i = 0; i < 3000; ++i) {
    Dice dice(23, static_cast<std::uint64_t>(i));
    const auto n = static_cast<std::size_t>(dice.number(2, 24));
    const MixedProblem problem = singular_problem(dice, n);
    const ModeSystem system(problem, ConeMode(n, ConeState::stick));
    const std::vector<double> z(n, 1);
    SystemBlock block = whole_block(system, z);
    if (!std::all_of(block.inverse.value.begin(), block.inverse.value.end(), [](double x) { return std::isfinite(x); }))
      continue;
    ++made_up;
    CHECK_FALSE(krawczyk(system, block, z));
  }
  CHECK(made_up > 1000);
}

TEST_CASE("a nearly singular matrix is enclosed where binary64 can, and contains the solution") {
  // Pascal's matrices: integers, determinant 1, condition beyond 10^16 from n = 14 on. A x = b with x = (1, -1, 1,
  // ...).
  int enclosed = 0;
  for (std::size_t n = 2; n <= 18; ++n) {
    std::vector<double> A(n * n, 1);
    for (std::size_t i = 1; i < n; ++i) {
      for (std::size_t j = 1; j < n; ++j) A[i * n + j] = A[(i - 1) * n + j] + A[i * n + j - 1];
    }
    MixedProblem problem;
    problem.free = n;
    problem.A = from_dense(n, n, A);
    std::vector<double> x(n);
    for (std::size_t j = 0; j < n; ++j) x[j] = j % 2 == 0 ? 1 : -1;
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < n; ++j) sum += A[i * n + j] * x[j];
      problem.c.push_back(-sum);
    }
    const ModeSystem system(problem, {});
    std::vector<double> z(n, 0);
    SystemBlock block = whole_block(system, z);
    for (int step = 0; step < 10; ++step) {
      const std::vector<double> d = newton_step(system, block, z, system.x_at(z));
      for (std::size_t j = 0; j < n; ++j) z[j] -= d[j];
    }
    const auto box = krawczyk(system, block, z);
    if (!box) continue;
    ++enclosed;
    for (std::size_t j = 0; j < n; ++j) CHECK(std::abs(z[j] - x[j]) <= box->radius[j]);
  }
  CHECK(enclosed >= 8);
}

TEST_CASE("rows of free unknowns without any of them are judged, too") {
  // M = 0: v is anything as long as no force acts, and the contact opens with 1.
  MixedProblem p;
  p.free = 1;
  p.dimension = 2;
  p.A = from_dense(3, 3, std::vector<double>{0, -1, 0, 1, 0, 0, 0, 0, 0});
  p.c = {0, 1, 1};
  p.mu = {0.5};
  const ContactJudgement found = judge_contacts(p, {0, 0, 0}, {}, {});
  CHECK(found.residual->backward_error() == 0);
  CHECK(found.verdict != ContactVerdict::wrong);
}
