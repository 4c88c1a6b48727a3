// Small problems that are judged as files are.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "records/certify/judged_problems.hpp"

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
