#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/run_program.hpp"

using slipproof::test::run;
using Json = nlohmann::json;

namespace {

std::vector<std::filesystem::path> cases() {
  std::vector<std::filesystem::path> result;
  for (const auto& entry : std::filesystem::directory_iterator(SLIPPROOF_SOURCE_DIR "/cases")) {
    if (entry.path().extension() == ".toml") result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

TEST_CASE("every shipped scene is solved, in text and in JSON, the same bytes twice") {
  REQUIRE(cases().size() >= 12);
  for (const auto& scene : cases()) {
    CAPTURE(scene);
    const auto text = run({"solve", scene});
    CHECK(text.exit_code == 0);
    CHECK(text.err.empty());
    CHECK(text.out.substr(text.out.rfind('\n', text.out.size() - 2) + 1).starts_with("s SOLVED "));
    const auto json = run({"solve", "--json", scene});
    CHECK(json.exit_code == 0);
    const Json document = Json::parse(json.out);
    CHECK(document["schema"] == "slipproof/solve/2");
    CHECK(document.contains("motions") == !document["load"]["value"].is_null());
    if (document.contains("motions")) {
      std::size_t modes = document["rejected"].size() + document["continua"].size();
      for (const auto& motion : document["motions"]) modes += motion["modes"].size() + motion["boundary_modes"].size();
      CHECK(modes == (document["not_modelled"].empty() ? 16 : 9));
    }
    CHECK(run({"solve", "--json", scene}).out == json.out);
  }
}

TEST_CASE("of every load solve says what critical says, where the theorem is about such contacts") {
  const std::string folder = SLIPPROOF_SOURCE_DIR "/cases/";
  for (const auto& [scene, verdict] : std::vector<std::pair<std::string, Json>>{
           {"ambiguous.toml", "not unique"},
           {"mechanisms/scenes/bicycle-two-radii.toml", "unique"},
           {"mechanisms/scenes/ladder.toml", "at most one"},         // W is singular
           {"mechanisms/scenes/block-on-incline.toml", nullptr}}) {  // it slides already
    CAPTURE(scene);
    const Json told = Json::parse(run({"solve", "--json", folder + scene}).out)["every_q"];
    CHECK(told == Json::parse(run({"critical", "--json", folder + scene}).out)["at_value"]["every_q"]);
    CHECK((told.is_null() ? told : told["verdict"]) == verdict);
    const std::string text = run({"solve", folder + scene}).out;
    CHECK((text.find("ther forces") != std::string::npos || text.find("whatever else") != std::string::npos) ==
          !told.is_null());
  }
}

TEST_CASE("--load is another value of the load, in the plane and in space, where there is one") {
  const std::string cases = SLIPPROOF_SOURCE_DIR "/cases/";
  for (const std::string& scene : {cases + "city-bicycle.toml", cases + "space/cube-pushed-obliquely.toml"}) {
    const Json own = Json::parse(run({"solve", scene, "--json"}).out);
    const Json other = Json::parse(run({"solve", scene, "--json", "--load", "1/8"}).out);
    const auto load = [](const Json& answer) { return answer.contains("F") ? answer["F"] : answer["load"]["value"]; };
    CHECK(load(other) == "1/8");
    CHECK(own["motions"] != other["motions"]);
    CHECK(run({"solve", scene, "--load", "1/0"}).exit_code == 2);
  }
  CHECK(run({"solve", cases + "space/ball-on-belt.toml", "--load", "1"}).exit_code == 2);
}

TEST_CASE("--quiet prints the result line alone") {
  const auto quiet = run({"solve", "--quiet", cases().front()});
  CHECK(quiet.out.starts_with("s SOLVED "));
  CHECK(std::count(quiet.out.begin(), quiet.out.end(), '\n') == 1);
}

TEST_CASE("usage errors exit with 2 and say what is wrong; help and version with 0") {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {}, {"solve"}, {"sovle", "x"}, {"solve", "a", "b"}, {"solve", "--digits", "0", "x"}, {"--nonsense"}}) {
    const auto outcome = run(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK_FALSE(outcome.err.empty());
    CHECK(outcome.out.empty());
  }
  CHECK(run({"--help"}).exit_code == 0);
  CHECK(run({"solve", "--help"}).exit_code == 0);
  CHECK(run({"--version"}).out.starts_with("slipproof "));
}

TEST_CASE("bad scenes exit with 3 and name the place; nothing on standard output") {
  const slipproof::test::TemporaryFolder folder;
  const auto scene = folder.write("bad.toml", "[bicycle]\nR = \"one\"\n");
  const auto outcome = run({"solve", scene});
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find("bad.toml:2:") != std::string::npos);
  CHECK(run({"solve", folder.path() / "missing.toml"}).exit_code == 3);
  CHECK(run({"solve", folder.path()}).exit_code == 3);
}

TEST_CASE("results have the units of the file, and those that follow") {
  const std::string cases = SLIPPROOF_SOURCE_DIR "/cases/";
  const auto solved = [&](const std::string& scene) { return run({"solve", cases + scene}).out; };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  const std::string bicycle = solved("three-motions/three-motions.toml");
  // In the file, by a coefficient of 1 in the gap, and in the file.
  CHECK(has(bicycle, "    a     0.477273 m/s^2 = 21/44\n"));
  CHECK(has(bicycle, "    gap2  0 m/s^2\n"));
  CHECK(has(bicycle, "    N2    0.957386 N     = 337/352\n"));
  CHECK(has(solved("space/domino.toml"), "    N_back_right        0 N\n"));
  // A file without units has none.
  const std::string ball = solved("engines/scenes/one-motion/ball-rolls-down-slope.toml");
  CHECK(has(ball, "    alpha     -5.39011       = -981/182\n"));
  CHECK(has(ball, "    gap_tyre  0\n"));
}
