// Which contact modes are consistent, for a million scenes: only the columns that change are columns.
#include <iostream>
#include <map>
#include <slipproof/slipproof.hpp>

int main() {
  using namespace slipproof;
  std::vector<double> forces(1'000'000);
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = -10'000 + 0.025 * static_cast<double>(i);
  const MechanismScene scene = parse_scene(R"(
mechanism = "bicycle"
[values]
M = 94
R = 0.3
h = 0.56
b2 = 0.34
b3 = 0.68
I1 = 0.01
I2 = 0.12
I3 = 0.2
r1 = 0.09
r2 = 0.036
L = 0.17
J = 15.7
f = 0.8
g = 9.81
external = 0
)",
                                           "scene");
  const MechanismBatch batch(scene.mechanism);
  MechanismColumns columns;
  for (const Rational& value : scene.values.parameters) columns.parameters.emplace_back(value.to_double());
  columns.load = forces;
  const MechanismAnswers answers = batch.modes_at(columns);
  std::map<std::string, int> counts;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    for (std::size_t mode = 0; mode < answers.modes; ++mode) {
      if (answers.at(i, mode) != ModeAt::inconsistent) ++counts[name(batch.modes()[mode])];
    }
  }
  for (const auto& [mode, count] : counts) std::cout << mode << ": " << count << '\n';
  for (std::size_t i = 0; i < tier_count; ++i) {
    std::cout << "decided by " << name(static_cast<Tier>(i)) << ": " << answers.tiers[i] << '\n';
  }
}
