#include <fmt/format.h>

#include "base/input/toml.hpp"
#include "base/number/format.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

std::string to_toml(const MechanismScene& scene, const std::string& mechanism, const std::string& along) {
  const Mechanism& m = scene.mechanism;
  const MechanismValues& values = scene.values;
  std::string text = fmt::format("name = {}\nmechanism = {}\n", toml_string(scene.name), toml_string(mechanism));
  if (!along.empty()) text += fmt::format("along = {}\n", toml_string(along));
  if (!scene.question.empty()) text += fmt::format("question = {}\n", toml_string(scene.question));
  if (!scene.asked.empty()) text += fmt::format("asked = {}\n", toml_string(scene.asked));
  text += "\n[values]\n";
  for (std::size_t i = 0; i < values.parameters.size(); ++i) {
    if (values.given[i]) text += fmt::format("{} = \"{}\"\n", m.parameters[i].symbol, exact_text(values.parameters[i]));
  }
  for (std::size_t i = 0; i < values.angles.size(); ++i) {
    text += fmt::format("{} = {{ cos = \"{}\", sin = \"{}\" }}\n", m.angles[i].name,
                        exact_text(values.angles[i].cosine), exact_text(values.angles[i].sine));
  }
  if (m.load && scene.load) text += fmt::format("{} = \"{}\"\n", m.load->symbol, exact_text(*scene.load));
  std::string states;
  const auto own = starts(m);
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (values.starts[i] == own[i]) continue;
    states += fmt::format("{} = \"{}\"\n", element_name(m, i), name(values.starts[i]));
  }
  if (!states.empty()) text += "\n[state]\n" + states;
  if (const auto& threshold = scene.threshold) {
    text += fmt::format("\n[threshold]\nparameter = {}\nfrom = \"{}\"\nto = \"{}\"\n",
                        toml_string(threshold->parameter), exact_text(threshold->from), exact_text(threshold->to));
  }
  return text;
}

}  // namespace slipproof
