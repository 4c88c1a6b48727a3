// The scenes people ask about have the answers that their page gives.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mechanics/checks/checks.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/write_mechanism.hpp"
#include "mechanics/scene/scene.hpp"

using namespace slipproof;

namespace {

struct Asked {
  std::string scene;
  std::vector<Rational> changes;  ///< loads at which the motion becomes another
};

/// At a load, the strict modes of each motion; those with more than one are boundaries.
std::vector<std::string> modes_at(const MechanismScene& scene, const Rational& load) {
  std::vector<std::string> result;
  const MotionsAtLoad found = motions_of(friction_problem(scene.mechanism, scene.values), load);
  for (const MotionAtLoad& motion : found.motions) result.push_back(equal_modes(motion.modes));
  for (const ContinuumAtLoad& continuum : found.continua) result.push_back("continuum " + name(continuum.mode));
  std::ranges::sort(result);
  return result;
}

}  // namespace

TEST_CASE("the scenes people ask about change their motions where the page says") {
  const std::vector<Asked> all{
      {"block-pushed", {Rational(1, 5), Rational(22, 75), Rational(400, 971), Rational(1760, 179)}},
      {"truck", {Rational(-23544, 2005), Rational(-109, 25)}},
      {"barrow-at-kerb", {Rational(544327, 1650), Rational(1574242, 4025)}},
      {"book", {Rational(-6867, 2650), Rational(1984563, 131150)}},
      {"finger", {Rational(-185409, 4750000), Rational(-43273, 1750000), Rational(-15124077) / 9964750000}},
      {"walking-foot", {Rational(-198157407939) / 7838963500, Rational(184024756026) / 1884748375}},
      {"car-and-trailer", {Rational(1177455543633) / 386875255, Rational(1922651747631) / 428449385}},
      {"stepladder", {Rational(981, 20)}},
      {"garden-roller", {Rational(2943, 53), Rational(120663, 223), 981}},
      {"double-pendulum", {Rational(2943, 91600), Rational(981, 200)}}};
  const Rational near(1, 100000);
  for (const Asked& asked : all) {
    CAPTURE(asked.scene);
    const auto scene = read_scene(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/asked/scenes/" + asked.scene + ".toml");
    CHECK(check_mechanism(scene.mechanism).empty());
    for (const Rational& load : asked.changes) {
      CHECK(modes_at(scene, load - near) != modes_at(scene, load + near));
    }
  }
}

TEST_CASE("a roller that leaves the ground has one strict motion, in which its rolling resistance is free") {
  const auto scene = read_scene(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/asked/scenes/garden-roller.toml");
  const MotionsAtLoad found = motions_of(friction_problem(scene.mechanism, scene.values), Rational(1000));
  REQUIRE(found.motions.size() == 1);
  CHECK(equal_modes(found.motions[0].modes) == "lift/free");
  CHECK(found.motions[0].boundary_modes.empty());
  const Mechanism by_equations = parse_mechanism(to_toml(scene.mechanism), "garden-roller.toml");
  CHECK(motions_of(friction_problem(by_equations, scene.values), Rational(1000)).motions[0].modes ==
        found.motions[0].modes);
}

TEST_CASE("a square drawer pulled at its edge jams, and one that is twice as deep does not") {
  const std::string folder = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/asked/scenes/";
  MechanismScene drawer = read_scene(folder + "drawer-rule.toml");
  const auto accelerates = [&] {
    const MotionsAtLoad found = motions_of(friction_problem(drawer.mechanism, drawer.values), Rational(100));
    if (!found.continua.empty()) return true;
    REQUIRE(found.motions.size() == 1);
    return std::ranges::any_of(found.motions[0].accelerations, [](const Rational& x) { return !x.is_zero(); });
  };
  CHECK(!accelerates());
  const auto depth = std::ranges::find_if(drawer.mechanism.parameters, [](const auto& p) { return p.symbol == "d"; });
  drawer.values.parameters[static_cast<std::size_t>(depth - drawer.mechanism.parameters.begin())] = Rational(4, 5);
  CHECK(accelerates());
}
