// What is solved of bicycles by their mechanism, against their reduced equations: the same modes, loads and rationals.
#include "mechanics/bicycle_modes/bicycle_motions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

#include "mechanics/bicycle/chain.hpp"
#include "mechanics/bicycle/domain.hpp"
#include "mechanics/bicycle_modes/motions.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "support/bicycle_scenes.hpp"
#include "support/random_scene.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// In the order of the mechanism: accelerations, then forces.
std::vector<Rational> numbers(const Bicycle<Rational>& p, const Motion<Rational>& m, const Rational& F) {
  using enum Quantity;
  const Chain<Rational> chain = chain_of(p, m, F);
  return {m[a],    m[a_y],   m[phi],  chain.eps1, m[eps2], m[eps3], m[gap2], m[slip2],
          m[gap3], m[slip3], chain.T, m[N2],      m[S2],   m[N3],   m[S3]};
}

std::vector<MechanismMode> sorted(std::vector<MechanismMode> modes) {
  std::sort(modes.begin(), modes.end());
  return modes;
}

void check_modes(const ModeTable& table, const MotionsOverLoads& motions) {
  for (const ContactMode mode : all_modes()) {
    CHECK(contact_mode(mechanism_mode(mode)) == mode);
    const ModeSolution* known = table.find(mode);
    const auto found = motions.find(mechanism_mode(mode));
    REQUIRE((known != nullptr) == found.has_value());
    if (!found) continue;
    CHECK(*found->closed == known->closed());
    CHECK(*found->strict == known->strict());
  }
}

void check_motions(const MechanismScene& scene, const BicycleOfValues& p, const MotionsAtForce& known) {
  const MotionsAtLoad found = motions_of(friction_problem(scene.mechanism, scene.values), scene.load);
  CHECK(found.continua.empty() == known.continua.empty());
  if (!known.continua.empty()) return;  // what a continuum contains is none of its own here
  REQUIRE(found.motions.size() == known.motions.size());
  CHECK(found.rejected.size() == known.rejected.size());
  for (const auto& motion : known.motions) {
    std::vector<MechanismMode> modes;
    for (const ContactMode mode : motion.modes) modes.push_back(mechanism_mode(mode));
    const auto same = std::find_if(found.motions.begin(), found.motions.end(),
                                   [&](const MotionAtLoad& m) { return sorted(m.all_modes()) == sorted(modes); });
    REQUIRE(same != found.motions.end());
    CHECK(same->strict() == motion.strict);
    std::vector<Rational> values = same->accelerations;
    for (const Range& force : same->forces) values.push_back(*force.lower);
    CHECK(values == numbers(p.bicycle, motion.values, *scene.load));
  }
}

}  // namespace

TEST_CASE("a bicycle has the motions of its reduced equations, as rationals, at every force where they change") {
  RandomScenes random(20261122);
  std::size_t continua = 0;
  const char* wanted = std::getenv("SLIPPROOF_RANDOM_BICYCLES");
  const int count = wanted == nullptr ? 200 : std::atoi(wanted);
  for (int i = 0; i < count; ++i) {
    BicycleOfValues p;
    p.bicycle = i % 3 == 0 ? random.reduced(true) : random.bicycle(i % 4 != 0);
    if (i % 5 == 0) p.bicycle.I2 = p.bicycle.I3 = 0;  // a massless wheel that slips may spin at any rate
    p.road = random.road();
    if (!in_domain(p.bicycle, p.road)) continue;  // one in many thousands has no wheelbase
    p.kind = i % 2 == 0 ? ForceKind::internal : ForceKind::external;
    MechanismScene scene = scene_of(p.bicycle, p.road, p.kind);
    const ModeTable table(p.bicycle, p.road, p.kind);
    check_modes(table, *motions_over_loads(friction_problem(scene.mechanism, scene.values)));
    for (const Cell& cell : partition(table)) {
      scene.load = cell.forces.sample();
      const MotionsAtForce known = motions_at(table, *scene.load);
      continua += known.continua.size();
      check_motions(scene, p, known);
    }
  }
  CHECK(continua > 10);
}
