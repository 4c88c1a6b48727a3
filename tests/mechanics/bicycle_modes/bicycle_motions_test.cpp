// The table of a bicycle's modes against the kernel on the bicycle's file.
#include "mechanics/bicycle_modes/bicycle_motions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

#include "mechanics/bicycle/domain.hpp"
#include "support/random_scene.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// The values of forms without free parameters at a load.
std::vector<Rational> at(const std::vector<AffineForm>& forms, const Rational& load) {
  std::vector<Rational> values;
  for (const AffineForm& form : forms) values.push_back(form.at({load}));
  return values;
}

void check_modes(const MotionsOverLoads& table, const MotionsOverLoads& kernel) {
  for (const ContactMode mode : all_modes()) {
    const MechanismMode& m = mechanism_mode(mode);
    CHECK(contact_mode(m) == mode);
    const auto x = table.find(m), y = kernel.find(m);
    REQUIRE(x.has_value() == y.has_value());
    if (!x) continue;
    CHECK(*x->closed == *y->closed);
    CHECK(*x->strict == *y->strict);
    CHECK(x->continuum == y->continuum);
    const auto forms = table.forms(m), others = kernel.forms(m);
    REQUIRE(forms.has_value() == others.has_value());
    if (!forms || x->closed->empty()) continue;
    REQUIRE(forms->free == others->free);
    if (forms->free > 0) continue;  // both are the kernel's
    const Rational load = x->closed->sample();
    CHECK(at(forms->accelerations, load) == at(others->accelerations, load));
    CHECK(at(forms->forces, load) == at(others->forces, load));
    CHECK(at(forms->conditions, load) == at(others->conditions, load));
  }
}

using Parts = std::vector<MechanismMode>;
Parts sorted(Parts modes) {
  std::sort(modes.begin(), modes.end());
  return modes;
}

void check_cells(const std::vector<LoadCell>& table, const std::vector<LoadCell>& kernel) {
  for (const LoadCell& cell : table) {
    const Rational inside = cell.loads.sample();
    const auto same =
        std::find_if(kernel.begin(), kernel.end(), [&](const auto& c) { return c.loads.contains(inside); });
    REQUIRE(same != kernel.end());
    CHECK(sorted(cell.continua) == sorted(same->continua));
    REQUIRE(cell.motions.size() == same->motions.size());
    for (const MotionOverLoads& motion : cell.motions) {
      const auto alike = std::find_if(same->motions.begin(), same->motions.end(), [&](const MotionOverLoads& m) {
        return sorted(m.modes) == sorted(motion.modes) && sorted(m.boundary_modes) == sorted(motion.boundary_modes);
      });
      REQUIRE(alike != same->motions.end());
      for (std::size_t i = 0; i < motion.accelerations.size(); ++i) {
        CHECK(motion.accelerations[i].at(inside) == alike->accelerations[i].at(inside));
      }
      for (std::size_t i = 0; i < motion.forces.size(); ++i) {
        CHECK(motion.forces[i]->at(inside) == alike->forces[i]->at(inside));
      }
    }
  }
}

}  // namespace

TEST_CASE("a bicycle's modes over the loads are those of its file") {
  RandomScenes random(20261122);
  std::size_t continua = 0;
  const char* wanted = std::getenv("SLIPPROOF_RANDOM_BICYCLES");
  const int count = wanted == nullptr ? 200 : std::atoi(wanted);
  for (int i = 0; i < count; ++i) {
    Bicycle<Rational> p = i % 3 == 0 ? random.reduced(true) : random.bicycle(i % 4 != 0);
    if (i % 5 == 0) p.I2 = p.I3 = 0;  // a massless wheel that slips may spin at any rate
    const Road<Rational> road = random.road();
    if (!in_domain(p, road)) continue;  // one in many thousands has no wheelbase
    const ForceKind kind = i % 2 == 0 ? ForceKind::internal : ForceKind::external;
    const MechanismValues values = bicycle_values(p, road, kind);
    const auto table = bicycle_motions(p, road, kind);
    const auto kernel = motions_over_loads(friction_problem(bicycle_mechanism(), values));
    check_modes(*table, *kernel);
    check_cells(table->cells(), kernel->cells());
    for (const LoadCell& cell : kernel->cells()) continua += cell.continua.size();
    const BicycleOfValues back = bicycle_of(values);
    CHECK(bicycle_values(back.bicycle, back.road, back.kind).parameters == values.parameters);
  }
  CHECK(continua > 10);
}

TEST_CASE("some modes alone are as among all") {
  RandomScenes random(7);
  const std::vector<MechanismMode> some{mechanism_mode({ElementState::stick, ElementState::slip_forward}),
                                        mechanism_mode({ElementState::slip_backward, ElementState::lift})};
  for (int i = 0; i < 50; ++i) {
    const Bicycle<Rational> p = random.bicycle(true);
    const Road<Rational> road = random.road();
    const auto all = bicycle_motions(p, road, ForceKind::external);
    const auto problem = friction_problem(bicycle_mechanism(), bicycle_values(p, road, ForceKind::external));
    for (const auto& few : {bicycle_motions(p, road, ForceKind::external, some), motions_over_loads(problem, some)}) {
      for (const MechanismMode& mode : some) CHECK(*few->find(mode)->closed == *all->find(mode)->closed);
    }
  }
}
