#include "claims/paper/compiled.hpp"

#include <algorithm>
#include <utility>

#include "base/expression/cases.hpp"
#include "base/expression/logic.hpp"
#include "claims/paper/setting_names.hpp"

namespace slipproof {

namespace {

Expression scene_condition(const Setting::PointConditions& conditions) {
  Expression all = make_truth(true);
  for (const Expression& e : conditions.truths) all = conjunction(all, e);
  for (const Expression& e : conditions.defined) all = conjunction(all, make_comparison({e, e}, {Relation::equal}));
  return all;
}

/// A load that is not linear as written has no point.
Expression point_condition(const Setting& setting, const Setting::PointConditions& conditions) {
  Expression all = make_truth(!setting.mechanism->load || conditions.slope != nullptr);
  for (const Parameter& parameter : setting.parameters) all = conjunction(all, parameter.domain);
  all = conjunction(all, scene_condition(conditions));
  if (!conditions.slope) return all;
  return conjunction(all, make_comparison({conditions.slope, make_number(0)}, {Relation::not_equal}));
}

/// What the parameter must be equal to; null if its domain allows more than one constant.
Expression only_value(const Parameter& parameter) {
  const Node& domain = *parameter.domain;
  const bool equation = domain.operation == Operation::compare && domain.relations == std::vector{Relation::equal};
  if (!equation || !is_symbol(domain.operands[0], parameter.symbol) || !symbols(domain.operands[1]).empty()) return {};
  return domain.operands[1];
}

}  // namespace

std::vector<const Program*> CompiledScene::programs() const {
  std::vector<const Program*> all;
  for (const auto& parameter : parameters) {
    if (parameter) all.push_back(&*parameter);
  }
  for (const auto& [cosine, sine] : angles) all.insert(all.end(), {&cosine, &sine});
  if (load) all.push_back(&*load);
  return all;
}

CompiledSetting::CompiledSetting(const Setting& setting) {
  const auto add = [&](std::string symbol) {
    slots_.emplace(symbol, scope_.slots.size());
    scope_.slots.push_back({std::move(symbol), std::nullopt});
  };
  add(setting.force.symbol);
  for (const Parameter& parameter : setting.parameters) add(parameter.symbol);
  for (const PaperAngle& angle : setting.angles) {
    for (const auto& [symbol, value] :
         {std::pair{angle.cosine, angle.cosine_value()}, {angle.sine, angle.sine_value()}}) {
      add(symbol);
      scope_.slots.back().definition =
          Program(value, [&](std::string_view) { return parameter_slot(angle.parameter); });
    }
  }
  first_quantity_ = scope_.slots.size();
  for (std::string& quantity : setting.quantities()) add(std::move(quantity));
  quantities_ = scope_.slots.size() - first_quantity_;
  for (const MechanismUnknown& unknown : setting.mechanism->unknowns) {
    unknown_slots_.push_back(slots_.find(unknown.symbol)->second);
  }

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
  for (const Reading reading : all_readings) {
    for (std::size_t i = 0; i < count; ++i) {
      auto& slot = scope_.slots[definition_slot(i, reading)];
      if (!slot.definition) slot.definition = compile(names.definition(i, reading), reading);
    }
  }
  find_varying();

  for (const Parameter& parameter : setting.parameters) {
    domains_.push_back(compile(parameter.domain, Reading::printed));
    const Expression value = only_value(parameter);
    only_values_.push_back(value ? std::optional(compile(value, Reading::printed)) : std::nullopt);
  }
  for (const Realisable& one : setting.realisable) realisable_.push_back(compile(one.condition, Reading::repaired));
  force_domain_ = compile(setting.force.domain, Reading::printed);
  const Setting::PointConditions conditions = setting.point_conditions();
  is_point_ = compile(point_condition(setting, conditions), Reading::printed);
  is_scene_ = compile(scene_condition(conditions), Reading::printed);
  compile_scene(setting);
  for (const slipproof::Boundary& boundary : setting.boundaries) {
    const std::size_t parameter = names.find(boundary.symbol)->index;
    boundaries_.push_back({parameter, compile(boundary.value, Reading::printed)});
    if (!names.readings_differ(boundary.value)) continue;
    boundaries_.push_back({parameter, compile(boundary.value, Reading::repaired)});
  }
}

void CompiledSetting::compile_scene(const Setting& setting) {
  const auto value = [&](const std::string& symbol) -> std::optional<Program> {
    const auto found = setting.scene.find(symbol);
    if (found == setting.scene.end()) return std::nullopt;
    return compile(found->second, Reading::printed);
  };
  const Mechanism& mechanism = *setting.mechanism;
  mechanism_ = setting.mechanism;
  maker_ = std::make_shared<const ProblemMaker>(mechanism);
  starts_ = setting.starts;
  kinds_ = setting.kinds();
  for (const ElementKind& kind : kinds_) complete_ = complete_ && kind.lifts;
  for (const MechanismParameter& parameter : mechanism.parameters) scene_.parameters.push_back(value(parameter.symbol));
  for (const MechanismAngle& angle : mechanism.angles)
    scene_.angles.emplace_back(*value(angle.cosine), *value(angle.sine));
  if (mechanism.load) scene_.load = value(mechanism.load->symbol);
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
      const auto slot = slots_.find(e->symbol);
      return e->symbol == force_ || (slot != slots_.end() && is_quantity(slot->second));
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
  return Program(equation, [&](std::string_view symbol) { return resolve(symbol, reading); });
}

void CompiledSetting::redefine(std::size_t index, const Expression& expression) {
  definitions_[0][index] = expression;
  scope_.slots[definition_slot(index, Reading::printed)].definition = compile(expression, Reading::printed);
  find_varying();
}

bool CompiledSetting::varies(const Program& program) const {
  return std::any_of(program.code().begin(), program.code().end(), [&](const Program::Instruction& instruction) {
    return instruction.operation == Operation::symbol && varying_[instruction.first];
  });
}

/// Definitions may be in any order, so this repeats until no further one is found to vary.
void CompiledSetting::find_varying() {
  varying_.assign(scope_.slots.size(), false);
  varying_[force_slot()] = true;
  for (std::size_t i = 0; i < quantities_; ++i) varying_[quantity_slot(i)] = true;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t slot = 0; slot < varying_.size(); ++slot) {
      const auto& definition = scope_.slots[slot].definition;
      if (varying_[slot] || !definition || !varies(*definition)) continue;
      varying_[slot] = more = true;
    }
  }
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
