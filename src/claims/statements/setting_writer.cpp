#include "claims/statements/setting_writer.hpp"

#include <algorithm>
#include <functional>

#include "base/expression/logic.hpp"
#include "claims/statements/formulas.hpp"

namespace slipproof {

WrittenStatement SettingWriter::begun(const std::string& theorem, const std::string& comment) {
  defined_.clear();
  made_up_ = mechanics_.names();
  return {theorem, in_ascii(comment)};
}

void SettingWriter::assume(WrittenStatement& to, const std::string& label, const Expression& formula) {
  to.add(Directive::Kind::assume, made_up_.take(label), formula);
}

void SettingWriter::assume_truth(WrittenStatement& to, const std::string& label, const Expression& truth) {
  if (!is_true(truth)) assume(to, label, formula(truth));
}

StatedMotion SettingWriter::motion(const MechanismMode& mode, bool strict) {
  if (!mechanics_.is_modelled(mode)) {
    give_up();
    return {{}, plainly_true()};
  }
  return {mechanics_.definitions(mode, strict), conjoined({mechanics_.dynamics(), mechanics_.in_mode(mode)})};
}

StatedMotion SettingWriter::equations(const std::optional<MechanismMode>& mode) const {
  const Expression contacts = mode ? mechanics_.state_equations(*mode) : mechanics_.on_contacts();
  return {mechanics_.equations(), conjoined({mechanics_.dynamics(), contacts})};
}

StatedMotion SettingWriter::any_motion(bool strict) {
  for (const ElementKind& kind : setting().kinds()) complete_ = complete_ && kind.all_modelled();
  return {mechanics_.all_definitions(strict), conjoined({mechanics_.dynamics(), mechanics_.in_any_mode()})};
}

Expression SettingWriter::inlined(const Expression& e) const {
  Expression result = e;
  for (const std::string& symbol : symbols(e)) {
    const auto entry = names().find(symbol);
    if (!entry || entry->kind != SettingNames::Kind::definition) continue;
    const Expression value = inlined(names().definition(entry->index, reading()));
    if (has_function(value)) result = substitute(result, symbol, value);
  }
  return result;
}

Expression SettingWriter::formula(const Expression& truth) {
  const Expression result = formula_of(inlined(truth), [this](const Expression& e) { return always_defined(e); });
  complete_ = complete_ && result;
  return result ? result : plainly_true();
}

Expression SettingWriter::formula_of_all(const std::vector<Expression>& truths) {
  std::vector<Expression> parts;
  for (const Expression& truth : truths) {
    const Expression part = formula(truth);
    parts.push_back(has_cases(part) ? braced(part) : part);
  }
  return conjoined(parts);
}

Expression SettingWriter::number(const Expression& of_paper) const {
  return written_number(of_paper, [this](const Expression& e) { return always_defined(e); });
}

std::vector<std::string> SettingWriter::parameter_names() const {
  std::vector<std::string> names;
  for (const FreeParameter& parameter : setting().parameters) {
    if (!parameter.angle) names.push_back(parameter.symbol);
  }
  for (const FreeAngle& angle : setting().angles) names.insert(names.end(), {angle.cosine, angle.sine});
  if (!setting().force.symbol.empty()) names.push_back(setting().force.symbol);
  return names;
}

void SettingWriter::add_parameters(WrittenStatement& to, bool with_force) {
  to.declare(Directive::Kind::real, parameter_names());
  assume(to, "domain", domain(with_force));
}

Expression SettingWriter::domain(bool with_force, const std::string& parameter, const std::string& renamed) {
  std::vector<Expression> conditions;
  for (const FreeParameter& given : setting().parameters) conditions.push_back(given.domain);
  const auto of_points = point_conditions();
  if (!of_points) give_up();
  if (of_points) conditions.insert(conditions.end(), of_points->begin(), of_points->end());
  if (with_force) conditions.push_back(setting().force.domain);
  std::erase_if(conditions, [](const Expression& condition) { return is_true(condition); });
  if (!parameter.empty()) {
    for (Expression& condition : conditions) condition = substitute(condition, parameter, make_symbol(renamed));
  }
  return conditions.empty() ? plainly_true() : formula_of_all(conditions);
}

void SettingWriter::add_definitions(WrittenStatement& to, const std::vector<Expression>& uses) {
  for (const Expression& use : uses) {
    if (!use) continue;
    for (const std::string& symbol : symbols(use)) {
      const auto found = std::ranges::find(setting().definitions, symbol, &Definition::symbol);
      if (found == setting().definitions.end() || !defined_.insert(symbol).second) continue;
      const Expression& value = found->value(reading());
      add_definitions(to, {value});
      if (!has_function(inlined(value))) to.add(Directive::Kind::let, symbol, number(value));
    }
  }
}

void SettingWriter::add_scene(WrittenStatement& to, const std::vector<Expression>& uses) {
  std::vector<Expression> all = uses;
  for (const auto& [symbol, value] : setting().scene) all.push_back(value);
  add_definitions(to, all);
  to.add(mechanics_.scene());
}

}  // namespace slipproof
