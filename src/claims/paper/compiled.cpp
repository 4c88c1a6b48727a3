#include "claims/paper/compiled.hpp"

#include <algorithm>
#include <utility>

#include "base/expression/cases.hpp"
#include "base/expression/logic.hpp"
#include "claims/paper/setting_names.hpp"

namespace slipproof {

CompiledSetting::CompiledSetting(const Setting& setting) : CompiledFamily(setting) {
  const SettingNames names(setting);
  const std::size_t count = setting.definitions.size();
  for (auto& slots : definition_slots_) slots.resize(count);
  for (const Reading reading : all_readings) {
    for (std::size_t i = 0; i < count; ++i) {
      definitions_[static_cast<std::size_t>(reading)].push_back(names.definition(i, reading));
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Definition& definition = setting.definitions[i];
    if (!find_slot(definition.symbol)) definition_indices_.emplace(definition.symbol, i);
    definition_slots_[0][i] = definition_slots_[1][i] = scope_.slots.size();
    scope_.slots.push_back({definition.symbol, std::nullopt});
    if (!definition.repaired && !names.readings_differ(definition.printed)) continue;
    definition_slots_[1][i] = scope_.slots.size();
    scope_.slots.push_back({definition.symbol, std::nullopt});
  }
  for (const Reading reading : all_readings) {
    for (std::size_t i = 0; i < count; ++i) {
      auto& slot = scope_.slots[definition_slot(i, reading)];
      if (!slot.definition) slot.definition = compile(names.definition(i, reading), reading);
    }
  }
  find_varying();

  for (const Realisable& one : setting.realisable) realisable_.push_back(compile(one.condition, Reading::repaired));
  for (const slipproof::Boundary& boundary : setting.boundaries) {
    const std::size_t parameter = names.find(boundary.symbol)->index;
    boundaries_.push_back({parameter, compile(boundary.value, Reading::printed)});
    if (!names.readings_differ(boundary.value)) continue;
    boundaries_.push_back({parameter, compile(boundary.value, Reading::repaired)});
  }
}

const Expression* CompiledSetting::definition(const std::string& symbol, Reading reading) const {
  const auto found = definition_indices_.find(symbol);
  if (found == definition_indices_.end()) return nullptr;
  return &definitions_[static_cast<std::size_t>(reading)][found->second];
}

std::optional<std::size_t> CompiledSetting::resolve(std::string_view symbol, Reading reading) const {
  if (const auto slot = find_slot(symbol)) return slot;
  const auto found = definition_indices_.find(symbol);
  return found == definition_indices_.end() ? std::nullopt : std::optional(definition_slot(found->second, reading));
}

bool CompiledSetting::may_vary(const Expression& e, Reading reading) const {
  if (e->operation == Operation::symbol) {
    const Expression* defined = definition(e->symbol, reading);
    return defined == nullptr ? varies_itself(e) : may_vary(*defined, reading);
  }
  return std::any_of(e->operands.begin(), e->operands.end(), [&](const Expression& x) { return may_vary(x, reading); });
}

Expression CompiledSetting::written_out(const Expression& e, Reading reading) const {
  Expression result = e;
  for (const std::string& symbol : symbols(e)) {
    const Expression* defined = definition(symbol, reading);
    if (defined == nullptr) continue;
    const Expression value = written_out(*defined, reading);
    if (has_function(value) && may_vary(value, reading)) result = substitute(result, symbol, value);
  }
  return result;
}

Expression CompiledSetting::prepared(const Expression& e, Reading reading) const {
  const auto is_varying = [&](const Expression& x) { return may_vary(x, reading); };
  const auto is_defined = [&](const std::string& symbol) { return definition(symbol, reading) != nullptr; };
  const Expression cases = in_cases(written_out(e, reading), is_varying, is_defined);
  return cases ? cases : e;
}

Program CompiledSetting::compile(const Expression& expression, Reading reading) const {
  return Program(prepared(expression, reading), [&](std::string_view symbol) { return resolve(symbol, reading); });
}

Program CompiledSetting::compile_equation(const Expression& equation, Reading reading) const {
  return Program(equation, [&](std::string_view symbol) { return resolve(symbol, reading); });
}

void CompiledSetting::redefine(std::size_t index, const Expression& expression) {
  definitions_[0][index] = expression;
  scope_.slots[definition_slot(index, Reading::printed)].definition = compile(expression, Reading::printed);
  find_varying();
}

CompiledClaims::CompiledClaims(const ClaimsFile& file) {
  for (const Setting& setting : file.settings) settings.emplace_back(setting);
  for (const Claim& claim : file.claims) {
    const CompiledSetting& setting = settings[claim.setting];
    const auto compile = [&](const ClaimBody& body, Reading reading) {
      CompiledBody programs{setting.compile(body.region, reading),
                            setting.compile(body.forces, reading),
                            setting.compile(closure(body.forces), reading),
                            setting.compile(body.holds, reading),
                            {},
                            {}};
      for (const Expression& e : body.equations) programs.equations.push_back(setting.compile_equation(e, reading));
      for (const Expression& e : body.assume) programs.assume.push_back(setting.compile_equation(e, reading));
      return programs;
    };
    claims.push_back({compile(claim.printed, Reading::printed), std::nullopt});
    if (claim.repaired) claims.back().repaired = compile(*claim.repaired, Reading::repaired);
  }
}

}  // namespace slipproof
