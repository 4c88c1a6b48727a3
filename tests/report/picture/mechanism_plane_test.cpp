// Phase diagrams of mechanisms: every point solved anew at its load, closed forms, and the borders of domains.
#include "mechanics/planes/mechanism_plane.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <pugixml.hpp>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "mechanics/points/degrees.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "report/phase/phase_points.hpp"
#include "report/phase/phase_svg.hpp"
#include "report/planes/map_json.hpp"

using namespace slipproof;

namespace {

const std::string mechanism_scenes = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes/";

MechanismScene shipped_scene(const std::string& name) {
  return read_scene(mechanism_scenes + name + ".toml");
}

std::size_t parameter(const Mechanism& mechanism, const std::string& symbol) {
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    if (mechanism.parameters[i].symbol == symbol) return i;
  }
  REQUIRE(false);
  return 0;
}

/// The values at one x, without what solves columns.
MechanismValues values_at(const MechanismScene& scene, const Axis& axis, const Rational& x) {
  MechanismValues values = scene.values;
  if (axis.is_angle) {
    values.angles[0] = point_of_tan_half(x);
  } else {
    values.parameters[parameter(scene.mechanism, axis.symbol)] = x;
  }
  return values;
}

std::vector<MechanismMode> all_modes_of(const MotionAtLoad& motion) {
  std::vector<MechanismMode> modes = motion.modes;
  modes.insert(modes.end(), motion.boundary_modes.begin(), motion.boundary_modes.end());
  std::sort(modes.begin(), modes.end());
  return modes;
}

/// What the kernel finds at the point's load alone.
void check_against_kernel(const PhasePoint& point, const FrictionProblem& problem) {
  const MotionsAtLoad there = motions_of(problem, point.y);
  REQUIRE(point.motions.size() == there.motions.size());
  CHECK(point.continua.size() == there.continua.size());
  for (const MotionAtLoad& motion : there.motions) {
    const auto same = [&](const PhasePoint::Motion& other) {
      if (other.modes != all_modes_of(motion) || other.strict != motion.strict()) return false;
      for (std::size_t i = 0; i < motion.accelerations.size(); ++i) {
        if (other.values[i] != motion.accelerations[i]) return false;
      }
      for (std::size_t i = 0; i < motion.forces.size(); ++i) {
        const auto& value = other.values[motion.accelerations.size() + i];
        if (value && !(motion.forces[i].is_point() && value == motion.forces[i].lower)) return false;
        if (!value && motion.forces[i].is_point() && motion.modes.size() + motion.boundary_modes.size() == 1)
          return false;
      }
      return true;
    };
    CHECK(std::count_if(point.motions.begin(), point.motions.end(), same) == 1);
  }
}

std::size_t check_points(const MechanismScene& scene, const MechanismAxes& axes) {
  const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, axes, "m"), 4);
  const auto points = sample_points(diagram, 4, 4);
  for (const PhasePoint& point : points) {
    CAPTURE(point.x);
    CAPTURE(point.y);
    check_against_kernel(point, friction_problem(scene.mechanism, values_at(scene, diagram.plane.x, point.x)));
  }
  pugi::xml_document svg;
  CHECK(svg.load_string(phase_svg_file(diagram).c_str()));
  return points.size();
}

template <class Call>
std::string complaint(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing";
}

/// A block on a rough floor that is pushed; `more` stands between its parameters and its load.
MechanismScene sled(const std::string& more, const std::string& values) {
  MechanismScene scene;
  scene.name = "a sled";
  scene.mechanism = parse_mechanism(
      "schema = \"slipproof/mechanism/1\"\nname = \"sled\"\n[parameters]\nm = \"m > 0\"\nl = \"l > 0\"\nI = \"I > 0\"\n"
      "mu = \"mu >= 0\"\ng = \"g > 0\"\n" +
          more +
          "[load]\nsymbol = \"F\"\n[unknowns]\naccelerations = [\"ax\", \"ay\"]\n[motion]\nax = \"m*ax + I*ax = F\"\n"
          "ay = \"m*ay = -m*g*l\"\n[[contact]]\nname = \"runner\"\ngap = \"ay\"\nslip = \"ax\"\nfriction = \"mu\"\n",
      "sled.toml");
  scene.values = default_values(scene.mechanism);
  for (std::size_t i = 0; i < 5; ++i) scene.values.parameters[i] = values[i] - '0';
  return scene;
}

}  // namespace

TEST_CASE("points of every shipped mechanism's diagram are what its kernel finds at their load alone") {
  std::size_t scenes = 0, points = 0;
  for (const auto& entry : std::filesystem::directory_iterator(mechanism_scenes)) {
    CAPTURE(entry.path());
    MechanismScene scene = read_scene(entry.path());
    if (!scene.mechanism.load) scene = with_load(scene, "g");
    points += check_points(scene, {});
    if (!scene.mechanism.angles.empty()) {
      MechanismAxes axes;
      axes.x = scene.mechanism.angles[0].name;
      points += check_points(scene, axes);
    }
    ++scenes;
  }
  CHECK(scenes == 15);
  CHECK(points > 200);
}

TEST_CASE("a block on a shaken floor stays until it slides or tips, exactly where Housner says") {
  const MechanismScene scene = shipped_scene("block-shaken");  // h = 1, mu = 1
  MechanismAxes axes;
  axes.x = "b";
  axes.x_from = 0;
  axes.x_to = 2;
  const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, axes, "m"), 16);
  int columns = 0;
  for (const PhaseColumn& column : diagram.columns) {
    const Rational ends = std::min(column.x, Rational(1));
    for (const PhaseBand& band : bands(column, true)) {
      if (name(band.set) != "stick/stick") continue;
      CHECK(band.lower == -ends);
      CHECK(band.upper == ends);
      ++columns;
    }
  }
  CHECK(columns == static_cast<int>(diagram.columns.size()));
  CHECK(map_json(diagram, scene) == map_json(phase_diagram(mechanism_plane(scene, axes, "m"), 16), scene));
}

TEST_CASE("without a range the loads around the scene's are shown, and those far away are told") {
  const Plane plane = mechanism_plane(shipped_scene("bicycle"), {}, "m");  // a push of 300 N
  CHECK(plane.y.from > -3000);
  CHECK(plane.y.from < -1319);  // the motions change at -1319, 1592 and 1623, and at -9043 and 12301
  CHECK(plane.y.to > 1623);
  CHECK(plane.y.to < 3000);
  CHECK(plane.note.find("Beyond the picture motions change at F near -9042.92, 12301.4.") != std::string::npos);
  MechanismAxes wanted;
  wanted.y_from = -100;
  CHECK(mechanism_plane(shipped_scene("bicycle"), wanted, "m").note.find("Beyond") == std::string::npos);
  CHECK(mechanism_plane(shipped_scene("ladder"), {}, "m").note.find("Beyond") == std::string::npos);
}

TEST_CASE("the legend of a map has all signs in it: the scene's dot, lines, dots and stripes") {
  const PhaseDiagram diagram = phase_diagram(mechanism_plane(shipped_scene("bicycle"), {}, "m"), 24);
  pugi::xml_document svg;
  REQUIRE(svg.load_string(phase_svg_file(diagram).c_str()));
  std::string words;
  for (const auto& entry : svg.select_nodes("//g[@class='sign']/text"))
    words += std::string(entry.node().child_value()) + "\n";
  CHECK(words.find("the scene: ") == 0);
  CHECK(words.find("F = 300 N") != std::string::npos);
  CHECK(words.find("on a line the motions change") != std::string::npos);
  CHECK(words.find("dots: a contact opens") != std::string::npos);
  CHECK(!svg.select_nodes("//g[@class='sign']/circle[@class='ink']").empty());
  const double height = svg.document_element().attribute("height").as_double();
  for (const auto& entry : svg.select_nodes("//g[@class='sign']")) {
    const std::string place = entry.node().attribute("transform").value();
    CHECK(std::stod(place.substr(place.find(' '))) < height - 15);
  }
}

TEST_CASE("another parameter goes up: what hangs on the ladder, or how high") {
  const MechanismScene ladder = shipped_scene("ladder");
  const MechanismScene high = with_load(ladder, "d");
  CHECK(high.mechanism.load->symbol == "d");
  CHECK(high.load == Rational(1));
  CHECK(high.values.parameters[parameter(high.mechanism, "W")] == 100);
  const Plane plane = mechanism_plane(high, {}, "m");
  CHECK(plane.y.from == -2);  // no higher and no lower than the ladder is long
  CHECK(plane.y.to == 2);
  check_points(high, {});
  CHECK(with_load(ladder, "W").load == ladder.load);
  MechanismScene open = ladder;
  open.load.reset();
  CHECK(complaint([&] { with_load(open, "d"); }) ==
        "the scene has no value of W, expected one: it is a parameter where d is the load");
  CHECK_THROWS_AS(with_load(ladder, "m"), InputError);
}

TEST_CASE("what is out of the domain is left out, and its border is found") {
  MechanismScene scene = shipped_scene("block-on-incline");  // mu_k = 3/5 <= mu_s
  const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, {}, "m"), 10);
  CHECK(diagram.plane.x.symbol == "mu_s");
  const Rational narrow = (diagram.plane.x.to - diagram.plane.x.from) / 640;
  CHECK(diagram.columns.front().x >= Rational(3, 5));
  CHECK(diagram.columns.front().x <= Rational(3, 5) + narrow);
  const PhaseRegions regions = phase_regions(diagram);
  CHECK(regions.leaves_domain);
  for (const Strip& strip : regions.strips) CHECK(strip.lower.front().x >= 0.6);
  CHECK(phase_svg_file(diagram).find("White is out of the domain.") != std::string::npos);
  CHECK(phase_svg_file(phase_diagram(mechanism_plane(shipped_scene("trailer"), {}, "m"), 6)).find("White is out") ==
        std::string::npos);
}

TEST_CASE("a hole in the domain stays white, with both sides apart") {
  const MechanismScene scene = sled("[assume]\nhole = \"mu < 1 or mu >= 2\"\n", "11111");
  MechanismScene inside = scene;
  inside.values.parameters[3] = Rational(1, 2);
  MechanismAxes axes;
  axes.x_from = 0;
  axes.x_to = 4;
  const PhaseDiagram diagram = phase_diagram(mechanism_plane(inside, axes, "m"), 16);
  int gaps = 0;
  for (std::size_t i = 0; i < diagram.columns.size(); ++i) {
    const PhaseColumn& column = diagram.columns[i];
    CHECK((column.x < 1 || column.x >= 2));
    if (!column.after_gap) continue;
    ++gaps;
    CHECK(diagram.columns[i - 1].x >= 1 - Rational(4, 16 * 64));
    CHECK(column.x == 2);
  }
  CHECK(gaps == 1);
  for (const Strip& strip : phase_regions(diagram).strips) {
    CHECK((strip.upper.back().x < 1 || strip.upper.front().x >= 2));
  }
}

TEST_CASE("what an equation of the domain ties to x follows, and the plane says so") {
  const MechanismScene scene = sled("[assume]\nsolid = \"3*I = m*l^2\"\n", "33911");
  MechanismAxes axes;
  axes.x = "l";
  const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, axes, "m"), 8);
  CHECK(diagram.plane.note == "With l, I changes as the domain asks.");
  REQUIRE(diagram.columns.size() >= 8);
  for (const PhasePoint& point : sample_points(diagram, 4, 4)) {
    MechanismValues values = scene.values;
    values.parameters[1] = point.x;
    values.parameters[2] = point.x * point.x;  // m l^2 / 3 with m = 3
    check_against_kernel(point, friction_problem(scene.mechanism, values));
  }
  axes.x = "I";  // then m follows, the last but one that is in the equation, and l^2 is not affine
  CHECK(mechanism_plane(scene, axes, "m").note == "With I, m changes as the domain asks.");
  axes.x = "mu";
  CHECK(mechanism_plane(scene, axes, "m").note.empty());
}

TEST_CASE("an angle goes by tan(angle/2), in degrees on the axis, over its domain") {
  MechanismAxes axes;
  axes.x = "theta";
  const MechanismScene ladder = shipped_scene("ladder");
  const PhaseDiagram diagram = phase_diagram(mechanism_plane(ladder, axes, "m"), 8);
  CHECK(diagram.plane.x.from == 0);
  CHECK(diagram.plane.x.to == 1);
  pugi::xml_document svg;
  REQUIRE(svg.load_string(phase_svg_file(diagram).c_str()));
  const auto frame = svg.select_node("//rect[@class='frame']").node();
  const auto label = svg.select_node("//text[.='40°']").node();
  REQUIRE(label);
  const double place = std::tan(std::numbers::pi / 9);
  CHECK(
      label.attribute("x").as_double() ==
      doctest::Approx(frame.attribute("x").as_double() + place * frame.attribute("width").as_double()).epsilon(0.001));
  const auto json = nlohmann::json::parse(map_json(diagram, ladder));
  CHECK(json["schema"] == "slipproof/map/2");
  CHECK(json["x"]["kind"] == "angle");
  CHECK(json["columns"].size() == diagram.columns.size());
  CHECK(json["columns"][1]["x"]["cos"].is_string());
  CHECK(json["columns"][1]["cells"][0]["load"][0] == "0");
  axes.x_from = 30;
  axes.x_to = 90;
  const Plane part = mechanism_plane(ladder, axes, "m");
  CHECK(nearest_binary64(part.x.from) == doctest::Approx(std::tan(std::numbers::pi / 12)));
  CHECK(part.x.to == 1);
}

TEST_CASE("a plane of a mechanism that cannot be is refused in words, before any work") {
  const MechanismScene ladder = shipped_scene("ladder");
  const auto refused = [&](const MechanismScene& scene, const std::string& x, std::optional<Rational> from,
                           std::optional<Rational> to) {
    MechanismAxes axes;
    axes.x = x;
    axes.x_from = from;
    axes.x_to = to;
    return complaint([&] { mechanism_plane(scene, axes, "m"); });
  };
  CHECK(refused(shipped_scene("painleve-rod"), "", {}, {}) ==
        "the mechanism Painlevé's rod has no load, expected one, or a parameter that takes its place");
  CHECK(refused(ladder, "mu_g", {}, {}) == "unknown parameter or angle 'mu_g', did you mean 'mu_f'?");
  CHECK(refused(ladder, "W", {}, {}) == "found the load W across, expected a parameter or an angle: the load goes up");
  CHECK(refused(ladder, "d", Rational(1), Rational(1)) ==
        "found the range of d from 1 to 1, expected one that begins below its end");
  CHECK(refused(ladder, "d", Rational(3), Rational(4)) ==
        "no values side by side of d in its range are in the domain, expected -l <= d and d <= l");
  CHECK(refused(ladder, "theta", Rational(0), Rational(180)) ==
        "found 180 degrees for theta, expected an angle between -180 and 180 degrees");
  MechanismAxes below;
  below.y_from = -2;
  below.y_to = -1;
  CHECK(complaint([&] { mechanism_plane(ladder, below, "m"); }) ==
        "found the range of W from -2 to -1, expected one with values in [0, +oo)");
  MechanismScene light = shipped_scene("bicycle");
  const std::size_t J = parameter(light.mechanism, "J");
  light.values.given[J] = false;
  CHECK(refused(light, "J", {}, {}) == "the scene has no J");
  CHECK(mechanism_plane(light, {}, "m").note.starts_with("Without J, that rear opens is not modelled."));
}

TEST_CASE("a mechanism of more modes than are tried has its motions by kinematics") {
  std::string text =
      "schema = \"slipproof/mechanism/1\"\nname = \"many\"\n[parameters]\nmu = \"mu >= 0\"\n[load]\nsymbol = \"F\"\n"
      "[unknowns]\naccelerations = [\"a\", \"b\"]\n[motion]\na = \"a = F\"\nb = \"b = -1\"\n";
  for (int i = 0; i < 9; ++i) {
    text += "[[contact]]\nname = \"c" + std::to_string(i) + "\"\ngap = \"b\"\nslip = \"a\"\nfriction = \"mu\"\n";
  }
  MechanismScene scene;
  scene.mechanism = parse_mechanism(text, "many.toml");
  scene.values = default_values(scene.mechanism);
  // It is pressed down by 1 and pushed by F: it slips back, rests, slips ahead, with a border between each two.
  CHECK(mechanism_plane(scene, {}, "m").solve(Rational(1, 2))->cells.size() == 5);
}
