#include "claims/statements/claim_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>

#include "base/expression/logic.hpp"
#include "claims/statements/truth_text.hpp"
#include "proofs/statement/zero_divisors.hpp"

namespace slipproof {
namespace {

/// The text with some of its words replaced.
std::string with_names(const std::string& text, const std::map<std::string, std::string, std::less<>>& names) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && MadeUpNames::is_in_word(text[end])) ++end;
    const std::string word = text.substr(i, std::max<std::size_t>(end - i, 1));
    const auto found = names.find(word);
    result += found == names.end() ? word : found->second;
    i += word.size();
  }
  return result;
}

/// A line `real` or `exists` has a space before each name.
bool has_too_many_variables(const NamedStatement& statement) {
  std::size_t variables = 0;
  std::string line;
  for (std::istringstream lines(statement.text); std::getline(lines, line);) {
    const bool declares = line.starts_with("real ") || line.starts_with("exists ");
    if (declares) variables += static_cast<std::size_t>(std::ranges::count(line, ' '));
  }
  return variables > max_statement_variables;
}

}  // namespace

ClaimWriter::ClaimWriter(const ClaimsFile& claims, const Claim& claim, Reading reading)
    : SettingWriter(claims.settings[claim.setting], claim.repaired ? reading : Reading::printed),
      claims_(claims),
      claim_(claim),
      body_(claim.body(reading)),
      name_(claim.id + (reading == Reading::repaired && claim.repaired ? ".repaired" : "")) {
  if (!has_interval_of_forces()) give_up();
}

std::string ClaimWriter::opening(const std::string& suffix) {
  return header(name_ + suffix, fmt::format("{} of {}, {} reading", claim_.id, claims_.paper.source, name(reading())));
}

std::string ClaimWriter::assumed(const Assumptions& assumptions, std::vector<Expression>& uses) {
  std::string result;
  for (const auto& [label, truth] : assumptions) {
    if (!is_true(truth)) uses.push_back(truth);
    result += assumption(label, truth);
  }
  return result;
}

void ClaimWriter::implied(const Implication& implication, const Expression& shown) {
  implied(implication, text(shown), {shown});
}

void ClaimWriter::implied(const Implication& implication, const std::string& shown,
                          const std::vector<Expression>& uses) {
  std::string result = opening(implication.suffix);
  std::vector<Expression> all = uses;
  const std::string assumptions = assumed(implication.assumptions, all);
  result += variables() + assumption("domain", domain(implication.force_domain)) + scene(all) + assumptions;
  if (implication.motion) {
    result += fmt::format("{}real {}\n{}", implication.hints, fmt::join(mechanics().unknowns(), " "),
                          implication.motion->definitions) +
              assumption("motion", implication.motion->formula);
  }
  statements_.push_back({name_ + implication.suffix, result + fmt::format("show {}\n", shown), implication.refutes});
}

void ClaimWriter::implied_of_each(const Modes& modes, const Expression& forces, const Expression& shown) {
  const Assumptions assumptions = {{"region", body_.region}, {"force", forces}};
  const bool refutes = always_defined(shown);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const std::string suffix = modes.size() == 1 ? "" : fmt::format(".{}", i + 1);
    implied({suffix, assumptions, motion(modes[i]), true, {}, refutes}, shown);
  }
  if (modes.empty()) implied({"", assumptions, {}, true, {}, refutes}, shown);
  have_values(".defined", body_.region, forces);
}

MotionText ClaimWriter::one_of(const std::vector<ModeAndMore>& modes, bool strict) const {
  std::vector<std::string> parts;
  for (const auto& [mode, more] : modes) parts.push_back("{" + mechanics().mode_text(mode) + more + "}");
  return {mechanics().equations() + mechanics().all_state_definitions(strict),
          fmt::format("{} and {{{}}}", mechanics().dynamics(), fmt::join(parts, " or "))};
}

std::vector<ClaimWriter::ModeAndMore> ClaimWriter::modelled(const Modes& modes) {
  std::vector<ModeAndMore> result;
  for (const MechanismMode& mode : modes) {
    if (mechanics().is_modelled(mode)) result.emplace_back(mode, "");
  }
  if (result.empty()) give_up();
  return result;
}

void ClaimWriter::exists(const Implication& implication, const std::vector<std::string>& unknowns,
                         const MotionText& shown, const std::vector<Expression>& uses) {
  std::string result = opening(implication.suffix);
  std::vector<Expression> all = uses;
  const std::string assumptions = assumed(implication.assumptions, all);
  std::vector<std::string> known;  // unknowns of the motion that are given
  for (const auto& unknown : mechanics().unknowns()) {
    if (std::find(unknowns.begin(), unknowns.end(), unknown) == unknowns.end()) known.emplace_back(unknown);
  }
  result += variables();
  if (!known.empty()) result += fmt::format("real {}\n", fmt::join(known, " "));
  result += assumption("domain", domain(implication.force_domain)) + scene(all) + assumptions + implication.hints;
  result += fmt::format("exists {}\n{}show {}\n", fmt::join(unknowns, " "), shown.definitions, shown.formula);
  statements_.push_back({name_ + implication.suffix, std::move(result), implication.refutes});
}

void ClaimWriter::exists(const Implication& implication, const MotionText& motion) {
  exists(implication, mechanics().unknowns(), motion);
}

void ClaimWriter::together(const std::string& suffix, const Assumptions& assumptions,
                           const std::vector<MotionText>& motions, const std::string& hints, const std::string& shown) {
  std::string result = opening(suffix);
  std::vector<Expression> uses;
  const std::string assumption_lines = assumed(assumptions, uses);
  result += variables() + assumption("domain", domain(true)) + scene(uses) + assumption_lines + hints;
  for (std::size_t i = 1; i <= motions.size(); ++i) {
    const MotionText motion = numbered(motions[i - 1], i);
    result += fmt::format("real {}\n{}", fmt::join(unknowns(i), " "), motion.definitions) +
              assumption("motion" + made_up().ending(i), motion.formula);
  }
  statements_.push_back({name_ + suffix, result + fmt::format("show {}\n", shown)});
}

std::vector<std::string> ClaimWriter::unknowns(std::size_t motion) const {
  std::vector<std::string> result;
  for (const std::string& unknown : mechanics().unknowns())
    result.push_back(unknown + mechanics().names().ending(motion));
  return result;
}

MotionText ClaimWriter::numbered(const MotionText& motion, std::size_t number) {
  if (number == 1) return motion;
  std::map<std::string, std::string, std::less<>> names;
  const std::vector<std::string>& first = mechanics().unknowns();
  const std::vector<std::string> here = unknowns(number);
  for (std::size_t i = 0; i < first.size(); ++i) names.emplace(first[i], here[i]);
  std::string line;
  for (std::istringstream lines(motion.definitions); std::getline(lines, line);) {
    const std::size_t begin = line.find(' ') + 1;
    const std::string name = line.substr(begin, line.find_first_of(" :", begin) - begin);
    names.emplace(name, made_up().take(name + made_up().ending(number)));
  }
  return {with_names(motion.definitions, names), with_names(motion.formula, names)};
}

void ClaimWriter::one_motion(const std::string& suffix, const Assumptions& assumptions, const MotionText& x,
                             const MotionText& y, const std::string& hints) {
  together(suffix, assumptions, {x, y}, hints, same_accelerations(2));
}

std::string ClaimWriter::same_accelerations(std::size_t other) const {
  const std::string ending = mechanics().names().ending(other);
  std::vector<std::string> same;
  for (const auto& unknown : mechanics().accelerations()) same.push_back(fmt::format("{0} = {0}{1}", unknown, ending));
  return fmt::format("{}", fmt::join(same, " and "));
}

void ClaimWriter::same_as_one_of(const std::string& suffix, const Assumptions& assumptions,
                                 const std::vector<MechanismMode>& modes, bool strict) {
  std::vector<MotionText> motions = {any_motion(strict)};
  std::vector<std::string> same;
  for (const MechanismMode& mode : modes) {
    motions.push_back(motion(mode, strict));
    same.push_back("{" + same_accelerations(motions.size()) + "}");
  }
  together(suffix, assumptions, motions, "", fmt::format("{}", fmt::join(same, " or ")));
}

void ClaimWriter::impossible_together(const std::string& suffix, const Assumptions& assumptions,
                                      const std::vector<MotionText>& motions) {
  together(suffix, assumptions, motions, "", "false");
}

void ClaimWriter::has_value(const std::string& suffix, const Assumptions& assumptions, const Expression& truth) {
  has_value({suffix, assumptions, {}, false}, truth);
}

void ClaimWriter::has_value_at_forces(const std::string& suffix, const Assumptions& assumptions,
                                      const Expression& truth) {
  has_value({suffix, assumptions, {}, true}, truth);
}

void ClaimWriter::has_value(const Implication& implication, const Expression& truth) {
  if (!always_defined(truth)) implied(implication, make(Operation::logical_or, {truth, opposite(truth)}));
}

void ClaimWriter::have_values(const std::string& suffix, const Expression& region, const Expression& forces) {
  has_value(suffix + ".region", {}, region);
  has_value_at_forces(suffix, {{"region", region}}, forces);
}

void ClaimWriter::goes_beyond(const std::string& suffix, const std::string& parameter, const Expression& from) {
  if (!is_bounded(parameter)) return;
  const std::string greater = parameter + "'";
  std::vector<Expression> uses = {body_.region, from};
  std::string result = opening(suffix) + variables() + assumption("domain", domain(false));
  result += definitions(uses) + assumption("region", body_.region);
  const auto bound = number_text(from, [this](const Expression& e) { return always_defined(e); });
  if (!bound) give_up();
  result += fmt::format("exists {}\nshow {} and {} > {}\n", greater, domain(false, parameter, greater), greater,
                        bound.value_or("0"));
  statements_.push_back({name_ + suffix, std::move(result)});
}

std::vector<Expression> ClaimWriter::cells(const std::vector<Expression>& regions) const {
  std::vector<Expression> values;
  std::string symbol;
  for (const Boundary& boundary : setting().boundaries) {
    if (boundary.value->operation != Operation::symbol) continue;
    const bool bounds_region = std::any_of(regions.begin(), regions.end(), [&](const Expression& region) {
      const std::vector<std::string> names = symbols(region);
      return std::find(names.begin(), names.end(), boundary.value->symbol) != names.end();
    });
    if (!bounds_region || (!symbol.empty() && boundary.symbol != symbol)) continue;
    symbol = boundary.symbol;
    values.push_back(boundary.value);
  }
  if (values.empty()) return {make_truth(true)};
  const Expression bounded = make_symbol(symbol);
  std::vector<Expression> result = {make_comparison({bounded, values.front()}, {Relation::less})};
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    result.push_back(make_comparison({values[i], bounded, values[i + 1]}, {Relation::less_equal, Relation::less}));
  }
  result.push_back(make_comparison({values.back(), bounded}, {Relation::less_equal}));
  return result;
}

/// Nothing if statements cannot express the value.
std::string ClaimWriter::hint(const Boundary& boundary) const {
  const auto value = number_text(inlined(boundary.value), [this](const Expression& e) { return always_defined(e); });
  return value ? fmt::format("# split: {} - ({})\n", boundary.symbol, *value) : std::string();
}

Expression ClaimWriter::in_one_of(const References& others, bool stated) const {
  Expression result;
  for (const std::size_t other : others) {
    const ClaimBody& its = body(other);
    const Expression here = stated ? conjunction(its.region, its.forces) : its.region;
    result = result ? make(Operation::logical_or, {result, here}) : here;
  }
  return result;
}

std::string ClaimWriter::hints_to_numbers() const {
  std::string result;
  for (const Boundary& boundary : setting().boundaries) {
    if (!symbols(boundary.value).empty()) continue;
    result += hint(boundary);
  }
  return result;
}

void ClaimWriter::somewhere(const std::string& suffix, const std::vector<Expression>& truths,
                            const std::vector<MotionText>& motions, const std::vector<Expression>& more_uses) {
  std::string result = opening(suffix);
  std::string shown = domain(true);
  std::vector<Expression> uses = more_uses;
  for (const Expression& truth : truths) {
    if (is_true(truth)) continue;
    uses.push_back(truth);
    shown += fmt::format(" and {{{}}}", text(truth));
  }
  result += "exists " + parameters();
  std::string definitions;
  for (std::size_t i = 1; i <= motions.size(); ++i) {
    result += fmt::format(" {}", fmt::join(unknowns(i), " "));
    const MotionText motion = numbered(motions[i - 1], i);
    definitions += motion.definitions;
    shown += " and " + motion.formula;
  }
  std::string hints;  // the boundaries, where bicycles are special
  for (const Boundary& boundary : setting().boundaries) {
    uses.push_back(boundary.value);
    hints += hint(boundary);
  }
  statements_.push_back({name_ + suffix, result + '\n' + scene(uses) + hints + definitions + "show " + shown + '\n'});
}

std::vector<NamedStatement> ClaimWriter::take() {
  if (!complete() || std::ranges::any_of(statements_, has_too_many_variables)) return {};
  for (NamedStatement& statement : statements_) statement.text = without_zero_divisors(std::move(statement.text));
  return std::move(statements_);
}

}  // namespace slipproof
