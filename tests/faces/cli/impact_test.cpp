#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"

using slipproof::test::last_line;
using slipproof::test::run;

namespace {

const std::string impacts = SLIPPROOF_SOURCE_DIR "/cases/impact/";

}  // namespace

TEST_CASE("impact says what moves after, and that energy is gained") {
  const auto text = run({"impact", impacts + "rod-that-gains.toml"});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("an impact by Moreau's law") != std::string::npos);
  CHECK(text.out.find("GAINS 37.5 % of the energy") != std::string::npos);
  CHECK(last_line(text.out) == "s COMPLETE outcomes 1 gain energy 1 undecided 0\n");
}

TEST_CASE("impact as JSON: velocities before and after, impulses, energies") {
  const auto document =
      nlohmann::json::parse(run({"impact", impacts + "rod-that-gains.toml", "--law", "newton", "--json"}).out);
  CHECK(document["schema"] == "slipproof/impact/1");
  CHECK(document["law"] == "newton");
  CHECK(document["complete"] == true);
  CHECK(document["before"]["velocities"]["vy"] == "-2/5");
  CHECK(document["before"]["contacts"]["foot"]["opening"] == "-1");
  CHECK(document["before"]["energy"] == "4/15");
  REQUIRE(document["outcomes"].size() == 1);
  const auto& outcome = document["outcomes"][0];
  CHECK(outcome["modes"] == nlohmann::json::array({"stick"}));
  CHECK(outcome["velocities"]["omega"] == "-1/2");
  CHECK(outcome["impulses"]["N_foot"] == "11/10");
  CHECK(outcome["contacts"]["foot"]["opening"] == "1");
  CHECK(outcome["energy"] == "11/30");
  CHECK(outcome["gains_energy"] == true);
}

TEST_CASE("each law has its own outcome, and Poisson's says what compression ends with") {
  const auto poisson =
      nlohmann::json::parse(run({"impact", impacts + "rod-that-gains.toml", "--law", "poisson", "--json"}).out);
  CHECK(poisson["outcomes"][0]["gains_energy"] == false);
  CHECK(poisson["outcomes"][0]["velocities"].contains("omega_compression"));
  CHECK(poisson["outcomes"][0]["impulses"].contains("N_foot_extra"));
  CHECK(run({"impact", impacts + "two-balls.toml", "--law", "hertz"}).exit_code == 2);
}

TEST_CASE("a mechanism with [impact] is its own impact for all commands that know one") {
  const std::string proofs = SLIPPROOF_SOURCE_DIR "/proofs/impacts/";
  const auto search = run({"search", proofs + "cradle.toml", "--samples", "5"});
  CHECK(search.exit_code == 0);
  CHECK(search.out.find("touch/touch") != std::string::npos);
  const auto show = run({"show", proofs + "rod.toml"});
  CHECK(show.out.find("vx") != std::string::npos);
}

TEST_CASE("scenes without an impact are refused by impact, and approaching ones by others name it") {
  const auto rest = run({"impact", SLIPPROOF_SOURCE_DIR "/cases/rest/ladder.toml"});
  CHECK(rest.exit_code == 3);
  CHECK(rest.err.find("found no contact that approaches") != std::string::npos);
  const auto bicycle = run({"impact", SLIPPROOF_SOURCE_DIR "/cases/city-bicycle.toml"});
  CHECK(bicycle.exit_code == 3);
  const slipproof::test::TemporaryFolder folder;
  const std::string scene = (folder.path() / "ball.toml").string();
  std::ofstream(scene) << R"(schema = "slipproof/mechanism/1"
name = "ball"
gravity = "none"
[[body]]
name = "ball"
mass = "1"
turning = "0"
velocity = ["0", "-1"]
[[contact]]
name = "floor"
of = "ball"
point = ["0", "0"]
normal = ["0", "1"]
restitution = "1"
)";
  const auto solve = run({"solve", scene});
  CHECK(solve.exit_code == 3);
  CHECK(solve.err.find("slipproof impact") != std::string::npos);
  CHECK(run({"impact", scene}).exit_code == 0);
  CHECK(run({"rest", impacts + "two-balls.toml"}).exit_code == 3);  // an impact by its file
}

TEST_CASE("records of an impact are held against its outcomes, and tell their energy") {
  const slipproof::test::TemporaryFolder folder;
  const std::string records = (folder.path() / "rod.csv").string();
  std::ofstream(records) << "vx,vy,omega,N_foot,S_foot\n0.4,0.7,-0.5,1.1,0.2\n0.4,0.6,-0.5,1,0.2\n";
  const auto judged = run({"certify", "--scene", impacts + "rod-that-gains.toml", records});
  const std::size_t second = judged.out.find("{\"record\":2");
  REQUIRE(second != std::string::npos);
  CHECK(judged.out.find("\"verdict\":\"certified\"") < second);
  CHECK(judged.out.find("\"energy\":{\"before\":0.26666666666666666,\"work\":0.09999999999999998,\"gains\":true}") <
        second);
  CHECK(judged.out.find("\"verdict\":\"wrong\"", second) != std::string::npos);
}

TEST_CASE("a file with a step that has an impact tells its law and energy") {
  const slipproof::test::TemporaryFolder folder;
  const std::string file = (folder.path() / "rod.json").string();
  std::ofstream(file) << R"({"dimension": 2, "M": [[3, 0, 0], [0, 3, 0], [0, 0, 25]], "H": [[0, 1], [1, 0], [-3, 4]],
 "f": [3, -6, 25], "w": [0, 0], "mu": 1, "impact": "newton", "restitution": 1, "v_before": [1, -2, 1], "r": [16.5, 3]})";
  CHECK(run({"certify", file}).out.find("Impact by Newton's law: the answer GAINS 37.5 % of the energy.") !=
        std::string::npos);
}
