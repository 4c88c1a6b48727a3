// Records of mechanisms whose motions a person knows, and bad ones, which are told with their place.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "mechanics/scene/scene.hpp"
#include "support/certified.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// A ladder that rests: undetermined forces N_floor in [200.26, 241.342], and so on.
CertifyOptions ladder() {
  CertifyOptions options;
  options.mechanism.emplace(read_scene(std::string(SLIPPROOF_SOURCE_DIR) + "/cases/mechanisms/scenes/ladder.toml"));
  return options;
}

nlohmann::json only_line(const std::string& text, const CertifyOptions& options) {
  const auto lines = certified(text, options).lines();
  REQUIRE(lines.size() == 1);
  return lines[0];
}

}  // namespace

TEST_CASE("undetermined forces must be one solution, not only within their ranges") {
  const std::string header = "ax,ay,phi,N_floor,S_floor,N_wall,S_wall\n";
  // N_floor + S_wall = 217.72, S_floor = -N_wall; the moment about the centre gives the rest.
  const auto line = [&](const char* forces) { return only_line(header + "0,0,0," + forces + "\n", ladder()); };
  CHECK(line("217.72,-100.395,100.395,0")["verdict"] == "certified");
  CHECK(line("212.72,-96.645,96.645,5")["verdict"] == "certified");
  CHECK(line("212.72,-96.645,96.645,5")["tier"] == "filter");
  CHECK(line("217.72,-100.395,100.395,5")["verdict"] != "certified");
  CHECK(line("212.72,-101,96.645,5")["verdict"] != "certified");
  CHECK(line("400,-100.395,100.395,0")["verdict"] != "certified");
  CHECK(line("187.72,-77.895,77.895,30")["verdict"] != "certified");  // an equilibrium, by more friction than there is
}

TEST_CASE("an angle may be given in several forms, and a point near the circle is on it") {
  CertifyOptions options = ladder();
  const auto verdict = [&](const std::string& header, const std::string& values) {
    return only_line("ax,ay,phi," + header + "\n0,0,0," + values + "\n", options);
  };
  CHECK(verdict("theta.tan_half", "0.5")["verdict"] == "certified");
  CHECK(verdict("theta.cos,theta.sin", "0.6,0.8")["verdict"] == "certified");
  CHECK(verdict("theta.cos,theta.sin", "3/5,4/5")["verdict"] == "certified");
  CHECK(verdict("theta.degrees", "53.13010235415598")["verdict"] == "certified");
  CHECK(verdict("theta.cos,theta.sin", "0.6,0.81")["reason"] ==
        "theta: found cos^2 + sin^2 = 1.0161000000000001, expected 1 to within 4e-15; tan_half has no such limit");
  CHECK(verdict("theta.tan_half", "-0.5")["reason"] ==
        "theta: found the cosine 0.6 and the sine -0.8, expected c > 0 and s > 0");
  CHECK(verdict("theta.cos,theta.sin", "-1,0")["verdict"] == "invalid");
  CHECK(verdict("theta.cos,theta.sin", "nan,0")["verdict"] == "invalid");
}

TEST_CASE("bad records of mechanisms are told with place, found and expected") {
  const CertifyOptions options = ladder();
  const auto reason = [&](const std::string& text) { return only_line(text, options)["reason"].get<std::string>(); };
  CHECK(reason("ax,ay,phi\n0,0,inf\n") ==
        "line 2, column 5: phi: found infinity or a number beyond the largest binary64, expected a finite number");
  CHECK(reason("ax,ay,phi,mu_f\n0,0,0,-1\n") == "mu_f: found -1, expected mu_f >= 0");
  CHECK(reason("ax,ay,phi,W\n0,0,0,-1\n") == "W: found -1, expected a value in [0, +oo)");
  CHECK(reason("ax,ay,phi,mode\n0,0,0,stick/slide\n").starts_with("line 2, column 7: found the mode 'stick/slide'"));
  CHECK(reason("ax,ay,phi\n0,0\n") == "line 2, column 3: found fewer cells, expected 3 as in the header");
  CHECK(reason("ax,ay,phi\n0,0,\n") == "line 2, column 1: missing phi");
  const auto header = [&](const std::string& text) -> std::string {
    try {
      certified(text, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  CHECK(header("ax,ay\n").find("missing phi") != std::string::npos);
  CHECK(header("ax,ay,phi,a\n").find("found the column 'a'") != std::string::npos);
  CHECK(header("ax,ay,phi,ax\n").find("found the column 'ax' twice") != std::string::npos);
  CHECK(header("ax,ay,phi,theta.cos\n").find("missing theta.sin") != std::string::npos);
  CHECK(header("ax,ay,phi,theta.cos,theta.sin,theta.tan_half\n").find("in one form") != std::string::npos);
}

TEST_CASE("a wrong mode of a mechanism is wrong by its violated condition") {
  const auto line = only_line("ax,ay,phi,mode\n0,0,0,stick/lift\n", ladder());
  CHECK(line["verdict"] == "wrong");
  CHECK(line["claimed"] == "stick/lift");
  CHECK(line["violated"] == "|S_floor| <= mu_f N_floor");
  CHECK(line["margin"] == "-118307/5000");
  CHECK(line["found"][0]["force_ranges"]["N_floor"][0] == "10013/50");
  const auto boundary = only_line("ax,ay,phi,mode\n0,0,0,stick/slip+\n", ladder());
  CHECK(boundary["verdict"] == "certified");
  CHECK(boundary["modes"] == nlohmann::json{"stick/stick"});
}

TEST_CASE("records of mechanisms with more modes than are numbered: the answer's own mode decides first") {
  const std::string folder = std::string(SLIPPROOF_SOURCE_DIR) + "/cases/mechanisms/many/scenes/";
  const auto lines_of = [&](const std::string& scene, const std::string& text) {
    CertifyOptions options;
    options.mechanism = CertifiedMechanism(read_scene(folder + scene + ".toml"));
    return certified(text, options).lines();
  };
  std::string lifts = "lift", slips = "slip+";
  for (int i = 1; i < 12; ++i) lifts += "/lift";
  for (int i = 1; i < 24; ++i) slips += "/slip+";
  const auto hand =
      lines_of("hand-of-12-fingers", "F,ax,ay,alpha,mode\n12,0,2,0," + lifts + "\n12,0,0,0,\n8,0,0,0,\n8,0,1,0,\n" +
                                         "12,0,2,0,stick/stick\n8,0,-2,0," + lifts + "\n8,0,1e-13,0,\n");
  const std::vector<std::string> expected{"ambiguous", "ambiguous", "certified", "wrong",
                                          "invalid",   "wrong",     "certified"};
  REQUIRE(hand.size() == expected.size());
  for (std::size_t i = 0; i < hand.size(); ++i) CHECK(hand[i]["verdict"] == expected[i]);
  CHECK(hand[5]["violated"] == "gap_finger1 >= 0");
  CHECK(hand[5]["motions"].is_null());
  const auto beam = lines_of("beam-on-24-feet", "F,ax,ay,alpha,mode\n72,1,0,0," + slips + "\n72,1.1,0,0,\n");
  CHECK(beam[0]["verdict"] == "certified");
  CHECK(beam[0]["modes"][0] == slips);
  CHECK(beam[1]["verdict"] == "inaccurate");
}
