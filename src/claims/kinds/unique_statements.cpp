#include "claims/kinds/unique_statements.hpp"

#include <fmt/format.h>

#include "claims/kinds/kind_base.hpp"

namespace slipproof {
namespace {

/// Whether the number is the force, or the force times a parameter that is positive by its domain.
bool is_force(const Setting& setting, const Expression& number) {
  if (number->operation == Operation::symbol) return number->symbol == setting.force.symbol;
  if (number->operation != Operation::multiply) return false;
  const Expression &left = number->operands[0], &right = number->operands[1];
  if (right->operation != Operation::symbol) return false;
  return is_force(setting, left) &&
         std::any_of(setting.parameters.begin(), setting.parameters.end(), [&](const FreeParameter& parameter) {
           return parameter.symbol == right->symbol && parameter.is_positive();
         });
}

/// Whether the two sides of each strict comparison are equal at one force at most, so that the closure adds only single
/// forces.
bool has_single_ends(const ClaimWriter& writer, const Expression& truth) {
  const auto inner = [&](const Expression& e) { return has_single_ends(writer, e); };
  if (truth->operation == Operation::truth) return true;
  if (truth->operation != Operation::compare) {
    return std::all_of(truth->operands.begin(), truth->operands.end(), inner);
  }
  const Setting& setting = writer.setting();
  for (std::size_t i = 0; i + 1 < truth->operands.size(); ++i) {
    const Expression &left = truth->operands[i], &right = truth->operands[i + 1];
    const Relation relation = truth->relations[i];
    if (relation == Relation::less_equal || relation == Relation::greater_equal || relation == Relation::equal)
      continue;
    const bool single = (is_force(setting, left) && !writer.depends_on_force(right)) ||
                        (is_force(setting, right) && !writer.depends_on_force(left));
    if (!single) return false;
  }
  return true;
}

class UniqueWriter {
 public:
  explicit UniqueWriter(ClaimWriter& writer) : writer_(writer), claim_(writer.body()) {}

  void write() {
    common_ = {{"region", claim_.region}, {"force", claim_.forces}};
    for (std::size_t i = 0; i < claim_.except.size(); ++i) {
      common_.emplace_back(fmt::format("not_excepted{}", i + 1), beyond(claim_.except[i]));
    }
    for (const std::size_t other : claim_.claims) write_stated(other);
    write_rest();
    write_values();
  }

 private:
  const ClaimBody& other(std::size_t index) const { return writer_.body(index); }
  const std::string& id(std::size_t index) const { return writer_.claims().claims[index].id; }
  const Expression& forces(std::size_t index) const { return other(index).forces; }

  /// The condition that nothing of the claim is near: the point is neither among its forces nor at an end of them.
  Expression beyond(std::size_t index) {
    if (!has_single_ends(writer_, forces(index))) writer_.give_up();
    return opposite(make(Operation::logical_and, {other(index).region, closure(forces(index))}));
  }

  /// Writes that there is no other motion where a claim states one.
  void write_stated(std::size_t index) {
    ClaimWriter::Assumptions assumptions = common_;
    assumptions.emplace_back("stated", make(Operation::logical_and, {other(index).region, forces(index)}));
    const MechanismMode mode = other(index).modes.front();
    const StatedMotion its = writer_.motion(mode, false);
    write_no_other("." + id(index), assumptions, its, writer_.mechanics().in_mode(mode));
    writer_.one_motion("." + id(index) + ".one", assumptions, its, its, hints_);
    writer_.exists({"." + id(index) + ".exists", assumptions, {}, true, hints_}, its);
  }

  /// Writes that every motion is in one of the modes in question. If forces may be undetermined, a motion in one of
  /// them need only have its accelerations: the forces of a motion in another mode may not fit.
  void write_no_other(const std::string& suffix, const ClaimWriter::Assumptions& assumptions,
                      const StatedMotion& listed, const Expression& shown) {
    if (writer_.mechanics().may_leave_forces_open()) {
      writer_.one_motion(suffix, assumptions, motion_, listed, hints_);
    } else {
      writer_.implied({suffix, assumptions, motion_, true, hints_}, shown, {});
    }
  }

  void write_rest() {
    ClaimWriter::Assumptions rest = common_;
    std::vector<Expression> regions;
    for (const std::size_t index : claim_.claims) {
      rest.emplace_back("beyond_" + id(index), beyond(index));
      regions.push_back(other(index).region);
    }
    const std::vector<Expression> cells = writer_.cells(regions);
    Expression any_cell;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      ClaimWriter::Assumptions here = rest;
      here.emplace(here.begin(), "cell", cells[i]);
      const StatedMotion right{motion_.definitions, conjoined({writer_.mechanics().dynamics(), braced(listed())})};
      write_no_other(fmt::format(".rest.{}", i + 1), here, right, shown());
      writer_.exists({fmt::format(".rest.exists.{}", i + 1), here, {}, true, hints_}, right);
      any_cell = any_cell ? make(Operation::logical_or, {any_cell, cells[i]}) : cells[i];
    }
    writer_.implied({".rest.cells", {}, {}}, any_cell);
    std::vector<StatedMotion> motions;  // of 160 modes there are 12,880 pairs
    for (const MechanismMode& mode : claim_.modes) motions.push_back(writer_.motion(mode, false));
    for (std::size_t i = 0; i < motions.size(); ++i) {
      for (std::size_t k = i; k < motions.size(); ++k) {
        writer_.one_motion(fmt::format(".rest.one.{}-{}", i + 1, k + 1), common_, motions[i], motions[k]);
      }
    }
  }

  void write_values() {
    writer_.have_values(".defined", claim_.region, claim_.forces);
    References named = claim_.claims;
    named.insert(named.end(), claim_.except.begin(), claim_.except.end());
    for (const std::size_t index : named) {
      writer_.has_value(".defined." + id(index) + ".region", {{"region", claim_.region}}, other(index).region);
      writer_.has_value_at_forces(".defined." + id(index), {{"region", claim_.region}, {"stated", other(index).region}},
                                  forces(index));
    }
  }

  Expression listed() const {
    std::vector<Expression> modes;
    for (const MechanismMode& mode : claim_.modes) modes.push_back(braced(writer_.mechanics().in_mode(mode)));
    return modes.empty() ? make_truth(false) : disjoined(modes);
  }
  /// The formula to show. If all states of the other elements are listed, as in */lift, it is about one element only.
  Expression shown() const {
    const MechanicsWriter& mechanics = writer_.mechanics();
    for (std::size_t element = 0; element < mechanics.elements() && !claim_.modes.empty(); ++element) {
      const ElementState state = claim_.modes.front()[element];
      const auto fits = [&](const MechanismMode& mode) { return mode[element] == state; };
      std::vector<MechanismMode> all = mechanics.modes();
      std::erase_if(all, [&](const MechanismMode& mode) { return !fits(mode); });
      if (all.size() == claim_.modes.size() && std::all_of(claim_.modes.begin(), claim_.modes.end(), fits)) {
        return mechanics.state_name(element, state);
      }
    }
    return listed();
  }

  ClaimWriter& writer_;
  const ClaimBody& claim_;
  const StatedMotion motion_ = writer_.any_motion(false);
  const std::vector<Expression> hints_ = writer_.hints_to_numbers();
  ClaimWriter::Assumptions common_;
};

/// Collects the numbers that a condition compares and that may have no value.
void collect_unvalued(const ClaimWriter& writer, const Expression& e, std::vector<Expression>& found) {
  const bool number = sort(*e) == Sort::number;
  if (number && !writer.always_defined(e)) found.push_back(e);
  if (number) return;
  for (const Expression& operand : e->operands) collect_unvalued(writer, operand, found);
}

/// States that in the region `forces` has a value at every force. Gives up if that may depend on the force.
Expression valued_at_all(ClaimWriter& writer, const Expression& region, const Expression& forces) {
  std::vector<Expression> unvalued;
  collect_unvalued(writer, forces, unvalued);
  Expression valued = make_truth(true);
  for (const Expression& e : unvalued) {
    if (writer.depends_on_force(e)) writer.give_up();
    valued = conjunction(valued, make_comparison({e, e}, {Relation::less_equal}));
  }
  return is_true(region) ? valued : make(Operation::logical_or, {opposite(region), valued});
}

}  // namespace

void unique_statements(ClaimWriter& writer) {
  UniqueWriter(writer).write();
}

void unique_refutation(ClaimWriter& writer) {
  const ClaimBody& claim = writer.body();
  const auto beyond = [&](std::size_t index) {
    return opposite(conjunction(writer.body(index).region, closure(writer.body(index).forces)));
  };
  std::vector<Expression> truths = {claim.region, claim.forces}, uses;
  for (const std::size_t index : claim.except) truths.push_back(beyond(index));
  Expression near_none = make_truth(true);
  for (const std::size_t index : claim.claims) near_none = conjunction(near_none, beyond(index));
  // The motion is in none of `right`. If its own mode is another one this is plain, unless forces are undetermined.
  const auto in_none = [&](const Expression& where, const Modes& right) {
    std::vector<Expression> parts = {braced(writer.formula(where))};
    for (const MechanismMode& mode : right) parts.push_back(braced(writer.mechanics().mode_missed(mode)));
    return braced(conjoined(parts));
  };
  std::vector<ClaimWriter::ModeAndMore> wrong;
  for (const MechanismMode& mode : writer.mechanics().modes()) {
    Expression where = names(claim.modes, mode) ? nullptr : near_none;
    std::vector<Expression> parts;
    if (where) parts.push_back(in_none(near_none, claim.modes));
    for (const std::size_t index : claim.claims) {
      const Modes& right = writer.body(index).modes;
      if (right.front() == mode) continue;
      const Expression stated = conjunction(writer.body(index).region, writer.body(index).forces);
      where = where ? make(Operation::logical_or, {where, stated}) : stated;
      parts.push_back(in_none(stated, right));
    }
    if (!where) continue;
    uses.push_back(where);
    const Expression more = writer.mechanics().may_leave_forces_open() ? disjoined(parts)
                            : is_true(where)                           ? nullptr
                                                                       : writer.formula(where);
    wrong.emplace_back(mode, more ? braced(more) : nullptr);
  }
  if (wrong.empty()) writer.give_up();
  References named = claim.claims;  // if one of these has no value, even at another force, nothing is claimed
  named.insert(named.end(), claim.except.begin(), claim.except.end());
  for (const std::size_t index : named) {
    const ClaimBody& other = writer.body(index);
    if (!writer.always_defined(other.region)) writer.give_up();
    if (!writer.always_defined(other.forces)) truths.push_back(valued_at_all(writer, other.region, other.forces));
  }
  writer.somewhere(refuted_suffix, truths, {writer.one_of(wrong, true)}, uses);
}

}  // namespace slipproof
