// Small problems that are judged as files are.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "records/certify/judged_problems.hpp"
#include "records/problems/contact_file.hpp"

using namespace slipproof;
using namespace slipproof::test;
using Json = nlohmann::json;

TEST_CASE("a small problem that is judged as a file has all its solutions, and the margin of a wrong answer's mode") {
  const std::string definite = R"({"M":[[2,1],[1,2]],"q":[-5,-6],)";
  const std::string three_solutions = R"({"M":[[1,2],[2,1]],"q":[-1,-1],)";
  CertifyOptions as_file;
  as_file.law = FrictionLaw::cone;
  const Json line = judged(three_solutions + R"("z":[1,0]})", as_file),
             in_a_line = judged(three_solutions + R"("z":[1,0]})");
  CHECK(line["verdict"] == "ambiguous");
  CHECK(line["all"]["solutions"] == 3);
  CHECK(line["all"]["found"] == in_a_line["found"]);
  CHECK_FALSE(line["all"].contains("violated"));
  const Json wrong = judged(definite + R"("z":[2.5,0]})", as_file);
  CHECK(wrong["verdict"] == "wrong");
  CHECK(wrong["all"]["looks_like"] == "zw");
  CHECK(wrong["all"]["violated"] == "w2 >= 0");
  CHECK(wrong["all"]["margin"] == "-7/2");
  const std::string rod = R"({"W":[[1,0,1,0],[0,1,0,1],[1,0,1,0],[0,1,0,1]],"q":[-1,0,-1,0],"mu":[0.5,0.5],)";
  const Json open = judged(rod + R"("z":[0.25,0.125,0.75,-0.125]})", as_file);
  CHECK(open["verdict"] == "solution within rho");
  CHECK(open["unique"] == "velocities");
  CHECK_FALSE(open.contains("others"));
  CHECK(open["all"]["continuum"] == true);
  CHECK(open["all"]["continua"][0]["mode"] == "stick/stick");
}

TEST_CASE("wrong guesses of a file are no answers: with refine one is looked for") {
  ReadProblem read;
  read.problem.dimension = 3;
  read.problem.W = from_dense(3, 3, std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  read.problem.q = {-10, 3, 0};
  read.problem.mu = {0.5};
  read.answers.push_back({"/guesses/1", {0, 0, 0}, {}, {}, {}});
  ContactFileOptions options;
  CHECK(judge_problem_file("guessed", read, options).first().judgement.verdict == ContactVerdict::wrong);
  options.judge.refine = true;
  const JudgedProblem found("guessed", read, options);
  REQUIRE(found.answers.size() == 2);
  CHECK(found.first().origin == "found here");
  CHECK(is_certified(found.first().judgement.verdict));
  CHECK(found.answers[1].judgement.verdict == ContactVerdict::wrong);
  // An answer that is called one stays the first, and so does a guess that is right.
  read.answers[0].origin = "/solution";
  CHECK(JudgedProblem("answered", read, options).first().judgement.verdict == ContactVerdict::wrong);
  read.answers[0] = {"/guesses/1", {10, -3, 0}, {}, {}, {}};
  CHECK(JudgedProblem("guessed", read, options).first().origin == "/guesses/1");
}
