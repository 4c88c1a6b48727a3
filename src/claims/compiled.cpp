#include "claims/compiled.hpp"

#include <algorithm>
#include <utility>

#include "claims/setting_names.hpp"

namespace slipproof {

std::optional<std::size_t> unknown_index(std::string_view symbol) {
  const auto found = std::find(unknown_names.begin(), unknown_names.end(), symbol);
  return found == unknown_names.end() ? std::nullopt
                                      : std::optional(static_cast<std::size_t>(found - unknown_names.begin()));
}

CompiledSetting::CompiledSetting(const Setting& setting) {
  const auto add = [&](std::string symbol) {
    slots_.emplace(symbol, scope_.slots.size());
    scope_.slots.push_back({std::move(symbol), std::nullopt});
  };
  for (const Quantity quantity : all_quantities()) add(std::string(name(quantity)));
  add(setting.force.symbol);
  for (const Parameter& parameter : setting.parameters) add(parameter.symbol);

  const SettingNames names(setting);
  const std::size_t count = setting.definitions.size();
  for (auto& slots : definition_slots_) slots.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Definition& definition = setting.definitions[i];
    definition_indices_.emplace(definition.symbol, i);
    definition_slots_[0][i] = definition_slots_[1][i] = scope_.slots.size();
    scope_.slots.push_back({definition.symbol, std::nullopt});
    if (!definition.repaired && !names.readings_differ(definition.printed)) continue;
    definition_slots_[1][i] = scope_.slots.size();
    scope_.slots.push_back({definition.symbol, std::nullopt});
  }
  first_unknown_ = scope_.slots.size();
  for (const std::string_view unknown : unknown_names) scope_.slots.push_back({std::string(unknown), std::nullopt});
  for (const Reading reading : all_readings) {
    for (std::size_t i = 0; i < count; ++i) {
      auto& slot = scope_.slots[definition_slot(i, reading)];
      if (!slot.definition) slot.definition = compile(names.definition(i, reading), reading);
    }
  }

  for (const Parameter& parameter : setting.parameters) domains_.push_back(compile(parameter.domain, Reading::printed));
  force_domain_ = compile(setting.force.domain, Reading::printed);
  for (const std::string_view symbol : scene_symbols) {
    const auto found = setting.scene.find(symbol);
    scene_.push_back(found == setting.scene.end() ? std::nullopt
                                                  : std::optional(compile(found->second, Reading::printed)));
  }
  for (const slipproof::Boundary& boundary : setting.boundaries) {
    const std::size_t parameter = names.find(boundary.symbol)->index;
    boundaries_.push_back({parameter, compile(boundary.value, Reading::printed)});
    if (!names.readings_differ(boundary.value)) continue;
    boundaries_.push_back({parameter, compile(boundary.value, Reading::repaired)});
  }
}

std::optional<std::size_t> CompiledSetting::resolve(std::string_view symbol, Reading reading) const {
  if (const auto found = slots_.find(symbol); found != slots_.end()) return found->second;
  const auto found = definition_indices_.find(symbol);
  return found == definition_indices_.end() ? std::nullopt : std::optional(definition_slot(found->second, reading));
}

Program CompiledSetting::compile(const Expression& expression, Reading reading) const {
  return Program(expression, [&](std::string_view symbol) { return resolve(symbol, reading); });
}

Program CompiledSetting::compile_equation(const Expression& equation, Reading reading) const {
  return Program(equation, [&](std::string_view symbol) {
    const auto unknown = unknown_index(symbol);
    return unknown ? std::optional(unknown_slot(*unknown)) : resolve(symbol, reading);
  });
}

void CompiledSetting::redefine(std::size_t index, const Expression& expression) {
  scope_.slots[definition_slot(index, Reading::printed)].definition = compile(expression, Reading::printed);
}

CompiledClaims::CompiledClaims(const ClaimsFile& file) {
  for (const Setting& setting : file.settings) settings.emplace_back(setting);
  for (const Claim& claim : file.claims) {
    const CompiledSetting& setting = settings[claim.setting];
    const auto compile = [&](const ClaimBody& body, Reading reading) {
      CompiledBody programs{setting.compile(body.region, reading),
                            setting.compile(body.forces, reading),
                            setting.compile(body.holds, reading),
                            {},
                            {}};
      for (const Expression& equation : body.equations) {
        programs.equations.push_back(setting.compile_equation(equation, reading));
      }
      for (const Expression& equation : body.assume) {
        programs.assume.push_back(setting.compile_equation(equation, reading));
      }
      return programs;
    };
    claims.push_back({compile(claim.printed, Reading::printed), std::nullopt});
    if (claim.repaired) claims.back().repaired = compile(*claim.repaired, Reading::repaired);
  }
}

}  // namespace slipproof
