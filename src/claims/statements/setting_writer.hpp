// Writes the parts of statements about a setting of a claims file.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "claims/plain/plain_setting.hpp"
#include "claims/statements/mechanics_writer.hpp"

namespace slipproof {

class SettingWriter : public PlainSetting {
 public:
  /// The setting must outlive it.
  SettingWriter(const Setting& setting, Reading reading)
      : PlainSetting(setting, reading), mechanics_(setting, names(), signs()) {}
  SettingWriter(const SettingWriter&) = delete;
  SettingWriter& operator=(const SettingWriter&) = delete;

  const MechanicsWriter& mechanics() const { return mechanics_; }

  /// The motions in a mode, with conditions that are strict if the setting is.
  StatedMotion motion(const MechanismMode& mode) { return motion(mode, setting().strict); }
  /// The equations of a mode without its conditions; without a mode: of motions without an open contact.
  StatedMotion equations(const std::optional<MechanismMode>& mode) const;
  /// The same, including boundary motions unless `strict`, whatever the setting says.
  StatedMotion motion(const MechanismMode& mode, bool strict);
  /// Motions in all modes. Gives up if not all are modelled.
  StatedMotion any_motion(bool strict);

  /// The condition as a formula. Gives up if it would be too long.
  Expression formula(const Expression& truth);
  /// The conjunction of the conditions' formulas; null if there are none. Braces a formula with cases.
  Expression formula_of_all(const std::vector<Expression>& truths);
  void give_up() { complete_ = false; }

 protected:
  /// Begins a statement.
  WrittenStatement begun(const std::string& theorem, const std::string& comment);
  /// The names of the paper's parameters, cosines and sines, and of the force.
  std::vector<std::string> parameter_names() const;
  /// Declares these names, and assumes domain().
  void add_parameters(WrittenStatement& to, bool with_force);
  /// The conditions for a point of the mechanism that are not plain (proofs/MEANING.md, The words), and the domain of
  /// the paper's force.
  Expression domain(bool with_force) { return domain(with_force, "", ""); }
  /// The same with another name for one parameter.
  Expression domain(bool with_force, const std::string& parameter, const std::string& renamed);
  /// Adds lines `let` for every definition that the expressions use; each comes after those that it uses. None needs an
  /// unknown of the motion, since definitions are over parameters and the force.
  void add_definitions(WrittenStatement& to, const std::vector<Expression>& uses);
  /// Adds the definitions in use, and the values of the scene's symbols.
  void add_scene(WrittenStatement& to, const std::vector<Expression>& uses);
  /// Adds a line `assume`, and the same for a condition; no line for `true`.
  void assume(WrittenStatement& to, const std::string& label, const Expression& formula);
  void assume_truth(WrittenStatement& to, const std::string& label, const Expression& truth);
  /// A number of the paper; null if statements cannot express it.
  Expression number(const Expression& of_paper) const;
  /// The names that the statement has so far.
  MadeUpNames& made_up() { return made_up_; }
  bool complete() const { return complete_ && mechanics_.complete(); }
  /// Writes out definitions that statements cannot abbreviate because they contain functions.
  Expression inlined(const Expression& e) const;

 private:
  MechanicsWriter mechanics_;
  MadeUpNames made_up_ = mechanics_.names();
  std::set<std::string> defined_;
  bool complete_ = true;
};

}  // namespace slipproof
