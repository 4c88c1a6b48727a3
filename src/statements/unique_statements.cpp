#include "statements/unique_statements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "statements/truth_text.hpp"

namespace slipproof {
namespace {

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

}  // namespace

void unique_statements(ClaimWriter& writer) {
  const ClaimBody& body = writer.body();
  const auto other = [&](std::size_t index) -> const ClaimBody& {
    return writer.claims().claims[index].body(writer.reading());
  };
  const auto beyond = [&](std::size_t index) {
    return opposite(make(Operation::logical_and, {other(index).region, with_ends(writer, other(index).forces)}));
  };
  ClaimWriter::Assumptions common = {{"region", body.region}, {"force", body.forces}};
  for (std::size_t i = 0; i < body.except.size(); ++i) {
    common.emplace_back(fmt::format("not_excepted{}", i + 1), beyond(body.except[i]));
  }
  const MotionText motion = writer.any_motion();
  const std::string hints = writer.hints_to_numbers();
  ClaimWriter::Assumptions rest = common;
  std::vector<Expression> regions;
  for (const std::size_t index : body.claims) {
    const ClaimBody& stated = other(index);
    ClaimWriter::Assumptions assumptions = common;
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
    ClaimWriter::Assumptions here = rest;
    here.emplace(here.begin(), "cell", cells[i]);
    writer.implied({fmt::format(".rest.{}", i + 1), here, motion, true, hints}, shown, {});
    writer.exists({fmt::format(".rest.exists.{}", i + 1), here, {}, true, hints}, some_motion);
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

}  // namespace slipproof
