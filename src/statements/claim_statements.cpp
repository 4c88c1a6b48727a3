#include "statements/claim_statements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "statements/claim_writer.hpp"
#include "statements/unique_statements.hpp"

namespace slipproof {
namespace {

using Assumptions = ClaimWriter::Assumptions;

void interval(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  const ContactMode mode = body.modes.front();
  writer.implied({".only-then", {{"region", body.region}}, writer.motion(mode)}, body.forces);
  writer.exists({".always", {{"region", body.region}, {"force", body.forces}}, {}}, writer.motion(mode));
}

void impossible(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  for (std::size_t i = 0; i < body.modes.size(); ++i) {
    writer.implied({body.modes.size() == 1 ? "" : fmt::format(".{}", i + 1),
                    {{"region", body.region}, {"force", body.forces}},
                    writer.motion(body.modes[i])},
                   make_truth(false));
  }
}

void formula(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  const Assumptions assumptions = {{"region", body.region}, {"force", body.forces}};
  if (body.modes.empty()) writer.implied({"", assumptions, {}}, body.holds);
  for (std::size_t i = 0; i < body.modes.size(); ++i) {
    writer.implied({body.modes.size() == 1 ? "" : fmt::format(".{}", i + 1), assumptions, writer.motion(body.modes[i])},
                   body.holds);
  }
}

void cover(ClaimWriter& writer) {
  Expression regions;
  for (const std::size_t other : writer.body().claims) {
    const Expression& region = writer.claims().claims[other].body(writer.reading()).region;
    regions = regions ? make(Operation::logical_or, {regions, region}) : region;
  }
  writer.implied({"", {{"region", writer.body().region}}, {}}, regions);
}

void motions(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  const Assumptions assumptions = {{"region", body.region}, {"force", body.forces}};
  std::vector<std::string> modes;
  for (std::size_t i = 0; i < body.modes.size(); ++i) {
    writer.exists({fmt::format(".{}", i + 1), assumptions, {}}, writer.motion(body.modes[i]));
    modes.push_back("{" + mode_text(body.modes[i]) + "}");
  }
  writer.implied({".complete", assumptions, writer.any_motion()}, fmt::format("{}", fmt::join(modes, " or ")), {});
}

void equivalence(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  writer.implied({".forwards", {{"region", body.region}, {"force", body.forces}}, {}}, body.holds);
  writer.implied({".backwards", {{"region", body.region}, {"force", body.holds}}, {}}, body.forces);
}

std::string conjunction(ClaimWriter& writer, const std::vector<Expression>& equations) {
  std::vector<std::string> texts;
  for (const Expression& equation : equations) texts.push_back(writer.text(equation));
  return fmt::format("{}", fmt::join(texts, " and "));
}

/// Equations that follow from the model's or from others; as linear equations, in the force too, so that it is any.
void consequence(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  const bool from_model = body.given.empty() && body.claims.empty();
  std::vector<std::size_t> sources = body.given;
  sources.insert(sources.end(), body.claims.begin(), body.claims.end());
  const Expression shown = all_of(body.equations);
  MotionText motion{"", ""};
  if (from_model) {
    motion = writer.equations(body.modes.empty() ? std::nullopt : std::optional(body.modes.front()));
  }
  const std::vector<Expression> others = equations_of(writer, sources, body.assume);
  if (!others.empty()) {
    motion.formula += (motion.formula.empty() ? "" : " and ") + conjunction(writer, others);
  }
  std::vector<Expression> uses = others;
  uses.push_back(shown);
  writer.implied({"", {{"region", body.region}}, motion, false}, writer.text(shown), uses);
}

bool occurs(std::string_view unknown, const std::vector<Expression>& equations) {
  return std::any_of(equations.begin(), equations.end(), [&](const Expression& equation) {
    const std::vector<std::string> names = symbols(equation);
    return std::find(names.begin(), names.end(), unknown) != names.end();
  });
}

/// The consequence; and conversely: what meets the equations (and those given) can be completed to what they follow
/// from.
void system(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  const std::vector<Expression> given = equations_of(writer, body.given, {});
  std::vector<Expression> right = given;
  right.insert(right.end(), body.equations.begin(), body.equations.end());
  const std::vector<Expression> claimed = equations_of(writer, body.claims, body.assume);
  std::vector<Expression> left = given;
  left.insert(left.end(), claimed.begin(), claimed.end());
  MotionText motion{"", ""};
  if (body.given.empty() && body.claims.empty()) motion = writer.equations(std::nullopt);
  if (!left.empty()) motion.formula += (motion.formula.empty() ? "" : " and ") + conjunction(writer, left);
  std::vector<Expression> uses = left;
  uses.insert(uses.end(), right.begin(), right.end());
  writer.implied({".forwards", {{"region", body.region}}, motion, false}, conjunction(writer, body.equations), uses);
  std::vector<std::string> others;
  for (const auto& unknown : motion_unknowns) {
    if (!occurs(unknown, right)) others.emplace_back(unknown);
  }
  const Assumptions assumptions = {{"region", body.region}, {"equations", all_of(right)}};
  if (others.empty()) {
    writer.implied(
        {".backwards", {{"region", body.region}}, MotionText{motion.definitions, conjunction(writer, right)}, false},
        motion.formula, uses);
  } else {
    writer.exists({".backwards", assumptions, {}, false}, others, motion, left);
  }
}

/// From a value of the parameter on that the others determine; and that it is defined.
void limit(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  if (!body.from) return;
  const Expression beyond = make_comparison({body.from, make_symbol(body.parameter)}, {Relation::less});
  writer.implied({".eventually", {{"region", body.region}, {"beyond", beyond}}, {}}, body.holds);
  const Expression defined = make_comparison({body.from, body.from}, {Relation::equal});
  writer.implied({".from", {{"region", body.region}}, {}}, defined);
}

void exists(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  std::vector<MotionText> motions;
  for (const ContactMode mode : body.modes) motions.push_back(writer.motion(mode));
  writer.somewhere("", {body.region, body.forces}, motions);
}

}  // namespace

std::vector<NamedStatement> claim_statements(const ClaimsFile& claims, const Claim& claim, Reading reading) {
  ClaimWriter writer(claims, claim, reading);
  switch (claim.kind) {
    case ClaimKind::interval:
      interval(writer);
      break;
    case ClaimKind::impossible:
      impossible(writer);
      break;
    case ClaimKind::formula:
      formula(writer);
      break;
    case ClaimKind::cover:
      cover(writer);
      break;
    case ClaimKind::motions:
      motions(writer);
      break;
    case ClaimKind::equivalence:
      equivalence(writer);
      break;
    case ClaimKind::consequence:
      consequence(writer);
      break;
    case ClaimKind::system:
      system(writer);
      break;
    case ClaimKind::exists:
      exists(writer);
      break;
    case ClaimKind::unique:
      unique_statements(writer);
      break;
    case ClaimKind::limit:
      limit(writer);
      break;
  }
  std::vector<NamedStatement> result = writer.take();
  if (claim.kind != ClaimKind::unique || result.empty()) return result;
  for (const std::size_t stated : writer.body().claims) {  // that the motions exist, of which there are no others
    for (NamedStatement& statement : claim_statements(claims, claims.claims[stated], reading)) {
      if (statement.name.ends_with(".always")) result.push_back(std::move(statement));
    }
  }
  return result;
}

}  // namespace slipproof
