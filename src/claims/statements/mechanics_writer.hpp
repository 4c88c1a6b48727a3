// Writes the mechanics of a setting as lines of statements: a printout of its mechanism that a person can compare
// with the mechanism's file. tests/claims/papers compares it with the problem that the kernel solves.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "claims/plain/plain_signs.hpp"
#include "claims/statements/made_up_names.hpp"
#include "mechanics/elements/friction_problem.hpp"
#include "proofs/statement/statement_text.hpp"

namespace slipproof {

/// What a statement assumes or shows about a motion.
struct StatedMotion {
  std::vector<Directive> definitions;  ///< lines after the declaration of the unknowns
  Expression formula;
};

/// An unknown and a limit, or one of them, added as form_of() does, and compared with 0 as people write it: the unknown
/// alone is on the left.
class WrittenForm {
 public:
  WrittenForm() = default;
  explicit WrittenForm(const std::string& unknown) : unknown_(make_symbol(unknown)) {}
  static WrittenForm limit(Expression limit) {
    WrittenForm form;
    form.limit_ = std::move(limit);
    return form;
  }

  /// The unknown or the limit; null for neither.
  const Expression& alone() const { return unknown_ ? unknown_ : limit_; }
  /// `S >= -mu*N` for mu*N + S and the relation `>=`.
  Expression compared(Relation relation) const;
  /// The right side.
  Expression bound() const;

  friend WrittenForm operator-(WrittenForm x) {
    x.negative_ = !x.negative_;
    x.limit_negative_ = !x.limit_negative_;
    return x;
  }
  friend WrittenForm operator+(WrittenForm x, WrittenForm y) {
    if (!x.unknown_) std::swap(x, y);
    x.limit_ = std::move(y.limit_);
    x.limit_negative_ = y.limit_negative_;
    return x;
  }
  friend WrittenForm operator-(WrittenForm x, WrittenForm y) { return std::move(x) + -std::move(y); }

 private:
  Expression unknown_, limit_;
  bool negative_ = false, limit_negative_ = false;
};

class MechanicsWriter {
 public:
  /// The setting and its signs must outlive the writer.
  MechanicsWriter(const Setting& setting, const SettingNames& names, const PlainSigns& signs);

  /// The names of the setting, and those that the mechanics take in every statement.
  const MadeUpNames& names() const { return made_up_; }

  /// The mechanism's unknowns, in the order in which statements declare them.
  const std::vector<std::string>& unknowns() const { return unknowns_; }
  /// The unknowns that are accelerations.
  std::vector<std::string> accelerations() const;

  /// Lines `let` that define the mechanism's symbols in terms of the paper's. A symbol that is also the paper's own
  /// needs none. A symbol that the paper uses for something else is renamed.
  std::vector<Directive> scene() const;
  /// Gaps and slips, and the equations of every mode, as named formulas.
  std::vector<Directive> equations() const;
  /// The conjunction of the formulas that equations() defines.
  Expression dynamics() const;
  /// The condition that no contact is open; null if all are.
  Expression on_contacts() const;

  std::size_t elements() const { return kinds_.size(); }
  /// Whether forces may be undetermined while the accelerations are determined, as under a body on two contacts. False
  /// only if they plainly are not, at any point.
  bool may_leave_forces_open() const;
  /// The states of an element that are modelled.
  std::vector<ElementState> states_of(std::size_t element) const { return states(kinds_[element]); }
  bool is_modelled(const MechanismMode& mode) const;
  /// All modes that are modelled.
  std::vector<MechanismMode> modes() const;

  /// `rear_sticks`, the name of the formula with the equations and conditions of the state.
  Expression state_name(std::size_t element, ElementState state) const;
  /// equations(), and the definitions of the mode's states, or of all states.
  std::vector<Directive> definitions(const MechanismMode& mode, bool strict) const;
  std::vector<Directive> all_definitions(bool strict) const;
  /// `rear_sticks and front_lifts`
  Expression in_mode(const MechanismMode& mode) const;
  /// Every element is in some state.
  Expression in_any_mode() const;
  /// The condition that a motion is not in the mode, where boundary motions count as in it. If forces may be
  /// undetermined: that no forces put the motion in the mode, because its accelerations do not fit.
  Expression mode_missed(const MechanismMode& mode) const;
  /// The equations of the mode's states, without their conditions; null if there are none.
  Expression state_equations(const MechanismMode& mode) const;

  /// False if a statement cannot express part of the mechanism, such as min in its expressions.
  bool complete() const { return complete_; }

 private:
  struct WrittenElement : ElementForms<WrittenForm> {
    std::array<std::string, element_state_count> state_names;
  };
  void name_symbols();
  void write_elements();
  void name_states(WrittenElement& element, const std::string& name);
  const std::string& name(const std::string& symbol) const { return names_.find(symbol)->second; }
  Expression number(const Expression& of_mechanism) const;
  Expression friction(const Expression& coefficient, const std::string& normal) const;
  /// T1^2 + T2^2 against (mu*N)^2, of a contact in space.
  Expression cone(std::size_t element, Relation relation) const;
  Directive state_definition(std::size_t element, ElementState state, bool strict) const;
  /// All equations of a state, with `=` or `!=`, or only those about accelerations.
  std::vector<Expression> equations_of(std::size_t element, ElementState state, Relation relation,
                                       bool of_accelerations = false) const;
  /// The conditions of a state, one of two limits that are equal. An element that sticks has two conditions on its
  /// friction: holds_forward stands for both.
  std::vector<StateCondition> conditions_of(std::size_t element, ElementState state) const;

  const Setting& setting_;
  const PlainSigns& signs_;
  std::vector<ElementKind> kinds_;
  std::vector<std::string> unknowns_;
  MadeUpNames made_up_;
  std::map<std::string, std::string, std::less<>> names_;  ///< names of the mechanism's symbols in statements
  std::vector<std::string> equation_names_;
  std::vector<WrittenElement> elements_;
  mutable bool complete_ = true;
  mutable std::optional<bool> forces_open_;  ///< found where it is asked for: few claims need it
};

}  // namespace slipproof
