// The mechanics of a setting in the syntax of statements: a printout of its mechanism, for a person to compare with the
// mechanism's file. tests/claims/papers holds it against the problem that the kernel solves.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "claims/reading/claims_file.hpp"

namespace slipproof {

class MechanicsWriter {
 public:
  /// Whether all that an expression over the paper's symbols divides by plainly differs from 0.
  using Defined = std::function<bool(const Expression&)>;

  /// The setting must outlive the writer.
  MechanicsWriter(const Setting& setting, Defined defined);

  /// The mechanism's unknowns, in the order in which statements declare them.
  const std::vector<std::string>& unknowns() const { return unknowns_; }
  /// Those that make a motion.
  std::vector<std::string> accelerations() const;

  /// What the mechanism's symbols are in the paper's: lines `let`. Symbols that are the paper's own have none; of those
  /// that the paper uses for something else the name is changed.
  std::string scene() const;
  /// Gaps and slips, and the equations of every mode as named formulas.
  std::string equations() const;
  /// The formulas that equations() defines, joined by `and`.
  std::string dynamics() const;
  /// No contact is open.
  std::string on_contacts() const;

  std::size_t elements() const { return kinds_.size(); }
  /// Whether forces may be undetermined while the accelerations are not, as under a body on two contacts: contacts,
  /// friction elements and links may tie more than there are accelerations. If not, what bears no inertia may still.
  bool may_leave_forces_open() const;
  /// The states of an element that are modelled.
  std::vector<ElementState> states_of(std::size_t element) const { return states(kinds_[element]); }
  bool is_modelled(const MechanismMode& mode) const;
  /// All modes that are modelled.
  std::vector<MechanismMode> modes() const;

  /// `rear_sticks`, and the line that defines it: equations and conditions of the state.
  std::string state_name(std::size_t element, ElementState state) const;
  std::string state_definition(std::size_t element, ElementState state, bool strict) const;
  std::string state_definitions(const MechanismMode& mode, bool strict) const;
  std::string all_state_definitions(bool strict) const;
  /// `rear_sticks and front_lifts`
  std::string mode_text(const MechanismMode& mode) const;
  /// Some state of each element.
  std::string any_mode_text() const;
  /// That a motion is not in the mode, boundary motions of the mode counted as in it. Where forces may be undetermined,
  /// that it has no forces by which it is: its accelerations do not fit.
  std::string mode_missed_text(const MechanismMode& mode) const;
  /// The equations of the mode's states alone, without their conditions.
  std::string state_equations(const MechanismMode& mode) const;

  /// False where something of the mechanism cannot be said in a statement: functions such as min in its expressions.
  bool complete() const { return complete_; }

 private:
  /// The forms of an element as texts.
  struct ElementText {
    std::string name, gap, slip, normal, tangent, static_limit, kinetic_limit;
  };
  void name_symbols();
  void write_elements();
  std::string fresh(std::string name) const;
  std::string number(const Expression& of_mechanism) const;
  std::string friction(const Expression& coefficient, const std::string& normal) const;
  std::string equation(std::size_t element, ElementState state, StateEquation equation, const char* is) const;
  std::string condition(std::size_t element, ElementState state, StateCondition condition, bool strict) const;
  std::string missed(std::size_t element, ElementState state, StateCondition condition) const;

  const Setting& setting_;
  Defined defined_;
  std::vector<ElementKind> kinds_;
  std::vector<std::string> unknowns_;
  std::map<std::string, std::string, std::less<>> names_;  ///< of the mechanism's symbols, in statements
  std::vector<std::string> taken_;
  std::vector<std::string> equation_names_;
  std::vector<ElementText> elements_;
  mutable bool complete_ = true;
};

}  // namespace slipproof
