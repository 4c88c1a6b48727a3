#include <fmt/format.h>

#include "report/expected/expected.hpp"
#include "report/expected/numbers.hpp"

namespace slipproof {

namespace expected {

namespace {

/// Quoted where a comma, a quote or a line break is in it.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

/// What a line says of a scene before its numbers.
struct LineStart {
  std::string scene, motion, modes, status;
};

void add_line(std::string& text, const LineStart& start, std::string_view kind, const std::string& quantity,
              const Range& range) {
  text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", field(start.scene), start.motion, field(start.modes),
                      start.status, kind, field(quantity), binary64(range.lower, -1), binary64(range.upper, 1),
                      exact(range.lower), exact(range.upper));
}

void add_motions(std::string& text, const ExpectedAnswer& answer) {
  const Mechanism& m = answer.solved.scene.mechanism;
  const auto accelerations = acceleration_names(m), forces = force_names(m);
  const std::vector<ToldMotion> motions = told_motions(answer);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const ToldMotion& motion = motions[k];
    const LineStart start{answer.id, std::to_string(k + 1), motion.modes,
                          std::string(motion.continuum ? "continuum " : "") + (motion.strict ? "strict" : "boundary")};
    for (std::size_t i = 0; i < accelerations.size(); ++i) {
      add_line(text, start, "acceleration", accelerations[i], motion.accelerations[i]);
    }
    for (std::size_t i = 0; i < forces.size(); ++i) add_line(text, start, "force", forces[i], motion.forces[i]);
  }
  if (motions.empty()) text += fmt::format("{},0,,none,,,,,,\n", field(answer.id));
}

}  // namespace

}  // namespace expected

std::string expected_csv(const std::vector<ExpectedAnswer>& answers) {
  using namespace expected;
  std::string text = "scene,motion,modes,status,kind,quantity,lower,upper,exact_lower,exact_upper\n";
  for (const ExpectedAnswer& answer : answers) {
    add_motions(text, answer);
    for (const MotionChange& change : answer.changes) {
      const std::string& parameter = answer.solved.scene.threshold->parameter;
      const ToldRoot root = told_root(change.at, parameter);
      text += fmt::format("{},,,,threshold,{},{},{},{},{}\n", field(answer.id), field(parameter), root.nearest,
                          root.nearest, field(root.text), field(root.text));
    }
  }
  return text;
}

}  // namespace slipproof
