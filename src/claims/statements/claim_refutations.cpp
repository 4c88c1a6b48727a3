// For refuted claims: that there is a counterexample, as a theorem.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "base/expression/logic.hpp"
#include "base/input/diagnostic.hpp"
#include "claims/statements/claim_writer.hpp"

namespace slipproof {
namespace {

constexpr const char* suffix = ".refuted";

/// A mode, and what else is to hold, as text; empty: nothing.
using ModeAndMore = std::pair<MechanismMode, std::string>;

/// A motion in one of `modes`, each with what else is to hold of it.
MotionText one_of(const ClaimWriter& writer, const std::vector<ModeAndMore>& modes, bool strict) {
  const MechanicsWriter& mechanics = writer.mechanics();
  std::vector<std::string> parts;
  for (const auto& [mode, more] : modes) parts.push_back("{" + mechanics.mode_text(mode) + more + "}");
  return {mechanics.equations() + mechanics.all_state_definitions(strict),
          fmt::format("{} and {{{}}}", mechanics.dynamics(), fmt::join(parts, " or "))};
}

/// Those of the modes that are modelled. Gives up where there are none.
std::vector<ModeAndMore> alone(ClaimWriter& writer, const Modes& modes) {
  std::vector<ModeAndMore> result;
  for (const MechanismMode& mode : modes) {
    if (writer.mechanics().is_modelled(mode)) result.emplace_back(mode, "");
  }
  if (result.empty()) writer.give_up();
  return result;
}

bool lists(const Modes& modes, const MechanismMode& mode) {
  return std::find(modes.begin(), modes.end(), mode) != modes.end();
}

void refute(ClaimWriter& writer, const Interval& claim) {
  writer.somewhere(suffix, {writer.body().region, opposite(claim.forces)}, {writer.motion(claim.mode)});
}

void refute(ClaimWriter& writer, const Formula& claim) {
  const std::vector<Expression> truths = {writer.body().region, claim.forces, opposite(claim.holds)};
  std::vector<MotionText> motions;
  if (claim.modes.size() == 1) motions = {writer.motion(claim.modes.front())};
  if (claim.modes.size() > 1) motions = {one_of(writer, alone(writer, claim.modes), writer.setting().strict)};
  writer.somewhere(suffix, truths, motions);
}

void refute(ClaimWriter& writer, const Impossible& claim) {
  writer.somewhere(suffix, {writer.body().region, claim.forces},
                   {one_of(writer, alone(writer, claim.modes), writer.setting().strict)});
}

void refute(ClaimWriter& writer, const Cover& claim) {
  std::vector<Expression> truths = {writer.body().region};
  for (const std::size_t other : claim.claims) {
    truths.push_back(opposite(writer.claims().claims[other].body(writer.reading()).region));
  }
  writer.somewhere(suffix, truths, {});
}

void refute(ClaimWriter& writer, const ForceCover& claim) {
  writer.somewhere(suffix, {writer.body().region, claim.forces, opposite(writer.in_one_of(claim.claims, true))}, {});
}

/// Whether a strict motion in one mode may be a motion in another one, by other forces.
bool may_be_in_several(const ClaimWriter& writer) {
  return writer.mechanics().may_leave_forces_open();
}

/// A motion in none of the modes; gives up where they are all modes there are. Strict motions are in one mode only; a
/// boundary motion may be in one that is listed, too, so that the conditions of these have to fail.
void refute(ClaimWriter& writer, const Motions& claim) {
  const bool strict = writer.setting().strict;
  std::string in_none;
  if (!strict || may_be_in_several(writer)) {
    for (const MechanismMode& mode : claim.modes)
      in_none += fmt::format(" and {{{}}}", writer.mechanics().mode_missed_text(mode));
  }
  std::vector<ModeAndMore> others;
  for (const MechanismMode& mode : writer.mechanics().modes()) {
    if (!lists(claim.modes, mode)) others.emplace_back(mode, in_none);
  }
  if (others.empty()) writer.give_up();
  writer.somewhere(suffix, {writer.body().region, claim.forces}, {one_of(writer, others, strict)});
}

/// What a condition compares and may have no value.
void collect_unvalued(const ClaimWriter& writer, const Expression& e, std::vector<Expression>& found) {
  const bool number = sort(*e) == Sort::number;
  if (number && !writer.always_defined(e)) found.push_back(e);
  if (number) return;
  for (const Expression& operand : e->operands) collect_unvalued(writer, operand, found);
}

/// In the region, the forces have a value at every force. Gives up where that may depend on the force.
Expression valued_at_all(ClaimWriter& writer, const Expression& region, const Expression& forces) {
  std::vector<Expression> unvalued;
  collect_unvalued(writer, forces, unvalued);
  Expression valued = make_truth(true);
  for (const Expression& e : unvalued) {
    if (writer.depends_on_force(e)) writer.give_up();
    valued = both(valued, make_comparison({e, e}, {Relation::less_equal}));
  }
  return is_true(region) ? valued : make(Operation::logical_or, {opposite(region), valued});
}

/// A strict motion, which is in one mode only, where a claim states another mode; or where no claim is near, and its
/// mode is not listed. Gives up where no mode is wrong anywhere.
void refute(ClaimWriter& writer, const Unique& claim) {
  const auto other = [&](std::size_t index) -> const ClaimBody& {
    return writer.claims().claims[index].body(writer.reading());
  };
  const auto forces = [&](std::size_t index) { return *parts(other(index), BodyPart::forces).front(); };
  const auto beyond = [&](std::size_t index) { return opposite(both(other(index).region, closure(forces(index)))); };
  std::vector<Expression> truths = {writer.body().region, claim.forces}, uses;
  for (const std::size_t index : claim.except) truths.push_back(beyond(index));
  Expression near_none = make_truth(true);
  for (const std::size_t index : claim.claims) near_none = both(near_none, beyond(index));
  // In none of `right`, which where the motion's own mode is another one is plain, but for undetermined forces.
  const auto in_none = [&](const Expression& where, const Modes& right) {
    std::string text = writer.text(where);
    for (const MechanismMode& mode : right) text += " and {" + writer.mechanics().mode_missed_text(mode) + "}";
    return "{" + text + "}";
  };
  std::vector<ModeAndMore> wrong;
  for (const MechanismMode& mode : writer.mechanics().modes()) {
    Expression where = lists(claim.modes, mode) ? nullptr : near_none;
    std::vector<std::string> parts;
    if (where) parts.push_back(in_none(near_none, claim.modes));
    for (const std::size_t index : claim.claims) {
      const Modes right = modes(other(index).says);
      if (right.front() == mode) continue;
      const Expression stated = both(other(index).region, forces(index));
      where = where ? make(Operation::logical_or, {where, stated}) : stated;
      parts.push_back(in_none(stated, right));
    }
    if (!where) continue;
    uses.push_back(where);
    const std::string text = may_be_in_several(writer) ? fmt::format("{}", fmt::join(parts, " or "))
                             : is_true(where)          ? ""
                                                       : writer.text(where);
    wrong.emplace_back(mode, text.empty() ? "" : " and {" + text + "}");
  }
  if (wrong.empty()) writer.give_up();
  References named = claim.claims;  // where one of them has no value, even at another force, nothing is claimed
  named.insert(named.end(), claim.except.begin(), claim.except.end());
  for (const std::size_t index : named) {
    if (!writer.always_defined(other(index).region)) writer.give_up();
    if (!writer.always_defined(forces(index)))
      truths.push_back(valued_at_all(writer, other(index).region, forces(index)));
  }
  writer.somewhere(suffix, truths, {one_of(writer, wrong, true)}, uses);
}

void refute(ClaimWriter& writer, const Equivalence& claim) {
  writer.somewhere(suffix,
                   {writer.body().region, make(Operation::logical_or, {both(claim.forces, opposite(claim.holds)),
                                                                       both(claim.holds, opposite(claim.forces))})},
                   {});
}

/// Also of a system: that one direction fails.
void refute(ClaimWriter& writer, const LinearEquations& claim) {
  References sources = claim.given;
  sources.insert(sources.end(), claim.claims.begin(), claim.claims.end());
  const Equations assumed = equations_of(writer, sources, claim.assume);
  std::vector<MotionText> motions = {{"", "0 = 0"}};
  if (claim.from_model()) motions = {writer.equations(claim.mode)};
  std::vector<Expression> truths = {writer.body().region, opposite(all_of(claim.equations))};
  truths.insert(truths.end(), assumed.begin(), assumed.end());
  writer.somewhere(suffix, truths, motions);
}

/// There is none anywhere.
void refute(ClaimWriter& writer, const Exists& claim) {
  const ClaimWriter::Assumptions assumptions = {{"region", writer.body().region}, {"force", claim.forces}};
  writer.have_values(std::string(suffix) + ".defined", writer.body().region, claim.forces);
  if (claim.modes.size() == 1) {
    writer.implied({suffix, assumptions, writer.motion(claim.modes.front())}, make_truth(false));
    return;
  }
  std::vector<MotionText> motions;
  for (const MechanismMode& mode : claim.modes) motions.push_back(writer.motion(mode));
  writer.impossible_together(suffix, assumptions, motions);
}

/// That it fails however large the parameter is has no statement.
void refute(ClaimWriter&, const Limit&) {}

}  // namespace

std::vector<NamedStatement> claim_refutation(const ClaimsFile& claims, const Claim& claim, Reading reading) {
  ClaimWriter writer(claims, claim, reading);
  std::visit([&](const auto& kind) { refute(writer, kind); }, writer.body().says);
  return writer.take();
}

std::vector<NamedStatement> expected_statements(const ClaimsFile& claims, const Claim& claim, Reading reading) {
  const Expectation expect = claim.body(reading).expect;
  if (expect == Expectation::undecided) return {};
  return expect == Expectation::refuted ? claim_refutation(claims, claim, reading)
                                        : claim_statements(claims, claim, reading);
}

std::vector<NamedStatement> paper_statements(const ClaimsFile& claims) {
  std::vector<NamedStatement> result;
  std::map<std::string, const Claim*> claim_of;
  for (const Claim& claim : claims.claims) {
    for (const Reading reading : all_readings) {
      if (reading == Reading::repaired && !claim.repaired) continue;
      for (NamedStatement& statement : expected_statements(claims, claim, reading)) {
        const auto [other, is_new] = claim_of.emplace(statement.name, &claim);
        if (!is_new) {
          throw InputError({{claims.file, 0, 0,
                             "the claims " + other->second->id + " and " + claim.id + " both have a statement " +
                                 statement.name + ", expected ids whose statements have names of their own"}});
        }
        result.push_back(std::move(statement));
      }
    }
  }
  return result;
}

}  // namespace slipproof
