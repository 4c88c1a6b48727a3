#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/output/percent.hpp"
#include "claims/paper/compiled.hpp"
#include "claims/paper/setting_names.hpp"
#include "mechanics/mechanism/words.hpp"
#include "report/html/headline.hpp"
#include "report/html/sections.hpp"
#include "report/markup/mathml.hpp"
#include "report/papers/explain.hpp"
#include "report/picture/mechanism_svg.hpp"

namespace slipproof {

namespace {

void add_value(const Element& parent, std::string_view symbol, const Rational& value) {
  const Element row = add_math(parent).add("mrow");
  add_symbol(row, symbol);
  add_operator(row, "=");
  add_number(row, value);
}

/// The values of the definitions that the claim uses, at the counterexample.
void add_symbols(const Element& parent, const ClaimsFile& file, const Claim& claim, Reading reading,
                 const Counterexample& e) {
  const Setting& setting = file.settings[claim.setting];
  const CompiledSetting compiled(setting);
  const SettingNames names(setting);
  Evaluator<Rational> values(compiled.scope());
  for (std::size_t k = 0; k < e.values.size(); ++k) values.set(CompiledSetting::parameter_slot(k), e.values[k]);
  if (e.force) values.set(CompiledSetting::force_slot(), *e.force);
  std::vector<bool> needed(setting.definitions.size());
  for (const Expression& expression : expressions(claim.body(reading))) {
    for (const std::size_t i : names.needs(expression, reading)) needed[i] = true;
  }
  std::vector<std::pair<std::string, Rational>> known;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (!needed[i]) continue;
    const auto value = values.at(compiled.definition_slot(i, reading)).number;
    if (value) known.emplace_back(setting.definitions[i].symbol, *value);
  }
  if (known.empty()) return;  // the claim uses only parameters, which are listed already
  const Element p = parent.add("p", "values");
  p.text("There ");
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (i > 0) p.text(i + 1 == known.size() ? " and " : ", ");
    add_value(p.add("span", "definition"), known[i].first, known[i].second);
  }
  p.text(".");
}

/// One side of an equation. Each term is a formula of its own, so that lines can break between terms.
class Terms {
 public:
  explicit Terms(const Element& cell) : cell_(cell) {}

  /// Begins a term: `+ 3`, `− 1/2`; the number 1 is left out if a symbol or value follows.
  Element start(const Rational& coefficient, bool number) {
    const Element row = add_math(cell_).add("mrow");
    cell_.text(" ");
    // The sign is written as an operator between two terms; by default it would be set close to the number, as its
    // sign.
    const char* sign = coefficient < 0 ? "−" : "+";
    if (!first_) row.add("mo").set("form", "infix").text(sign);
    if (first_ && coefficient < 0) add_operator(row, sign);
    first_ = false;
    if (number) add_number(row, Rational(abs(coefficient)));
    return row;
  }
  void end() {
    const Element row = add_math(cell_).add("mrow");
    if (first_) row.add("mn").text("0");
    add_operator(row, "=");
    row.add("mn").text("0");
  }

 private:
  Element cell_;
  bool first_ = true;
};

/// One motion with the values of all symbols in the equations: the unknowns, then the load.
struct NumberedMotion {
  std::vector<std::string> names;
  std::vector<Rational> values;
};

/// Nothing if forces are undetermined.
std::optional<NumberedMotion> numbered(const MechanismScene& scene, const MotionAtLoad& motion) {
  const Mechanism& mechanism = scene.mechanism;
  NumberedMotion result;
  for (const MechanismUnknown& unknown : mechanism.unknowns) result.names.push_back(unknown.symbol);
  result.values.assign(motion.accelerations.begin(),
                       motion.accelerations.begin() + static_cast<std::ptrdiff_t>(mechanism.accelerations));
  for (const Range& force : motion.forces) {
    if (!force.is_point()) return std::nullopt;
    result.values.push_back(*force.lower);
  }
  result.names.push_back(mechanism.load ? mechanism.load->symbol : "");
  result.values.push_back(scene.load.value_or(Rational(0)));
  return result;
}

/// A row `a x + b y = 0` with numbers: an equation of the mechanism at this motion.
void add_equation_row(const Element& body, std::string_view what, const AffineForm& form,
                      const NumberedMotion& motion) {
  const Element row = body.add("tr");
  row.add("th").set("scope", "row").text(what);
  Terms symbols(row.add("td")), numbers(row.add("td"));
  for (std::size_t i = 0; i < motion.names.size(); ++i) {
    const Rational& coefficient = form.coefficients[i];
    if (coefficient.is_zero()) continue;
    const Rational& value = motion.values[i];
    const bool one = abs(coefficient) == 1;
    const Element left = symbols.start(coefficient, !one), right = numbers.start(coefficient, !one);
    if (!one) {
      add_operator(left, "\xE2\x81\xA2");
      add_operator(right, "·");
    }
    add_symbol(left, motion.names[i]);
    if (value < 0) add_operator(right, "(");
    add_number(right, value);
    if (value < 0) add_operator(right, ")");
  }
  if (!form.constant.is_zero()) {
    symbols.start(form.constant, true);
    numbers.start(form.constant, true);
  }
  symbols.end();
  numbers.end();
}

/// All equations and conditions of one motion with their numbers, as wide as the page; lines break where necessary.
void add_arithmetic(const Element& parent, const MechanismScene& scene, const MotionAtLoad& found) {
  const auto motion = numbered(scene, found);
  if (!motion) return;
  const Mechanism& mechanism = scene.mechanism;
  const FrictionProblem problem = friction_problem(mechanism, scene.values);
  const MechanismMode& mode = found.strict() ? found.modes.front() : found.boundary_modes.front();
  const Element details = parent.add("details", "data by-hand");
  details.add("summary").text("Follow " + name(mode) + " by hand");
  const Element table = details.add("table", "arithmetic");
  table.add("caption").text("The equations of the model in " + name(mode) + ", and the same with the numbers put in");
  const Element body = table.add("tbody");
  for (std::size_t i = 0; i < problem.equations.size(); ++i) {
    const std::size_t own = mechanism.equations.size();
    const std::string& what = i < own ? mechanism.equations[i].name : mechanism.links[i - own].name;
    add_equation_row(body, what, problem.equations[i], *motion);
  }
  for (std::size_t i = 0; i < mode.size(); ++i) {
    for (const StateEquation equation : equations(problem.elements[i].kind, mode[i])) {
      add_equation_row(body, element_name(mechanism, i), form_of(problem.elements[i], mode[i], equation), *motion);
    }
  }
  const Element inequalities = details.add("table", "arithmetic conditions");
  inequalities.add("caption").text("The conditions of the mode, and by how much each of them holds");
  const Element conditions_body = inequalities.add("tbody");
  for (std::size_t i = 0; i < mode.size(); ++i) {
    for (const StateCondition condition : conditions(problem.elements[i].kind, mode[i])) {
      const Element row = conditions_body.add("tr");
      row.add("th").set("scope", "row").text(condition_name(mechanism, i, mode[i], condition));
      add_number(add_math(row.add("td")).add("mrow"),
                 form_of(problem.elements[i], mode[i], condition).at(motion->values));
    }
  }
}

/// The scene as a file to save and as text to read.
void add_scene(const Element& parent, const PageInput& input, const MechanismScene& scene, const std::string& text,
               const std::string& file_name) {
  const Element p = parent.add("p", "download");
  p.add("a")
      .set("download", file_name)
      .set("href", "data:text/plain;charset=utf-8," + percent_encoded(text))
      .text("Download the scene");
  p.text(" for ");
  p.add("code").text("slipproof solve " + file_name);
  if (const std::string link = link_to_explorer(input, scene); !link.empty()) {
    p.text(", or ").add("a").set("href", link).text("drag its values in the explorer");
  }
  const Element details = parent.add("details", "data");
  details.add("summary").text("Read the scene");
  details.add("pre").set("tabindex", 0).add("code").text(text);
}

/// `at R = 1, h = 2, F = 2/9`.
void add_place(const Element& p, const ClaimsFile& file, const ClaimResult& result, const Counterexample& e) {
  p.text("at ");
  const auto place = place_of(file, result, e);
  for (const auto& [symbol, value] : place) {
    if (&symbol != &place.front().first) p.text(", ");
    add_value(p.add("span", "definition"), symbol, value);
  }
}

/// The motions at the force, drawn, with the arithmetic.
void add_motions(const Element& box, const Counterexample& e) {
  if (!e.motions) return;
  const auto& motions = e.motions->motions;
  for (const auto& continuum : e.motions->continua) {
    box.add("p").text("In " + name(continuum.mode) + " there is a continuum of motions.");
  }
  if (motions.empty()) {
    if (!e.motions->continua.empty()) return;
    box.add("p").text(sentence(no_motions(e)));
    return;
  }
  box.add("p").text(motions.size() == 1
                        ? "There is one motion:"
                        : "There are " + std::to_string(motions.size()) + " motions, with these forces:");
  const Element grid = box.add("div", "motions");
  for (const auto& found : motions) add_motion(grid, e.scene, found, {});
  for (const auto& found : motions) add_arithmetic(box, e.scene, found);
}

}  // namespace

void add_counterexample(const Element& parent, const PageInput& input, const ClaimResult& result) {
  const ClaimsFile& file = *input.claims;
  const Counterexample& e = *result.counterexample;
  const Claim& claim = file.claims[result.claim];
  const Setting& setting = file.settings[claim.setting];
  const std::string file_name = claim.id + "-" + std::string(name(result.reading));
  const Element box = parent.add("div", "counterexample");
  const Element what = box.add("p");
  what.add("b").text("Counterexample. ");
  const std::string said = sentence(explain(file, result));
  add_prose(what, *input.claims, said.substr(0, said.size() - 1) + ", ");
  add_place(what, file, result, e);
  what.text(".");
  std::string sure = sentence(realisability(file, result));
  if (e.minimal) {
    const bool built = !setting.realisable.empty() && e.unrealisable.empty();
    sure +=
        std::string(sure.empty() ? "" : " ") + (built ? "No simpler one can be built." : "There is no simpler one.");
  }
  if (!sure.empty()) add_prose(box.add("p", "built"), *input.claims, sure);
  add_symbols(box, file, claim, result.reading, e);
  if (is_about_motions(claim)) add_motions(box, e);
  add_scene(box, input, e.scene, scene_text(setting, e), file_name + ".toml");
  if (!result.simplest) return;
  const Element simplest = box.add("details", "data");
  simplest.add("summary").text("A simpler one, which cannot be built");
  const Element where = simplest.add("p");
  where.text("The same fails ");
  add_place(where, file, result, *result.simplest);
  add_prose(where, *input.claims,
            ". This " + std::string(noun(setting, "mechanism")) + " cannot be built: it breaks " +
                broken_conditions(setting, *result.simplest) + ".");
  if (is_about_motions(claim)) add_motions(simplest, *result.simplest);
  add_scene(simplest, input, result.simplest->scene, scene_text(setting, *result.simplest),
            file_name + "-simplest.toml");
}

}  // namespace slipproof
