// What is plain about a setting as it is written, without a proof: where it has values, what is linear in it, and how
// far its parameters reach.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/plain/plain_signs.hpp"

namespace slipproof {

class PlainSetting {
 public:
  /// The setting must outlive it.
  PlainSetting(const Setting& setting, Reading reading)
      : setting_(setting), reading_(reading), names_(setting), signs_(setting, reading) {}

  const Setting& setting() const { return setting_; }
  Reading reading() const { return reading_; }
  const SettingNames& names() const { return names_; }
  const PlainSigns& signs() const { return signs_; }

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
  /// The conditions for a point of the mechanism (proofs/MEANING.md, The words) that the domains of the parameters do
  /// not plainly imply; nothing if the load is not linear in the force as written.
  std::optional<std::vector<Expression>> point_conditions() const;

 private:
  /// Whether an unknown, a quantity of a motion, or the force occurs, also in definitions.
  bool varies(const Expression& e) const;

  const Setting& setting_;
  Reading reading_;
  SettingNames names_;
  PlainSigns signs_;
};

}  // namespace slipproof
