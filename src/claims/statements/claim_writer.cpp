#include "claims/statements/claim_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "base/expression/logic.hpp"
#include "claims/statements/formulas.hpp"
#include "proofs/statement/zero_divisors.hpp"

namespace slipproof {

namespace {

constexpr auto real = Directive::Kind::real;

}  // namespace

ClaimWriter::ClaimWriter(const ClaimsFile& claims, const Claim& claim, Reading reading)
    : SettingWriter(claims.settings[claim.setting], claim.repaired ? reading : Reading::printed),
      claims_(claims),
      claim_(claim),
      body_(claim.body(reading)),
      name_(claim.id + (reading == Reading::repaired && claim.repaired ? ".repaired" : "")) {
  if (!has_interval_of_forces()) give_up();
}

WrittenStatement ClaimWriter::opened(const std::string& suffix) {
  return begun(name_ + suffix, fmt::format("{} of {}, {} reading", claim_.id, claims_.paper.source, name(reading())));
}

void ClaimWriter::close(const std::string& suffix, WrittenStatement statement, const Expression& shown, bool refutes) {
  statement.show(shown);
  drafts_.push_back({suffix, std::move(statement), refutes});
}

void ClaimWriter::add_assumptions(WrittenStatement& to, const Implication& implication, std::vector<Expression> uses) {
  for (const auto& [label, truth] : implication.assumptions) {
    if (!is_true(truth)) uses.push_back(truth);
  }
  assume(to, "domain", domain(implication.force_domain));
  add_scene(to, uses);
  for (const auto& [label, truth] : implication.assumptions) assume_truth(to, label, truth);
  to.add_hints(implication.hints);
}

void ClaimWriter::implied(const Implication& implication, const Expression& shown) {
  implied(implication, formula(shown), {shown});
}

void ClaimWriter::implied(const Implication& implication, const Expression& formula,
                          const std::vector<Expression>& uses) {
  WrittenStatement statement = opened(implication.suffix);
  statement.declare(real, parameter_names());
  add_assumptions(statement, implication, uses);
  if (implication.motion) {
    statement.declare(real, mechanics().unknowns());
    statement.add(implication.motion->definitions);
    assume(statement, "motion", implication.motion->formula);
  }
  close(implication.suffix, std::move(statement), formula, implication.refutes);
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

StatedMotion ClaimWriter::one_of(const std::vector<ModeAndMore>& modes, bool strict) const {
  std::vector<Expression> parts;
  for (const auto& [mode, more] : modes) parts.push_back(braced(conjoined({mechanics().in_mode(mode), more})));
  return {mechanics().all_definitions(strict), conjoined({mechanics().dynamics(), braced(disjoined(parts))})};
}

std::vector<ClaimWriter::ModeAndMore> ClaimWriter::modelled(const Modes& modes) {
  std::vector<ModeAndMore> result;
  for (const MechanismMode& mode : modes) {
    if (mechanics().is_modelled(mode)) result.emplace_back(mode, nullptr);
  }
  if (result.empty()) give_up();
  return result;
}

void ClaimWriter::exists(const Implication& implication, const std::vector<std::string>& unknowns,
                         const StatedMotion& shown, const std::vector<Expression>& uses) {
  WrittenStatement statement = opened(implication.suffix);
  statement.declare(real, parameter_names());
  std::vector<std::string> known = mechanics().unknowns();  // unknowns of the motion that are given
  std::erase_if(known, [&](const std::string& name) { return std::ranges::find(unknowns, name) != unknowns.end(); });
  statement.declare(real, std::move(known));
  add_assumptions(statement, implication, uses);
  statement.declare(Directive::Kind::exists, unknowns);
  statement.add(shown.definitions);
  close(implication.suffix, std::move(statement), shown.formula, implication.refutes);
}

void ClaimWriter::exists(const Implication& implication, const StatedMotion& motion) {
  exists(implication, mechanics().unknowns(), motion);
}

void ClaimWriter::together(const std::string& suffix, const Assumptions& assumptions,
                           const std::vector<StatedMotion>& motions, const std::vector<Expression>& hints,
                           const Expression& shown) {
  WrittenStatement statement = opened(suffix);
  statement.declare(real, parameter_names());
  add_assumptions(statement, {suffix, assumptions, {}, true, hints}, {});
  for (std::size_t i = 1; i <= motions.size(); ++i) {
    const StatedMotion motion = numbered(motions[i - 1], i);
    statement.declare(real, unknowns(i));
    statement.add(motion.definitions);
    assume(statement, "motion" + made_up().ending(i), motion.formula);
  }
  close(suffix, std::move(statement), shown);
}

std::vector<std::string> ClaimWriter::unknowns(std::size_t motion) const {
  std::vector<std::string> result;
  for (const std::string& unknown : mechanics().unknowns())
    result.push_back(unknown + mechanics().names().ending(motion));
  return result;
}

StatedMotion ClaimWriter::numbered(StatedMotion motion, std::size_t number) {
  if (number == 1) return motion;
  std::map<std::string, std::string> names;
  const std::vector<std::string> here = unknowns(number);
  for (std::size_t i = 0; i < here.size(); ++i) names.emplace(mechanics().unknowns()[i], here[i]);
  for (Directive& line : motion.definitions) {
    std::string& name = line.names.front();
    name = names.emplace(name, made_up().take(name + made_up().ending(number))).first->second;
  }
  const auto renamed = [&](const std::string& symbol) {
    const auto found = names.find(symbol);
    return found == names.end() ? nullptr : make_symbol(found->second);
  };
  for (Directive& line : motion.definitions) line.body = substitute(line.body, renamed);
  motion.formula = substitute(motion.formula, renamed);
  return motion;
}

void ClaimWriter::one_motion(const std::string& suffix, const Assumptions& assumptions, const StatedMotion& x,
                             const StatedMotion& y, const std::vector<Expression>& hints) {
  together(suffix, assumptions, {x, y}, hints, same_accelerations(2));
}

Expression ClaimWriter::same_accelerations(std::size_t other) const {
  const std::string ending = mechanics().names().ending(other);
  std::vector<Expression> same;
  for (const std::string& unknown : mechanics().accelerations())
    same.push_back(make_comparison({make_symbol(unknown), make_symbol(unknown + ending)}, {Relation::equal}));
  return conjoined(same);
}

void ClaimWriter::same_as_one_of(const std::string& suffix, const Assumptions& assumptions,
                                 const std::vector<MechanismMode>& modes, bool strict) {
  std::vector<StatedMotion> motions = {any_motion(strict)};
  std::vector<Expression> same;
  for (const MechanismMode& mode : modes) {
    motions.push_back(motion(mode, strict));
    same.push_back(braced(same_accelerations(motions.size())));
  }
  together(suffix, assumptions, motions, {}, disjoined(same));
}

void ClaimWriter::impossible_together(const std::string& suffix, const Assumptions& assumptions,
                                      const std::vector<StatedMotion>& motions) {
  together(suffix, assumptions, motions, {}, make_truth(false));
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
  WrittenStatement statement = opened(suffix);
  add_parameters(statement, false);
  add_definitions(statement, {body_.region, from});
  assume_truth(statement, "region", body_.region);
  const Expression bound = number(from);
  if (!bound) return give_up();
  statement.declare(Directive::Kind::exists, {greater});
  const Expression is_greater = make_comparison({make_symbol(greater), bound}, {Relation::greater});
  close(suffix, std::move(statement), conjoined({domain(false, parameter, greater), is_greater}));
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

Expression ClaimWriter::hint(const Boundary& boundary) const {
  const Expression value = number(inlined(boundary.value));
  return value ? make(Operation::subtract, {make_symbol(boundary.symbol), bracketed(value)}) : nullptr;
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

std::vector<Expression> ClaimWriter::hints_to_numbers() const {
  std::vector<Expression> result;
  for (const Boundary& boundary : setting().boundaries) {
    if (symbols(boundary.value).empty()) result.push_back(hint(boundary));
  }
  return result;
}

void ClaimWriter::somewhere(const std::string& suffix, const std::vector<Expression>& truths,
                            const std::vector<StatedMotion>& motions, const std::vector<Expression>& more_uses) {
  WrittenStatement statement = opened(suffix);
  std::vector<Expression> uses = more_uses, shown = {domain(true)}, hints;
  for (const Expression& truth : truths) {
    if (is_true(truth)) continue;
    uses.push_back(truth);
    shown.push_back(braced(formula(truth)));
  }
  std::vector<std::string> all_unknowns = parameter_names();
  std::vector<Directive> definitions;
  for (std::size_t i = 1; i <= motions.size(); ++i) {
    for (std::string& unknown : unknowns(i)) all_unknowns.push_back(std::move(unknown));
    const StatedMotion motion = numbered(motions[i - 1], i);
    definitions.insert(definitions.end(), motion.definitions.begin(), motion.definitions.end());
    shown.push_back(motion.formula);
  }
  for (const Boundary& boundary : setting().boundaries) {  // where bicycles are special
    uses.push_back(boundary.value);
    hints.push_back(hint(boundary));
  }
  statement.declare(Directive::Kind::exists, std::move(all_unknowns));
  add_scene(statement, uses);
  statement.add_hints(hints);
  statement.add(definitions);
  close(suffix, std::move(statement), conjoined(shown));
}

std::vector<NamedStatement> ClaimWriter::take() {
  const auto too_large = [](const Draft& draft) { return draft.statement.variables() > max_statement_variables; };
  if (!complete() || std::ranges::any_of(drafts_, too_large)) return {};
  std::vector<NamedStatement> result;
  for (const Draft& draft : drafts_)
    result.push_back({name_ + draft.suffix, without_zero_divisors(draft.statement.text()), draft.refutes});
  return result;
}

}  // namespace slipproof
