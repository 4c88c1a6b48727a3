#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/run_program.hpp"

using slipproof::test::city_bicycle;
using slipproof::test::read_file;
using slipproof::test::rear_drive;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

#ifdef SLIPPROOF_RSVG
constexpr bool draws_png = true;
#else
constexpr bool draws_png = false;
#endif

}  // namespace

TEST_CASE("report writes one file, the same at any number of threads") {
  const TemporaryFolder folder;
  const auto report = [&](const std::string& name, const std::string& threads) {
    const std::string file = (folder.path() / name).string();
    const auto outcome = run({"report", rear_drive, "--samples", "40", "--threads", threads, "--out", file});
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.starts_with("s REPORTED "));
    return read_file(file);
  };
  const std::string html = report("one.html", "1");
  CHECK(html.starts_with("<!DOCTYPE html>"));
  CHECK(html.find("claim-T1.5") != html.npos);
  // Our scenes, and what solvers made of them, have no place in a report on somebody else's paper.
  CHECK(html.find("class=\"model\"") != html.npos);
  CHECK(html.find("penny-farthing") == html.npos);
  CHECK(html.find("Certified solvers") == html.npos);
  CHECK(html == report("two.html", "2"));
}

TEST_CASE("a report that cannot be made is refused before the work, and what stood in its place stays") {
  const TemporaryFolder folder;
  const std::string file = folder.write("old.html", "as it was");
  const std::string fresh = (folder.path() / "new.html").string();
  // All these bicycles would take many minutes.
  const auto refusal = [](int exit_code, const std::vector<std::string>& arguments) {
    std::vector<std::string> all{arguments[0], "--samples", "100000000", "--only", "A1"};
    all.insert(all.end(), arguments.begin() + 1, arguments.end());
    const auto outcome = run(all);
    CHECK(outcome.exit_code == exit_code);
    CHECK(outcome.out.empty());
    return outcome.err;
  };
  CHECK(refusal(6, {"report", "--out", folder.path().string()}).find("cannot be written") != std::string::npos);
  CHECK(refusal(6, {"verify", "--report", file + "/x.html"}).find("cannot be written") != std::string::npos);
  for (const std::string& out : {file, fresh}) {
    CHECK(refusal(3, {"report", "--trade", city_bicycle, "--out", out}).find("no output of slipproof trade") !=
          std::string::npos);
    CHECK(refusal(3, {"verify", "--trade", city_bicycle, "--report", out}).find("no output of slipproof") !=
          std::string::npos);
  }
  CHECK(read_file(file) == "as it was");
  CHECK(!std::filesystem::exists(fresh));
  CHECK(run({"report", rear_drive, "--samples", "200", "--out", file}).exit_code == 0);
  CHECK(read_file(file).starts_with("<!DOCTYPE html>"));
}

TEST_CASE("verify writes the report of what it says") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "index.html").string();
  const auto outcome = run({"verify", rear_drive, "--samples", "20", "--report", file});
  CHECK(outcome.exit_code == 0);
  CHECK(read_file(file).find("claim-T1.5") != std::string::npos);
}

TEST_CASE("a report without verdicts is refused, with what to do, and nothing is written") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "index.html").string();
  for (const std::string mode : {"--mutants", "--coverage"}) {
    const auto outcome = run({"verify", mode, "--report", file});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("leave " + mode + " out") != std::string::npos);
    CHECK(!std::filesystem::exists(file));
  }
}

TEST_CASE("map draws a scene, as SVG, as PNG where it can, and as exact data") {
  const auto svg = run({"map", city_bicycle, "--x", "f", "--y", "F", "--columns", "12"});
  CHECK(svg.exit_code == 0);
  CHECK(svg.out.starts_with("<?xml"));
  const auto png = run({"map", city_bicycle, "--columns", "12", "--png"});
  CHECK(png.out.starts_with("\x89PNG") == draws_png);
  CHECK((draws_png || (png.exit_code == 2 && png.err.find("librsvg") != std::string::npos)));
  const auto json = run({"map", city_bicycle, "--x", "h0", "--x-range", "0.5", "3/2", "--columns", "4", "--json"});
  const Json document = Json::parse(json.out);
  CHECK(document["schema"] == "slipproof/map/2");
  CHECK(document["x"]["range"] == Json({"1/2", "3/2"}));
  CHECK(document["columns"].front()["x"] == "1/2");
}

/// By hand: N = (110 - 10 F)/13.5 and T = -(6.5 F + 50)/13.5 where the rod's foot sticks; it lifts from F = 2 on, and
/// at F = 3 it slips as well wherever it can stick, from mu = 139/160 on; at F = 1 it slips below mu = 113/200.
TEST_CASE("map and critical follow a scene in space at single values") {
  const std::string scene = SLIPPROOF_SOURCE_DIR "/cases/space/mapped/leaning-rod.toml";
  const auto json = run({"map", scene, "--columns", "2", "--rows", "3", "--y-range", "0", "6", "--json"});
  CHECK(json.exit_code == 0);
  const Json columns = Json::parse(json.out)["columns"];
  REQUIRE(columns.size() == 2);
  CHECK(columns[0]["places"][1]["motions"] == Json({"lift"}));  // at mu = 1/2, F = 3
  CHECK(columns[1]["complete"] == true);
  CHECK(columns[1]["places"][1]["motions"] == Json({"stick", "slip", "lift"}));  // at mu = 3/2
  CHECK(run({"map", scene, "--columns", "2", "--rows", "2", "--effort", "1"}).exit_code == 4);
  CHECK(run({"map", city_bicycle, "--rows", "2"}).err.find("--rows") != std::string::npos);
  const auto text = run({"critical", scene, "--x", "mu", "--x-range", "1/2", "2", "--columns", "3"});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("1 motion: lift") != std::string::npos);
  CHECK(text.out.find("3 motions: stick, slip, lift") != std::string::npos);
  CHECK(text.out.find("s COMPLETE changes 1 ") != std::string::npos);
  const auto at_one = run({"critical", scene, "--x-range", "1/2", "2", "--columns", "3", "--load", "1", "--json"});
  const Json changes = Json::parse(at_one.out)["changes"];
  REQUIRE(changes.size() == 1);
  const auto number = [](const std::string& text) {
    const std::size_t bar = text.find('/');
    return std::stod(text) / (bar == std::string::npos ? 1 : std::stod(text.substr(bar + 1)));
  };
  CHECK(number(changes[0][0]) < 0.565);
  CHECK(number(changes[0][1]) > 0.565);
  CHECK(number(changes[0][1]) < 0.566);
  CHECK(run({"critical", city_bicycle, "--load", "1"}).exit_code == 2);
}

TEST_CASE("map refuses what it cannot draw, in words") {
  CHECK(run({"map", city_bicycle, "--x", "frog"}).exit_code == 3);
  CHECK(run({"map", city_bicycle, "--y", "f"}).err.find("multiplies") != std::string::npos);
  CHECK(run({"map", city_bicycle, "--x-range", "nan", "1"}).exit_code == 2);
  const auto empty = run({"map", city_bicycle, "--x-range", "1", "1/2"});
  CHECK(empty.exit_code == 3);
  CHECK(empty.err.find("range of f from 1 to 1/2") != std::string::npos);
  CHECK(run({"map", city_bicycle, "--json", "--png"}).exit_code == 2);
  const TemporaryFolder folder;
  const std::string photo = (folder.path() / "map.jpg").string();
  const auto name = run({"map", city_bicycle, "--columns", "4", "-o", photo});
  CHECK(name.exit_code == 2);
  CHECK(name.err.find("--svg or --png") != std::string::npos);
  CHECK(!std::filesystem::exists(photo));
  CHECK(run({"map", city_bicycle, "--columns", "4", "--svg", "-o", photo}).exit_code == 0);
  CHECK(read_file(photo).starts_with("<?xml"));
  CHECK(run({"map", city_bicycle, "--x", "R", "--x-range", "-2", "-1"}).exit_code == 3);
  CHECK(run({"map", "nowhere.toml"}).exit_code == 3);
}

TEST_CASE("map draws a mechanism, with another load if asked, and refuses it in words") {
  const std::string scenes = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes/";
  const auto svg = run({"map", scenes + "ladder.toml", "--x", "theta", "--columns", "8"});
  CHECK(svg.exit_code == 0);
  CHECK(svg.out.starts_with("<?xml"));
  const Json document = Json::parse(run({"map", scenes + "ladder.toml", "--x", "mu_f", "--x-range", "1/4", "1", "--y",
                                         "d", "--columns", "4", "--json"})
                                        .out);
  CHECK(document["schema"] == "slipproof/map/2");
  CHECK(document["x"]["range"] == Json({"1/4", "1"}));
  CHECK(document["load"]["symbol"] == "d");
  CHECK(document["columns"].front()["x"] == "1/4");
  CHECK(document["columns"].front()["cells"].front()["load"] == Json({"-2", "-2"}));
  const auto no_load = run({"map", scenes + "painleve-rod.toml"});
  CHECK(no_load.exit_code == 3);
  CHECK(no_load.err.find("painleve-rod.toml: the mechanism Painlevé's rod has no load, expected one") !=
        std::string::npos);
  CHECK(run({"map", scenes + "painleve-rod.toml", "--y", "g", "--columns", "4"}).exit_code == 0);
  CHECK(run({"map", scenes + "ladder.toml", "--y", "m", "--columns", "4"}).err.find("multiplies") != std::string::npos);
  const auto unknown = run({"map", scenes + "ladder.toml", "--x", "thet"});
  CHECK(unknown.exit_code == 3);
  CHECK(unknown.err.find("unknown parameter or angle 'thet', did you mean 'theta'?") != std::string::npos);
}

TEST_CASE("draw draws a mechanism, and the forces of the motion that is asked for") {
  const std::string scenes = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes/";
  const auto alone = run({"draw", scenes + "gripper.toml"});
  CHECK(alone.exit_code == 0);
  const auto first = run({"draw", scenes + "gripper.toml", "--motion", "1"});
  CHECK(first.exit_code == 0);
  CHECK(first.out != alone.out);
  CHECK(first.out.find("left: stick") != std::string::npos);
  const auto second = run({"draw", scenes + "gripper.toml", "--motion", "2"});
  CHECK(second.exit_code == 3);
  CHECK(second.err.find("found --motion 2, expected at most 1: so many motions it has there") != std::string::npos);
  CHECK(run({"draw", scenes + "painleve-rod.toml", "--motion", "1"}).err.find("there is no motion at this load") !=
        std::string::npos);
  CHECK(run({"draw", scenes + "painleve-rod.toml", "--motion", "all"}).out.find(">no motion<") != std::string::npos);
  CHECK(run({"draw", city_bicycle, "--motion", "1"}).out.find("rear: stick") != std::string::npos);
  CHECK(run({"draw", scenes + "gripper.toml", "--motion", "0"}).exit_code == 2);
  const TemporaryFolder folder;
  folder.write("bare.toml",
               "schema = \"slipproof/mechanism/1\"\nname = \"bare\"\n[unknowns]\naccelerations = [\"a\"]\n"
               "[motion]\na = \"a = 0\"\n[[contact]]\nname = \"c\"\ngap = \"a\"\n");
  const auto scene = folder.write("scene.toml", "mechanism = \"bare.toml\"\n[values]\n");
  const auto bare = run({"draw", scene.string()});
  CHECK(bare.exit_code == 3);
  CHECK(bare.err.find("the mechanism bare has no picture, expected a [[shape]]") != std::string::npos);
  const auto over = run({"draw", scene.string(), "-o", (folder.path() / "bare.toml").string()});
  CHECK(over.exit_code == 3);
  CHECK(over.err.find("bare.toml' where the result is to be written") != std::string::npos);
}

TEST_CASE("of a scene without a load draw takes the modes that solve lists, or a load") {
  const std::string scene = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/asked/scenes/block-pushed.toml";
  const auto listed = run({"solve", scene}).out;
  CHECK(listed.find("    lift/slip+   [0.293333, 0.411946]         [22/75, 400/971]\n") !=
        std::string::npos);  // the 10th
  const auto tenth = run({"draw", scene, "--motion", "10"});
  CHECK(tenth.exit_code == 0);
  CHECK(tenth.out.find(">lift/slip+<") != std::string::npos);
  CHECK(tenth.out.find("F = 1/3 ") != std::string::npos);  // the simplest number between 22/75 and 400/971
  CHECK(run({"draw", scene, "--motion", "12"}).err.find("found --motion 12, expected at most 11: so many modes") !=
        std::string::npos);
  CHECK(run({"draw", scene, "--motion", "all"}).err.find("expected --load for --motion all") != std::string::npos);
  CHECK(run({"draw", scene, "--motion", "1", "--load", "0.4"}).out.find(">lift/slip+<") != std::string::npos);
  CHECK(run({"draw", scene, "--load", "1/0"}).exit_code == 2);
  const auto every = run({"draw", scene, "--motion", "every"});
  CHECK(every.exit_code == 2);
  CHECK(every.err.find("expected a whole number from 1 to 1000000, all or rest") != std::string::npos);
  const std::string truck = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes/three-axles.toml";
  CHECK(run({"draw", truck, "--motion", "5"}).out.find(">slip+/stick/stick<") != std::string::npos);
  CHECK(run({"draw", truck, "--motion", "6"}).err.find("expected at most 5: so many motions") != std::string::npos);
}

TEST_CASE("the picture of the README is what draw makes of its scene, with the three motions of solve") {
  const std::string folder = SLIPPROOF_SOURCE_DIR "/cases/three-motions/three-motions";
  const auto picture = run({"draw", folder + ".toml", "--motion", "all"});
  CHECK(picture.exit_code == 0);
  CHECK(picture.out == read_file(folder + ".svg"));
  for (const char* mode : {">1: stick/stick<", ">2: stick/slip+<", ">3: stick/lift<", "F = 7/4 N, f = 4, 3 motions"}) {
    CAPTURE(mode);
    CHECK(picture.out.find(mode) != std::string::npos);
  }
}

TEST_CASE("draw shows a scene in space from where --from says, and the shipped picture is what it makes") {
  const std::string cube = SLIPPROOF_SOURCE_DIR "/cases/space/cube-pushed-obliquely";
  const auto all = run({"draw", cube + ".toml", "--motion", "all"});
  CHECK(all.exit_code == 0);
  CHECK(all.out == read_file(cube + ".svg"));
  const auto usual = run({"draw", cube + ".toml"}), side = run({"draw", cube + ".toml", "--from", "-20,40"});
  CHECK(usual.exit_code == 0);
  CHECK(usual.out.find(">N<") != std::string::npos);
  CHECK(side.exit_code == 0);
  CHECK(side.out != usual.out);
  CHECK(run({"draw", cube + ".toml", "--from=-20,40"}).out == side.out);
  CHECK(run({"draw", cube + ".toml", "--from", "1,-2,1", "--load", "3"}).out.find("F = 3 N") != std::string::npos);
  const auto nowhere = run({"draw", cube + ".toml", "--from", "0,0,0"});
  CHECK(nowhere.exit_code == 2);
  CHECK(nowhere.err.find("found '0,0,0', which is no direction, expected a direction x,y,z") != std::string::npos);
  CHECK(run({"draw", cube + ".toml", "--motion", "9"}).err.find("found --motion 9, expected at most 1") !=
        std::string::npos);
  CHECK(run({"draw", city_bicycle, "--from", "1,0,0"}).err.find("found --from, but the scene is in the plane") !=
        std::string::npos);
}

TEST_CASE("a report of a folder with one paper is a page, and of several a folder") {
  const TemporaryFolder folder;
  const std::string paper = SLIPPROOF_SOURCE_DIR "/proofs/rear-drive", page = (folder.path() / "x.html").string();
  CHECK(run({"report", paper, "--samples", "20", "--out", page}).out.starts_with("s REPORTED " + page + " "));
  CHECK(read_file(page).starts_with("<!DOCTYPE html>"));
  const auto several = run({"report", SLIPPROOF_SOURCE_DIR "/proofs", "--out", page + ".html"});
  CHECK(several.exit_code == 2);
  CHECK(several.err.find("expected a folder to write: 29 papers have a page each") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(page + ".html"));
  const auto engines = run({"report", SLIPPROOF_SOURCE_DIR "/cases/engines", "--only", "A1", "--out", page + ".html"});
  CHECK(engines.exit_code == 2);
  CHECK(engines.err.find("--only: found a folder of engines, expected claims") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(page + ".html"));
}

TEST_CASE("draw writes the labelled figure of a scene, the shipped one of the city bicycle") {
  const auto figure = run({"draw", city_bicycle});
  CHECK(figure.exit_code == 0);
  CHECK(figure.out == read_file(SLIPPROOF_SOURCE_DIR "/cases/bicycle.svg"));
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "figure.svg").string();
  CHECK(run({"draw", city_bicycle, "-o", file}).out == "s DRAWN " + file + "\n");
  CHECK(read_file(file) == figure.out);
  const std::string pixels = (folder.path() / "figure.png").string();
  const auto png = run({"draw", city_bicycle, "-o", pixels});
  CHECK(png.exit_code == (draws_png ? 0 : 2));
  CHECK((!draws_png || read_file(pixels).starts_with("\x89PNG")));
  CHECK(run({"draw", "/nonexistent.toml"}).exit_code == 3);
}
