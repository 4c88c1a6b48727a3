// All solutions of problems in space, as the judge gives them, and their certificates before the checker.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "base/algebra/sparse_matrix.hpp"
#include "contact/formats/read_files.hpp"
#include "contact/judge/certificate.hpp"
#include "contact/judge/find/find.hpp"
#include "contact/judge/judge.hpp"
#include "proofs/check_contact/check_contact.hpp"

using namespace slipproof;

namespace {

MixedProblem problem_in_space(const std::string& text) {
  MixedProblem problem;
  const nlohmann::json given = nlohmann::json::parse(text);
  problem.dimension = 3;
  problem.mu = given["mu"].get<std::vector<double>>();
  problem.c = given["c"].get<std::vector<double>>();
  problem.free = problem.c.size() - 3 * problem.mu.size();
  std::vector<double> dense;
  for (const auto& row : given["A"]) dense.insert(dense.end(), row.begin(), row.end());
  problem.A = from_dense(problem.c.size(), problem.c.size(), dense);
  return problem;
}

/// A leaning body on one contact, which can lift, stick or slip.
MixedProblem leaning_body(double mu) {
  MixedProblem problem = problem_in_space(
      R"({"A": [[1.25, 1, 0], [1, 5, 0], [0, 0, 5.0625]], "c": [0.09375, 3.375, 2.09375], "mu": [1]})");
  problem.mu = {mu};
  return problem;
}

ContactJudgement judged_among_all(const MixedProblem& problem, std::vector<double> x) {
  ContactJudgeOptions options;
  options.all = true;
  return judge_contacts(problem, std::move(x), {}, options);
}

void check_claim_of(const MixedProblem& problem, const ContactJudgement& judgement, const std::string& established) {
  const auto verdict = check_contact::check_contact_certificate(contact_certificate(problem, judgement));
  CHECK(verdict.kind == check_contact::ContactVerdict::Kind::accepted);
  CAPTURE(verdict.message);
  CHECK(verdict.message.find(established) != std::string::npos);
}

}  // namespace

TEST_CASE("all motions of a leaning body: it lifts, sticks or slips") {
  const MixedProblem problem = leaning_body(1.75);
  const ContactJudgement open = judged_among_all(problem, {0, 0, 0});
  CHECK(open.verdict == ContactVerdict::ambiguous);
  REQUIRE(open.all);
  CHECK(open.all->solutions.size() == 3);
  check_claim_of(problem, open, "3 motions and no others");
}

TEST_CASE("with less friction the body lifts, and nothing else") {
  const MixedProblem problem = leaning_body(0.5);
  const ContactJudgement open = judged_among_all(problem, {0, 0, 0});
  CHECK(open.verdict == ContactVerdict::unique);
  check_claim_of(problem, open, "one motion and no other");
}

TEST_CASE("free unknowns are eliminated in certificates, too") {
  // v - r = f, u = v + w of a point mass: it rests, pressed with 2 and pushed with 1 where mu is 1.
  const MixedProblem problem = problem_in_space(R"({"A": [[1, 0, 0, -1, 0, 0], [0, 1, 0, 0, -1, 0], [0, 0, 1, 0, 0, -1],
      [1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0]], "c": [2, -1, 0, 0, 0, 0], "mu": [1]})");
  const ContactJudgement rest = judged_among_all(problem, {0, 0, 0, 2, -1, 0});
  CHECK(rest.verdict == ContactVerdict::unique);
  check_claim_of(problem, rest, "one motion and no other");
}

TEST_CASE("a block whose motion depends on how its feet share the weight moves in several ways") {
  const ProblemFile file =
      read_problem_file(std::string(SLIPPROOF_SOURCE_DIR) + "/cases/contact-problems/turning-block.json").problem;
  const MixedProblem problem = mixed_problem(file);
  const ContactJudgement slips = judged_among_all(problem, approximate_solution(problem, {}));
  CHECK(slips.verdict == ContactVerdict::ambiguous);
  REQUIRE(slips.all);
  REQUIRE(slips.all->solutions.size() == 1);
  const FoundSolution& continuum = slips.all->solutions[0];
  CHECK(continuum.is_family());
  CHECK(!continuum.others.empty());
  REQUIRE(continuum.around.size() == 12);
  for (std::size_t i = 0; i < 12; ++i) {
    for (const auto& other : continuum.others) {
      CHECK(*other.u[i].lower >= *continuum.around[i].lower);
      CHECK(*other.u[i].upper <= *continuum.around[i].upper);
    }
  }
  check_claim_of(problem, slips, "at least");
}

TEST_CASE("a search that ends early tells what it found, how many patterns are open, and how fast they may be") {
  const std::string file = SLIPPROOF_SOURCE_DIR "/cases/contact-problems/turning-block.json";
  const MixedProblem problem = mixed_problem(read_problem_file(file).problem);
  ContactJudgeOptions options;
  options.all = true;
  options.effort = 50'000'000;
  const ContactJudgement early = judge_contacts(problem, std::vector<double>(problem.size()), {}, options);
  CHECK_FALSE(early.all);
  REQUIRE(early.some);
  CHECK_FALSE(early.some->complete());
  CHECK(early.some->open_speed.value_or(0) > 0);
  const bool told = std::ranges::any_of(early.left_out, [](const std::string& words) {
    return words.find("patterns stay open") != std::string::npos &&
           words.find("no velocity is above") != std::string::npos;
  });
  CHECK(told);
}

TEST_CASE("three cubes on each other have one motion, and the checker takes the squares of their W") {
  const std::string file = SLIPPROOF_SOURCE_DIR "/cases/contact-problems/three-cubes.json";
  const MixedProblem problem = mixed_problem(read_problem_file(file).problem);
  const ContactJudgement rest = judged_among_all(problem, approximate_solution(problem, {}));
  REQUIRE(rest.all);
  REQUIRE(rest.all->solutions.size() == 1);
  CHECK(rest.all->solutions[0].open_directions == 18);
  CHECK(rest.all->solutions[0].others.empty());
  check_claim_of(problem, rest, "one motion and no other");
}
