// Writes the mechanics of a setting in the syntax of statements: a printout of its mechanism that a person can compare
// with the mechanism's file. tests/claims/papers compares it with the problem that the kernel solves.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "claims/statements/made_up_names.hpp"
#include "claims/statements/plain_signs.hpp"
#include "mechanics/elements/friction_problem.hpp"

namespace slipproof {

/// An unknown and a limit, or one of them, added as form_of() does, and compared with 0 as people write it: the unknown
/// alone is on the left.
class TextForm {
 public:
  TextForm() = default;
  explicit TextForm(std::string unknown) : unknown_(std::move(unknown)) {}
  static TextForm limit(std::string text) {
    TextForm form;
    form.limit_ = std::move(text);
    return form;
  }

  /// The text of an unknown or a limit.
  const std::string& text() const { return unknown_.empty() ? limit_ : unknown_; }
  /// `S >= -mu*N` for mu*N + S; `above` stands for `>=`, `below` for the opposite relation.
  std::string compared(std::string_view above, std::string_view below) const {
    return text() + ' ' + std::string(negative_ ? below : above) + ' ' + bound();
  }
  /// The right side.
  std::string bound() const {
    if (unknown_.empty() || limit_.empty()) return "0";
    return (limit_negative_ == negative_ ? "-" : "") + limit_;
  }

  friend TextForm operator-(TextForm x) {
    x.negative_ = !x.negative_;
    x.limit_negative_ = !x.limit_negative_;
    return x;
  }
  friend TextForm operator+(TextForm x, TextForm y) {
    if (x.unknown_.empty()) std::swap(x, y);
    x.limit_ = std::move(y.limit_);
    x.limit_negative_ = y.limit_negative_;
    return x;
  }
  friend TextForm operator-(TextForm x, TextForm y) { return std::move(x) + -std::move(y); }

 private:
  std::string unknown_, limit_;
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
  std::string scene() const;
  /// Gaps and slips, and the equations of every mode, as named formulas.
  std::string equations() const;
  /// The formulas that equations() defines, joined by `and`.
  std::string dynamics() const;
  /// The condition that no contact is open.
  std::string on_contacts() const;

  std::size_t elements() const { return kinds_.size(); }
  /// Whether forces may be undetermined while the accelerations are determined, as under a body on two contacts. False
  /// only if they plainly are not, at any point.
  bool may_leave_forces_open() const;
  /// The states of an element that are modelled.
  std::vector<ElementState> states_of(std::size_t element) const { return states(kinds_[element]); }
  bool is_modelled(const MechanismMode& mode) const;
  /// All modes that are modelled.
  std::vector<MechanismMode> modes() const;

  /// `rear_sticks`, and the line that defines it: the equations and conditions of the state.
  std::string state_name(std::size_t element, ElementState state) const;
  std::string state_definition(std::size_t element, ElementState state, bool strict) const;
  std::string state_definitions(const MechanismMode& mode, bool strict) const;
  std::string all_state_definitions(bool strict) const;
  /// `rear_sticks and front_lifts`
  std::string mode_text(const MechanismMode& mode) const;
  /// Every element is in some state.
  std::string any_mode_text() const;
  /// The condition that a motion is not in the mode, where boundary motions count as in it. If forces may be
  /// undetermined: that no forces put the motion in the mode, because its accelerations do not fit.
  std::string mode_missed_text(const MechanismMode& mode) const;
  /// The equations of the mode's states, without their conditions.
  std::string state_equations(const MechanismMode& mode) const;

  /// False if a statement cannot express part of the mechanism, such as min in its expressions.
  bool complete() const { return complete_; }

 private:
  struct ElementText : ElementForms<TextForm> {
    std::array<std::string, element_state_count> state_names;
  };
  void name_symbols();
  void write_elements();
  void name_states(ElementText& element, const std::string& name);
  std::string number(const Expression& of_mechanism) const;
  std::string friction(const Expression& coefficient, const std::string& normal) const;
  /// All equations of a state, with `=` or `!=`, or only those about accelerations.
  std::string equations_of(std::size_t element, ElementState state, const char* is, const char* word,
                           bool of_accelerations = false) const;
  /// Applies `text` to each condition of a state.
  template <class Text>
  std::string conditions_of(std::size_t element, ElementState state, const char* word, const Text& text) const;

  const Setting& setting_;
  const PlainSigns& signs_;
  std::vector<ElementKind> kinds_;
  std::vector<std::string> unknowns_;
  MadeUpNames made_up_;
  std::map<std::string, std::string, std::less<>> names_;  ///< names of the mechanism's symbols in statements
  std::vector<std::string> equation_names_;
  std::vector<ElementText> elements_;
  mutable bool complete_ = true;
  mutable std::optional<bool> forces_open_;  ///< found where it is asked for: few claims need it
};

}  // namespace slipproof
