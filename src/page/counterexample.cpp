#include <string>
#include <utility>
#include <vector>

#include "claims/compiled.hpp"
#include "claims/setting_names.hpp"
#include "model/chain.hpp"
#include "model/conditions.hpp"
#include "model/linear_form.hpp"
#include "number/format.hpp"
#include "page/sections.hpp"
#include "picture/bicycle_svg.hpp"
#include "report/verify_report.hpp"
#include "typeset/mathml.hpp"

namespace slipproof {

namespace {

void add_value(const Element& parent, std::string_view symbol, const Rational& value) {
  const Element row = add_math(parent).add("mrow");
  add_symbol(row, symbol);
  add_operator(row, "=");
  add_number(row, value);
}

/// The values of the definitions that the claim uses, at the counterexample.
void add_symbols(const Element& parent, const ClaimsFile& file, const Claim& claim, const ClaimResult& result) {
  const Setting& setting = file.settings[claim.setting];
  const CompiledSetting compiled(setting);
  const SettingNames names(setting);
  Evaluator<Rational> values(compiled.scope());
  const Counterexample& e = *result.counterexample;
  for (std::size_t k = 0; k < e.values.size(); ++k) values.set(CompiledSetting::parameter_slot(k), e.values[k]);
  if (e.force) values.set(CompiledSetting::force_slot(), *e.force);
  std::vector<bool> needed(setting.definitions.size());
  for (const Expression& expression : expressions(claim.body(result.reading))) {
    for (const std::size_t i : names.needs(expression, result.reading)) needed[i] = true;
  }
  const Element p = parent.add("p", "values");
  p.text("There the claim's symbols are ");
  bool any = false;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (!needed[i]) continue;
    const auto value = values.at(compiled.definition_slot(i, result.reading)).number;
    if (!value) continue;
    if (any) p.text(", ");
    add_value(p.add("span", "definition"), setting.definitions[i].symbol, *value);
    any = true;
  }
  p.text(any ? "." : "its parameters alone.");
}

/// a x + b y = 0 with the numbers in it: what each equation of the model comes to.
void add_equation_row(const Element& body, std::string_view what, const LinearForm<Rational>& form,
                      const std::vector<std::pair<std::string_view, Rational>>& unknowns) {
  const Element row = body.add("tr");
  row.add("th").set("scope", "row").text(what);
  const Element symbols = add_math(row.add("td")).add("mrow"), numbers = add_math(row.add("td")).add("mrow");
  bool first = true;
  const auto term = [&](const Rational& coefficient, std::string_view symbol, const Rational& value) {
    if (coefficient.is_zero()) return;
    for (const Element& side : {symbols, numbers}) {
      if (!first || coefficient < 0) add_operator(side, coefficient < 0 ? "−" : "+");
    }
    first = false;
    const Rational size = abs(coefficient);
    const bool one = size == 1 && !symbol.empty();
    if (!one) {
      add_number(symbols, size);
      add_number(numbers, size);
    }
    if (symbol.empty()) return;
    if (!one) {
      add_operator(symbols, "\xE2\x81\xA2");
      add_operator(numbers, "·");
    }
    add_symbol(symbols, symbol);
    const bool parentheses = value < 0;
    if (parentheses) add_operator(numbers, "(");
    add_number(numbers, value);
    if (parentheses) add_operator(numbers, ")");
  };
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    term(form.coefficients[i], unknowns[i].first, unknowns[i].second);
  }
  term(form.constant, "", Rational(0));
  for (const Element& side : {symbols, numbers}) {
    if (first) add_operator(side, "0");
    add_operator(side, "=");
    side.add("mn").text("0");
  }
}

constexpr std::array<std::string_view, unknown_count> equation_names{
    "along the road", "up and down",  "rotation of all", "sprocket",      "rear wheel",   "front wheel",
    "chain",          "rear contact", "rear contact",    "front contact", "front contact"};

/// `S2 <= f N2`, `gap3 >= 0`, as formulas.
void add_condition(const Element& parent, const Condition& condition) {
  const Element row = add_math(parent).add("mrow");
  const bool friction = condition.kind == ConditionKind::friction_up || condition.kind == ConditionKind::friction_dn;
  if (!friction) {
    const std::string text = name(condition);
    const std::size_t end = text.find(' ');
    add_symbol(row, text.substr(0, end));
    add_operator(row, text.find(">=") != text.npos ? "≥" : "≤");
    row.add("mn").text("0");
    return;
  }
  const std::string wheel = condition.wheel == Wheel::rear ? "2" : "3";
  if (condition.kind == ConditionKind::friction_dn) add_operator(row, "−");
  add_symbol(row, "S" + wheel);
  add_operator(row, "≤");
  add_symbol(row, "f");
  add_symbol(row, "N" + wheel);
}

void add_arithmetic(const Element& parent, const Scene& scene, const FoundMotion<Rational>& found) {
  const Element details = parent.add("details", "data");
  details.add("summary").text("Follow it by hand");
  const Element scroll = details.add("div", "scroll").set("tabindex", 0).set("role", "region");
  scroll.set("aria-label", "The equations with their numbers");
  const Element table = scroll.add("table", "arithmetic");
  table.add("caption").text("The model's equations in " + name(found.modes.front()) + ", and with the numbers in them");
  const Element body = table.add("tbody");
  const Rational F = scene.F.value_or(Rational(0));
  const auto chain = chain_of(scene.bicycle, found.values, F);
  using enum Quantity;
  const auto& v = found.values;
  const std::vector<std::pair<std::string_view, Rational>> unknowns{
      {"a", v[a]},    {"a_y", v[a_y]}, {"phi", v[phi]}, {"eps1", chain.eps1}, {"eps2", v[eps2]}, {"eps3", v[eps3]},
      {"T", chain.T}, {"S2", v[S2]},   {"S3", v[S3]},   {"N2", v[N2]},        {"N3", v[N3]},     {"F", F}};
  const auto rows = raw_system(scene.bicycle, scene.road, scene.force_kind, found.modes.front());
  for (std::size_t i = 0; i < rows.size(); ++i) add_equation_row(body, equation_names[i], rows[i], unknowns);

  const Element inequalities = scroll.add("table", "arithmetic");
  inequalities.add("caption").text("Its conditions, and by how much each one holds");
  const Element conditions_body = inequalities.add("tbody");
  for (const Condition& condition : conditions(found.modes.front())) {
    const Element row = conditions_body.add("tr");
    add_condition(row.add("th").set("scope", "row"), condition);
    add_number(add_math(row.add("td")).add("mrow"), condition_value(condition, v, scene.road.f));
  }
}

void add_motion(const Element& parent, const Scene& scene, const FoundMotion<Rational>& found) {
  const Element box = parent.add("div", "motion");
  std::string modes;
  for (const ContactMode mode : found.modes) modes += (modes.empty() ? "" : " = ") + name(mode);
  const Element heading = box.add("p", "motion-name");
  heading.add("b").text(modes);
  if (!found.strict) heading.text(" (boundary)");
  add_bicycle(box, scene, &found, "The bicycle with the forces of the motion " + modes);
  add_arithmetic(box, scene, found);
}

}  // namespace

void add_counterexample(const Element& parent, const ClaimsFile& file, const ClaimResult& result) {
  const Counterexample& e = *result.counterexample;
  const Claim& claim = file.claims[result.claim];
  const Setting& setting = file.settings[claim.setting];
  const Element box = parent.add("div", "counterexample");
  const Element what = box.add("p");
  what.add("b").text("Counterexample. ");
  what.text(explain(file, result) + ", at ");
  for (std::size_t k = 0; k < e.values.size(); ++k) {
    if (k > 0) what.text(", ");
    add_value(what.add("span", "definition"), setting.parameters[k].symbol, e.values[k]);
  }
  if (e.force) {
    what.text(", ");
    add_value(what.add("span", "definition"), setting.force.symbol, *e.force);
  }
  what.text(e.minimal ? ". There is no simpler one." : ".");
  add_symbols(box, file, claim, result);
  if (e.motions && !e.motions->motions.empty()) {
    box.add("p").text(e.motions->motions.size() == 1
                          ? "The one motion that is really there:"
                          : "The " + std::to_string(e.motions->motions.size()) + " motions that are really there:");
    const Element motions = box.add("div", "motions");
    for (const auto& found : e.motions->motions) add_motion(motions, e.scene, found);
  }
  const Element details = box.add("details", "data");
  details.add("summary").text("As a scene for slipproof solve");
  details.add("pre").set("tabindex", 0).add("code").text(to_toml(e.scene));
}

}  // namespace slipproof
