// Scenes of the three formats against the same scenes drawn by hand: every motion, as rationals.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "contact/exchange/planar.hpp"
#include "contact/exchange/written.hpp"
#include "contact/imported/read_scene.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/points/problem.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "support/parsers.hpp"

using namespace slipproof;
using test::WrittenScene;

namespace {

/// A number for each name in braces.
using Values = std::map<std::string, Rational>;

std::string filled(std::string text, const Values& values) {
  for (const auto& [name, value] : values) {
    const std::string hole = "{" + name + "}";
    for (std::size_t at = text.find(hole); at != std::string::npos; at = text.find(hole)) {
      text.replace(at, hole.size(), "(" + value.str() + ")");
    }
  }
  return text;
}

const std::string head = "schema = \"slipproof/mechanism/1\"\nname = \"by hand\"\ngravity = [\"0\", \"-9.81\"]\n";

std::string body(const std::string& name, const std::string& mass, const std::string& inertia, const std::string& x,
                 const std::string& z) {
  return fmt::format("[[body]]\nname = \"{}\"\nmass = \"{{{}}}\"\ninertia = \"{{{}}}\"\nat = [\"{}\", \"{}\"]\n", name,
                     mass, inertia, x, z);
}
std::string foot(const std::string& name, const std::string& of, const std::string& x, const std::string& z,
                 const std::string& more = {}) {
  return fmt::format("[[contact]]\nname = \"{}\"\nof = \"{}\"\npoint = [\"{}\", \"{}\"]\nfriction = \"{{mu}}\"\n{}",
                     name, of, x, z, more.empty() ? "normal = [\"0\", \"1\"]\n" : more);
}

/// Ten scenes in some numbers.
std::vector<std::pair<std::string, WrittenScene>> scenes(const Values& v) {
  const auto& at = [&](const char* name) { return v.at(name); };
  const Rational w = at("w"), h = at("h"), m = at("m"), I = at("I"), R = at("R"), l = at("l"), mu = at("mu");
  const std::string level = "normal = [\"0\", \"1\"]\n", disc = "radius = \"{R}\"\n" + level;
  std::vector<std::pair<std::string, WrittenScene>> all;
  const auto add = [&](const std::string& name, std::vector<test::WrittenBody> bodies,
                       std::vector<test::WrittenJoint> joints, const std::string& hand) {
    all.push_back({name, {std::move(bodies), std::move(joints), mu, filled(head + hand, v)}});
  };
  add("a box on the ground", {{"box", "box", {w, 1, h}, 1, h / 2, m, I}}, {},
      body("box", "m", "I", "1", "{h}/2") + foot("a", "box", "-{w}/2", "-{h}/2") + foot("b", "box", "{w}/2", "-{h}/2"));
  add("a ball on the ground", {{"ball", "sphere", {R}, 0, R, m, I}}, {},
      body("ball", "m", "I", "0", "{R}") + foot("a", "ball", "0", "0", disc));
  add("a roller on the ground", {{"roller", "cylinder", {R, l}, 2, R, m, I}}, {},
      body("roller", "m", "I", "2", "{R}") + foot("a", "roller", "0", "0", disc));
  add("a bar on the ground", {{"bar", "bar", {R, l}, 0, R, m, I}}, {},
      body("bar", "m", "I", "0", "{R}") + foot("a", "bar", "-{l}/2", "-{R}") + foot("b", "bar", "{l}/2", "-{R}"));
  add("a box on a wider box",
      {{"under", "box", {2 * w, 1, h}, 0, h / 2, m, I}, {"upper", "box", {w, 1, h}, 0, 3 * h / 2, 2, I}}, {},
      body("under", "m", "I", "0", "{h}/2") +
          "[[body]]\nname = \"upper\"\nmass = \"2\"\ninertia = \"{I}\"\nat = [\"0\", \"3*{h}/2\"]\n" +
          foot("a", "under", "-{w}", "-{h}/2") + foot("b", "under", "{w}", "-{h}/2") +
          foot("c", "upper", "-{w}/2", "-{h}/2", level + "on = \"under\"\n") +
          foot("d", "upper", "{w}/2", "-{h}/2", level + "on = \"under\"\n"));
  add("a pendulum whose bob touches the ground", {{"bob", "sphere", {R}, 0, R, m, I}},
      {{"pin", "hinge", "", "bob", l, R + h}},
      body("bob", "m", "I", "0", "{R}") +
          "[[joint]]\nname = \"pin\"\nkind = \"pin\"\nbetween = [\"ground\", \"bob\"]\nat = [\"{l}\", \"{R} + "
          "{h}\"]\n" +
          foot("a", "bob", "0", "0", disc));
  add("a cart on two wheels",
      {{"deck", "box", {2 * l, 1, h}, 0, 2 * R + h, m, I},
       {"rear", "cylinder", {R, 1}, -l, R, 1, I},
       {"front", "cylinder", {R, 1}, l, R, 2, I}},
      {{"axle1", "hinge", "deck", "rear", -l, R}, {"axle2", "hinge", "deck", "front", l, R}},
      body("deck", "m", "I", "0", "2*{R} + {h}") +
          "[[body]]\nname = \"rear\"\nmass = \"1\"\ninertia = \"{I}\"\nat = [\"-{l}\", \"{R}\"]\n"
          "[[body]]\nname = \"front\"\nmass = \"2\"\ninertia = \"{I}\"\nat = [\"{l}\", \"{R}\"]\n"
          "[[joint]]\nname = \"axle1\"\nkind = \"pin\"\nbetween = [\"rear\", \"deck\"]\nat = [\"0\", \"0\"]\n"
          "[[joint]]\nname = \"axle2\"\nkind = \"pin\"\nbetween = [\"front\", \"deck\"]\nat = [\"0\", \"0\"]\n" +
          foot("a", "rear", "0", "0", disc) + foot("b", "front", "0", "0", disc));
  add("a press that slides down on the ground", {{"press", "box", {w, 1, h}, 0, h / 2, m, I}},
      {{"rail", "slide", "", "press", 1, h}},
      body("press", "m", "I", "0", "{h}/2") +
          "[[joint]]\nname = \"rail\"\nkind = \"slider\"\nbetween = [\"ground\", \"press\"]\nat = [\"1\", "
          "\"{h}\"]\naxis = [\"0\", \"1\"]\n" +
          foot("a", "press", "-{w}/2", "-{h}/2") + foot("b", "press", "{w}/2", "-{h}/2"));
  add("a ball in a corner",
      {{"wall", "box", {1, 1, 4}, R + Rational(1, 2), 2, 1, 1, true}, {"ball", "sphere", {R}, 0, R, m, I}}, {},
      body("ball", "m", "I", "0", "{R}") + foot("a", "ball", "0", "0", disc) +
          foot("b", "ball", "0", "0", "radius = \"{R}\"\nnormal = [\"-1\", \"0\"]\n"));
  add("two balls side by side", {{"left", "sphere", {R}, -R, R, m, I}, {"right", "sphere", {R}, R, R, 2, I}}, {},
      body("left", "m", "I", "-{R}", "{R}") +
          "[[body]]\nname = \"right\"\nmass = \"2\"\ninertia = \"{I}\"\nat = [\"{R}\", \"{R}\"]\n" +
          foot("a", "left", "0", "0", disc) + foot("b", "right", "0", "0", disc) +
          foot("c", "left", "0", "0",
               "radius = \"{R}\"\non = \"right\"\non_point = [\"0\", \"0\"]\non_radius = \"{R}\"\n"));
  return all;
}

/// All that is determined of all motions: accelerations of bodies, and the sum of the normal forces where it has one
/// value. Names, the order of contacts and redundant forces do not matter.
std::vector<std::vector<Rational>> motions(const std::string& text) {
  const Mechanism mechanism = parse_mechanism(text, "scene");
  const FrictionProblem problem = friction_problem(mechanism, default_values(mechanism));
  std::vector<std::vector<Rational>> result;
  const MotionsAtLoad found = motions_of(problem, std::nullopt);
  for (const MotionAtLoad& motion : found.motions) {
    result.emplace_back(motion.accelerations.begin(),
                        motion.accelerations.begin() + static_cast<std::ptrdiff_t>(mechanism.accelerations));
    Rational least = 0, most = 0;
    bool bounded = true;
    for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
      const Range& range = motion.forces[mechanism.contacts[i].normal - mechanism.accelerations];
      bounded = bounded && range.lower && range.upper;
      if (bounded) least += *range.lower, most += *range.upper;
    }
    if (bounded) result.back().insert(result.back().end(), {least, most});
    result.back().emplace_back(static_cast<int>(motion.modes.size() + motion.boundary_modes.size()));
  }
  result.push_back({static_cast<int>(found.continua.size()), static_cast<int>(mechanism.contacts.size())});
  std::ranges::sort(result);
  return result;
}

const std::vector<Values> numbers{
    {{"w", 2}, {"h", 1}, {"m", 3}, {"I", Rational(5, 4)}, {"R", Rational(1, 2)}, {"l", 2}, {"mu", Rational(1, 2)}},
    {{"w", Rational(3, 5)},
     {"h", Rational(7, 4)},
     {"m", Rational(1, 8)},
     {"I", Rational(1, 100)},
     {"R", Rational(1, 20)},
     {"l", Rational(3, 10)},
     {"mu", Rational(9, 10)}},
    {{"w", 10},
     {"h", Rational(1, 10)},
     {"m", 1000},
     {"I", Rational(625, 2)},
     {"R", 3},
     {"l", 8},
     {"mu", Rational(1, 100)}}};

}  // namespace

TEST_CASE("thirty scenes in each format have the motions of the same scenes drawn by hand") {
  if (!has_parsers()) return;
  std::size_t compared = 0;
  for (const Values& values : numbers) {
    for (const auto& [name, scene] : scenes(values)) {
      CAPTURE(name);
      const auto expected = motions(scene.hand);
      imported::PlanarOptions options;
      imported::PlanarOptions ground = options;
      ground.ground = 0;
      ground.mu = scene.mu;
      for (const auto& [text, how] :
           {std::pair(scene.urdf(), ground), std::pair(scene.sdf(), options), std::pair(scene.mjcf(), options)}) {
        CAPTURE(text);
        const auto found = to_planar(imported::parse_scene_of_bodies(text, "scene.xml"), how);
        CHECK(found.plane == "xz");
        CHECK(motions(found.text) == expected);
        ++compared;
      }
    }
  }
  CHECK(compared == 90);
}
