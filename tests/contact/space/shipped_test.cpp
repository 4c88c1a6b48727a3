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
