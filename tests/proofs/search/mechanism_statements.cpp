// The printed mechanics of every shipped mechanism against the motions that the kernel finds: what statements say of a
// mode is true of its motions, and of nothing beside them.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"
#include "proofs/statement/statement.hpp"

using namespace slipproof;

namespace {

bool is_true_there(const prove::Formula& formula) {
  using Kind = prove::Formula::Kind;
  if (formula.kind == Kind::atom) {
    const Rational value = formula.polynomial.front().constant();
    if (formula.sign == prove::Sign::zero) return value == 0;
    return formula.sign == prove::Sign::positive ? value > 0 : value >= 0;
  }
  const bool all = formula.kind == Kind::conjunction;
  for (const prove::Formula& part : formula.parts) {
    if (is_true_there(part) != all) return !all;
  }
  return all;
}

/// A claim that there is a motion in the mode, in a setting that has the mechanism's own symbols.
ClaimsFile exists(const MechanismScene& scene, const std::string& file, const MechanismMode& mode) {
  const Mechanism& m = scene.mechanism;
  std::string text =
      "schema = \"slipproof/claims/1\"\npaper = { title = \"x\", authors = [\"x\"], source = \"x\" }\n[[setting]]\nid "
      "= "
      "\"x\"\nmotions = \"closed\"\nmechanism = \"" +
      file + "\"\n[setting.parameters]\n";
  for (std::size_t i = 0; i < m.parameters.size(); ++i) {
    if (!scene.values.given[i]) continue;
    text += m.parameters[i].symbol + " = { domain = \"" + to_string(m.parameters[i].domain.expression) +
            "\", meaning = \"x\" }\n";
  }
  if (!m.angles.empty()) text += "[setting.angles]\n";
  for (const MechanismAngle& angle : m.angles) {
    text += angle.name + " = { cos = \"" + angle.cosine + "\", sin = \"" + angle.sine + "\" }\n";
  }
  if (scene.values.starts != starts(m)) {
    constexpr std::array<const char*, 4> names{"rest", "slides+", "slides-", "open"};
    text += "[setting.state]\n";
    for (std::size_t i = 0; i < m.elements(); ++i) {
      text += element_name(m, i) + " = \"" + names[static_cast<std::size_t>(scene.values.starts[i])] + "\"\n";
    }
  }
  text += "[[claim]]\nid = \"X\"\nline = 1\nstatement = \"x\"\nkind = \"exists\"\nmodes = [\"" + name(mode) + "\"]\n";
  return parse_claims(text, "x.toml");
}

std::string shipped_name(const MechanismScene& scene) {
  return std::filesystem::path(scene.mechanism.file).stem().string();
}

/// Parameters, cosines and sines, the load, then the unknowns, in the order of the statement; empty where a force is
/// undetermined.
std::vector<Rational> values_of(const MechanismScene& scene, const MotionAtLoad& motion) {
  std::vector<Rational> values;
  for (std::size_t i = 0; i < scene.values.parameters.size(); ++i) {
    if (scene.values.given[i]) values.push_back(scene.values.parameters[i]);
  }
  for (const auto& point : scene.values.angles) values.insert(values.end(), {point.cosine, point.sine});
  if (scene.mechanism.load) values.push_back(*scene.load);
  const auto own = static_cast<std::ptrdiff_t>(scene.mechanism.accelerations);
  values.insert(values.end(), motion.accelerations.begin(), motion.accelerations.begin() + own);
  for (const Range& force : motion.forces) {
    if (!force.is_point()) return {};
    values.push_back(*force.lower);
  }
  return values;
}

std::vector<std::string> texts(const std::vector<Rational>& values) {
  std::vector<std::string> result;
  for (const Rational& value : values) result.push_back(value.str());
  return result;
}

}  // namespace

TEST_CASE("what statements say of a mode of a shipped mechanism is true of its motions, and of nothing beside them") {
  int motions = 0, rejected = 0;
  const std::filesystem::path folder = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    CAPTURE(entry.path().string());
    MechanismScene scene = read_scene(entry.path());
    const FrictionProblem problem = friction_problem(scene.mechanism, scene.values);
    if (problem.has_load && !scene.load) scene.load = problem.load_domain.sample();
    const MotionsAtLoad found = motions_of(problem, scene.load);
    for (const MotionAtLoad& motion : found.motions) {
      std::vector<Rational> values = values_of(scene, motion);
      if (values.empty()) continue;
      const MechanismMode& mode = motion.strict() ? motion.modes.front() : motion.boundary_modes.front();
      const ClaimsFile file = exists(scene, shipped_name(scene), mode);
      const auto statements = claim_statements(file, file.claims[0], Reading::printed);
      REQUIRE(statements.size() == 1);
      const prove::Statement statement("x", statements[0].text);
      CHECK(is_true_there(statement.shown(texts(values))));
      for (std::size_t i = values.size() - scene.mechanism.unknowns.size(); i < values.size(); ++i) {
        CAPTURE(i);
        values[i] += Rational(1, 1000);
        CHECK_FALSE(is_true_there(statement.shown(texts(values))));
        values[i] -= Rational(1, 1000);
      }
      ++motions;
      for (std::size_t i = 0; i < std::min<std::size_t>(found.rejected.size(), 12); ++i) {
        const ClaimsFile other = exists(scene, shipped_name(scene), found.rejected[i].mode);
        const auto text = claim_statements(other, other.claims[0], Reading::printed);
        REQUIRE(text.size() == 1);
        CHECK_FALSE(is_true_there(prove::Statement("x", text[0].text).shown(texts(values))));
        ++rejected;
      }
    }
  }
  CHECK(motions > 8);
  CHECK(rejected > 40);
}
