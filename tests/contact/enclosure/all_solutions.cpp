#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "contact/exact/exact_lcp.hpp"
#include "contact/exact/no_solution.hpp"
#include "contact/exact/unique_class.hpp"
#include "lcp_problems.hpp"

using namespace lcp;

namespace {

using Kind = SolutionCount::Kind;

SolutionCount all_solutions(const MixedProblem& p) {
  Effort effort(10'000'000'000);
  SolutionCount result = count_solutions(p, effort);
  for (const Rationals& x : result.solutions) REQUIRE(obeys_law(p, x));
  auto sorted = result.solutions;
  std::sort(sorted.begin(), sorted.end());
  REQUIRE(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
  return result;
}

/// A problem in the text form of Siconos: without bilateral rows "n 0 n n n n", the matrix, the constant, and words.
std::optional<std::pair<Matrix, std::vector<double>>> read_lcp(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::size_t n = 0, bilateral = 1, skipped = 0;
  file >> n >> bilateral;
  if (!file || bilateral != 0) return std::nullopt;
  for (int i = 0; i < 4; ++i) file >> skipped;
  Matrix A(n, std::vector<double>(n));
  std::vector<double> c(n);
  for (auto& row : A) {
    for (double& x : row) file >> x;
  }
  for (double& x : c) file >> x;
  if (!file) return std::nullopt;
  return std::pair(A, c);
}

}  // namespace

TEST_CASE("small problems have the solutions of all their active sets") {
  Draw draw(1);
  std::set<Kind> seen;
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::size_t n = draw.size(1, 4);
    const Matrix A = draw.matrix(n, n, -3, 3);
    const MixedProblem p = problem(A, draw.vector(n, -4, 4));
    const SolutionCount found = all_solutions(p);
    const Enumerated all = enumerate(p, A);
    seen.insert(found.kind);
    if (found.kind == Kind::continuum) CHECK(found.solutions.size() >= 2);
    if (found.kind == Kind::continuum) CHECK(all.singular);
    if (found.kind == Kind::none) CHECK(all.solutions.empty());
    if (all.singular) continue;
    ++compared;
    CHECK(std::set<Rationals>(found.solutions.begin(), found.solutions.end()) == all.solutions);
    CHECK(found.kind == (all.solutions.empty() ? Kind::none : all.solutions.size() == 1 ? Kind::one : Kind::several));
  }
  CHECK(compared > 200);
  CHECK(seen == std::set<Kind>{Kind::none, Kind::one, Kind::several, Kind::continuum});
}

TEST_CASE("known problems") {
  CHECK(all_solutions(problem({{1, 2}, {2, 1}}, {-1, -1})).solutions.size() == 3);
  CHECK(all_solutions(problem({{0}}, {-1})).kind == Kind::none);
  CHECK(all_solutions(problem({{0}}, {0})).kind == Kind::continuum);
  CHECK(all_solutions(problem({{0}}, {1})).kind == Kind::one);
  CHECK(all_solutions(problem({{1, 1}, {1, 1}}, {-1, -1})).kind == Kind::continuum);
  CHECK(all_solutions(problem({}, {})).kind == Kind::one);
  for (std::size_t n = 1; n <= 6; ++n) {  // x_i is 0 or 1
    Matrix A(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i) A[i][i] = -1;
    const SolutionCount found = all_solutions(problem(A, std::vector<double>(n, 1)));
    CHECK(found.kind == Kind::several);
    CHECK(found.solutions.size() == std::size_t{1} << n);
  }
}

TEST_CASE("a contact as on Painleve's rod: nothing, slip and stick are possible at once") {
  const Matrix W = {{1, 2}, {2, 5}};
  const SolutionCount three = all_solutions(problem(W, {1, 10}, {1}));
  CHECK(three.kind == Kind::several);
  CHECK(std::set<Rationals>(three.solutions.begin(), three.solutions.end()) ==
        std::set<Rationals>{{0, 0}, {1, -1}, {15, -8}});
  CHECK(all_solutions(problem(W, {-1, 10}, {1})).solutions == std::vector<Rationals>{{25, -12}});
  CHECK(all_solutions(problem(W, {1, 10}, {0.25})).solutions == std::vector<Rationals>{{0, 0}});
  CHECK(all_solutions(problem({{0, 0}, {0, 0}}, {0, 1}, {1})).kind == Kind::continuum);
}

TEST_CASE("random contacts with friction: each solution obeys the law, and one that is built in is found") {
  Draw draw(2);
  int several = 0;
  for (int i = 0; i < 150; ++i) {
    const std::size_t contacts = draw.size(1, 3), n = 2 * contacts;
    const Matrix W = draw.matrix(n, n, -3, 3);
    MixedProblem p = problem(W, std::vector<double>(n), std::vector<double>(contacts, 0.5));
    Rationals x(n);
    for (std::size_t k = 0; k < contacts; ++k) {
      x[2 * k] = 2 * draw.whole(0, 2);
      x[2 * k + 1] = draw.whole(-1, 1) * x[2 * k] / 2;  // slides forward or backward, or sticks
    }
    const Rationals w = image(p, x);
    for (std::size_t k = 0; k < contacts; ++k) {
      const double gap = x[2 * k] == 0 ? draw.whole(0, 3) : 0, slip = -sign(x[2 * k + 1]) * draw.whole(0, 3);
      p.c[2 * k] = gap - w[2 * k].to_double();
      p.c[2 * k + 1] = slip - w[2 * k + 1].to_double();
    }
    REQUIRE(obeys_law(p, x));
    const SolutionCount found = all_solutions(p);
    REQUIRE(found.kind != Kind::unknown);
    CHECK(found.kind != Kind::none);
    if (found.kind == Kind::continuum) continue;
    CHECK(std::count(found.solutions.begin(), found.solutions.end(), x) == 1);
    several += found.kind == Kind::several ? 1 : 0;
  }
  CHECK(several > 10);
}

TEST_CASE("free unknowns are eliminated before solutions are counted") {
  // 2 v + r = 4 and w = v + r - 1 = r / 2 + 1 > 0, so that r = 0; with v + r - 3 it is r = 2, v = 1.
  for (const int r : {0, 2}) {
    MixedProblem global = problem({{2, 1}, {1, 1}}, {-4, r == 0 ? -1.0 : -3.0});
    global.free = 1;
    global.mu = {0};
    Effort effort(1'000'000);
    const SolutionCount found = count_solutions(global, effort);
    CHECK(found.kind == Kind::one);
    CHECK(found.solutions == std::vector<Rationals>{{Rational(4 - r, 2), Rational(r)}});
  }
}

TEST_CASE("what is not counted is unknown") {
  MixedProblem singular = problem({{0, 0}, {0, 1}}, {-1, -1});
  singular.free = 1;
  singular.mu = {0};
  CHECK(all_solutions(singular).kind == Kind::unknown);
  Draw draw(3);
  const MixedProblem large = problem(draw.definite(30, 1), std::vector<double>(30, -1));
  CHECK(all_solutions(large).kind == Kind::unknown);
  Effort little(1000);
  CHECK(count_solutions(problem(draw.definite(6, 1), std::vector<double>(6, -1)), little).kind == Kind::unknown);
}

TEST_CASE("published problems are solved, and what is said of them agrees") {
  const char* given = std::getenv("SLIPPROOF_SHARED");
  const std::filesystem::path shared = given != nullptr ? given : SLIPPROOF_SOURCE_DIR "/../shared/data";
  if (!std::filesystem::is_directory(shared / "lcp")) return;
  int problems = 0;
  for (const auto& file : std::filesystem::directory_iterator(shared / "lcp")) {
    const auto text = read_lcp(file.path());
    if (!text || text->second.size() > 12) continue;
    CAPTURE(file.path().filename().string());
    ++problems;
    const MixedProblem p = problem(text->first, text->second);
    const SolutionCount found = all_solutions(p);
    CHECK(found.kind != Kind::unknown);
    Effort effort(10'000'000'000);
    const auto proof = prove_unique(p, effort);
    if (proof) CHECK(found.kind == Kind::one);
    const auto solution = solve_lcp(p, std::vector<bool>(p.size()), effort);
    if (found.kind == Kind::one) CHECK(solution);
    if (found.kind == Kind::none) CHECK(!solution);
    if (infeasibility(p, effort)) CHECK(found.kind == Kind::none);
  }
  CHECK(problems >= 5);
}
