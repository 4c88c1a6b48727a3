// The scenes in space that come with slipproof.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "contact/exchange/export_scene.hpp"
#include "contact/space/solve_space.hpp"

using namespace slipproof;

TEST_CASE("shipped scenes in space have one motion, completely") {
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SLIPPROOF_SOURCE_DIR "/cases/space")) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path().string());
    const SolvedSpace solved = solve_space(read_scene(entry.path(), Dimensions::any));
    CHECK(solved.complete());
    CHECK(solved.motions.size() == 1);
    CHECK_THROWS_AS(read_scene(entry.path()), InputError);  // whoever knows the plane alone
    ++scenes;
  }
  CHECK(scenes >= 1);
}

TEST_CASE("the cube that is pushed obliquely slides and turns, and satisfies Newton's equations") {
  const MechanismScene scene =
      read_scene(SLIPPROOF_SOURCE_DIR "/cases/space/cube-pushed-obliquely.toml", Dimensions::any);
  const SolvedSpace solved = solve_space(scene);
  REQUIRE(solved.motions.size() == 1);
  const SpaceMotion& motion = solved.motions.front();
  CHECK(motion.is_continuum());
  const auto names = force_names(scene.mechanism);
  Rational low = 0, high = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i][0] != 'N') continue;
    low += *motion.forces[i]->lower;
    high += *motion.forces[i]->upper;
  }
  const Rational weight(981, 100);
  CHECK(low <= weight);
  CHECK(weight <= high);
  CHECK(*motion.accelerations[0].lower > 4);    // along the push,
  CHECK(*motion.accelerations[5].upper < -40);  // and round
}

TEST_CASE("an exported scene in space has its accelerations in order") {
  const MechanismScene scene =
      read_scene(SLIPPROOF_SOURCE_DIR "/cases/space/cube-pushed-obliquely.toml", Dimensions::any);
  const GlobalProblem problem = global_problem(scene);
  CHECK(problem.dimension == 3);
  REQUIRE(problem.M.size() == 6);
  CHECK(problem.M[0][0] == 1);
  CHECK(problem.M[5][5] == Rational(2, 300));
  CHECK(problem.f[2] == Rational(-981, 100));
  REQUIRE(problem.H[0].size() == 12);
  CHECK(problem.H[2][0] == 1);                 // N of A along z
  CHECK(problem.H[4][0] == Rational(1, 10));   // and its moment about y at (-h, -h, -h)
  CHECK(problem.H[5][2] == Rational(-1, 10));  // of T2 about z
}

TEST_CASE("of a continuum another motion is told, and where all are") {
  for (const std::string name : {"cube-pushed-obliquely", "cart-across-slope"}) {
    CAPTURE(name);
    const SolvedSpace solved =
        solve_space(read_scene(SLIPPROOF_SOURCE_DIR "/cases/space/" + name + ".toml", Dimensions::any));
    REQUIRE(solved.motions.size() == 1);
    const SpaceMotion& one = solved.motions.front();
    REQUIRE(one.others.size() == 1);
    const SpaceMotion& other = one.others.front();
    bool differ = false;
    REQUIRE(one.all_accelerations.size() == one.accelerations.size());
    for (std::size_t i = 0; i < one.accelerations.size(); ++i) {
      const Range &a = one.accelerations[i], &b = other.accelerations[i], &all = one.all_accelerations[i];
      differ = differ || *a.upper < *b.lower || *b.upper < *a.lower;
      CHECK(*all.lower <= std::min(*a.lower, *b.lower));
      CHECK(std::max(*a.upper, *b.upper) <= *all.upper);
    }
    CHECK(differ);
  }
}

TEST_CASE("what follows from contacts that stay closed is exactly 0") {
  const SolvedSpace cart =
      solve_space(read_scene(SLIPPROOF_SOURCE_DIR "/cases/space/cart-across-slope.toml", Dimensions::any));
  const auto names = acceleration_names(cart.scene.mechanism);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] != "az_cart" && names[i] != "alphax_cart" && names[i] != "alphay_cart") continue;
    CAPTURE(names[i]);
    CHECK(cart.motions.front().accelerations[i] == Range{0, 0});
  }
}
