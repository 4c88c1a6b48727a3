// Is a solver's answer the one motion? Numbers as a physics engine has them, doubles, each taken exactly as it is.
#include <iostream>
#include <slipproof/slipproof.hpp>

int main() {
  using namespace slipproof;
  const SolvedMechanism solved = solve_mechanism(parse_scene(R"(
mechanism = "bicycle"
[values]
M = 94
R = "0.3"
h = "0.56"
b2 = "0.34"
b3 = "0.68"
I1 = "0.01"
I2 = "0.12"
I3 = "0.2"
r1 = "0.09"
r2 = "0.036"
L = "0.17"
J = "15.7"
f = "0.8"
g = "9.81"
external = 0
F = 300
)",
                                                             "scene"));
  const RecordJudge judge(CertifiedMechanism(solved.scene), {});
  RecordJudge::NamedNumbers answer;
  const MotionAtLoad& motion = solved.at_load->motions.at(0);
  for (std::size_t i = 0; i < motion.accelerations.size(); ++i) {
    answer.emplace_back(acceleration_names(solved.scene.mechanism)[i], motion.accelerations[i].to_double());
  }
  for (std::size_t i = 0; i < motion.forces.size(); ++i) {
    answer.emplace_back(force_names(solved.scene.mechanism)[i], motion.forces[i].lower->to_double());
  }
  std::cout << "the exact motion, rounded: " << name(judge(judge.record(answer)).verdict) << '\n';
  answer[0].second *= 1.0001;
  std::cout << answer[0].first << ", off by 1e-4: " << name(judge(judge.record(answer)).verdict) << '\n';
  for (auto& [symbol, value] : answer) {
    if (symbol == "N3") value = -value;
  }
  std::cout << "the front wheel pulled down: " << name(judge(judge.record(answer)).verdict) << '\n';
}
