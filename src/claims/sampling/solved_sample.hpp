// One sample of a setting: its mechanism at a point, all modes solved, and the claims' symbols with their values.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/expression/filtered.hpp"
#include "claims/paper/compiled.hpp"
#include "claims/paper/force_truth.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"

namespace slipproof {

/// Rows of coefficients: of the mechanism's unknowns in their order, of the force variable, and the constant; each row
/// vanishes.
using LinearRows = std::vector<std::vector<Rational>>;

/// Modes are solved over the mechanism's load; claims speak of the paper's force variable x, and load = offset + slope
/// x. Everything that this class gives out is in x, unless it says otherwise. Without a load x is 0. Not shared between
/// threads.
class SolvedSample {
 public:
  /// Nothing if the sample is no point of the mechanism (a scene expression or a coefficient undefined, or out of its
  /// domain). The setting must outlive the sample.
  static std::unique_ptr<SolvedSample> make(const CompiledSetting& setting, std::vector<Rational> values);

  const std::vector<Rational>& values() const { return values_; }
  /// The mechanism's own parameters.
  const MechanismValues& point() const { return point_; }
  const FrictionProblem& problem() const { return *problem_; }
  /// All modes, over the load; solved when first asked for, since most samples are outside of most regions.
  const MotionsOverLoads& motions();
  /// Lets motions() have these modes only: for one claim that asks for no others. Before motions() is first used.
  void only_modes(std::vector<MechanismMode> modes) { only_modes_ = std::move(modes); }
  /// The same point for another version of its setting, with what is already solved: the versions may differ in
  /// definitions, not in parameters, scene or force.
  std::unique_ptr<SolvedSample> under(const CompiledSetting& other);

  /// The load at a value of the force variable.
  Rational load(const Rational& x) const { return load_.at(x); }
  /// Loads as the force variable sees them.
  ForceInterval in_variable(const ForceInterval& loads) const;
  /// The partition of the line of the force variable, motions with their modes only; made when first asked for.
  const std::vector<LoadCell>& cells();
  /// The same with the motions' numbers; made anew each time.
  std::vector<LoadCell> cells_with_numbers() { return cells_told(Told::numbers); }
  /// The equations that hold in every mode, with no contact open; in a mode, with the equations of its states.
  LinearRows equations(const std::optional<MechanismMode>& mode);
  /// Where the paper stands: the domain of the force variable.
  const std::optional<ForceInterval>& force_domain() const { return domain_; }

  /// The truth of a statement for all values of a parameter beyond some value, the others as they are.
  Truth eventually(const Program& statement, std::size_t parameter) const;
  Truth region(const Program& region) { return constants_.truth(region); }
  /// Over all numbers, in the domain or not.
  std::vector<TruthCell> over_forces(const Program& statement) {
    if (!setting_->varies(statement)) return {{ForceInterval(), constants_.truth(statement)}};
    return truth_over_forces(statement, functions_);
  }
  /// The forces in the domain at which a statement is true, and those at which it has no value.
  struct TrueForces {
    std::vector<ForceInterval> parts, unvalued;  ///< ascending, none empty

    bool valued() const { return unvalued.empty(); }
  };
  TrueForces true_at(const Program& statement);
  /// The forces in the domain at which the mode has motions: strict ones, or all.
  ForceInterval forces_of(const ModeOverLoads& mode, bool strict) const;
  /// Gives the quantities their values in a mode as functions of the force variable; those that the force does not
  /// determine have none. Whether all are determined of which some program speaks.
  bool set_motion(const ModeForms& forms, const std::vector<std::size_t>& slots);
  /// What is affine in the load, in the force variable.
  Affine<Rational> in_variable(const Affine<Rational>& over_load) const {
    return {over_load.alpha + over_load.beta * load_.alpha, over_load.beta * load_.beta};
  }

 private:
  SolvedSample(const CompiledSetting& setting, std::vector<Rational> values);
  bool read_scene();
  bool read_load();
  std::vector<LoadCell> cells_told(Told told);
  void put_in_variable(MotionOverLoads& motion) const;

  const CompiledSetting* setting_;
  std::vector<Rational> values_;
  FilteredEvaluator constants_;
  Evaluator<ForceFunction> functions_;
  MechanismValues point_;
  Affine<Rational> load_{0, 1};
  std::optional<std::vector<MechanismMode>> only_modes_;
  std::shared_ptr<const FrictionProblem> problem_;
  std::shared_ptr<const MotionsOverLoads> motions_;
  std::optional<ForceInterval> domain_;
  std::shared_ptr<const std::vector<LoadCell>> cells_;
};

/// The forms of a mode's quantities, in the order of Setting::quantities().
const AffineForm& quantity_form(const ModeForms& forms, std::size_t quantity);

}  // namespace slipproof
