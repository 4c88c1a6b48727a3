#include "mechanics/family/compiled_family.hpp"

#include <algorithm>
#include <utility>

#include "base/expression/cases.hpp"
#include "base/expression/filtered.hpp"
#include "base/expression/logic.hpp"

namespace slipproof {

namespace {

Expression scene_condition(const Family::PointConditions& conditions) {
  Expression all = make_truth(true);
  for (const Expression& e : conditions.truths) all = conjunction(all, e);
  for (const Expression& e : conditions.defined) all = conjunction(all, make_comparison({e, e}, {Relation::equal}));
  return all;
}

/// A load that is not linear as written has no point.
Expression point_condition(const Family& family, const Family::PointConditions& conditions) {
  Expression all = make_truth(!family.mechanism->load || conditions.slope != nullptr);
  for (const FreeParameter& parameter : family.parameters) all = conjunction(all, parameter.domain);
  all = conjunction(all, scene_condition(conditions));
  if (!conditions.slope) return all;
  return conjunction(all, make_comparison({conditions.slope, make_number(0)}, {Relation::not_equal}));
}

/// What the parameter must be equal to; null if its domain allows more than one constant.
Expression only_value(const FreeParameter& parameter) {
  const Node& domain = *parameter.domain;
  const bool equation = domain.operation == Operation::compare && domain.relations == std::vector{Relation::equal};
  if (!equation || !is_symbol(domain.operands[0], parameter.symbol) || !symbols(domain.operands[1]).empty()) return {};
  return domain.operands[1];
}

/// An evaluator in which the family's programs find the values of the parameters.
FilteredEvaluator evaluator_at(const CompiledFamily& family, const std::vector<Rational>& values) {
  FilteredEvaluator evaluator(family.scope());
  evaluator.set(CompiledFamily::parameter_slot(0), values);
  return evaluator;
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

CompiledFamily::CompiledFamily(const Family& family) {
  const auto add = [&](std::string symbol) {
    slots_.emplace(symbol, scope_.slots.size());
    scope_.slots.push_back({std::move(symbol), std::nullopt});
  };
  add(family.force.symbol);
  for (const FreeParameter& parameter : family.parameters) add(parameter.symbol);
  for (const FreeAngle& angle : family.angles) {
    for (const auto& [symbol, value] :
         {std::pair{angle.cosine, angle.cosine_value()}, {angle.sine, angle.sine_value()}}) {
      add(symbol);
      scope_.slots.back().definition =
          Program(value, [&](std::string_view) { return parameter_slot(angle.parameter); });
    }
  }
  first_quantity_ = scope_.slots.size();
  for (std::string& quantity : family.quantities()) add(std::move(quantity));
  quantities_ = scope_.slots.size() - first_quantity_;
  for (const MechanismUnknown& unknown : family.mechanism->unknowns) {
    unknown_slots_.push_back(slots_.find(unknown.symbol)->second);
  }
  find_varying();

  for (const FreeParameter& parameter : family.parameters) {
    domains_.push_back(compile(parameter.domain));
    const Expression value = only_value(parameter);
    only_values_.push_back(value ? std::optional(compile(value)) : std::nullopt);
  }
  force_domain_ = compile(family.force.domain);
  const Family::PointConditions conditions = family.point_conditions();
  is_point_ = compile(point_condition(family, conditions));
  is_scene_ = compile(scene_condition(conditions));
  compile_scene(family);
}

void CompiledFamily::compile_scene(const Family& family) {
  const auto value = [&](const std::string& symbol) -> std::optional<Program> {
    const auto found = family.scene.find(symbol);
    if (found == family.scene.end()) return std::nullopt;
    return compile(found->second);
  };
  const Mechanism& mechanism = *family.mechanism;
  mechanism_ = family.mechanism;
  maker_ = std::make_shared<const ProblemMaker>(mechanism);
  starts_ = family.starts;
  kinds_ = family.kinds();
  for (const ElementKind& kind : kinds_) complete_ = complete_ && kind.all_modelled();
  for (const MechanismParameter& parameter : mechanism.parameters) scene_.parameters.push_back(value(parameter.symbol));
  for (const MechanismAngle& angle : mechanism.angles)
    scene_.angles.emplace_back(*value(angle.cosine), *value(angle.sine));
  if (mechanism.load) scene_.load = value(mechanism.load->symbol);
}

std::optional<std::size_t> CompiledFamily::find_slot(std::string_view symbol) const {
  const auto found = slots_.find(symbol);
  return found == slots_.end() ? std::nullopt : std::optional(found->second);
}

bool CompiledFamily::varies_itself(const Expression& e) const {
  if (e->operation == Operation::symbol) {
    const auto slot = find_slot(e->symbol);
    return slot && (*slot == force_slot() || is_quantity(*slot));
  }
  return std::any_of(e->operands.begin(), e->operands.end(), [&](const Expression& x) { return varies_itself(x); });
}

Expression CompiledFamily::in_cases(const Expression& condition, const std::function<bool(const Expression&)>& varies,
                                    const std::function<bool(const std::string&)>& may_lack_value) {
  if (slipproof::sort(*condition) == Sort::number || !has_function(condition)) return nullptr;
  const auto has_value = [&](const Expression& x) {
    const auto names = symbols(x);
    return has_no_division(x) && std::none_of(names.begin(), names.end(), may_lack_value);
  };
  return by_cases(condition, varies, has_value);
}

Program CompiledFamily::compile(const Expression& expression) const {
  const auto varies = [&](const Expression& e) { return varies_itself(e); };
  const Expression cases = in_cases(expression, varies, [](const std::string&) { return false; });
  return Program(cases ? cases : expression, [&](std::string_view symbol) { return find_slot(symbol); });
}

bool CompiledFamily::varies(const Program& program) const {
  return std::any_of(program.code().begin(), program.code().end(), [&](const Program::Instruction& instruction) {
    return instruction.operation == Operation::symbol && varying_[instruction.first];
  });
}

void CompiledFamily::find_varying() {
  const auto varies_itself = [&](std::size_t slot) { return slot == force_slot() || is_quantity(slot); };
  varying_.clear();
  for (std::size_t slot = 0; slot < scope_.slots.size(); ++slot) {
    const auto& definition = scope_.slots[slot].definition;
    varying_.push_back(varies_itself(slot) ||
                       (definition && std::ranges::any_of(slots_behind(scope_, {&*definition}), varies_itself)));
  }
}

std::vector<std::size_t> slots_behind(const Scope& scope, const std::vector<const Program*>& programs) {
  std::vector<std::size_t> found;
  std::vector<const Program*> open = programs;
  while (!open.empty()) {
    const Program* program = open.back();
    open.pop_back();
    for (const std::size_t slot : program->slots()) {
      if (std::find(found.begin(), found.end(), slot) != found.end()) continue;
      found.push_back(slot);
      if (scope.slots[slot].definition) open.push_back(&*scope.slots[slot].definition);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool allows(const CompiledFamily& family, std::size_t parameter, const std::vector<Rational>& values) {
  return evaluator_at(family, values).truth(family.domains()[parameter]) == Truth::yes;
}

bool in_domain(const CompiledFamily& family, const std::vector<Rational>& values) {
  FilteredEvaluator evaluator = evaluator_at(family, values);
  return std::ranges::all_of(family.domains(),
                             [&](const Program& domain) { return evaluator.truth(domain) == Truth::yes; });
}

}  // namespace slipproof
