#include "mechanics/scene/solve_mechanism.hpp"

#include <utility>

#include "base/input/diagnostic.hpp"
#include "mechanics/kernel/kinematic_modes.hpp"
#include "mechanics/mechanism/words.hpp"

namespace slipproof {

namespace {

FrictionProblem checked_problem(const MechanismScene& scene) {
  FrictionProblem problem;
  try {
    problem = friction_problem(scene.mechanism, scene.values);
  } catch (const NoValue& error) {
    throw InputError({{scene.mechanism.file, 0, 0, error.what()}});
  }
  return without_equations(problem);
}

void find_modes(SolvedMechanism& solved, Listing listing) {
  std::optional<ModesOf> all;
  if (has_too_many_to_try(solved.problem)) {
    if (listing == Listing::modes) all = every_mode(solved.problem, std::nullopt);
    solved.ranges_complete = all.has_value();
  }
  solved.modes = all ? std::move(all->consistent) : consistent_modes(solved.problem, std::nullopt);
}

void find_motions(SolvedMechanism& solved, Listing listing) {
  const FrictionProblem& problem = solved.problem;
  const std::optional<Rational>& load = solved.scene.load;
  if (problem.has_load) find_modes(solved, listing);
  if (problem.has_load && !load) {
    solved.cells = cells_of(problem, solved.modes);
    solved.by_kinematics = !solved.ranges_complete;
    return;
  }
  solved.at_load = motions_of(problem, load, listing);
  solved.by_kinematics = solved.at_load->by_kinematics;
  if (has_too_many_to_try(problem)) return;
  // Modes that were excluded together share a reason. Solved alone, each has its own reason, which may be a single
  // condition.
  const ModeSolver solver(problem, load);
  for (RejectedMode& rejected : solved.at_load->rejected) {
    if (!rejected.margin) rejected = std::move(solver.one(rejected.mode).rejected.front());
  }
}

}  // namespace

SolvedMechanism solve_mechanism(MechanismScene scene, Listing listing) {
  FrictionProblem problem = checked_problem(scene);
  SolvedMechanism solved{std::move(scene), std::move(problem), false, true, {}, {}, {}};
  try {
    find_motions(solved, listing);
  } catch (const TooMuchWork&) {
    throw InputError({{solved.scene.mechanism.file, 0, 0, too_many_modes(mode_count(kinds_of(solved.problem)))}});
  }
  return solved;
}

}  // namespace slipproof
