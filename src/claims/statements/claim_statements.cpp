#include "claims/statements/claim_statements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/expression/logic.hpp"
#include "claims/statements/claim_writer.hpp"
#include "claims/statements/unique_statements.hpp"

namespace slipproof {
namespace {

using Assumptions = ClaimWriter::Assumptions;

// The sentences are those of proofs/MEANING.md, kind by kind.

void write(ClaimWriter& writer, const Interval& claim) {
  const Expression& region = writer.body().region;
  writer.implied(
      {".only-then", {{"region", region}}, writer.motion(claim.mode), true, {}, writer.always_defined(claim.forces)},
      claim.forces);
  writer.exists({".always", {{"region", region}, {"force", claim.forces}}, {}, true, {}, true},
                writer.motion(claim.mode));
  writer.have_values(".defined", region, claim.forces);
}

/// Of the motions in each mode.
void implied_of_each(ClaimWriter& writer, const Modes& modes, const Expression& forces, const Expression& shown) {
  const Assumptions assumptions = {{"region", writer.body().region}, {"force", forces}};
  const bool refutes = writer.always_defined(shown);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const std::string suffix = modes.size() == 1 ? "" : fmt::format(".{}", i + 1);
    writer.implied({suffix, assumptions, writer.motion(modes[i]), true, {}, refutes}, shown);
  }
  if (modes.empty()) writer.implied({"", assumptions, {}, true, {}, refutes}, shown);
  writer.have_values(".defined", writer.body().region, forces);
}

void write(ClaimWriter& writer, const Impossible& claim) {
  implied_of_each(writer, claim.modes, claim.forces, make_truth(false));
}

void write(ClaimWriter& writer, const Formula& claim) {
  implied_of_each(writer, claim.modes, claim.forces, claim.holds);
}

void write(ClaimWriter& writer, const Cover& claim) {
  writer.implied({"", {{"region", writer.body().region}}, {}, false}, writer.in_one_of(claim.claims, false));
  writer.have_values(".defined", writer.body().region, make_truth(true));
}

void write(ClaimWriter& writer, const ForceCover& claim) {
  implied_of_each(writer, {}, claim.forces, writer.in_one_of(claim.claims, true));
}

void write(ClaimWriter& writer, const Motions& claim) {
  const Assumptions assumptions = {{"region", writer.body().region}, {"force", claim.forces}};
  const bool strict = writer.setting().strict;
  std::vector<std::string> modes;
  for (std::size_t i = 0; i < claim.modes.size(); ++i) {
    const MechanismMode& mode = claim.modes[i];
    writer.exists({fmt::format(".{}", i + 1), assumptions, {}, true, {}, true}, writer.motion(mode));
    writer.one_motion(fmt::format(".{}.one", i + 1), assumptions, mode, mode, strict);
    modes.push_back("{" + writer.mechanics().mode_text(mode) + "}");
  }
  if (!strict && writer.mechanics().may_leave_forces_open() && !claim.modes.empty()) {
    writer.same_as_one_of(".complete", assumptions, claim.modes);
  } else {
    writer.implied({".complete", assumptions, writer.any_motion(strict)}, fmt::format("{}", fmt::join(modes, " or ")),
                   {});
  }
  writer.have_values(".defined", writer.body().region, claim.forces);
}

void write(ClaimWriter& writer, const Equivalence& claim) {
  const Expression& region = writer.body().region;
  writer.implied(
      {".forwards", {{"region", region}, {"force", claim.forces}}, {}, true, {}, writer.always_defined(claim.holds)},
      claim.holds);
  writer.implied(
      {".backwards", {{"region", region}, {"force", claim.holds}}, {}, true, {}, writer.always_defined(claim.forces)},
      claim.forces);
  writer.have_values(".defined", region, claim.forces);
  writer.has_value(".defined.holds", {{"region", region}}, claim.holds);
}

std::string conjunction(ClaimWriter& writer, const std::vector<Expression>& equations) {
  std::vector<std::string> texts;
  for (const Expression& equation : equations) {
    texts.push_back(writer.text(equation));
    if (texts.back().find(" or ") != std::string::npos) texts.back() = "{" + texts.back() + "}";  // functions as cases
  }
  return fmt::format("{}", fmt::join(texts, " and "));
}

/// The hypotheses of a claim of equations, with the equations of claims and of `assume` among them as `others`.
MotionText hypotheses(ClaimWriter& writer, const LinearEquations& claim, const Equations& others) {
  MotionText result{"", ""};
  if (claim.from_model()) result = writer.equations(claim.mode);
  if (!others.empty()) result.formula += (result.formula.empty() ? "" : " and ") + conjunction(writer, others);
  return result;
}

/// That equations divide by nothing that vanishes, for any numbers in place of the unknowns.
void equations_have_values(ClaimWriter& writer, const Equations& equations) {
  Equations divided;
  for (const Expression& e : equations) {
    if (!writer.always_defined(e)) divided.push_back(e);
  }
  if (divided.empty()) return;
  const Expression all = all_of(divided);
  std::string shown;
  for (const Expression& e : divided) {
    const Expression valued = make(Operation::logical_or, {e, opposite(e)});
    shown += (shown.empty() ? "{" : " and {") + writer.text(valued) + "}";
  }
  writer.implied({".defined", {{"region", writer.body().region}}, MotionText{"", "0 = 0"}, false}, shown, {all});
}

/// As linear equations, in the force too, so that it is any.
void write(ClaimWriter& writer, const Consequence& claim) {
  References sources = claim.given;
  sources.insert(sources.end(), claim.claims.begin(), claim.claims.end());
  const Expression shown = all_of(claim.equations);
  const Equations others = equations_of(writer, sources, claim.assume);
  std::vector<Expression> uses = others;
  uses.push_back(shown);
  const Expression& region = writer.body().region;
  writer.implied({"", {{"region", region}}, hypotheses(writer, claim, others), false},
                 conjunction(writer, claim.equations), uses);
  writer.has_value(".defined.region", {}, region);
  equations_have_values(writer, others);
}

bool occurs(std::string_view unknown, const Equations& equations) {
  return std::any_of(equations.begin(), equations.end(), [&](const Expression& equation) {
    const std::vector<std::string> names = symbols(equation);
    return std::find(names.begin(), names.end(), unknown) != names.end();
  });
}

/// The consequence; and conversely: what meets the equations (and those given) can be completed to what they follow
/// from.
void write(ClaimWriter& writer, const System& claim) {
  const Expression& region = writer.body().region;
  const Equations right = equations_of(writer, claim.given, claim.equations);
  Equations left = equations_of(writer, claim.given, {});
  const Equations claimed = equations_of(writer, claim.claims, claim.assume);
  left.insert(left.end(), claimed.begin(), claimed.end());
  const MotionText motion = hypotheses(writer, claim, left);
  std::vector<Expression> uses = left;
  uses.insert(uses.end(), right.begin(), right.end());
  writer.implied({".forwards", {{"region", region}}, motion, false}, conjunction(writer, claim.equations), uses);
  std::vector<std::string> others;
  for (const auto& unknown : writer.mechanics().unknowns()) {
    if (!occurs(unknown, right)) others.emplace_back(unknown);
  }
  if (others.empty()) {
    writer.implied(
        {".backwards", {{"region", region}}, MotionText{motion.definitions, conjunction(writer, right)}, false},
        motion.formula, uses);
  } else {
    writer.exists({".backwards", {{"region", region}, {"equations", all_of(right)}}, {}, false}, others, motion, left);
  }
  writer.has_value(".defined.region", {}, region);
  equations_have_values(writer, uses);
}

/// From a value of the parameter on that the others determine; that it is defined, and that there is something beyond.
void write(ClaimWriter& writer, const Limit& claim) {
  if (!claim.from) return;
  const Expression& region = writer.body().region;
  const Expression beyond = make_comparison({claim.from, make_symbol(claim.parameter)}, {Relation::less});
  writer.implied({".eventually", {{"region", region}, {"beyond", beyond}}, {}, false}, claim.holds);
  const Expression defined = make_comparison({claim.from, claim.from}, {Relation::equal});
  writer.implied({".from", {{"region", region}}, {}, false}, defined);
  writer.goes_beyond(".beyond", claim.parameter, claim.from);
  writer.has_value(".defined", {{"beyond", beyond}}, region);
}

void write(ClaimWriter& writer, const Exists& claim) {
  std::vector<MotionText> motions;
  for (const MechanismMode& mode : claim.modes) motions.push_back(writer.motion(mode));
  writer.somewhere("", {writer.body().region, claim.forces}, motions);
}

void write(ClaimWriter& writer, const Unique& claim) {
  unique_statements(writer, claim);
}

}  // namespace

std::vector<NamedStatement> claim_statements(const ClaimsFile& claims, const Claim& claim, Reading reading) {
  ClaimWriter writer(claims, claim, reading);
  std::visit([&](const auto& kind) { write(writer, kind); }, writer.body().says);
  return writer.take();
}

}  // namespace slipproof
