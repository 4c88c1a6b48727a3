// import and export, from the shipped files to an answer.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"

using slipproof::test::read_file;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

const std::string imported = SLIPPROOF_SOURCE_DIR "/cases/imported/";

bool has_parsers() {
  const bool found = std::filesystem::exists(SLIPPROOF_BINARY_DIR "/slipproof-parsers.so");
  if (!found) MESSAGE("not tried: the program was built without the parsers");
  return found;
}

}  // namespace

TEST_CASE("the shipped scenes of other programs are imported, told about and solved") {
  if (!has_parsers()) return;
  const TemporaryFolder folder;
  const std::string out = folder.path() / "scene.toml";
  const auto crate = run({"import", imported + "crate.sdf", "-o", out});
  CHECK(crate.exit_code == 0);
  CHECK(crate.out == "s IMPORTED " + out + " bodies 1 contacts 2 plane xz\n");
  CHECK(crate.err.find("left out: visual (line 13)") != std::string::npos);
  CHECK(run({"solve", "--quiet", out}).out.find("motions 1 strict 1") != std::string::npos);
  const auto arm = run({"import", imported + "arm.urdf", "--ground", "0", "--mu", "0.5", "-o", out, "--quiet"});
  CHECK(arm.exit_code == 0);
  CHECK(arm.err.empty());
  CHECK(run({"import", imported + "cart.xml", "--plane", "xz", "-o", out}).exit_code == 0);
  CHECK(Json::parse(run({"solve", "--json", out}).out)["motions"][0]["forces"]["N_rear_touch"] == "60");
}

TEST_CASE("shipped scenes of other programs are imported in space and solved") {
  if (!has_parsers()) return;
  const TemporaryFolder folder;
  const std::string out = folder.path() / "scene.toml";
  const auto stool = run({"import", imported + "stool.xml", "--space", "-o", out});
  CHECK(stool.out == "s IMPORTED " + out + " bodies 2 contacts 7 in space\n");
  const auto solved = run({"solve", "--json", out});
  CHECK(solved.exit_code == 0);
  CHECK(Json::parse(solved.out)["complete"] == true);
  CHECK(run({"import", imported + "biped.xml", "--space", "--key", "walks", "-o", out}).exit_code == 0);
  CHECK(run({"import", imported + "biped.xml", "--space", "--key", "runs", "-o", out}).err.find("walks") !=
        std::string::npos);
  CHECK(run({"import", imported + "biped.xml", "-o", out}).err.find("found an armature") != std::string::npos);
  CHECK(run({"import", imported + "cart.xml", "--space", "--spatial", "-o", out}).exit_code == 2);
  CHECK(run({"import", imported + "cart.xml", "--stand", "-o", out}).exit_code == 2);
}

TEST_CASE("what a scene does not say is asked for, and nothing is lost") {
  if (!has_parsers()) return;
  const TemporaryFolder folder;
  const std::string out = folder.path() / "out.toml";
  const auto fails = [&](const std::vector<std::string>& arguments, int code, const std::string& said) {
    const auto end = run(arguments);
    CAPTURE(end.err);
    CHECK(end.exit_code == code);
    CHECK(end.err.find(said) != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(out));
  };
  fails({"import", imported + "arm.urdf", "--ground", "0", "-o", out}, 3, "--mu does");
  fails({"import", imported + "crate.sdf", "--plane", "xy", "-o", out}, 3, "gravity points out of it");
  fails({"import", imported + "crate.sdf", "--mu", "many", "-o", out}, 2, "--mu");
  fails({"import", imported + "crate.sdf", "--mu", "-1", "-o", out}, 2, "negative");
  fails({"import", imported + "nothing.sdf", "-o", out}, 3, "nothing.sdf");
  fails({"import", imported + "README.md", "-o", out}, 3, "found no XML");
  const std::string text = read_file(imported + "crate.sdf"), copy = folder.write("crate.sdf", text);
  CHECK(run({"import", copy, "-o", copy}).exit_code == 3);
  CHECK(read_file(copy) == text);
}

TEST_CASE("an exported problem is judged, with the answer that the scene has") {
  const TemporaryFolder folder;
  const std::string out = folder.path() / "problem.json";
  const std::string scene = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/asked/scenes/block-pushed.toml";
  CHECK(run({"export", scene, "--load", "1/4", "-o", out}).out == "s EXPORTED " + out + " contacts 2\n");
  Json problem = Json::parse(read_file(out));
  CHECK(problem["contacts"] == Json({"left", "right"}));
  // At F = 1/4 the block slides flat: N = (1/2 -+ (30 F + 36/5)/32), S = -N/5.
  const double left = 0.5 - (30 * 0.25 + 36 * 0.2) / 32, right = 1 - left;
  problem["r"] = {left, -left / 5, right, -right / 5};
  const auto judged = run({"certify", folder.write("answered.json", problem.dump(1)), "--quiet"});
  CHECK(judged.exit_code == 0);
  CHECK(judged.out.find("s CERTIFIED 1/1") != std::string::npos);
  CHECK(run({"export", scene, "-o", out}).exit_code == 3);
  CHECK(run({"export", scene, "--load", "-1", "-o", out}).exit_code == 2);
}

TEST_CASE("a scene's bodies are exported on one line, with other values") {
  const TemporaryFolder folder;
  const std::string out = folder.path() / "scene.json", cases = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/";
  const std::string scene = cases + "asked/scenes/block-pushed.toml";
  CHECK(run({"export", scene, "--bodies", "--set", "mu=1/4", "--set", "m=2", "--load", "3", "-o", out}).out ==
        "s EXPORTED " + out + " contacts 2\n");
  const std::string text = read_file(out);
  CHECK(text.find('\n') == text.size() - 1);
  const Json bodies = Json::parse(text);
  CHECK(bodies["schema"] == "slipproof/bodies/1");
  CHECK(bodies["bodies"][0]["mass"] == 2);
  CHECK(bodies["contacts"][0]["friction"] == 0.25);
  const auto fails = [&](const std::vector<std::string>& more, int code, const std::string& said) {
    std::vector<std::string> arguments{"export", "--bodies", "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto end = run(arguments);
    CAPTURE(end.err);
    CHECK(end.exit_code == code);
    CHECK(end.err.find(said) != std::string::npos);
    CHECK(read_file(out) == text);
  };
  fails({scene}, 3, "found no value of the load F");
  fails({cases + "scenes/ladder.toml"}, 3, "given by its equations");
  fails({scene, "--set", "mu"}, 2, "expected NAME=VALUE");
  fails({scene, "--set", "mu=x"}, 2, "--set");
  fails({scene, "--set", "mo=1"}, 2, "--set");
  fails({scene, "--set", "h=-1"}, 2, "expected h > 0");
}

TEST_CASE("a scene is exported for each line of standard input") {
  const TemporaryFolder folder;
  const std::string out = folder.path() / "scene.json";
  const std::string scene = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/asked/scenes/block-pushed.toml";
  for (const bool bodies : {true, false}) {
    const auto told = [&](std::vector<std::string> arguments, const std::string& input = "") {
      arguments.insert(arguments.begin(), {"export", scene});
      if (bodies) arguments.push_back("--bodies");
      return run(arguments, "slipproof", input);
    };
    CHECK(told({"--set", "m=2", "--load", "3", "-o", out}).exit_code == 0);
    const Json first = Json::parse(read_file(out));
    CHECK(told({"--set", "mu=1/4", "--set", "h=1", "--set", "m=2", "--load", "3", "-o", out}).exit_code == 0);
    const auto each = told({"--each", "--set", "m=2", "--load", "3"}, "\nmu=1/4 h=1\n");
    CHECK(each.exit_code == 0);
    const std::size_t end = each.out.find('\n');
    CHECK(Json::parse(each.out.substr(0, end)) == first);
    CHECK(Json::parse(each.out.substr(end + 1)) == Json::parse(read_file(out)));
    const auto stopped = told({"--each", "--load", "3"}, "\nmu\n\n");
    CHECK(stopped.exit_code == 2);
    CHECK(std::count(stopped.out.begin(), stopped.out.end(), '\n') == 1);
    CHECK(stopped.err.find("expected NAME=VALUE") != std::string::npos);
    CHECK(told({}).exit_code == 2);
    CHECK(told({"--each", "-o", out}).exit_code == 2);
  }
}
