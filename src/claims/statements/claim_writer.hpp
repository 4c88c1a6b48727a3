// Writes statements about a claim of a claims file, line by line. The claim's kind decides which.
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
  /// The body of another claim, in the same reading.
  const ClaimBody& body(std::size_t claim) const { return claims_.claims[claim].body(reading()); }

  using Assumptions = std::vector<std::pair<std::string, Expression>>;  ///< by name; `true` is left out

  /// For all parameters with `assumptions` and all motions, `shown` is true.
  struct Implication {
    std::string suffix;
    Assumptions assumptions;
    std::optional<StatedMotion> motion = {};
    bool force_domain = true;            ///< whether the force is restricted to the paper's domain
    std::vector<Expression> hints = {};  ///< where to split cases
    bool refutes = false;                ///< see NamedStatement
  };
  void implied(const Implication& implication, const Expression& shown);
  /// The same for a formula, and the expressions whose definitions it uses.
  void implied(const Implication& implication, const Expression& formula, const std::vector<Expression>& uses);
  /// Writes ID, or ID.1, ID.2, ... if there are several modes: `shown` is true for all motions in each of the modes at
  /// the forces; without modes, at all the forces. Also writes that region and forces have values.
  void implied_of_each(const Modes& modes, const Expression& forces, const Expression& shown);
  /// For all parameters with `assumptions` and all values of the other unknowns, there are some `unknowns` with
  /// `shown`.
  void exists(const Implication& implication, const std::vector<std::string>& unknowns, const StatedMotion& shown,
              const std::vector<Expression>& uses = {});
  /// The same for all unknowns of a motion.
  void exists(const Implication& implication, const StatedMotion& motion);
  /// For all parameters with `assumptions`, two such motions have the same accelerations.
  void one_motion(const std::string& suffix, const Assumptions& assumptions, const StatedMotion& x,
                  const StatedMotion& y, const std::vector<Expression>& hints = {});
  /// If there is a motion in each of the modes, any motion has the accelerations of one of them. It is then in that
  /// mode, perhaps with other forces than its own. Counts boundary motions if not strict.
  void same_as_one_of(const std::string& suffix, const Assumptions& assumptions,
                      const std::vector<MechanismMode>& modes, bool strict);
  /// No parameters with `assumptions` have all of `motions` at once.
  void impossible_together(const std::string& suffix, const Assumptions& assumptions,
                           const std::vector<StatedMotion>& motions);
  /// States that a condition assumed by the claim has a value under `assumptions`, also where no force is in the
  /// domain, or only at each force of the domain; writes nothing if that is plain.
  void has_value(const std::string& suffix, const Assumptions& assumptions, const Expression& truth);
  void has_value_at_forces(const std::string& suffix, const Assumptions& assumptions, const Expression& truth);
  /// The same for the region, and for the forces at every force in the region.
  void have_values(const std::string& suffix, const Expression& region, const Expression& forces);
  /// States that the region has bicycles with a parameter greater than `from`; writes nothing if that is plain.
  void goes_beyond(const std::string& suffix, const std::string& parameter, const Expression& from);
  /// The cells between those boundaries of the setting that `regions` name, all of one parameter, in the setting's
  /// order. A boundary belongs to the cell above it. Every value is in one cell, whatever the order of the boundaries
  /// is.
  std::vector<Expression> cells(const std::vector<Expression>& regions) const;
  /// In the region of one of the claims; with `stated`, also at one of the forces that it states.
  Expression in_one_of(const References& others, bool stated) const;
  /// Hints to split at the boundaries that are numbers.
  std::vector<Expression> hints_to_numbers() const;
  /// A mode, and a further formula; null: none.
  using ModeAndMore = std::pair<MechanismMode, Expression>;
  /// A motion in one of `modes` that meets the mode's further condition.
  StatedMotion one_of(const std::vector<ModeAndMore>& modes, bool strict) const;
  /// The modes that are modelled. Gives up if there are none.
  std::vector<ModeAndMore> modelled(const Modes& modes);
  /// There are parameters, a force and a motion with all of `truths`.
  void somewhere(const std::string& suffix, const std::vector<Expression>& truths,
                 const std::vector<StatedMotion>& motions, const std::vector<Expression>& more_uses = {});

  /// The statements; empty if something could not be expressed.
  std::vector<NamedStatement> take();

 private:
  struct Draft {
    std::string suffix;
    WrittenStatement statement;
    bool refutes = false;
  };

  void has_value(const Implication& implication, const Expression& truth);
  /// The condition that the first motion has the accelerations of another one; motions count from 1.
  Expression same_accelerations(std::size_t other) const;
  /// All of `motions` at once; from the second on, each has its own names.
  void together(const std::string& suffix, const Assumptions& assumptions, const std::vector<StatedMotion>& motions,
                const std::vector<Expression>& hints, const Expression& shown);
  /// The unknowns of a motion by its number from 1.
  std::vector<std::string> unknowns(std::size_t motion) const;
  /// The same of a further motion: its unknowns, and everything that is defined from them, have names of their own.
  StatedMotion numbered(StatedMotion motion, std::size_t number);
  /// Begins a statement.
  WrittenStatement opened(const std::string& suffix);
  /// Ends it.
  void close(const std::string& suffix, WrittenStatement statement, const Expression& shown, bool refutes = false);
  /// Adds the scene with what the assumptions and `uses` need, the assumptions, and hints.
  void add_assumptions(WrittenStatement& to, const Implication& implication, std::vector<Expression> uses);
  /// A proposal to split where the parameter has the boundary's value; null if statements cannot express the value.
  Expression hint(const Boundary& boundary) const;

  const ClaimsFile& claims_;
  const Claim& claim_;
  const ClaimBody& body_;
  std::string name_;
  std::vector<Draft> drafts_;
};

/// The suffix of refutations.
inline constexpr const char* refuted_suffix = ".refuted";

}  // namespace slipproof
