// Statements about a claim of a claims file, line by line; its kind says which.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/statements/claim_statements.hpp"
#include "claims/statements/setting_writer.hpp"

namespace slipproof {

class ClaimWriter : public SettingWriter {
 public:
  ClaimWriter(const ClaimsFile& claims, const Claim& claim, Reading reading);

  const ClaimsFile& claims() const { return claims_; }
  const Claim& claim() const { return claim_; }
  const ClaimBody& body() const { return body_; }
  /// That of another claim, in the same reading.
  const ClaimBody& body(std::size_t claim) const { return claims_.claims[claim].body(reading()); }

  using Assumptions = std::vector<std::pair<std::string, Expression>>;  ///< by name; `true` is left out

  /// For all parameters with `assumptions`, and all motions: `shown`.
  struct Implication {
    std::string suffix;
    Assumptions assumptions;
    std::optional<MotionText> motion = {};
    bool force_domain = true;  ///< whether the force is where the paper stands
    std::string hints = {};    ///< lines after the assumptions
    bool refutes = false;      ///< see NamedStatement
  };
  void implied(const Implication& implication, const Expression& shown);
  void implied(const Implication& implication, const std::string& shown, const std::vector<Expression>& uses);
  /// ID, or ID.1, ID.2, ... where there are several modes: `shown` of all motions in each of the modes, at the forces;
  /// without modes, of all forces. And that region and forces have values.
  void implied_of_each(const Modes& modes, const Expression& forces, const Expression& shown);
  /// For all parameters with `assumptions`, and all values of the other unknowns, some `unknowns` with `shown`.
  void exists(const Implication& implication, const std::vector<std::string>& unknowns, const MotionText& shown,
              const std::vector<Expression>& uses = {});
  /// The same of all unknowns of a motion.
  void exists(const Implication& implication, const MotionText& motion);
  /// For all parameters with `assumptions`, and all motions in both modes, boundary motions if not strict: their
  /// accelerations are the same.
  void one_motion(const std::string& suffix, const Assumptions& assumptions, const MechanismMode& x,
                  const MechanismMode& y, bool strict, const std::string& hints = {});
  /// With motions in each of the modes, any motion has the accelerations of one of them: then it is in that mode by
  /// other forces, if not by its own.
  void same_as_one_of(const std::string& suffix, const Assumptions& assumptions,
                      const std::vector<MechanismMode>& modes);
  /// No parameters with `assumptions` have all of `motions` at once.
  void impossible_together(const std::string& suffix, const Assumptions& assumptions,
                           const std::vector<MotionText>& motions);
  /// That a condition, assumed by the claim, has a value under `assumptions`; nothing where that is plain.
  void has_value(const std::string& suffix, const Assumptions& assumptions, const Expression& truth);
  /// The same of the region, and in the region of the forces at every force.
  void have_values(const std::string& suffix, const Expression& region, const Expression& forces);
  /// In the region, there are bicycles with a greater value of the parameter than `from`; nothing where that is plain.
  void goes_beyond(const std::string& suffix, const std::string& parameter, const Expression& from);
  /// Between the boundaries of the setting that `regions` name, all of one parameter, in the order in which the setting
  /// lists them; a boundary belongs to the cell above it. Whatever their order, every value lies in one.
  std::vector<Expression> cells(const std::vector<Expression>& regions) const;
  /// In the region of one of the claims; with `stated`, one of the forces that it states there.
  Expression in_one_of(const References& others, bool stated) const;
  /// Hints to split at the boundaries that are numbers.
  std::string hints_to_numbers() const;
  /// A mode, and what else is to hold, as text; empty: nothing.
  using ModeAndMore = std::pair<MechanismMode, std::string>;
  /// A motion in one of `modes`, each with what else is to hold of it.
  MotionText one_of(const std::vector<ModeAndMore>& modes, bool strict) const;
  /// Those of the modes that are modelled. Gives up where there are none.
  std::vector<ModeAndMore> modelled(const Modes& modes);
  /// Some parameters, force and motion with all of `truths`.
  void somewhere(const std::string& suffix, const std::vector<Expression>& truths,
                 const std::vector<MotionText>& motions, const std::vector<Expression>& more_uses = {});

  /// Empty where something could not be said.
  std::vector<NamedStatement> take();

 private:
  /// That the accelerations of the first motion are those of another one; motions count from 1.
  std::string same_accelerations(std::size_t other) const;
  /// All of `motions` at once, under names of their own from the second on.
  void together(const std::string& suffix, const Assumptions& assumptions, const std::vector<MotionText>& motions,
                const std::string& hints, const std::string& shown);
  std::string opening(const std::string& suffix);
  /// A line that proposes to split where the parameter has the boundary's value.
  std::string hint(const Boundary& boundary) const;
  /// The lines of the assumptions; what the scene has to define for them joins `uses`.
  std::string assumed(const Assumptions& assumptions, std::vector<Expression>& uses);

  const ClaimsFile& claims_;
  const Claim& claim_;
  const ClaimBody& body_;
  std::string name_;
  std::vector<NamedStatement> statements_;
};

/// The suffix of refutations.
inline constexpr const char* refuted_suffix = ".refuted";

}  // namespace slipproof
