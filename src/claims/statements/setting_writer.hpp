// Writes the parts of statements about a setting of a claims file.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "claims/statements/mechanics_writer.hpp"
#include "claims/statements/plain_signs.hpp"

namespace slipproof {

/// What a statement assumes or shows about a motion.
struct MotionText {
  std::string definitions;  ///< lines after the declaration of the unknowns
  std::string formula;
};

class SettingWriter {
 public:
  SettingWriter(const Setting& setting, Reading reading)
      : setting_(setting),
        reading_(reading),
        names_(setting),
        signs_(setting, reading),
        mechanics_(setting, names_, signs_) {}
  SettingWriter(const SettingWriter&) = delete;
  SettingWriter& operator=(const SettingWriter&) = delete;

  const Setting& setting() const { return setting_; }
  const MechanicsWriter& mechanics() const { return mechanics_; }
  Reading reading() const { return reading_; }

  /// The motions in a mode, with conditions that are strict if the setting is.
  MotionText motion(const MechanismMode& mode);
  /// The equations of a mode without its conditions; without a mode: of motions without an open contact.
  MotionText equations(const std::optional<MechanismMode>& mode) const;
  /// The same, including boundary motions unless `strict`, whatever the setting says.
  MotionText motion(const MechanismMode& mode, bool strict);
  /// Motions in all modes. Gives up if not all are modelled.
  MotionText any_motion(bool strict);

  std::string text(const Expression& truth);  ///< gives up if the text would be too long
  void give_up() { complete_ = false; }
  /// Whether the domain of the force plainly is one interval that has a value everywhere. If not, no claim of the
  /// setting has a value.
  bool has_interval_of_forces() const;
  /// Whether the expression depends on the force, directly or through definitions.
  bool depends_on_force(const Expression& e) const { return names_.depends(e, reading_, setting_.force.symbol); }
  /// Whether an equation is linear in the unknowns and the force as it stands (proofs/MEANING.md).
  bool is_linear(const Expression& e) const;
  /// Whether all divisors in the expression plainly differ from 0 in the domain.
  bool always_defined(const Expression& e) const { return signs_.defined(e); }
  /// Whether the domain restricts the parameter by more than a lower end; it may then not be arbitrarily large.
  bool is_bounded(const std::string& parameter) const;

 protected:
  /// The first lines, up to the variables.
  std::string header(const std::string& theorem, const std::string& comment);
  /// The names of the paper's parameters, cosines and sines, and of the force; and the line that declares them, empty
  /// if there are none.
  std::vector<std::string> parameter_names() const;
  std::string parameters() const;
  std::string variables() const;
  /// The conditions for a point of the mechanism that are not plain (proofs/MEANING.md, The words), and the domain of
  /// the paper's force.
  std::string domain(bool with_force) { return domain(with_force, "", ""); }
  /// The same with another name for one parameter.
  std::string domain(bool with_force, const std::string& parameter, const std::string& renamed);
  /// `let` lines for every definition that the expressions use; each comes after those that it uses. None needs an
  /// unknown of the motion, since definitions are over parameters and the force.
  std::string definitions(const std::vector<Expression>& uses);
  /// The definitions in use, and the values of the scene's symbols.
  std::string scene(const std::vector<Expression>& uses);
  /// A line `assume`, and the same for a formula; no line for `true`.
  std::string assumption(const std::string& label, const std::string& formula);
  std::string assumption(const std::string& label, const Expression& truth);
  /// The names that the statement has so far.
  MadeUpNames& made_up() { return made_up_; }
  bool complete() const { return complete_ && mechanics_.complete(); }
  /// Writes out definitions that statements cannot abbreviate because they contain functions.
  Expression inlined(const Expression& e) const;

 private:
  /// Whether an unknown, a quantity of a motion, or the force occurs, also in definitions.
  bool varies(const Expression& e) const;
  /// Conditions on the scene that the domains of the parameters do not plainly imply.
  std::vector<Expression> physical();
  const Setting& setting_;
  Reading reading_;
  SettingNames names_;
  PlainSigns signs_;
  MechanicsWriter mechanics_;
  MadeUpNames made_up_ = mechanics_.names();
  std::set<std::string> defined_;
  bool complete_ = true;
};

}  // namespace slipproof
