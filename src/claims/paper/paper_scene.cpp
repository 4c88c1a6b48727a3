#include "claims/paper/paper_scene.hpp"

#include <algorithm>

namespace slipproof {

namespace {

const MechanismDefinition* definition_of(const Mechanism& mechanism, std::string_view symbol) {
  const auto found = std::find_if(mechanism.definitions.begin(), mechanism.definitions.end(),
                                  [&](const MechanismDefinition& d) { return d.symbol == symbol; });
  return found == mechanism.definitions.end() ? nullptr : &*found;
}

}  // namespace

Expression PaperScene::in_paper(const Expression& of_mechanism) const {
  return substitute(of_mechanism, [this](const std::string& symbol) -> Expression {
    if (const auto found = scene.find(symbol); found != scene.end()) return found->second;
    if (const MechanismDefinition* definition = definition_of(*mechanism, symbol)) {
      return in_paper(definition->expression.expression);
    }
    const auto is_parameter = [&](const MechanismParameter& p) { return p.symbol == symbol; };
    const auto& all = mechanism->parameters;
    // A parameter that is not given counts as 0.
    return std::any_of(all.begin(), all.end(), is_parameter) ? make_number(0) : nullptr;
  });
}

std::vector<bool> PaperScene::given() const {
  std::vector<bool> result;
  for (const MechanismParameter& parameter : mechanism->parameters) result.push_back(scene.contains(parameter.symbol));
  return result;
}

std::vector<ElementKind> PaperScene::kinds() const {
  return element_kinds(*mechanism, starts, given());
}

std::vector<ElementKind> PaperScene::all_kinds() const {
  return element_kinds(*mechanism, starts, std::vector<bool>(mechanism->parameters.size(), true));
}

std::vector<std::string> PaperScene::quantities() const {
  std::vector<std::string> names = acceleration_names(*mechanism);
  for (std::string& force : force_names(*mechanism)) names.push_back(std::move(force));
  return names;
}

std::optional<std::size_t> PaperScene::unknown_index(std::string_view symbol) const {
  const auto& unknowns = mechanism->unknowns;
  const auto found = std::find_if(unknowns.begin(), unknowns.end(),
                                  [&](const MechanismUnknown& unknown) { return unknown.symbol == symbol; });
  return found == unknowns.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - unknowns.begin()));
}

}  // namespace slipproof
