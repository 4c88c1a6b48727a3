// The parts of statements about a setting of a claims file.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "statements/mechanics_text.hpp"

namespace slipproof {

/// What a statement assumes or shows of a motion.
struct MotionText {
  std::string definitions;  ///< lines after the declaration of the unknowns
  std::string formula;
};

class SettingWriter {
 public:
  SettingWriter(const Setting& setting, Reading reading) : setting_(setting), reading_(reading) {}

  const Setting& setting() const { return setting_; }
  Reading reading() const { return reading_; }

  /// Motions of a mode, with conditions as strict as the setting's.
  MotionText motion(ContactMode mode);
  /// The equations of a mode without its conditions; without a mode: both wheels on the road.
  MotionText equations(std::optional<ContactMode> mode) const;
  /// Motions of all sixteen modes, boundaries included.
  MotionText any_motion() const;

  std::string text(const Expression& truth);  ///< gives up where statements have no word for it
  void give_up() { complete_ = false; }

 protected:
  static bool is_true(const Expression& truth);
  /// The first lines, up to the variables.
  std::string header(const std::string& theorem, const std::string& comment);
  std::string parameters() const;
  std::string domain(bool with_force);
  /// `let` lines for every definition that the expressions use, each after those that it uses itself; lines that need
  /// an unknown of the motion do not occur, as definitions are over parameters and the force.
  std::string definitions(const std::vector<Expression>& uses);
  /// The definitions in use, and what the scene's symbols are.
  std::string scene(const std::vector<Expression>& uses);
  std::string assumption(const std::string& label, const Expression& truth);
  bool complete() const { return complete_; }

 private:
  /// Without it, only motions with both wheels on the road are modelled, and there it drops out.
  bool has_pitch_inertia() const { return setting_.scene.contains("J"); }

  const Setting& setting_;
  Reading reading_;
  std::set<std::string> defined_;
  bool complete_ = true;
};

}  // namespace slipproof
