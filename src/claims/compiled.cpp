#include "claims/compiled.hpp"

#include <algorithm>
#include <utility>

#include "claims/setting_names.hpp"
#include "expression/cases.hpp"
#include "expression/logic.hpp"

namespace slipproof {

std::optional<std::size_t> unknown_index(std::string_view symbol) {
  const auto found = std::find(unknown_names.begin(), unknown_names.end(), symbol);
  return found == unknown_names.end() ? std::nullopt
                                      : std::optional(static_cast<std::size_t>(found - unknown_names.begin()));
}

namespace {

/// Where the pedal force is not linear as it stands, at no bicycle.
Expression bicycle_condition(const Setting& setting) {
  const Setting::BicycleConditions conditions = setting.bicycle_conditions();
  Expression all = make_truth(conditions.slope != nullptr);
  const auto add = [&](const Expression& e, Relation relation) {
    all = both(all, make_comparison({e, make_number(0)}, {relation}));
  };
  for (const Parameter& parameter : setting.parameters) all = both(all, parameter.domain);
  for (const Expression& e : conditions.positive) add(e, Relation::greater);
  for (const Expression& e : conditions.not_negative) add(e, Relation::greater_equal);
  for (const Expression& e : conditions.defined) all = both(all, make_comparison({e, e}, {Relation::equal}));
  if (conditions.slope) add(conditions.slope, Relation::not_equal);
  return all;
}

}  // namespace

CompiledSetting::CompiledSetting(const Setting& setting) {
  const auto add = [&](std::string symbol) {
    slots_.emplace(symbol, scope_.slots.size());
    scope_.slots.push_back({std::move(symbol), std::nullopt});
  };
  for (const Quantity quantity : all_quantities()) add(std::string(name(quantity)));
  add(setting.force.symbol);
  for (const Parameter& parameter : setting.parameters) add(parameter.symbol);

  force_ = setting.force.symbol;
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
  for (const Realisable& one : setting.realisable) realisable_.push_back(compile(one.condition, Reading::repaired));
  force_domain_ = compile(setting.force.domain, Reading::printed);
  is_bicycle_ = compile(bicycle_condition(setting), Reading::printed);
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

bool CompiledSetting::varies(const Expression& e, Reading reading) const {
  if (e->operation == Operation::symbol) {
    const auto defined = definition_indices_.find(e->symbol);
    if (slots_.contains(e->symbol) || defined == definition_indices_.end()) {
      return e->symbol == force_ || parse_quantity(e->symbol);
    }
    return varies(definitions_[static_cast<std::size_t>(reading)][defined->second], reading);
  }
  return std::any_of(e->operands.begin(), e->operands.end(), [&](const Expression& x) { return varies(x, reading); });
}

Expression CompiledSetting::written_out(const Expression& e, Reading reading) const {
  Expression result = e;
  for (const std::string& symbol : symbols(e)) {
    const auto defined = definition_indices_.find(symbol);
    if (slots_.contains(symbol) || defined == definition_indices_.end()) continue;
    const Expression value = written_out(definitions_[static_cast<std::size_t>(reading)][defined->second], reading);
    if (has_function(value) && varies(value, reading)) result = substitute(result, symbol, value);
  }
  return result;
}

Expression CompiledSetting::prepared(const Expression& e, Reading reading) const {
  if (slipproof::sort(*e) == Sort::number) return e;
  const Expression whole = written_out(e, reading);
  if (!has_function(whole)) return e;
  const auto is_wanted = [&](const Expression& x) { return varies(x, reading); };
  const auto defined = [&](const Expression& x) {
    const auto names = symbols(x);
    const auto is_defined = [&](const std::string& symbol) { return definition_indices_.contains(symbol); };
    return has_no_division(x) && std::none_of(names.begin(), names.end(), is_defined);
  };
  const Expression cases = by_cases(whole, is_wanted, defined);
  return cases ? cases : e;
}

Program CompiledSetting::compile(const Expression& expression, Reading reading) const {
  return Program(prepared(expression, reading), [&](std::string_view symbol) { return resolve(symbol, reading); });
}

Program CompiledSetting::compile_equation(const Expression& equation, Reading reading) const {
  return Program(equation, [&](std::string_view symbol) {
    const auto unknown = unknown_index(symbol);
    return unknown ? std::optional(unknown_slot(*unknown)) : resolve(symbol, reading);
  });
}

void CompiledSetting::redefine(std::size_t index, const Expression& expression) {
  definitions_[0][index] = expression;
  scope_.slots[definition_slot(index, Reading::printed)].definition = compile(expression, Reading::printed);
}

CompiledClaims::CompiledClaims(const ClaimsFile& file) {
  for (const Setting& setting : file.settings) settings.emplace_back(setting);
  for (const Claim& claim : file.claims) {
    const CompiledSetting& setting = settings[claim.setting];
    const auto compile = [&](const ClaimBody& body, Reading reading) {
      const Program always = setting.compile(make_truth(true), reading);
      CompiledBody programs{always, always, always, always, {}, {}};
      for_each_part(body, [&](BodyPart part, std::size_t, const Expression& expression) {
        switch (part) {
          case BodyPart::region:
            programs.region = setting.compile(expression, reading);
            break;
          case BodyPart::forces:
            programs.forces = setting.compile(expression, reading);
            programs.closure = setting.compile(closure(expression), reading);
            break;
          case BodyPart::holds:
            programs.holds = setting.compile(expression, reading);
            break;
          case BodyPart::equations:
            programs.equations.push_back(setting.compile_equation(expression, reading));
            break;
          case BodyPart::assume:
            programs.assume.push_back(setting.compile_equation(expression, reading));
            break;
        }
      });
      return programs;
    };
    claims.push_back({compile(claim.printed, Reading::printed), std::nullopt});
    if (claim.repaired) claims.back().repaired = compile(*claim.repaired, Reading::repaired);
  }
}

}  // namespace slipproof
