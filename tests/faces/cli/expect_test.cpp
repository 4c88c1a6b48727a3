// expect: what it writes where, and what it refuses.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/replaced.hpp"
#include "support/run_program.hpp"

using slipproof::test::read_file;
using slipproof::test::replaced;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

const std::string shipped_cases = SLIPPROOF_SOURCE_DIR "/cases/";
const std::string tipping_cube = shipped_cases + "engines/scenes/one-motion/cube-tips.toml";
const std::string stuck_rod = shipped_cases + "engines/scenes/several-or-none/painleve-rod-inconsistent.toml";

}  // namespace

TEST_CASE("one scene is one document, several are an array, to a file or standard output") {
  const TemporaryFolder folder;
  const std::string out = folder.path() / "expected.json";
  const auto printed = run({"expect", tipping_cube});
  CHECK(printed.exit_code == 0);
  CHECK(Json::parse(printed.out)["scene"] == "cube-tips");
  CHECK(run({"expect", tipping_cube, "-o", out}).out.empty());
  CHECK(read_file(out) == printed.out);
  const Json both = Json::parse(run({"expect", tipping_cube, stuck_rod}).out);
  REQUIRE(both.size() == 2);
  CHECK(both[0] == Json::parse(printed.out));
  CHECK(both[1]["how_many"] == "none");
}

TEST_CASE("a scene in space is expected with ranges, and tested where each of its motions is known alone") {
  const std::string space = shipped_cases + "space/";
  const Json domino = Json::parse(run({"expect", space + "domino.toml"}).out);
  CHECK(domino["schema"] == "slipproof/expected/1");
  CHECK(domino["how_many"] == "one");
  CHECK(domino["complete"] == true);
  CHECK(domino["unknowns"] == Json({"ax", "ay", "az", "alphax", "alphay", "alphaz"}));
  const Json& ax = domino["motions"][0]["accelerations"]["ax"];
  CHECK(ax["lower"]["double"] <= ax["upper"]["double"]);
  const Json slope = Json::parse(run({"expect", space + "box-on-slope-pulled-sideways.toml"}).out);
  CHECK(slope["motions"][0]["accelerations"]["ax"]["exact"] == "981/6500");  // as worked out by hand
  CHECK(Json::parse(run({"expect", space + "cube-pushed-obliquely.toml"}).out)["how_many"] == "a continuum");
  const auto tests = run({"expect", space + "domino.toml", space + "stool-tipping.toml", "--format", "pytest"});
  CHECK(tests.exit_code == 0);
  CHECK(tests.out.find("\"turn\": [[1.0, 0.0, 0.0]") != std::string::npos);
  const auto continuum = run({"expect", space + "cube-pushed-obliquely.toml", "--format", "pytest"});
  CHECK(continuum.exit_code == 3);
  CHECK(continuum.err.find("found a motion beside which others may be") != std::string::npos);
}

TEST_CASE("what no engine can be asked is refused, and nothing is written") {
  const TemporaryFolder folder;
  std::string out = folder.path() / "expected.json";
  const auto fails = [&](const std::vector<std::string>& more, int code, const std::string& said) {
    std::vector<std::string> arguments{"expect", "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto end = run(arguments);
    CAPTURE(end.err);
    CHECK(end.exit_code == code);
    CHECK(end.err.find(said) != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(out));
  };
  fails({shipped_cases + "mechanisms/asked/scenes/book.toml"}, 3, "book: found no value of the load P");
  fails({tipping_cube, tipping_cube}, 2, "found two scenes called 'cube-tips'");
  fails({tipping_cube, "--format", "xml"}, 2, "--format");
  fails({tipping_cube, folder.path() / "missing.toml"}, 3, "missing.toml");
  out = folder.path() / "expected.py";
  fails({shipped_cases + "mechanisms/scenes/painleve-rod.toml", "--format", "pytest"}, 3, "given by its equations");
  const std::string text = replaced(read_file(tipping_cube), "../../", shipped_cases + "engines/");
  const std::string copy = folder.write("cube.toml", text);
  CHECK(run({"expect", copy}).exit_code == 0);
  CHECK(run({"expect", copy, "-o", copy}).exit_code == 3);
  CHECK(read_file(copy) == text);
}
