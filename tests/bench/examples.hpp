// The bicycles that every exact solver is timed on.
#pragma once

#include "support/random_scene.hpp"

namespace slipproof::test {

struct Example {
  Bicycle<Rational> bicycle;
  Road<Rational> road;
};

inline const std::vector<Example>& examples() {
  static const std::vector<Example> all = [] {
    RandomScenes random(99);
    std::vector<Example> made;
    for (int i = 0; i < 32; ++i) {
      const auto bicycle = random.bicycle(true);
      made.push_back({bicycle, random.road()});
    }
    return made;
  }();
  return all;
}

}  // namespace slipproof::test
