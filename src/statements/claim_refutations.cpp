// For refuted claims: that there is a counterexample, as a theorem.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "statements/claim_writer.hpp"
#include "statements/truth_text.hpp"

namespace slipproof {
namespace {

/// A motion in one of `modes`, each with what else is to hold of it.
MotionText one_of(const ClaimWriter& writer, const std::vector<std::pair<ContactMode, std::string>>& modes) {
  MotionText result{mechanics_text(writer.setting().force_kind), ""};
  for (const Wheel wheel : {Wheel::rear, Wheel::front}) {
    for (const ContactState state : all_contact_states) {
      result.definitions += state_definition(wheel, state, writer.setting().strict);
    }
  }
  std::vector<std::string> parts;
  for (const auto& [mode, more] : modes) parts.push_back("{" + mode_text(mode) + more + "}");
  result.formula = fmt::format("{} and {{{}}}", dynamics, fmt::join(parts, " or "));
  return result;
}

Expression both(const Expression& x, const Expression& y) {
  return make(Operation::logical_and, {x, y});
}

/// Modes in which a motion would contradict the claim, with the condition under which it would.
std::vector<std::pair<ContactMode, std::string>> unlisted(ClaimWriter& writer, std::vector<Expression>& uses) {
  const ClaimBody& body = writer.body();
  std::vector<std::pair<ContactMode, std::string>> result;
  for (const ContactMode mode : all_modes()) {
    if (std::find(body.modes.begin(), body.modes.end(), mode) != body.modes.end()) continue;
    std::string unless;
    for (const std::size_t index : body.claims) {
      const ClaimBody& other = writer.claims().claims[index].body(writer.reading());
      if (other.modes.front() != mode) continue;
      const Expression elsewhere = opposite(both(other.region, other.forces));
      uses.push_back(elsewhere);
      unless += fmt::format(" and {{{}}}", writer.text(elsewhere));
    }
    result.emplace_back(mode, unless);
  }
  return result;
}

}  // namespace

std::vector<NamedStatement> claim_refutation(const ClaimsFile& claims, const Claim& claim, Reading reading) {
  ClaimWriter writer(claims, claim, reading);
  const ClaimBody& body = writer.body();
  const std::string suffix = ".refuted";
  const std::optional<ContactMode> mode = body.modes.empty() ? std::nullopt : std::optional(body.modes.front());
  switch (claim.kind) {
    case ClaimKind::interval:
      writer.somewhere(suffix, {body.region, opposite(body.forces)}, {writer.motion(*mode)});
      break;
    case ClaimKind::formula: {
      const std::vector<Expression> truths = {body.region, body.forces, opposite(body.holds)};
      writer.somewhere(suffix, truths, mode ? std::vector{writer.motion(*mode)} : std::vector<MotionText>{});
      break;
    }
    case ClaimKind::impossible: {
      std::vector<std::pair<ContactMode, std::string>> modes;
      for (const ContactMode m : body.modes) modes.emplace_back(m, "");
      writer.somewhere(suffix, {body.region, body.forces}, {one_of(writer, modes)});
      break;
    }
    case ClaimKind::cover: {
      std::vector<Expression> truths = {body.region};
      for (const std::size_t other : body.claims) {
        truths.push_back(opposite(claims.claims[other].body(writer.reading()).region));
      }
      writer.somewhere(suffix, truths, {});
      break;
    }
    case ClaimKind::motions:
    case ClaimKind::unique: {
      std::vector<Expression> uses;
      const auto modes = unlisted(writer, uses);
      std::vector<Expression> truths = {body.region, body.forces};
      for (const std::size_t other : body.except) {
        const ClaimBody& excepted = claims.claims[other].body(writer.reading());
        truths.push_back(opposite(both(excepted.region, excepted.forces)));
      }
      writer.somewhere(suffix, truths, {one_of(writer, modes)}, uses);
      break;
    }
    case ClaimKind::equivalence:
      writer.somewhere(suffix,
                       {body.region, make(Operation::logical_or, {both(body.forces, opposite(body.holds)),
                                                                  both(body.holds, opposite(body.forces))})},
                       {});
      break;
    case ClaimKind::consequence:
    case ClaimKind::system: {
      std::vector<Expression> assumed = equations_of(writer, body.given, {});
      const std::vector<Expression> claimed = equations_of(writer, body.claims, body.assume);
      assumed.insert(assumed.end(), claimed.begin(), claimed.end());
      std::vector<MotionText> motions = {{"", "0 = 0"}};
      if (body.given.empty() && body.claims.empty()) motions = {writer.equations(mode)};
      std::vector<Expression> truths = {body.region, opposite(all_of(body.equations))};
      truths.insert(truths.end(), assumed.begin(), assumed.end());
      writer.somewhere(suffix, truths, motions);
      break;
    }
    case ClaimKind::exists:
      for (std::size_t i = 0; i < body.modes.size(); ++i) {
        if (body.modes.size() > 1) writer.give_up();
        writer.implied({suffix, {{"region", body.region}, {"force", body.forces}}, writer.motion(body.modes[i])},
                       make_truth(false));
      }
      break;
    case ClaimKind::limit:
      break;
  }
  return writer.take();
}

std::vector<NamedStatement> paper_statements(const ClaimsFile& claims) {
  std::vector<NamedStatement> result;
  for (const Claim& claim : claims.claims) {
    for (const Reading reading : all_readings) {
      if (reading == Reading::repaired && !claim.repaired) continue;
      const Expectation expect = claim.body(reading).expect;
      if (expect == Expectation::undecided) continue;
      for (NamedStatement& statement : expect == Expectation::refuted ? claim_refutation(claims, claim, reading)
                                                                      : claim_statements(claims, claim, reading)) {
        result.push_back(std::move(statement));
      }
    }
  }
  return result;
}

}  // namespace slipproof
