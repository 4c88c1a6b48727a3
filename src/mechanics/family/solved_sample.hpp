// One sample of a family: its mechanism at a point, all modes solved, and values for the family's symbols.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/expression/filtered.hpp"
#include "mechanics/family/compiled_family.hpp"
#include "mechanics/family/force_truth.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"

namespace slipproof {

/// Rows of coefficients: of the mechanism's unknowns in their order, of the force variable, and the constant. Each row
/// equals 0.
using LinearRows = std::vector<std::vector<Rational>>;

/// Modes are solved over the mechanism's load. The family has its own force variable x, where load = offset + slope x.
/// All results of this class are in x unless stated otherwise. Without a load x is 0. Not shared between threads.
class SolvedSample {
 public:
  /// Nothing if the sample is not a point of the mechanism: a scene expression or a coefficient is undefined, or the
  /// point is outside the domain. The family must outlive the sample.
  static std::unique_ptr<SolvedSample> make(const CompiledFamily& family, std::vector<Rational> values);
  /// The same, and nothing if a value is outside its own domain, which samplers keep to.
  static std::unique_ptr<SolvedSample> in_domain(const CompiledFamily& family, std::vector<Rational> values);

  const std::vector<Rational>& values() const { return values_; }
  /// The mechanism's own parameters.
  const MechanismValues& point() const { return point_; }
  const FrictionProblem& problem() const { return *problem_; }
  /// All modes over the load. Solved at the first call, since most samples are outside most regions.
  const MotionsOverLoads& motions();
  /// Solves only the given modes in motions(), where no others are needed. Call before the first motions().
  void only_modes(std::vector<MechanismMode> modes) { only_modes_ = std::move(modes); }
  /// The same point for another version of its family, with all that is already solved. The versions may differ in
  /// definitions, but not in parameters, scene or force.
  std::unique_ptr<SolvedSample> under(const CompiledFamily& other);

  /// The load at a value of the force variable.
  Rational load(const Rational& x) const { return load_.at(x); }
  /// Converts loads to values of the force variable.
  ForceInterval in_variable(const ForceInterval& loads) const;
  /// The partition of the line of the force variable; motions have modes only, all or at least the named ones that they
  /// have. Made at the first call, and, where not all modes are tried, whenever other modes are named.
  const std::vector<LoadCell>& cells(const std::vector<MechanismMode>& named = {});
  /// The same with the motions' numbers; made anew at each call.
  std::vector<LoadCell> cells_with_numbers() { return cells_in_detail(Detail::numbers, {}); }
  /// The equations that hold in every mode without an open contact; for a mode, also the equations of its states.
  LinearRows equations(const std::optional<MechanismMode>& mode);
  /// The domain of the force variable.
  const std::optional<ForceInterval>& force_domain() const { return domain_; }

  /// The truth of a statement for all sufficiently large values of a parameter, with the others unchanged.
  Truth eventually(const Program& statement, std::size_t parameter) const;
  Truth region(const Program& region) { return constants_.truth(region); }
  /// The truth of a statement over all numbers, inside and outside the domain.
  std::vector<TruthCell> over_forces(const Program& statement) {
    if (!family_->varies(statement)) return {{ForceInterval(), constants_.truth(statement)}};
    return truth_over_forces(statement, functions_);
  }
  /// The forces in the domain at which a statement is true, and those at which it has no value.
  struct TrueForces {
    std::vector<ForceInterval> parts, unvalued;  ///< ascending, none empty

    bool valued() const { return unvalued.empty(); }
  };
  TrueForces true_at(const Program& statement);
  /// The forces in the domain at which the mode has motions: strict motions only, or all.
  ForceInterval forces_of(const ModeOverLoads& mode, bool strict) const;
  /// Assigns values in a mode, as functions of the force variable, to the quantities; quantities that the force does
  /// not determine get none. Returns whether all quantities that the programs use are determined.
  bool set_motion(const ModeForms& forms, const std::vector<std::size_t>& slots);
  /// Converts an affine function of the load to one of the force variable.
  Affine<Rational> in_variable(const Affine<Rational>& over_load) const {
    return {over_load.alpha + over_load.beta * load_.alpha, over_load.beta * load_.beta};
  }

 private:
  SolvedSample(const CompiledFamily& family, std::vector<Rational> values);
  bool read_scene();
  bool read_load();
  std::vector<LoadCell> cells_in_detail(Detail detail, const std::vector<MechanismMode>& named);
  void put_in_variable(MotionOverLoads& motion) const;

  const CompiledFamily* family_;
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
  std::vector<MechanismMode> named_;  ///< in cells_
};

/// The forms of a mode's quantities, in the order of Setting::quantities().
const AffineForm& quantity_form(const ModeForms& forms, std::size_t quantity);

}  // namespace slipproof
