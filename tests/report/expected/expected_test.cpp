// Expected answers as data, and those that are shipped.
#include "report/expected/expected.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/scene/scene.hpp"
#include "support/how_many.hpp"

using namespace slipproof;
using Read = nlohmann::json;

namespace {

const std::string engines = SLIPPROOF_SOURCE_DIR "/cases/engines/";

ExpectedAnswer answer_of(const std::string& scene) {
  return expected_answer(read_scene(engines + "scenes/" + scene + ".toml"),
                         std::filesystem::path(scene).stem().string());
}
Read json_of(const std::string& scene) {
  return Read::parse(expected_json({answer_of(scene)}));
}
Expected answer_in_space(const std::string& scene) {
  return expected_of(engines + "scenes/" + scene + ".toml", std::filesystem::path(scene).stem().string());
}
Read json_in_space(const std::string& scene) {
  return Read::parse(expected_json({answer_in_space(scene)}));
}
/// Many contacts, or a threshold, whose motions are found at many values.
bool is_long_in_space(const MechanismScene& scene) {
  return scene.mechanism.dimension == 3 && (scene.mechanism.contacts.size() > 3 || scene.threshold);
}

}  // namespace

TEST_CASE("a cube pushed above what friction holds has the acceleration that one computes by hand") {
  const Read cube = json_of("one-motion/cube-pushed-above-limit");
  CHECK(cube["schema"] == "slipproof/expected/1");
  CHECK(cube["how_many"] == "one");
  CHECK(cube["unknowns"] == Read({"ax", "ay", "alpha"}));
  REQUIRE(cube["motions"].size() == 1);
  const Read& motion = cube["motions"][0];
  CHECK(motion["modes"] == Read({"slip+/slip+"}));
  CHECK(motion["accelerations"]["ax"]["exact"] == "19/200");  // 5 - 9.81/2
  CHECK(motion["accelerations"]["ax"]["double"] == 0.095);
  CHECK(cube["threshold"].is_null());
}

TEST_CASE("forces that nothing determines have their ranges") {
  // At rest, each foot may bear all of the push that the other's cone allows: |S| <= mu N = 4.905/2.
  const Read block = json_of("undetermined/block-friction-opposed");
  const Read& forces = block["motions"][0]["forces"];
  CHECK(forces["N_left"]["exact"] == "981/200");
  CHECK(forces["S_left"]["lower"]["exact"] == "-981/200");
  CHECK(forces["S_left"]["upper"]["double"] == 4.905);
}

TEST_CASE("thresholds are where statics has them") {
  const auto at = [](const std::string& scene) {
    const Read read = json_of("thresholds/" + scene);
    REQUIRE(read["threshold"]["changes"].size() == 1);
    return read["threshold"]["changes"][0]["at"];
  };
  CHECK(at("push-that-moves-a-cube")["exact"] == "981/200");  // mu m g
  CHECK(at("friction-on-slope-3-4")["exact"] == "3/4");       // the slope
  CHECK(at("disc-rolls-on-slope")["exact"] == "1/4");         // a third of it
  CHECK(at("ring-slips-when-pulled")["exact"] == "981/100");  // 2 mu m g
  // T = m g R mu (1 + mu)/(1 + mu^2) with m g R = 5, T = 3/2
  const Read drum = at("friction-that-holds-a-drum");
  CHECK(drum["polynomial"] == "7*mu^2 + 10*mu - 3");
  const double mu = drum["double"];
  CHECK(std::abs(7 * mu * mu + 10 * mu - 3) < 1e-15);
}

TEST_CASE("between its ends a threshold scene has the motions of below or of above, and no others") {
  for (const std::string name : {"push-that-leaves-a-box-behind", "ladder-friction", "couple-over-a-kerb"}) {
    const ExpectedAnswer answer = answer_of("thresholds/" + name);
    const SceneThreshold& along = *answer.solved.scene.threshold;
    REQUIRE(answer.changes.size() == 1);
    const MotionChange& change = answer.changes[0];
    for (int i = 1; i < 16; ++i) {
      const Rational x = along.from + (along.to - along.from) * Rational(i, 16);
      if (change.at.lower <= x && x <= change.at.upper) continue;
      const MechanismScene there = with_values(answer.solved.scene, {{along.parameter, x}});
      const auto motions = motions_of(friction_problem(there.mechanism, there.values), there.load).motions;
      REQUIRE(motions.size() == 1);
      const auto& expected = (x < change.at.lower ? change.below : change.above).motions[0];
      const auto modes = motions[0].all_modes();
      CHECK(std::ranges::find_first_of(modes, expected) != modes.end());
    }
  }
}

TEST_CASE("a threshold in space lies between two values that are proved, or is exact where rest ends exactly") {
  // A ball that rolls slips where 2/7 F = mu m g.
  const Read slips = json_in_space("space-thresholds/push-at-which-a-ball-slips");
  REQUIRE(slips["threshold"]["changes"].size() == 1);
  const Read& change = slips["threshold"]["changes"][0];
  const double lower = change["at"]["lower"]["double"], upper = change["at"]["upper"]["double"], exact = 3.5 * 4.905;
  CHECK(lower < exact);
  CHECK(exact < upper);
  CHECK(upper - lower < 1e-5);
  CHECK(change["below"]["motions"] == Read::parse(R"([["stick"]])"));
  CHECK(change["above"]["motions"] == Read::parse(R"([["slip"]])"));
  const Read tripod = json_in_space("space-thresholds/push-that-moves-a-tripod-at-0");
  CHECK(tripod["threshold"]["changes"][0]["at"]["exact"] == "981/100");  // mu m g
}

TEST_CASE("in space it is said whether a scene can rest and must rest") {
  const Read slides = json_in_space("space-cone/tripod-pushed-at-37");
  CHECK(slides["can_rest"] == false);
  CHECK(slides["must_rest"] == false);
  const Read stands = json_in_space("space-slope/tripod-on-slope");
  CHECK(stands["can_rest"] == true);
  CHECK(stands["must_rest"] == true);
  const Read jams = json_in_space("space-several/jammed-ball-12-1-0");  // it comes out as well
  CHECK(jams["can_rest"] == true);
  CHECK(jams["must_rest"] == false);
  CHECK(json_in_space("space-cone/ball-slides-at-31")["can_rest"].is_null());  // it moves
}

TEST_CASE("a threshold in space that leaves the domain is refused") {
  MechanismScene scene =
      read_scene(engines + "scenes/space-thresholds/push-at-which-a-ball-slips.toml", Dimensions::any);
  scene.threshold = SceneThreshold{"m", -1, 1};
  CHECK_THROWS_WITH_AS(expected_of(scene, "ball"), doctest::Contains("ball: [threshold]: found values outside"),
                       InputError);
  scene.threshold = SceneThreshold{"nu", 0, 1};
  CHECK_THROWS_WITH_AS(expected_of(scene, "ball"), doctest::Contains("nu"), InputError);
}

TEST_CASE("an impact has its outcomes by each law, and no test for pytest") {
  const std::string file = engines + "scenes/impact/two-balls-e-half.toml";
  const Expected answer = expected_of(std::filesystem::path(file), "two-balls-e-half");
  const Read balls = Read::parse(expected_json({answer}));
  CHECK(balls["unknowns"].size() == balls["before"]["velocities"].size());
  CHECK(balls["before"]["energy"] == "2");
  for (const char* law : {"newton", "moreau", "poisson"}) {
    CHECK(balls["impact"][law]["complete"] == true);
    REQUIRE(balls["impact"][law]["outcomes"].size() == 1);
    CHECK(balls["impact"][law]["outcomes"][0]["energy"] == "5/4");  // (1/2)^2/2 + (3/2)^2/2
  }
  CHECK_THROWS_WITH_AS(expected_pytest({answer}), doctest::Contains("found an impact"), InputError);
}

TEST_CASE("texts with quotes, backslashes and control characters are told as they are") {
  ExpectedAnswer answer = answer_of("one-motion/cube-tips");
  answer.solved.scene.question = "a \"b\" \\ c\n\a\xc3\xa9?";
  CHECK(expected_pytest({answer}).find("\"a \\\"b\\\" \\\\ c\\n\\u0007\xc3\xa9?\"") != std::string::npos);
}

TEST_CASE("what cannot be expected is refused with its reason") {
  MechanismScene scene = read_scene(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/asked/scenes/block-pushed.toml");
  CHECK_THROWS_WITH_AS(expected_answer(scene, "block"), doctest::Contains("block: found no value of the load F"),
                       InputError);
  scene.load = 1;
  scene.threshold = SceneThreshold{"F", 0, 1};
  CHECK(expected_answer(scene, "block").changes.size() == 3);
  scene.threshold = SceneThreshold{"nu", 0, 1};
  CHECK_THROWS_WITH_AS(expected_answer(scene, "block"), doctest::Contains("[threshold]: unknown parameter"),
                       InputError);
  scene.threshold = SceneThreshold{"m", -1, 1};
  CHECK_THROWS_WITH_AS(expected_answer(scene, "block"), doctest::Contains("outside the domain"), InputError);
}

TEST_CASE("a scene says its question, who asked it, and its threshold, and is written with them") {
  const std::string mechanism = engines + "mechanisms/block.toml";
  const std::string text = "name = \"a\"\nquestion = \"Does it move?\"\nasked = \"by nobody\"\nmechanism = \"" +
                           mechanism +
                           "\"\n[values]\nm = 1\nI = 1\nb = 1\nh = 1\nmu = 1\ng = 10\nFx = 1\n[threshold]\n";
  const MechanismScene scene = parse_scene(text + "parameter = \"Fx\"\nfrom = 1\nto = 20\n", "scene.toml");
  CHECK(scene.question == "Does it move?");
  const MechanismScene again = parse_scene(to_toml(scene, mechanism), "scene.toml");
  CHECK(again.asked == "by nobody");
  CHECK(again.threshold->parameter == "Fx");
  CHECK(again.threshold->to == 20);
  const auto fails = [&](const std::string& threshold, const char* said) {
    CHECK_THROWS_WITH_AS(parse_scene(text + threshold, "scene.toml"), doctest::Contains(said), InputError);
  };
  fails("parameter = \"Fz\"\nfrom = 1\nto = 2\n", "unknown parameter 'Fz'");
  fails("parameter = \"Fx\"\nfrom = 2\nto = 2\n", "expected more than `from`");
  fails("parameter = \"Fx\"\nto = 2\n", "missing from");
}

TEST_CASE("the shipped expected answers are found again, byte for byte") {
  const auto every = static_cast<std::size_t>(test::how_many("SLIPPROOF_EXPECTED_EVERY", 20));
  std::set<std::string> scenes, answers;
  const auto collect = [](const std::string& folder, const std::string& extension, std::set<std::string>& names) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.path().extension() != extension) continue;
      names.insert(entry.path().parent_path().filename().string() + "/" + entry.path().stem().string());
    }
  };
  collect(engines + "scenes", ".toml", scenes);
  collect(engines + "expected", ".json", answers);
  CHECK(scenes == answers);
  CHECK(scenes.size() >= 500);
  std::set<std::string> stems, classes;
  std::size_t next = 0;
  for (const std::string& name : scenes) {
    CAPTURE(name);
    CHECK(stems.insert(std::filesystem::path(name).stem().string()).second);
    classes.insert(std::filesystem::path(name).parent_path().string());
    if (next++ % every != 0) continue;
    const MechanismScene scene = read_scene(engines + "scenes/" + name + ".toml", Dimensions::any);
    CHECK_FALSE(scene.question.empty());
    if (every > 1 && is_long_in_space(scene)) continue;
    const Expected answer = answer_in_space(name);
    CHECK(expected_json({answer}) == read_text_file(engines + "expected/" + name + ".json"));
  }
  CHECK(classes.size() == 15);
}
