// What a line says of other solutions than the one that is near an answer.
#include <doctest/doctest.h>

#include "support/certified.hpp"

using namespace slipproof;
using namespace slipproof::test;
using Json = nlohmann::json;

namespace others {

namespace {

const std::string ball_that_sticks = R"({"dimension":3,"W":[[1,0,0],[0,1,0],[0,0,1]],"q":[-1,0.25,0],"mu":0.5,)"
                                     R"("r":[1,-0.25,0]})";
const std::string open_or_stick =
    R"({"dimension":3,"W":[[9,-4,-4],[-4,7,2],[-4,2,3]],"q":[2,-3,-3],"mu":3,"r":[0,0,0]})";
const std::string definite = R"({"M":[[2,1],[1,2]],"q":[-5,-6],"z":["4/3","7/3"]})";

Certified lines(const std::string& text) {
  CertifyOptions options;
  options.format = RecordFormat::json_lines;
  return certified(text, options);
}

}  // namespace

TEST_CASE("a solution that is not proved to be the only one says that others are not excluded") {
  const Certified found = lines(ball_that_sticks + "\n" + open_or_stick + "\n" + definite + "\n");
  const std::vector<Json> line = found.lines();
  REQUIRE(line.size() == 3);
  CHECK(line[0]["verdict"] == "solution within rho");
  CHECK(line[0]["others"] == "not excluded");
  CHECK(line[0]["linear_modes"] == Json{{"number", 6}, {"tried", true}});
  CHECK(line[1]["verdict"] == "ambiguous");
  CHECK(line[1]["other"] == Json{"2/3", "1/3", "5/3"});
  CHECK_FALSE(line[1].contains("others"));
  CHECK(line[2]["verdict"] == "certified");
  CHECK_FALSE(line[2].contains("others"));
  CHECK(found.summary.others_possible == 1);
  CHECK(Json::parse(to_json(found.summary))["others_not_excluded"] == 1);
}

}  // namespace others
