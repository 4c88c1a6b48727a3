// Verdicts on contact problems in space: residuals of 20,000 contacts, an enclosure of 570 that all touch, exact LCPs.
#include <benchmark/benchmark.h>

#include <cmath>

#include "base/number/dice.hpp"
#include "contact/enclosure/known_problem.hpp"
#include "contact/exact/exact_lcp.hpp"
#include "contact/judge/find/find.hpp"
#include "contact/judge/judge.hpp"

namespace {

using namespace slipproof;

double between(Dice& dice, double low, double high) {
  return low + (high - low) * dice.number(0, 1'000'000) * 1e-6;
}

struct BenchProblem {
  MixedProblem problem;
  std::vector<double> x;
};

/// A third of the contacts open, a third sticking, a third sliding; each row has `band` entries to either side.
BenchProblem banded_problem(std::size_t contacts, std::size_t band) {
  Dice dice(1, contacts);
  const std::size_t n = 3 * contacts;
  std::vector<MatrixEntry> entries, twice;
  std::vector<double> sums(n, 1), u(n, 0);
  BenchProblem made;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i > band ? i - band : 0; j < i; ++j) {
      const double a = between(dice, -1, 1);
      entries.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), a});
      entries.push_back({static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(i), a});
      sums[i] += 1.5 * std::abs(a);
      sums[j] += 1.5 * std::abs(a);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    entries.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i), sums[i]});
  }
  made.problem.A = sparse_matrix(n, n, std::move(entries), twice);
  made.problem.mu.assign(contacts, 0.5);
  made.x.assign(n, 0);
  for (std::size_t k = 0; k < contacts; ++k) {
    double* const r = made.x.data() + 3 * k;
    double* const v = u.data() + 3 * k;
    const double N = between(dice, 1, 2), angle = between(dice, 0, 6.28);
    const double c = std::cos(angle), s = std::sin(angle);
    if (k % 3 == 0) {
      v[0] = between(dice, 0.1, 1);
    } else {
      const double pull = k % 3 == 1 ? 0.3 : 0.5;
      r[0] = N;
      r[1] = pull * N * c;
      r[2] = pull * N * s;
    }
    if (k % 3 == 2) {
      v[1] = -c;
      v[2] = -s;
    }
  }
  made.problem.c.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    made.problem.c[i] = u[i] - exact_row(made.problem, i, made.x).to_double();
  }
  return made;
}

void residual_of_contacts(benchmark::State& state) {
  const BenchProblem made = banded_problem(static_cast<std::size_t>(state.range(0)), 30);
  for (auto _ : state) {
    const std::vector<Rational> w = exact_rows(made.problem, made.x);
    benchmark::DoNotOptimize(residual(made.problem, made.x, w));
    benchmark::DoNotOptimize(exclusion(made.problem, made.x, w));
  }
}
BENCHMARK(residual_of_contacts)->Arg(300)->Arg(20'000)->Unit(benchmark::kMillisecond);

/// Dense: every contact moves every other. Of 1,700 unknowns 733 contacts are made, of 5,000 2,143.
void enclosure_of_contacts(benchmark::State& state) {
  const auto contacts = static_cast<std::size_t>(state.range(0));
  const BenchProblem made = banded_problem(contacts, 3 * contacts);
  for (auto _ : state) {
    if (!judge_contacts(made.problem, made.x, {}, {}).enclosure) state.SkipWithError("no enclosure");
  }
}
BENCHMARK(enclosure_of_contacts)->Arg(60)->Arg(733)->Arg(2143)->Unit(benchmark::kMillisecond);

/// Balls in rows that push each other: a row of so many, or as many rows.
void coupled(benchmark::State& state) {
  const auto contacts = static_cast<std::size_t>(state.range(0)), rows = static_cast<std::size_t>(state.range(1));
  Dice dice(3, contacts);
  const test::KnownProblem made = test::coupled_contacts(dice, contacts, rows);
  for (auto _ : state) {
    if (!judge_contacts(made.problem, made.x, {}, {}).enclosure) state.SkipWithError("no enclosure");
  }
}
BENCHMARK(coupled)->ArgsProduct({{200, 1000, 10000, 30000}, {1}})->Unit(benchmark::kMillisecond);
BENCHMARK(coupled)->Args({20, 20})->Args({40, 40})->Args({80, 80})->Unit(benchmark::kMillisecond);

/// What sweeps over the contacts take to find the answer, where they find one: W's diagonal exceeds its row by 1/2.
void sweeps_find(benchmark::State& state) {
  const auto contacts = static_cast<std::size_t>(state.range(0));
  Dice dice(3, contacts);
  const test::KnownProblem made = test::coupled_contacts(dice, contacts, 1, 0.5);
  for (auto _ : state) {
    const std::vector<double> x = approximate_solution(made.problem);
    const Residual found = residual(made.problem, x, exact_rows(made.problem, x));
    if (found.backward_error() > 1e-10) state.SkipWithError("not found");
  }
}
BENCHMARK(sweeps_find)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// And what it takes to enclose it.
void enclosure_of_what_sweeps_find(benchmark::State& state) {
  const auto contacts = static_cast<std::size_t>(state.range(0));
  Dice dice(3, contacts);
  const test::KnownProblem made = test::coupled_contacts(dice, contacts, 1, 0.5);
  for (auto _ : state) {
    if (!judge_contacts(made.problem, made.x, {}, {}).enclosure) state.SkipWithError("no enclosure");
  }
}
BENCHMARK(enclosure_of_what_sweeps_find)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// Random and positive definite, all components active.
void exact_complementarity(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  Dice dice(2, n);
  std::vector<double> A(n * n);
  MixedProblem problem;
  problem.dimension = 1;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) A[i * n + j] = between(dice, -1, 1) / 3;
    A[i * n + i] = static_cast<double>(n);
    problem.c.push_back(-static_cast<double>(n) - between(dice, 0, 1));
  }
  problem.A = from_dense(n, n, A);
  problem.mu.assign(n, 0);
  for (auto _ : state) {
    Effort effort(unlimited);
    if (!solve_lcp(problem, std::vector<bool>(n, true), effort)) state.SkipWithError("no solution");
  }
}
BENCHMARK(exact_complementarity)->Arg(60)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
