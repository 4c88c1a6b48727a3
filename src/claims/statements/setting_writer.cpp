#include "claims/statements/setting_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "base/expression/logic.hpp"
#include "claims/statements/truth_text.hpp"

namespace slipproof {

namespace {

/// Whether the expression as written is 0 where the symbol is 0: the symbol itself, a product with it, or its quotient.
bool has_no_constant(const Expression& e, const std::string& symbol) {
  switch (e->operation) {
    case Operation::symbol:
      return e->symbol == symbol;
    case Operation::negate:
    case Operation::divide:
      return has_no_constant(e->operands[0], symbol);
    case Operation::multiply:
      return has_no_constant(e->operands[0], symbol) || has_no_constant(e->operands[1], symbol);
    default:
      return false;
  }
}

}  // namespace

std::string SettingWriter::header(const std::string& theorem, const std::string& comment) {
  defined_.clear();
  made_up_ = mechanics_.names();
  return fmt::format("slipproof-statement 1\ntheorem {}\n# {}\n", theorem, in_ascii(comment));
}

std::string SettingWriter::assumption(const std::string& label, const std::string& formula) {
  return fmt::format("assume {}: {}\n", made_up_.take(label), formula);
}

std::string SettingWriter::assumption(const std::string& label, const Expression& truth) {
  return is_true(truth) ? "" : assumption(label, text(truth));
}

MotionText SettingWriter::motion(const MechanismMode& mode) {
  return motion(mode, setting_.strict);
}

MotionText SettingWriter::motion(const MechanismMode& mode, bool strict) {
  if (!mechanics_.is_modelled(mode)) {
    give_up();
    return {};
  }
  return {mechanics_.equations() + mechanics_.state_definitions(mode, strict),
          mechanics_.dynamics() + " and " + mechanics_.mode_text(mode)};
}

MotionText SettingWriter::equations(const std::optional<MechanismMode>& mode) const {
  const std::string contacts = mode ? mechanics_.state_equations(*mode) : mechanics_.on_contacts();
  return {mechanics_.equations(), mechanics_.dynamics() + (contacts.empty() ? "" : " and ") + contacts};
}

MotionText SettingWriter::any_motion(bool strict) {
  for (const ElementKind& kind : setting_.kinds()) complete_ = complete_ && kind.lifts;
  return {mechanics_.equations() + mechanics_.all_state_definitions(strict),
          mechanics_.dynamics() + " and " + mechanics_.any_mode_text()};
}

Expression SettingWriter::inlined(const Expression& e) const {
  Expression result = e;
  for (const std::string& symbol : symbols(e)) {
    const auto entry = names_.find(symbol);
    if (!entry || entry->kind != SettingNames::Kind::definition) continue;
    const Expression value = inlined(names_.definition(entry->index, reading_));
    if (has_function(value)) result = substitute(result, symbol, value);
  }
  return result;
}

std::string SettingWriter::text(const Expression& truth) {
  const auto result = truth_text(inlined(truth), [this](const Expression& e) { return always_defined(e); });
  complete_ = complete_ && result;
  return result.value_or("");
}

std::vector<std::string> SettingWriter::parameter_names() const {
  std::vector<std::string> names;
  for (const FreeParameter& parameter : setting_.parameters) {
    if (!parameter.angle) names.push_back(parameter.symbol);
  }
  for (const FreeAngle& angle : setting_.angles) names.insert(names.end(), {angle.cosine, angle.sine});
  if (!setting_.force.symbol.empty()) names.push_back(setting_.force.symbol);
  return names;
}

std::string SettingWriter::parameters() const {
  return fmt::format("{}", fmt::join(parameter_names(), " "));
}

std::string SettingWriter::variables() const {
  const std::string names = parameters();
  return names.empty() ? names : "real " + names + '\n';
}

std::vector<Expression> SettingWriter::physical() {
  const Family::PointConditions conditions = setting_.point_conditions();
  std::vector<Expression> result;
  for (const FreeAngle& angle : setting_.angles) {
    const Expression c = make_power(make_symbol(angle.cosine), 2), s = make_power(make_symbol(angle.sine), 2);
    result.push_back(make_comparison({make(Operation::add, {c, s}), make_number(1)}, {Relation::equal}));
  }
  for (const Expression& e : conditions.truths) {
    if (!signs_.true_everywhere(e)) result.push_back(e);
  }
  for (const Expression& e : conditions.defined) {
    if (!signs_.defined(e)) result.push_back(make_comparison({e, e}, {Relation::equal}));
  }
  const auto& load = setting_.mechanism->load;
  if (!load) return result;
  if (!conditions.slope) {
    give_up();
    return result;
  }
  // The force variable itself, and its product or quotient with a plainly positive number, needs no explanation.
  const Expression& F = setting_.scene.find(load->symbol)->second;
  const std::string& x = setting_.force.symbol;
  const bool plain = signs_.defined(F) && signs_.positive(substitute(F, x, make_number(1))) && has_no_constant(F, x);
  if (!plain) result.push_back(make_comparison({conditions.slope, make_number(0)}, {Relation::not_equal}));
  return result;
}

bool SettingWriter::has_interval_of_forces() const {
  const std::function<bool(const Expression&)> convex = [&](const Expression& e) {
    if (e->operation == Operation::logical_and) return convex(e->operands[0]) && convex(e->operands[1]);
    if (e->operation == Operation::truth) return true;
    if (e->operation != Operation::compare) return false;
    const auto linear = [&](const Expression& x) { return is_linear_in(x, setting_.force.symbol); };
    return std::all_of(e->operands.begin(), e->operands.end(), linear) &&
           std::find(e->relations.begin(), e->relations.end(), Relation::not_equal) == e->relations.end();
  };
  return convex(setting_.force.domain) && signs_.defined(setting_.force.domain);
}

bool SettingWriter::varies(const Expression& e) const {
  const auto occurs = [&](const std::string& symbol) { return names_.depends(e, reading_, symbol); };
  const std::vector<std::string> quantities = setting_.quantities();
  return depends_on_force(e) || std::any_of(quantities.begin(), quantities.end(), occurs);
}

bool SettingWriter::is_linear(const Expression& e) const {
  if (!varies(e)) return true;
  const auto linear = [&](const Expression& x) { return is_linear(x); };
  switch (e->operation) {
    case Operation::symbol: {
      const auto entry = names_.find(e->symbol);
      return !entry || entry->kind != SettingNames::Kind::definition ||
             is_linear(names_.definition(entry->index, reading_));
    }
    case Operation::multiply:
      if (varies(e->operands[0]) && varies(e->operands[1])) return false;
      break;
    case Operation::divide:
      if (varies(e->operands[1])) return false;
      break;
    case Operation::power:
      if (e->exponent != 0 && e->exponent != 1) return false;
      break;
    case Operation::minimum:
    case Operation::maximum:
    case Operation::absolute:
    case Operation::signum:
      return false;
    default:
      break;
  }
  return std::all_of(e->operands.begin(), e->operands.end(), linear);
}

std::string SettingWriter::domain(bool with_force, const std::string& parameter, const std::string& renamed) {
  std::vector<std::string> parts;
  const auto add = [&](const Expression& condition) {
    if (is_true(condition)) return;
    parts.push_back(text(parameter.empty() ? condition : substitute(condition, parameter, make_symbol(renamed))));
    const bool joined = parts.back().find(" or ") != std::string::npos;
    if (joined) parts.back() = "{" + parts.back() + "}";
  };
  for (const FreeParameter& given : setting_.parameters) add(given.domain);
  for (const Expression& condition : physical()) add(condition);
  if (with_force) add(setting_.force.domain);
  return parts.empty() ? "0 = 0" : fmt::format("{}", fmt::join(parts, " and "));
}

bool SettingWriter::is_bounded(const std::string& parameter) const {
  const auto has = [&](const Expression& e) {
    const auto names = symbols(e);
    return std::find(names.begin(), names.end(), parameter) != names.end();
  };
  for (const FreeParameter& given : setting_.parameters) {
    const Expression& domain = given.domain;
    if (!has(domain)) continue;
    const bool lower_end =
        given.symbol == parameter && domain->operation == Operation::compare && domain->relations.size() == 1 &&
        is_symbol(domain->operands[0], parameter) && !has(domain->operands[1]) &&
        (domain->relations[0] == Relation::greater || domain->relations[0] == Relation::greater_equal);
    if (!lower_end) return true;
  }
  SettingWriter copy(setting_, reading_);
  const std::vector<Expression> conditions = copy.physical();
  return std::any_of(conditions.begin(), conditions.end(), has);
}

std::string SettingWriter::definitions(const std::vector<Expression>& uses) {
  const auto defined = [this](const Expression& e) { return always_defined(e); };
  std::string result;
  for (const Expression& use : uses) {
    if (!use) continue;
    for (const std::string& symbol : symbols(use)) {
      const auto found = std::find_if(setting_.definitions.begin(), setting_.definitions.end(),
                                      [&](const Definition& d) { return d.symbol == symbol; });
      if (found == setting_.definitions.end() || !defined_.insert(symbol).second) continue;
      const Expression& value = found->value(reading_);
      result += definitions({value});
      if (has_function(inlined(value))) continue;
      result += fmt::format("let {} = {}\n", symbol, *number_text(value, defined));
    }
  }
  return result;
}

std::string SettingWriter::scene(const std::vector<Expression>& uses) {
  std::vector<Expression> all = uses;
  for (const auto& [symbol, value] : setting_.scene) all.push_back(value);
  return definitions(all) + mechanics_.scene();
}

}  // namespace slipproof
