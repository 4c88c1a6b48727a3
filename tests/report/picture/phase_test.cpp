// Phase diagrams say what `solve` says: every sample point and the inside of every region, solved again.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"
#include "claims/paper/compiled.hpp"
#include "claims/planes/claims_plane.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "mechanics/family/solved_sample.hpp"
#include "mechanics/planes/mechanism_plane.hpp"
#include "report/phase/axis.hpp"
#include "report/phase/phase_points.hpp"
#include "report/phase/phase_svg.hpp"
#include "report/planes/map_json.hpp"
#include "support/bicycle/domain.hpp"
#include "support/bicycle/motions.hpp"
#include "support/papers/shipped.hpp"
#include "support/scenes/bicycle_scenes.hpp"
#include "support/scenes/random_scene.hpp"

using namespace slipproof;

namespace {

const std::string source = SLIPPROOF_SOURCE_DIR;

std::vector<Figure> figures() {
  return read_figures(source + "/proofs/rozenblat-yashin/figures.toml", test::shipped_paper());
}

std::vector<MechanismMode> mechanism_modes(const std::vector<ContactMode>& modes) {
  std::vector<MechanismMode> result;
  for (const ContactMode mode : modes) result.push_back(mechanism_mode(mode));
  return result;
}

/// A number of a motion by its symbol.
std::optional<Rational> value_of(const PhasePoint::Motion& motion, const Plane& plane, std::string_view symbol) {
  const auto found = std::find_if(plane.quantities.begin(), plane.quantities.end(),
                                  [&](const MotionQuantity& quantity) { return quantity.name == symbol; });
  REQUIRE(found != plane.quantities.end());
  return motion.values[static_cast<std::size_t>(found - plane.quantities.begin())];
}

/// The motions by another way than the partition: at one force.
void check_point(const Plane& plane, const PhasePoint& point, const BicycleOfValues& p, const Rational& force) {
  const ModeTable table(p.bicycle, p.road, p.kind);
  const MotionsAtForce there = motions_at(table, force);
  REQUIRE(point.motions.size() == there.motions.size());
  CHECK(point.continua.size() == there.continua.size());
  for (const auto& motion : there.motions) {
    const auto same = [&](const PhasePoint::Motion& other) {
      const auto all = all_quantities();
      return other.modes == mechanism_modes(motion.modes) && other.strict == motion.strict &&
             std::all_of(all.begin(), all.end(),
                         [&](Quantity q) { return value_of(other, plane, name(q)) == motion.values[q]; });
    };
    CHECK(std::count_if(point.motions.begin(), point.motions.end(), same) == 1);
  }
}

/// The bicycle of a scene with another value of a parameter, or of what says several; nothing outside of the domain.
std::optional<BicycleOfValues> with_parameter(const MechanismScene& scene, std::string_view symbol, const Rational& x) {
  MechanismValues values = scene.values;
  for (const CombinedParameter& combined : scene.combined) {
    if (combined.symbol != symbol) continue;
    for (const auto& [parameter, over] : combined.sets) values.parameters[bicycle_parameter(parameter)] = over.at(x);
  }
  const auto& own = scene.mechanism.parameters;
  if (std::any_of(own.begin(), own.end(), [&](const auto& p) { return p.symbol == symbol; })) {
    values.parameters[bicycle_parameter(symbol)] = x;
  }
  const BicycleOfValues there = bicycle_of(values);
  return in_domain(there.bicycle, there.road) ? std::optional(there) : std::nullopt;
}

MotionSet set_at(const ModeTable& table, const Rational& force) {
  MotionSet set;
  const MotionsAtForce there = motions_at(table, force);
  for (const auto& motion : there.motions) set.motions.push_back(mechanism_modes(motion.modes));
  std::sort(set.motions.begin(), set.motions.end());
  for (const auto& c : there.continua) set.continua.push_back(mechanism_mode(c.continuum->mode));
  return set;
}

}  // namespace

TEST_CASE("sample points of every scene of cases/ are what solving it there gives") {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source + "/cases")) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path());
    const MechanismScene scene = read_scene(entry.path());
    const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, {}, "s"), 12);
    const auto points = sample_points(diagram, 6, 5);
    CHECK(points.size() >= 25);
    for (const PhasePoint& point : points) {
      check_point(diagram.plane, point, *with_parameter(scene, "f", point.x), point.y);
    }
    ++scenes;
  }
  CHECK(scenes >= 10);
}

TEST_CASE("the regions as drawn have the motions that they are coloured by") {
  const MechanismScene scene = read_scene(source + "/cases/city-bicycle.toml");
  for (const char* parameter : {"f", "h0", "b2", "b", "mu", "J"}) {
    CAPTURE(parameter);
    MechanismAxes axes;
    axes.x = parameter;
    const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, axes, "s"), 24);
    const PhaseRegions regions = phase_regions(diagram);
    int inside = 0;
    for (const Strip& strip : regions.strips) {
      for (std::size_t i = 0; i < strip.lower.size(); ++i) {
        const Rational x = to_rational(strip.lower[i].x);
        const double height = strip.upper[i].y - strip.lower[i].y;
        const double width = nearest_binary64(diagram.plane.y.to - diagram.plane.y.from);
        // The column that was drawn here, or one next to it: away from borders that makes no difference.
        const auto there = with_parameter(scene, parameter, x);
        if (!there || height < width / 50) continue;
        const Rational force = to_rational((strip.upper[i].y + strip.lower[i].y) / 2);
        const ModeTable table(there->bicycle, there->road, there->kind);
        if (i == 0 || i + 1 == strip.lower.size()) continue;  // the ends are drawn on to the next run
        CHECK(set_at(table, force) == strip.set);
        ++inside;
      }
    }
    CHECK(inside > 50);
  }
}

TEST_CASE("the paper's plane: points solved again, borders on thresholds exactly where they are said to be") {
  const auto& claims = test::shipped_paper();
  for (const Figure& figure : figures()) {
    CAPTURE(figure.id);
    const CompiledSetting setting(claims.settings[figure.setting]);
    const PhaseDiagram diagram = phase_diagram(claims_plane(claims, figure, Reading::printed), 24);
    for (const PhasePoint& point : sample_points(diagram, 8, 6)) {
      std::vector<Rational> values = figure.values;
      values[figure.x] = point.x;
      const auto sample = SolvedSample::make(setting, values);
      const BicycleOfValues scene = bicycle_of(sample->point());
      check_point(diagram.plane, point, scene, sample->load(point.y));
    }
    const std::vector<std::string> expected{"xi1", "xi2", "xi3", "xi4", "xi5", "xi6"};
    auto curves = diagram.plane.curves;
    std::sort(curves.begin(), curves.end());
    CHECK(curves == expected);
    std::vector<std::string> lines;
    for (const Plane::Line& line : diagram.plane.lines)
      lines.push_back(line.symbol + (line.misprint ? " printed" : ""));
    std::sort(lines.begin(), lines.end());
    CHECK(lines == std::vector<std::string>{"b0", "b1", "b1 printed", "b11"});
  }
}

TEST_CASE("a plane of claims about another mechanism tells its quantities") {
  const ClaimsFile claims = parse_claims(R"(
schema = "slipproof/claims/1"
paper = { title = "x", authors = ["y"], source = "z" }
[[setting]]
id = "shaken"
mechanism = "block-shaken"
motions = "strict"
[setting.parameters]
m = { domain = "m > 0", meaning = "as in the mechanism" }
b = { domain = "b > 0", meaning = "as in the mechanism" }
h = { domain = "h > 0", meaning = "as in the mechanism" }
I = { domain = "I > 0", meaning = "as in the mechanism" }
mu = { domain = "mu > 0", meaning = "as in the mechanism" }
g = { domain = "g > 0", meaning = "as in the mechanism" }
[[claim]]
id = "rest"
line = 1
statement = "it rests until it slides or tips"
kind = "interval"
mode = "stick/stick"
forces = "-mu < A < mu and -b < A*h < b"
)",
                                         "shaken.toml");
  const auto figure = parse_figures(R"(
schema = "slipproof/figures/1"
[[figure]]
id = "friction"
title = "friction"
setting = "shaken"
x = "mu"
x_from = "1/10"
x_to = "1"
y_from = "1/10"
y_to = "1"
values = { m = "1", b = "1/2", h = "1", I = "1/3", g = "10" }
)",
                                    "figures.toml", claims)
                          .front();
  const PhaseDiagram diagram = phase_diagram(claims_plane(claims, figure, Reading::printed), 8);
  REQUIRE(diagram.plane.quantities.size() == 3 + 4 + 4);
  CHECK(diagram.plane.words({ElementState::stick, ElementState::lift}) == "left sticks, right is open");
  CHECK(diagram.plane.words({ElementState::pulled_slip_backward, ElementState::free}) ==
        "left slips (-), pulled, right is free");
  for (const PhasePoint& point : sample_points(diagram, 4, 4)) {
    REQUIRE(point.motions.size() == 1);
    REQUIRE(point.motions.front().values.size() == diagram.plane.quantities.size());
    if (point.x < point.y && point.y * 2 < 1) CHECK(*point.motions.front().values[0] != 0);  // ax: it slides
  }
}

TEST_CASE("the third motion of the ambiguous region shows, and the claim that denies it is refuted there") {
  const auto& claims = test::shipped_paper();
  const auto all = figures();
  const auto zoom = std::find_if(all.begin(), all.end(), [](const Figure& f) { return f.id == "plane-b1"; });
  REQUIRE(zoom != all.end());
  const PhaseDiagram diagram = phase_diagram(claims_plane(claims, *zoom, Reading::printed), 40);
  const PhaseRegions regions = phase_regions(diagram);
  CHECK(std::any_of(regions.sets.begin(), regions.sets.end(),
                    [](const MotionSet& set) { return name(set) == "stick/stick, stick/slip+, stick/lift"; }));
  CHECK(std::any_of(regions.refuted.begin(), regions.refuted.end(),
                    [&](const RefutedStrip& strip) { return diagram.plane.claims[strip.claim] == "A5.1"; }));
  const PhaseDiagram meant = phase_diagram(claims_plane(claims, *zoom, Reading::repaired), 40);
  for (const RefutedStrip& strip : phase_regions(meant).refuted) CHECK(meant.plane.claims[strip.claim] != "A5.1");
}

TEST_CASE("random scenes: every point, and pictures that are well-formed") {
  test::RandomScenes random(11);
  for (int i = 0; i < 12; ++i) {
    const Bicycle<Rational> bicycle = random.bicycle(i % 3 != 0);
    const Rational f = random.fraction(0, 30), g = random.positive();
    MechanismScene scene = test::scene_of(bicycle, {f, g}, i % 2 == 0 ? ForceKind::internal : ForceKind::external);
    scene.name = "<&\x01 \xFF> scene " + std::to_string(i);
    MechanismAxes axes;
    axes.x = i % 2 == 0 ? "f" : "b3";
    const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, axes, "s"), 8);
    for (const PhasePoint& point : sample_points(diagram, 4, 5)) {
      check_point(diagram.plane, point, *with_parameter(scene, axes.x, point.x), point.y);
    }
    pugi::xml_document svg;
    CHECK(svg.load_string(phase_svg_file(diagram).c_str()));
    CHECK(phase_svg_file(diagram) == phase_svg_file(phase_diagram(mechanism_plane(scene, axes, "s"), 8)));
    const auto json = nlohmann::json::parse(map_json(diagram, scene));
    CHECK(json["columns"].size() == diagram.columns.size());
  }
}

TEST_CASE("a plane that cannot be is refused in words") {
  const MechanismScene scene = read_scene(source + "/cases/city-bicycle.toml");
  const auto refused = [&](const char* x, std::optional<Rational> from, std::optional<Rational> to) {
    MechanismAxes axes;
    axes.x = x;
    axes.x_from = from;
    axes.x_to = to;
    CHECK_THROWS_AS(mechanism_plane(scene, axes, "s"), std::invalid_argument);
  };
  refused("frog", std::nullopt, std::nullopt);
  refused("f", Rational(1), Rational(1));
  refused("R", Rational(-2), Rational(-1));
  MechanismScene light = scene;
  light.values.given[bicycle_parameter("J")] = false;
  MechanismAxes axes;
  axes.x = "J";
  CHECK_THROWS_AS(mechanism_plane(light, axes, "s"), std::invalid_argument);
}

TEST_CASE("every mistake of a figures file is reported") {
  const auto& claims = test::shipped_paper();
  const std::string text =
      "schema = \"slipproof/figures/1\"\n[[figure]]\nid = \"a b\"\ntitle = \"t\"\nsetting = \"nowhere\"\n"
      "x = \"b\"\nx_from = \"2\"\nx_to = \"1\"\ny_from = \"0\"\n";
  try {
    parse_figures(text, "f.toml", claims);
    CHECK(false);
  } catch (const InputError& error) {
    CHECK(error.diagnostics().size() == 4);  // the id, the setting, x_to below x_from, no y_to
    for (const Diagnostic& d : error.diagnostics()) CHECK(d.line > 0);
  }
  CHECK_THROWS_AS(parse_figures("schema = \"slipproof/claims/1\"", "f.toml", claims), InputError);
}

TEST_CASE("ticks are round and inside") {
  CHECK(ticks(0, 1, 5) == std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1});
  for (const double x : ticks(-12345, 6789, 6)) CHECK((x >= -12345 && x <= 6789));
}
