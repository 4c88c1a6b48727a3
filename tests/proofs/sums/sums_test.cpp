// Sums of squares: what is found is exact and no more than is true, also where it touches 0; and what the theory says
// of single polynomials. Where the solver is not installed, only that nothing changes.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "proofs/branch/facts.hpp"
#include "proofs/check/judge.hpp"
#include "proofs/search/prove.hpp"
#include "proofs/search/small_statement.hpp"
#include "proofs/sums/semidefinite.hpp"
#include "proofs/sums/squares_sum.hpp"
#include "support/run_program.hpp"

namespace {

using namespace slipproof;
using namespace slipproof::prove;
using test::statement;

const std::filesystem::path squares_folder = SLIPPROOF_SOURCE_DIR "/proofs/squares/by-hand.theorems";

bool solver_installed() {
  if (sums::has_semidefinite_solver()) return true;
  MESSAGE("csdp is not installed: skipped");
  return false;
}

/// What the checker says of a proof, or the prover's verdict where there is none.
std::string verdict_on(const std::string& text, const Limits& limits = {}) {
  const ProofOutcome outcome = prove_statement("small", text, limits);
  if (!outcome.proved()) return std::string(name(outcome.verdict));
  const check::Judgement judgement = check::judge(text, outcome.certificate);
  return judgement.verdict == check::Verdict::accepted ? "accepted" : judgement.message;
}

/// Whether there is a sum of squares of this shape that contradicts the conclusion's negation.
bool has_sum(const std::string& lines, const sums::Shape& shape) {
  const Statement read("small", statement(lines));
  Context context(read, {});
  State state;
  REQUIRE(!add_formula(context, state, "goal", negation(read.shown())));
  auto ansatz = sums::make_ansatz(context, state, shape);
  REQUIRE(ansatz);
  if (!sums::simplify(context, *ansatz)) return false;
  const auto sum = sums::find_sum_of_squares(context, *ansatz);
  if (!sum) return false;
  Polynomial total(read.ring());
  for (const sums::Square& square : sum->squares) {
    Polynomial worth = power(square.root, 2).scaled(square.coefficient);
    for (const auto& [name, exponent] : square.product) {
      CHECK(name == "goal");
      worth *= power(negation(read.shown()).polynomial.front(), exponent);
    }
    CHECK(square.coefficient > 0);
    CHECK(worth == square.worth);
    total += worth;
  }
  CHECK(total.is_zero());
  return true;
}

/// A variable of the environment, for the programs that are run meanwhile.
class Environment {
 public:
  Environment(const char* variable, const std::string& value) : variable_(variable) {
    if (const char* before = std::getenv(variable)) before_ = before;
    setenv(variable, value.c_str(), 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() { before_ ? setenv(variable_, before_->c_str(), 1) : unsetenv(variable_); }

 private:
  const char* variable_;
  std::optional<std::string> before_;
};

const std::string motzkin = "real x y\nshow x^4*y^2 + x^2*y^4 + 1 >= 3*x^2*y^2\n";

}  // namespace

TEST_CASE("matrices with a given diagonal have the margin that their closed form gives") {
  if (!solver_installed()) return;
  for (const double beside : {0.0, 0.5, 1.0, 2.0}) {
    sums::MatrixEquations problem{{2, 1}, {}};
    problem.equations.push_back({{{{0, 0, 0}, 1.0}}, 1.0});
    problem.equations.push_back({{{{0, 1, 1}, 1.0}}, 1.0});
    problem.equations.push_back({{{{0, 0, 1}, 1.0}}, 2 * beside});  // two places
    problem.equations.push_back({{{{1, 0, 0}, 4.0}}, 8.0});
    const auto point = sums::widest_point(problem);
    REQUIRE(point);
    CHECK(point->margin == doctest::Approx(1 - beside).epsilon(1e-5));  // the smaller of 1 - x, 1 + x, 2 and 1
    REQUIRE(point->blocks.size() == 2);
    CHECK(point->blocks[0][0] == doctest::Approx(1).epsilon(1e-5));
    CHECK(point->blocks[0][1] == doctest::Approx(beside).epsilon(1e-5));
    CHECK(point->blocks[0][2] == point->blocks[0][1]);
    CHECK(point->blocks[1][0] == doctest::Approx(2).epsilon(1e-5));
  }
}

TEST_CASE("polynomials that are no sums of squares are none, and are with a multiplier") {
  if (!solver_installed()) return;
  CHECK(!has_sum(motzkin, {6, 1, false}));
  CHECK(has_sum(motzkin, {8, 1, false}));
  // Nor is Motzkin's plus a constant, whatever the constant.
  CHECK(!has_sum("real x y\nshow x^4*y^2 + x^2*y^4 + 100 >= 3*x^2*y^2\n", {6, 1, false}));
  // A form needs a form as multiplier, which vanishes at 0.
  const std::string choi_lam = "real x y z w\nshow x^2*y^2 + y^2*z^2 + z^2*x^2 + w^4 >= 4*x*y*z*w\n";
  CHECK(!has_sum(choi_lam, {4, 1, false}));
  CHECK(!has_sum(choi_lam, {6, 1, false}));
  CHECK(has_sum(choi_lam, {6, 1, true}));
  CHECK(has_sum("real x y\nshow x^4 + y^4 + 1 > x*y\n", {4, 1, false}));
  // There is a sum of squares, and none of squares with rational coefficients (Scheiderer 2016).
  const std::string irrational =
      "real x y z\nshow x^4 + x*y^3 + y^4 - 3*x^2*y*z - 4*x*y^2*z + 2*x^2*z^2 + x*z^3 + y*z^3 + z^4 >= 0\n";
  CHECK(!has_sum(irrational, {4, 1, false}));
}

TEST_CASE("most random sums of squares with a common zero are proved, and nothing below them") {
  if (!solver_installed()) return;
  std::mt19937 random(43);
  const auto number = [&](unsigned most) { return random() % (most + 1); };
  int proved = 0;
  for (int k = 0; k < 12; ++k) {
    // All squares vanish where u and v do.
    const std::string at = fmt::format("let u = x - {}\nlet v = y + {}\n", number(3), number(3));
    std::string sum;
    for (int square = 0; square < 3; ++square) {
      sum +=
          fmt::format("{}({}*u + {}*u*v - {}*v^2 + v)^2", square > 0 ? " + " : "", number(8), number(8), number(8) + 1);
    }
    CAPTURE(at);
    CAPTURE(sum);
    const Limits limits{.split_depth = 0};
    const std::string verdict = verdict_on(statement("real x y\n" + at + "show " + sum + " >= 0\n"), limits);
    CHECK((verdict == "accepted" || verdict == "undecided"));
    proved += verdict == "accepted" ? 1 : 0;
    const std::string below = verdict_on(statement("real x y\n" + at + "show " + sum + " >= 1/1000\n"), limits);
    CHECK((below == "refuted" || below == "undecided"));
  }
  CHECK(proved >= 8);  // the kernels of the others are not seen in binary64
}

TEST_CASE("statements that nothing else proves, and false ones beside them") {
  if (!solver_installed()) return;
  for (const auto& [lines, expected] : std::vector<std::pair<std::string, std::string>>{
           {motzkin, "accepted"},
           {"real x y z\nshow x^4*y^2 + y^4*z^2 + z^4*x^2 >= 3*x^2*y^2*z^2\n", "accepted"},  // by a form
           {"real x y\nshow x^4*y^2 + x^2*y^4 + 1 > 3*x^2*y^2\n", "refuted"},
           {"real x y\nshow x^4*y^2 + x^2*y^4 + 999/1000 >= 3*x^2*y^2\n", "refuted"},
           {"real x y\nassume c: x^2 + y^2 = 1\nshow x*y <= 1/2\n", "accepted"},
           {"real x y\nassume c: x^2 + y^2 = 1\nshow x*y < 1/2\n", "undecided"},
           {"real x y z\nassume b: x^2 + y^2 + z^2 <= 1\nshow x + 2*y + 2*z <= 3\n", "accepted"},
           {"real x y z\nassume b: x^2 + y^2 + z^2 <= 1\nshow x + 2*y + 2*z < 3\n", "undecided"}}) {
    CAPTURE(lines);
    CHECK(verdict_on(statement(lines)) == expected);
    if (expected == "accepted") CHECK(verdict_on(statement(lines), {.sums_of_squares = false}) == "undecided");
  }
}

TEST_CASE("shipped sums of squares are found again, and no folder of the solver is left") {
  if (!solver_installed()) return;
  const test::TemporaryFolder scratch;
  for (const char* name : {"motzkin", "choi-lam-sextic", "quartic-above-products", "product-on-circle", "bipotential",
                           "triangle-1983", "cosine-of-difference"}) {
    CAPTURE(std::string(name));
    scratch.write(std::string(name) + ".statement",
                  test::read_file(squares_folder / (std::string(name) + ".statement")));
  }
  const Environment temporary("TMPDIR", scratch.path().string());
  const auto end = test::run({"prove", "--quiet", scratch.path().string()});
  CHECK(end.exit_code == 0);
  std::size_t certificates = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) {
    CHECK(entry.is_regular_file());
    if (entry.path().extension() != ".cert") continue;
    ++certificates;
    const std::string text = test::read_file(std::filesystem::path(entry.path()).replace_extension(".statement"));
    CHECK(check::judge(text, test::read_file(entry.path())).verdict == check::Verdict::accepted);
  }
  CHECK(certificates == 7);
}

TEST_CASE("without the solver a search ends as it did") {
  const test::TemporaryFolder scratch;
  scratch.write("small.statement", statement(motzkin));
  const auto end = [&] {
    const Environment without("PATH", "/nowhere");
    return test::run({"prove", scratch.path().string()});
  }();
  CHECK(end.exit_code == 4);
  CHECK(end.out.find("undecided small") != std::string::npos);
}
