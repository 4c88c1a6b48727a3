// One sample of a setting: its bicycle, all its modes solved, and the claims' symbols with their values.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "claims/compiled.hpp"
#include "claims/force_truth.hpp"
#include "modes/motions.hpp"

namespace slipproof {

/// Rows of coefficients: of the model's unknowns in their order, of the force variable, and the constant; each row
/// vanishes.
using LinearRows = std::vector<std::vector<Rational>>;
inline constexpr std::size_t linear_columns = unknown_count + 2;

/// Modes are solved over the pedal force F; claims speak of the paper's force variable x, and F = offset + slope x.
/// Everything that this class gives out is in x. Not shared between threads.
class SolvedSample {
 public:
  /// Nothing if the sample is no bicycle of the model (a scene expression undefined or out of its domain).
  /// The setting must outlive the sample.
  static std::unique_ptr<SolvedSample> make(const CompiledSetting& setting, ForceKind kind,
                                            std::vector<Rational> values);

  const std::vector<Rational>& values() const { return values_; }
  const Scene& scene() const { return scene_; }  ///< without a force
  /// All modes; solved when first asked for, since most samples are outside of most regions.
  const ModeTable& table();
  /// Lets table() have these modes only: for one claim that asks for no others. Before table() is first used.
  void only_modes(std::vector<ContactMode> modes) { only_modes_ = std::move(modes); }
  /// The same bicycle for another version of its setting, with what is already solved: the versions may differ in
  /// definitions, not in parameters, scene or force.
  std::unique_ptr<SolvedSample> under(const CompiledSetting& other);

  /// The pedal force at a value of the force variable.
  Rational pedal_force(const Rational& x) const { return force_.at(x); }
  /// Forces as the force variable sees them.
  ForceInterval in_variable(const ForceInterval& pedal_forces) const;
  /// The partition of the line of the force variable; made when first asked for.
  const std::vector<Cell>& cells();
  /// The equations of motion with both wheels on the road; in a mode, with the equations of its contacts.
  LinearRows equations(std::optional<ContactMode> mode);
  /// Where the paper stands: the domain of the force variable.
  const std::optional<ForceInterval>& force_domain() const { return domain_; }

  /// The truth of a statement for all values of a parameter beyond some value, the others as they are.
  Truth eventually(const Program& statement, std::size_t parameter) const;
  Truth region(const Program& region) { return constants_.truth(region); }
  /// Over all numbers, in the domain or not.
  std::vector<TruthCell> over_forces(const Program& statement) { return truth_over_forces(statement, functions_); }
  /// The forces in the domain at which a statement is true, and those at which it has no value.
  struct TrueForces {
    std::vector<ForceInterval> parts, unvalued;  ///< ascending, none empty

    bool valued() const { return unvalued.empty(); }
  };
  TrueForces true_at(const Program& statement);
  /// The forces in the domain at which the mode has motions: strict ones, or all.
  ForceInterval forces_of(const ModeSolution& mode, bool strict) const;
  /// Gives the quantities the values of a motion (over pedal forces) as functions of the force variable.
  void set_motion(const Motion<Affine<Rational>>& motion);
  /// What is affine in the pedal force, in the force variable.
  Affine<Rational> in_variable(const Affine<Rational>& pedal) const {
    return {pedal.alpha + pedal.beta * force_.alpha, pedal.beta * force_.beta};
  }

 private:
  SolvedSample(const CompiledSetting& setting, std::vector<Rational> values);
  const LinearRows& raw_rows(ContactState both);
  bool read_scene(ForceKind kind);

  const CompiledSetting* setting_;
  std::vector<Rational> values_;
  Evaluator<Rational> constants_;
  Evaluator<ForceFunction> functions_;
  Scene scene_;
  Affine<Rational> force_;
  std::shared_ptr<const ModeTable> table_;
  std::optional<std::vector<ContactMode>> only_modes_;
  std::optional<ForceInterval> domain_;
  std::shared_ptr<const std::vector<Cell>> cells_;
  std::array<LinearRows, 3> raw_rows_;  ///< of both wheels in one state on the road
};

}  // namespace slipproof
