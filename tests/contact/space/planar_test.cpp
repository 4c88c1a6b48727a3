// The plane is a special case of space: planar scenes put into space have the same motion.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "contact/space/in_space.hpp"
#include "contact/space/solve_space.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/points/sampling.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "support/how_many.hpp"

using namespace slipproof;

namespace {

const MotionAtLoad* only_motion(const MotionsAtLoad& found) {
  return found.motions.size() == 1 && found.continua.empty() ? found.motions.data() : nullptr;
}

bool contains(const Range& range, const Rational& value) {
  return *range.lower <= value && value <= *range.upper;
}

const Range& named(const Mechanism& m, const SpaceMotion& motion, const std::string& name) {
  const auto names = acceleration_names(m);
  const auto found = std::ranges::find(names, name);
  REQUIRE_MESSAGE(found != names.end(), name);
  return motion.accelerations[static_cast<std::size_t>(found - names.begin())];
}

/// Of each body along x and up, and its turning.
void compare(const Mechanism& planar, const MotionAtLoad& motion, const Mechanism& spatial,
             const SpaceMotion& in_space) {
  std::size_t unknown = 0;
  for (std::size_t b = 1; b < planar.bodies->bodies.size(); ++b) {
    const Body& flat = planar.bodies->bodies[b];
    const Body& body = spatial.bodies->bodies[b];
    const std::array<std::pair<std::size_t, std::size_t>, 3> same{{{0, 0}, {1, 2}, {5, 4}}};
    for (const auto& [from, to] : same) {
      if (flat.unknowns[from].symbol.empty()) continue;
      const bool negated = flat.unknowns[from].negated != (from == 5);
      const Rational& value = motion.accelerations[unknown++];
      CHECK(contains(named(spatial, in_space, body.unknowns[to].symbol), negated ? Rational(-value) : value));
    }
    for (const std::size_t out : {1U, 3U, 5U}) {  // nothing leaves the plane
      if (!body.unknowns[out].symbol.empty()) {
        CHECK(contains(named(spatial, in_space, body.unknowns[out].symbol), 0));
      }
    }
  }
}

}  // namespace

TEST_CASE("planar scenes put into space have the same motion") {
  const std::size_t wanted = test::how_many<std::size_t>("SLIPPROOF_SCENES_IN_SPACE", 10);
  std::size_t compared = 0, mechanisms = 0, tried = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/bodies")) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path().string());
    const Mechanism planar = read_mechanism(entry.path());
    const auto text = test::in_space(planar);
    if (!text) continue;
    CAPTURE(*text);
    const Mechanism spatial = parse_mechanism(*text, "in space");
    const ProblemMaker maker(planar);
    ++mechanisms;
    for (const MechanismValues& values : sample_values(planar, maker, wanted, 64)) {
      MechanismScene scene{"in space", spatial, values, std::nullopt, {}};
      scene.values.starts = starts(spatial);
      if (planar.load) scene.load = Rational(static_cast<int>(compared * 7 % 41) - 20, 3);
      const MotionsAtLoad found = motions_of(maker.problem(values), scene.load);
      const MotionAtLoad* motion = only_motion(found);
      if (motion == nullptr) continue;
      ++tried;
      const SolvedSpace solved = solve_space(scene);
      if (!solved.complete() || solved.motions.size() != 1) continue;
      compare(planar, *motion, spatial, solved.motions.front());
      ++compared;
    }
  }
  CHECK(mechanisms >= 12);
  CHECK(compared >= 10 * wanted);
  CHECK(compared > tried * 9 / 10);  // where bodies may leave the plane, there may be other motions
}
