#include "statements/setting_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "expression/logic.hpp"
#include "statements/truth_text.hpp"

namespace slipproof {

namespace {

/// Whether it is 0 where the symbol is 0, as it stands: a product with it, or a quotient of one.
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

/// Statements are printable ASCII, whatever the paper's file is called: ? for any other character.
std::string in_ascii(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
    if (!continues) result += c < ' ' || c > '~' ? '?' : c;
  }
  return result;
}

}  // namespace

std::string SettingWriter::header(const std::string& theorem, const std::string& comment) {
  defined_.clear();
  return fmt::format("slipproof-statement 1\ntheorem {}\n# {}\n", theorem, in_ascii(comment));
}

std::string SettingWriter::assumption(const std::string& label, const Expression& truth) {
  return is_true(truth) ? "" : fmt::format("assume {}: {}\n", label, text(truth));
}

MotionText SettingWriter::motion(ContactMode mode) {
  return motion(mode, setting_.strict);
}

MotionText SettingWriter::motion(ContactMode mode, bool strict) {
  complete_ = complete_ && (mode.on_road() || has_pitch_inertia());
  return {mechanics_text(setting_.force_kind) + state_definition(Wheel::rear, mode.rear, strict) +
              state_definition(Wheel::front, mode.front, strict),
          std::string(dynamics) + " and " + mode_text(mode)};
}

MotionText SettingWriter::equations(std::optional<ContactMode> mode) const {
  const std::string contacts =
      mode ? contact_equations(Wheel::rear, mode->rear) + " and " + contact_equations(Wheel::front, mode->front)
           : "gap2 = 0 and gap3 = 0";
  return {mechanics_text(setting_.force_kind), std::string(dynamics) + " and " + contacts};
}

MotionText SettingWriter::any_motion(bool strict) {
  complete_ = complete_ && has_pitch_inertia();
  MotionText result{mechanics_text(setting_.force_kind), dynamics};
  for (const Wheel wheel : {Wheel::rear, Wheel::front}) {
    std::vector<std::string> names;
    for (const ContactState state : all_contact_states) {
      result.definitions += state_definition(wheel, state, strict);
      names.push_back(state_name(wheel, state));
    }
    result.formula += fmt::format(" and {{{}}}", fmt::join(names, " or "));
  }
  return result;
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

std::string SettingWriter::parameters() const {
  std::string result;
  for (const Parameter& parameter : setting_.parameters) result += parameter.symbol + ' ';
  return result + setting_.force.symbol;
}

std::vector<Expression> SettingWriter::physical() {
  const Setting::BicycleConditions conditions = setting_.bicycle_conditions();
  const Expression zero = make_number(0);
  std::vector<Expression> result;
  for (const Expression& e : conditions.positive) {
    if (!signs_.positive(e)) result.push_back(make_comparison({e, zero}, {Relation::greater}));
  }
  for (const Expression& e : conditions.not_negative) {
    if (!signs_.not_negative(e)) result.push_back(make_comparison({e, zero}, {Relation::greater_equal}));
  }
  for (const Expression& e : conditions.defined) {
    if (!signs_.defined(e)) result.push_back(make_comparison({e, e}, {Relation::equal}));
  }
  if (!conditions.slope) {
    give_up();
    return result;
  }
  // What stands as the force variable, or as it over or times what is plainly positive, needs no words.
  const Expression& F = setting_.scene.find("F")->second;
  const std::string& x = setting_.force.symbol;
  const bool plain = signs_.defined(F) && signs_.positive(substitute(F, x, make_number(1))) && has_no_constant(F, x);
  if (!plain) result.push_back(make_comparison({conditions.slope, zero}, {Relation::not_equal}));
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

std::string SettingWriter::domain(bool with_force, const std::string& parameter, const std::string& renamed) {
  std::vector<std::string> parts;
  const auto add = [&](const Expression& condition) {
    if (is_true(condition)) return;
    parts.push_back(text(parameter.empty() ? condition : substitute(condition, parameter, make_symbol(renamed))));
    const bool joined = parts.back().find(" or ") != std::string::npos;
    if (joined) parts.back() = "{" + parts.back() + "}";
  };
  for (const Parameter& given : setting_.parameters) add(given.domain);
  for (const Expression& condition : physical()) add(condition);
  if (with_force) add(setting_.force.domain);
  return parts.empty() ? "0 = 0" : fmt::format("{}", fmt::join(parts, " and "));
}

bool SettingWriter::is_bounded(const std::string& parameter) const {
  const auto has = [&](const Expression& e) {
    const auto names = symbols(e);
    return std::find(names.begin(), names.end(), parameter) != names.end();
  };
  for (const Parameter& given : setting_.parameters) {
    const Expression& domain = given.domain;
    if (!has(domain)) continue;
    const bool lower_end =
        given.symbol == parameter && domain->operation == Operation::compare && domain->relations.size() == 1 &&
        domain->operands[0]->operation == Operation::symbol && domain->operands[0]->symbol == parameter &&
        !has(domain->operands[1]) &&
        (domain->relations[0] == Relation::greater || domain->relations[0] == Relation::greater_equal);
    if (!lower_end) return true;
  }
  SettingWriter copy = *this;
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
      // A symbol of the scene may only be defined as what it is there.
      const auto in_scene = setting_.scene.find(symbol);
      if (in_scene != setting_.scene.end() && !same(in_scene->second, value)) give_up();
    }
  }
  return result;
}

std::string SettingWriter::scene(const std::vector<Expression>& uses) {
  std::vector<Expression> all = uses;
  for (const auto& [symbol, value] : setting_.scene) all.push_back(value);
  std::string result = definitions(all);
  const bool free = std::any_of(setting_.parameters.begin(), setting_.parameters.end(),
                                [](const Parameter& parameter) { return parameter.symbol == "J"; });
  if (!has_pitch_inertia() && !free) result += "let J = 0\n";
  for (const auto& [symbol, value] : setting_.scene) {
    if (to_string(value) != symbol && defined_.insert(symbol).second) {
      const auto number = number_text(inlined(value), [this](const Expression& e) { return always_defined(e); });
      if (!number) give_up();
      result += fmt::format("let {} = {}\n", symbol, number.value_or("0"));
    }
  }
  return result;
}

}  // namespace slipproof
