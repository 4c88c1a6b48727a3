#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/run_program.hpp"

using slipproof::test::last_line;
using slipproof::test::run;

namespace {

const std::string simulated_scene = SLIPPROOF_SOURCE_DIR "/cases/ambiguous.toml";

}  // namespace

TEST_CASE("simulate says what it is, and which motions its runs come to, as text and as JSON") {
  const auto text = run({"simulate", simulated_scene, "--stiffness-ratio", "1", "--damping", "0.5"});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("a simulation, not a proof") != std::string::npos);
  CHECK(text.out.find("3 motions of rigid contacts") != std::string::npos);
  CHECK(last_line(text.out) == "s SIMULATED 2 runs: stick/stick 1, stick/lift 1\n");
  const auto document = nlohmann::json::parse(
      run({"simulate", simulated_scene, "--stiffness-ratio", "1", "--damping", "0.5", "--rise", "0", "--json"}).out);
  CHECK(document["schema"] == "slipproof/simulate/1");
  CHECK(document["proof"] == false);
  CHECK(document["motions"].size() == 3);
  CHECK(document["motions"][1]["accelerations"]["slip3"] == "327/160");
  REQUIRE(document["runs"].size() == 1);
  const auto& last = document["runs"][0]["seen"].back();
  CHECK(last["motion"] == 2);
  CHECK(last["mode"] == "stick/lift");
  CHECK(last["accelerations"]["slip3"].get<double>() == doctest::Approx(19947. / 6380).epsilon(0.01));
}

TEST_CASE("simulate takes a load, and refuses what it cannot simulate") {
  const auto other = run({"simulate", simulated_scene, "--load", "16/5", "--rise", "100", "--damping", "0.5"});
  CHECK(last_line(other.out) == "s SIMULATED 3 runs: stick/stick 3\n");
  CHECK(run({"simulate", simulated_scene, "--load", "much"}).exit_code == 2);
  CHECK(run({"simulate", simulated_scene, "--damping", "-1"}).exit_code == 2);
  const auto without = run({"simulate", SLIPPROOF_SOURCE_DIR "/cases/short-and-tall/mini-bike.toml"});
  CHECK(without.exit_code == 3);
  CHECK(without.err.find("found no value of the load F, expected one") != std::string::npos);
  const auto sliding = run({"simulate", SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes/painleve-rod.toml"});
  CHECK(sliding.exit_code == 3);
  CHECK(sliding.err.find("expected contacts from rest") != std::string::npos);
}
