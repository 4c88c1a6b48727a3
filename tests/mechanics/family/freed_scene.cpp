// A scene with a parameter freed is the same mechanism point by point and as a family, whose coefficients are compiled
// from expressions over the parameter.
#include "mechanics/family/freed_scene.hpp"

#include <doctest/doctest.h>

#include <filesystem>

#include "mechanics/family/solved_sample.hpp"

using namespace slipproof;

namespace {

std::vector<MechanismScene> shipped_scenes() {
  std::vector<MechanismScene> scenes;
  const std::filesystem::path folder = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) scenes.push_back(read_scene(entry.path()));
  return scenes;
}

void check_same(const std::vector<AffineForm>& x, const std::vector<AffineForm>& y) {
  REQUIRE(x.size() == y.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    CHECK(x[i].constant == y[i].constant);
    CHECK(x[i].coefficients == y[i].coefficients);
  }
}

}  // namespace

TEST_CASE("a freed scene has the same problems at its points and as a family") {
  std::size_t inside = 0, outside = 0;
  for (const MechanismScene& scene : shipped_scenes()) {
    for (std::size_t i = 0; i < scene.mechanism.parameters.size(); ++i) {
      if (!scene.values.given[i]) continue;
      const std::string& symbol = scene.mechanism.parameters[i].symbol;
      CAPTURE(scene.name);
      CAPTURE(symbol);
      const FreedScene freed(scene, find_parameter(scene, symbol), FreedScene::Tied::stay);
      const CompiledFamily family(freed.family());
      for (const Rational& x : {scene.values.parameters[i], Rational(-2), Rational(0), Rational(1, 3), Rational(40)}) {
        const auto problem = freed.problem(x);
        const auto sample = SolvedSample::in_domain(family, {x});
        REQUIRE(problem.has_value() == (sample != nullptr));
        ++(problem ? inside : outside);
        if (!problem) continue;
        CHECK(sample->point() == freed.values(x));
        check_same(problem->equations, sample->problem().equations);
        check_same(problem->accelerations, sample->problem().accelerations);
        if (problem->has_load) CHECK(*sample->force_domain() == problem->load_domain);
      }
    }
  }
  CHECK(inside > 100);
  CHECK(outside > 100);
}

TEST_CASE("only a parameter that the scene gives is freed") {
  const MechanismScene scene = read_scene(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes/ladder.toml");
  CHECK_THROWS_WITH_AS(find_parameter(scene, "muu"), doctest::Contains("parameter of the scene"),
                       std::invalid_argument);
  CHECK_THROWS_WITH_AS(find_symbol(scene, scene.mechanism.load->symbol), doctest::Contains("the load goes up"),
                       std::invalid_argument);
}
