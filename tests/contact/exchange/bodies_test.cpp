// Scenes as engines read them have the same equations, gaps and slips.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/number/binary64.hpp"
#include "contact/exchange/export_bodies.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/mechanism/words.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "support/engine_scene.hpp"

using namespace slipproof;
using test::EngineScene;

namespace {

const std::string shipped = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/";

/// A motion by names; nothing where forces are undetermined.
std::optional<EngineScene::Values> values_of(const Mechanism& m, const MotionAtLoad& motion) {
  EngineScene::Values result;
  const auto accelerations = acceleration_names(m), forces = force_names(m);
  for (std::size_t i = 0; i < accelerations.size(); ++i) {
    result[accelerations[i]] = nearest_binary64(motion.accelerations[i]);
  }
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (!motion.forces[i].is_point()) return std::nullopt;
    result[forces[i]] = nearest_binary64(*motion.forces[i].lower);
  }
  return result;
}

bool at_rest(const EngineScene& scene) {
  for (const auto& body : scene.document["bodies"]) {
    if (body["velocity"] != EngineScene::Json({0, 0}) || body["spin"] != 0) return false;
  }
  return true;
}

/// Holds each motion that the kernel finds to the exported scene; returns how many it had.
int agree(MechanismScene scene, const std::vector<Rational>& loads) {
  int held = 0;
  const FrictionProblem problem = friction_problem(scene.mechanism, scene.values);
  for (const Rational& load : loads) {
    if (scene.mechanism.load) {
      if (!problem.load_domain.contains(load)) continue;
      scene.load = load;
    }
    const EngineScene engine(bodies_json(scene));
    for (const MotionAtLoad& motion : motions_of(problem, scene.load).motions) {
      const auto values = values_of(scene.mechanism, motion);
      if (!values) continue;
      ++held;
      CHECK(engine.residual(*values) < 1e-12);
      if (!at_rest(engine)) continue;
      double size = 0;
      for (const std::string& name : acceleration_names(scene.mechanism))
        size = std::max(size, std::abs(values->at(name)));
      for (const auto& contact : engine.document["contacts"]) {
        for (const MechanismContact& given : scene.mechanism.contacts) {
          if (given.name != contact["name"]) continue;
          const auto seen = engine.gap_and_slip(contact, *values);
          CHECK(std::abs(seen[0] - values->at(given.gap_name)) <= 1e-12 * size);
          if (!given.slip_name.empty()) CHECK(std::abs(seen[1] - values->at(given.slip_name)) <= 1e-12 * size);
        }
      }
    }
  }
  return held;
}

}  // namespace

TEST_CASE("an engine that reads a scene has the equations, gaps and slips of its motions") {
  const std::vector<Rational> loads{-1000, -7, Rational(1, 3), 2, 40, 5000};
  for (const std::string name : {"barrow-at-kerb", "block-pushed", "book", "car-and-trailer", "double-pendulum",
                                 "finger", "garden-roller", "stepladder", "truck", "walking-foot"}) {
    CAPTURE(name);
    CHECK(agree(read_scene(shipped + "asked/scenes/" + name + ".toml"), loads) > 0);
  }
}

TEST_CASE("joints of all kinds push as they are exported") {
  const std::string masses = R"(
schema = "slipproof/mechanism/1"
name = "masses on a line"
gravity = ["0", "-10"]
[[body]]
name = "first"
mass = "2"
inertia = "1"
at = ["0", "1"]
angle = ["3/5", "4/5"]
[[body]]
name = "second"
mass = "3"
inertia = "1/2"
at = ["3", "5"]
[[contact]]
name = "floor"
of = "first"
point = ["0", "0"]
radius = "1"
normal = ["0", "1"]
friction = "1/3"
[[force]]
on = "second"
at = ["1", "2"]
is = ["3", "1"]
axes = "body"
back_on = "first"
[[torque]]
on = "second"
is = "5"
back_on = "first"
[[joint]]
name = "one"
between = ["first", "second"]
)";
  for (const std::string joint :
       {"kind = \"pin\"\nat = [\"1\", \"2\"]", "kind = \"weld\"\nat = [\"1\", \"2\"]",
        "kind = \"slider\"\nat = [\"0\", \"1\"]\naxis = [\"3/5\", \"-4/5\"]\nto = [\"-19/5\", \"-17/5\"]",
        "kind = \"rod\"\nat = [\"0\", \"0\"]\nto = [\"0\", \"0\"]\nlength = \"5\"",
        "kind = \"rope\"\nat = [\"0\", \"0\"]\nto = [\"0\", \"0\"]\nlength = \"5\"",
        "kind = \"spring\"\nat = [\"0\", \"0\"]\nto = [\"0\", \"0\"]\nlength = \"5\"\nforce = \"7/2\"",
        "kind = \"gear\"\nratio = \"-3/2\"", "kind = \"gear\"\nratio = \"1/2\"\none_sided = true"}) {
    CAPTURE(joint);
    CHECK(agree(parse_scene(masses + joint + "\n", "masses.toml"), {0}) > 0);
  }
}

TEST_CASE("what no engine can have is refused, and numbers are the nearest binary64") {
  CHECK_THROWS_WITH_AS(bodies_json(read_scene(shipped + "scenes/ladder.toml")),
                       doctest::Contains("given by its equations, expected one with bodies"), InputError);
  const MechanismScene scene = read_scene(shipped + "asked/scenes/block-pushed.toml");
  CHECK_THROWS_WITH_AS(bodies_json(scene), doctest::Contains("found no value of the load F"), InputError);
  const auto third = with_values(scene, {{"F", Rational(1, 3)}, {"mu", Rational(7)}});
  const EngineScene engine(bodies_json(third));
  CHECK(engine.document["forces"][0]["is"][0] == 1.0 / 3);
  CHECK(engine.document["contacts"][1]["friction"] == 7);
  CHECK(engine.document["bodies"][0]["inertia"] == 1552.0 / 3);
  CHECK_THROWS_WITH(with_values(scene, {{"m", Rational(-1)}}), doctest::Contains("expected m > 0"));
  CHECK_THROWS_WITH(with_values(scene, {{"F", Rational(-1)}}), doctest::Contains("expected a value in [0, +oo)"));
  CHECK_THROWS_WITH(with_values(scene, {{"mv", Rational(1)}}), doctest::Contains("did you mean 'm'?"));
  const auto book =
      with_values(read_scene(shipped + "asked/scenes/book.toml"), {{"P", Rational(0)}, {"theta", Rational(1, 2)}});
  CHECK(EngineScene(bodies_json(book)).document["bodies"][0]["angle"] == EngineScene::Json({-0.6, 0.8}));
}
