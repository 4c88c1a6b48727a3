#include "prove/claim_statements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "prove/claim_writer.hpp"
#include "prove/truth_text.hpp"

namespace slipproof {
namespace {

using Assumptions = std::vector<std::pair<std::string, Expression>>;

const std::vector<std::string>& all_unknowns() {
  static const std::vector<std::string> result(motion_unknowns.begin(), motion_unknowns.end());
  return result;
}

void interval(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  const ContactMode mode = body.modes.front();
  writer.implied({".only-then", {{"region", body.region}}, writer.motion(mode)}, body.forces);
  writer.exists({".always", {{"region", body.region}, {"force", body.forces}}, {}}, all_unknowns(),
                writer.motion(mode));
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
    writer.exists({fmt::format(".{}", i + 1), assumptions, {}}, all_unknowns(), writer.motion(body.modes[i]));
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

void exists(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  std::vector<MotionText> motions;
  for (const ContactMode mode : body.modes) motions.push_back(writer.motion(mode));
  writer.somewhere("", {body.region, body.forces}, motions);
}

/// Whether the number is the force, or it times a parameter that is positive by its domain.
bool is_force(const Setting& setting, const Expression& number) {
  if (number->operation == Operation::symbol) return number->symbol == setting.force.symbol;
  if (number->operation != Operation::multiply) return false;
  const Expression &left = number->operands[0], &right = number->operands[1];
  if (right->operation != Operation::symbol) return false;
  return is_force(setting, left) &&
         std::any_of(setting.parameters.begin(), setting.parameters.end(), [&](const Parameter& parameter) {
           return parameter.symbol == right->symbol && parameter.domain &&
                  to_string(parameter.domain) == parameter.symbol + " > 0";
         });
}

bool depends_on_force(const Setting& setting, Reading reading, const Expression& number) {
  const std::vector<std::string> names = symbols(number);
  return std::any_of(names.begin(), names.end(), [&](const std::string& symbol) {
    if (symbol == setting.force.symbol) return true;
    const auto defined = std::find_if(setting.definitions.begin(), setting.definitions.end(),
                                      [&](const Definition& d) { return d.symbol == symbol; });
    if (defined == setting.definitions.end()) return false;
    const bool repaired = reading == Reading::repaired && defined->repaired;
    return depends_on_force(setting, reading, repaired ? defined->repaired : defined->printed);
  });
}

/// The forces of a claim and their ends: no more than one force for each comparison. Gives up where it could be more.
Expression with_ends(ClaimWriter& writer, const Expression& truth) {
  switch (truth->operation) {
    case Operation::truth:
      return truth;
    case Operation::logical_not:
      return with_ends(writer, opposite(truth->operands[0]));
    case Operation::compare: {
      std::vector<Relation> relations = truth->relations;
      for (std::size_t i = 0; i < relations.size(); ++i) {
        const Expression &left = truth->operands[i], &right = truth->operands[i + 1];
        const Setting& setting = writer.setting();
        const bool one_force = (is_force(setting, left) && !depends_on_force(setting, writer.reading(), right)) ||
                               (is_force(setting, right) && !depends_on_force(setting, writer.reading(), left));
        if (!one_force) writer.give_up();
        if (relations[i] == Relation::less) relations[i] = Relation::less_equal;
        if (relations[i] == Relation::greater) relations[i] = Relation::greater_equal;
      }
      return make_comparison(truth->operands, std::move(relations));
    }
    default:
      return make(truth->operation, {with_ends(writer, truth->operands[0]), with_ends(writer, truth->operands[1])});
  }
}

/// Where a claim states a motion there is no other; and beyond the claims there is one of the modes listed, and no
/// other, and no two of these at once. What is beyond all claims is shown cell by cell, between the boundaries in their
/// regions, and that the cells are all there is.
void unique(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  const auto other = [&](std::size_t index) -> const ClaimBody& {
    return writer.claims().claims[index].body(writer.reading());
  };
  const auto beyond = [&](std::size_t index) {
    return opposite(make(Operation::logical_and, {other(index).region, with_ends(writer, other(index).forces)}));
  };
  Assumptions common = {{"region", body.region}, {"force", body.forces}};
  for (std::size_t i = 0; i < body.except.size(); ++i) {
    common.emplace_back(fmt::format("not_excepted{}", i + 1), beyond(body.except[i]));
  }
  const MotionText motion = writer.any_motion();
  const std::string hints = writer.hints_to_numbers();
  Assumptions rest = common;
  std::vector<Expression> regions;
  for (const std::size_t index : body.claims) {
    const ClaimBody& stated = other(index);
    Assumptions assumptions = common;
    assumptions.emplace_back("stated", make(Operation::logical_and, {stated.region, stated.forces}));
    const std::string& id = writer.claims().claims[index].id;
    writer.implied({"." + id, assumptions, motion, true, hints}, mode_text(stated.modes.front()), {});
    rest.emplace_back("beyond_" + id, beyond(index));
    regions.push_back(stated.region);
  }
  std::vector<std::string> modes;
  for (const ContactMode mode : body.modes) modes.push_back("{" + mode_text(mode) + "}");
  const std::string listed = fmt::format("{}", fmt::join(modes, " or "));
  // Where all states of the rear wheel are listed, as in */lift, only the front wheel has something to show.
  const bool any_rear = std::all_of(body.modes.begin(), body.modes.end(),
                                    [&](ContactMode mode) { return mode.front == body.modes.front().front; }) &&
                        body.modes.size() == all_contact_states.size();
  const std::string shown = any_rear ? state_name(Wheel::front, body.modes.front().front) : listed;
  const MotionText some_motion{motion.definitions, std::string(dynamics) + " and {" + listed + "}"};
  const std::vector<Expression> cells = writer.cells(regions);
  Expression any_cell;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Assumptions here = rest;
    here.emplace(here.begin(), "cell", cells[i]);
    writer.implied({fmt::format(".rest.{}", i + 1), here, motion, true, hints}, shown, {});
    writer.exists({fmt::format(".rest.exists.{}", i + 1), here, {}, true, hints}, all_unknowns(), some_motion);
    any_cell = any_cell ? make(Operation::logical_or, {any_cell, cells[i]}) : cells[i];
  }
  writer.implied({".rest.cells", {}, {}}, any_cell);
  for (std::size_t i = 0; i < body.modes.size(); ++i) {
    for (std::size_t k = i + 1; k < body.modes.size(); ++k) {
      writer.impossible_together(fmt::format(".rest.one.{}-{}", i + 1, k + 1), common,
                                 {writer.motion(body.modes[i]), writer.motion(body.modes[k])});
    }
  }
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
      unique(writer);
      break;
    case ClaimKind::limit:
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
