// Random mechanisms of a few bodies, in small numbers: forces that are undetermined, conditions that vanish and
// motions that coincide are common then.
#pragma once

#include <random>

#include "mechanics/elements/friction_problem.hpp"

namespace slipproof::test {

class RandomProblems {
 public:
  explicit RandomProblems(std::uint64_t seed) : engine_(seed) {}

  /// One to three accelerations and elements, perhaps a link, a load, masses without inertia.
  FrictionProblem problem();
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  bool one_in(int n) { return integer(1, n) == 1; }

 private:
  AffineForm direction();
  AffineForm unit(std::size_t unknown) const;
  ElementKind kind();
  void add_motion();
  void add_element(ProblemElement& element);
  void add_force(const AffineForm& along);
  ForceInterval domain();

  std::mt19937_64 engine_;
  FrictionProblem problem_;
  std::size_t accelerations_ = 0, used_ = 0;
  std::vector<AffineForm> directions_;
};

}  // namespace slipproof::test
