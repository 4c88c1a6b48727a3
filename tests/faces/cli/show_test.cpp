#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <pugixml.hpp>

#include "support/replaced.hpp"
#include "support/run_program.hpp"

using namespace slipproof::test;

TEST_CASE("show prints what was understood of a shipped mechanism, and of a file") {
  const auto shipped = run({"show", "painleve-rod"});
  CHECK(shipped.exit_code == 0);
  CHECK(shipped.err.empty());
  CHECK(shipped.out.find("  phi  I * phi = l * c * N + l * s * S\n") != std::string::npos);
  CHECK(shipped.out.find("  tip: slides forward, friction mu\n") != std::string::npos);
  CHECK(shipped.out.find("\nModes: 2\n") != std::string::npos);
  const auto file = run({"show", SLIPPROOF_SOURCE_DIR "/cases/mechanisms/painleve-rod.toml"});
  CHECK(file.out == shipped.out);
}

TEST_CASE("show of a scene shows its mechanism") {
  const std::string cases = SLIPPROOF_SOURCE_DIR "/cases/space/";
  const auto scene = run({"show", cases + "domino.toml"});
  CHECK(scene.exit_code == 0);
  CHECK(scene.out == run({"show", cases + "mechanisms/domino.toml"}).out);
}

TEST_CASE("show tells what looks wrong, and refuses what is wrong") {
  const TemporaryFolder folder;
  std::string text = read_file(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/painleve-rod.toml");
  text = replaced(text, "\"m*ay = -m*g\"", "\"m*ay = -g\"");
  const auto odd = run({"show", folder.write("odd.toml", text)});
  CHECK(odd.exit_code == 0);
  std::string unwrapped = odd.out;
  std::replace(unwrapped.begin(), unwrapped.end(), '\n', ' ');
  CHECK(unwrapped.find("odd.toml:30:7: warning: the equation ay has m.kg.s-2 and m.s-2") != std::string::npos);
  text = replaced(text, "m*ay = -g", "m*az = -g");
  const auto wrong = run({"show", folder.write("wrong.toml", text)});
  CHECK(wrong.exit_code == 3);
  CHECK(wrong.out.empty());
  CHECK(wrong.err.find("wrong.toml:30:9: ay: unknown symbol 'az', did you mean 'ax'?") != std::string::npos);
  CHECK(run({"show", "painleve"}).exit_code == 3);
  CHECK(run({"show"}).exit_code == 2);
}

TEST_CASE("what looks wrong in a mechanism is told wherever it is used, and its answer stands") {
  const TemporaryFolder folder;
  std::string text = read_file(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/painleve-rod.toml");
  text = replaced(text, "\"m*ay = -m*g\"", "\"m*ay = -g\"");
  const std::string mechanism = folder.write("odd.toml", text);
  const std::string scene = folder.write("scene.toml",
                                         "mechanism = \"odd.toml\"\n[values]\nm = 1\nl = 1\nI = \"1/3\"\nmu = 1\nw = "
                                         "0\ng = 10\ntheta = { tan = \"3/4\" }\n");
  const std::string claims = folder.write(
      "claims.toml",
      "schema = \"slipproof/claims/1\"\npaper = { title = \"x\", authors = [\"x\"], source = \"x\" }\n[[setting]]\nid "
      "= "
      "\"x\"\nmotions = \"closed\"\nmechanism = \"odd.toml\"\nscene = { m = \"1\", l = \"1\", I = \"1/3\", w = \"0\", "
      "g = "
      "\"10\", theta = { tan_half = \"1/3\" } }\n[setting.parameters]\nmu = { domain = \"mu >= 0\", meaning = \"x\" }\n"
      "[[claim]]\nid = \"X\"\nline = 1\nstatement = \"x\"\nkind = \"motions\"\nregion = \"mu = 0\"\nmodes = "
      "[\"slip+\"]\n");
  const std::string answers = folder.write("answers.csv", "mu,ax,ay,phi\n1,0,0,0\n");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"solve", scene},
        {"draw", scene},
        {"map", scene, "--x", "m", "--x-range", "1", "2", "--y", "g", "--columns", "5"},
        {"certify", "--scene", scene, answers},
        {"prove", claims},
        {"verify", claims, "--samples", "40"},
        {"search", mechanism, "--samples", "40"}}) {
    CAPTURE(command[0]);
    const auto told = run(command);
    CHECK(told.exit_code <= 1);
    CHECK(told.err.find("odd.toml:30:7: warning: the equation ay has") != std::string::npos);
    CHECK(told.out.find("warning") == std::string::npos);
    std::vector<std::string> quiet = command;
    quiet.emplace_back("--quiet");
    CHECK(run(quiet).err.empty());
  }
}

TEST_CASE("draw --animate lets a ball roll by half of its acceleration times the square of half a second") {
  const std::string cases = SLIPPROOF_SOURCE_DIR "/cases/";
  const std::string ball = cases + "engines/scenes/one-motion/ball-rolls-down-slope.toml";
  const auto drawn = run({"draw", ball, "--motion", "1", "--animate"});
  REQUIRE(drawn.exit_code == 0);
  pugi::xml_document svg;
  REQUIRE(svg.load_string(drawn.out.c_str()));
  const pugi::xml_node ahead = svg.select_node("//g[@class='moves ahead']").node();
  // The disc: it rolls, so that its centre moves by its radius times the angle, 981/182 / 8 clockwise.
  const double angle = 981.0 / 182 / 8;
  const pugi::xml_node disc = ahead.child("circle");
  double x = 0, y = 0, turned = 0;
  REQUIRE(std::sscanf(disc.attribute("transform").value(), "translate(%lf,%lf)", &x, &y) == 2);
  const double moved = std::hypot(x - disc.attribute("cx").as_double(), y - disc.attribute("cy").as_double());
  CHECK(moved == doctest::Approx(disc.attribute("r").as_double() * angle).epsilon(0.001));
  const pugi::xml_node spoke = svg.select_node("//g[@class='moves ahead']/path[last()]").node();
  REQUIRE(std::sscanf(spoke.attribute("transform").value(), "translate(%lf,%lf) rotate(%lf)", &x, &y, &turned) == 3);
  CHECK(turned == doctest::Approx(angle * 180 / std::numbers::pi).epsilon(0.001));
  CHECK(drawn.out.find("prefers-reduced-motion:reduce") != std::string::npos);
  CHECK(drawn.out.find("no simulation") != std::string::npos);
  CHECK(run({"draw", ball, "--motion", "1"}).out.find("ahead") == std::string::npos);

  // A sled of mass 1 on a spring: it moves by 2/8, and the spring of length 2 is as much longer.
  const auto pulled = run({"draw", SLIPPROOF_SOURCE_DIR "/tests/faces/cli/sled.toml", "--motion", "1", "--animate"});
  REQUIRE(svg.load_string(pulled.out.c_str()));
  const pugi::xml_node spring = svg.select_node("//g[@class='moves ahead']/path[last()]").node();
  double stretch = 0, zero = 0;
  REQUIRE(std::sscanf(spring.attribute("transform").value(), "translate(%lf,%lf) rotate(%lf) scale(%lf)", &x, &y, &zero,
                      &stretch) == 4);
  CHECK(stretch == doctest::Approx(1.125));
  CHECK(zero == 0);

  for (const std::vector<std::string>& refused :
       {std::vector<std::string>{city_bicycle, "--motion", "1"},  // by equations
        std::vector<std::string>{ball, "--motion", "all"}, std::vector<std::string>{ball},
        std::vector<std::string>{cases + "space/domino.toml", "--motion", "1"}}) {
    std::vector<std::string> arguments{"draw", "--animate"};
    arguments.insert(arguments.end(), refused.begin(), refused.end());
    const auto end = run(arguments);
    CHECK(end.exit_code == 3);
    CHECK(end.out.empty());
    CHECK(end.err.find("--animate") != std::string::npos);
  }
}
