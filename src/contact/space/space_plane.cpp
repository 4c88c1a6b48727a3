#include "contact/space/space_plane.hpp"

#include <algorithm>
#include <memory>

#include "base/input/diagnostic.hpp"
#include "contact/space/solve_space.hpp"
#include "contact/space/space_problem.hpp"
#include "mechanics/family/freed_scene.hpp"
#include "mechanics/planes/axis_choice.hpp"

namespace slipproof {

namespace {

ElementState state_of(const std::string& mode) {
  if (mode == "slip") return ElementState::slip_forward;
  return mode == "stick" ? ElementState::stick : mode == "touch" ? ElementState::touch : ElementState::lift;
}

/// The scene at other values of a freed symbol and of the load.
class PlaceSolver {
 public:
  PlaceSolver(const MechanismScene& scene, std::shared_ptr<const FreedScene> freed, Work effort)
      : scene_(scene), freed_(std::move(freed)) {
    options_.effort = effort;
  }

  std::optional<MotionSet> at(const Rational& x, const std::optional<Rational>& load) const {
    const auto problem = freed_->problem(x);
    if (!problem || (load && !problem->load_domain.contains(*load))) return std::nullopt;
    MechanismScene there = scene_;
    there.values = freed_->values(x);
    there.load = load;
    try {
      return motion_set(solve_space(std::move(there), options_));
    } catch (const InputError&) {  // such as links that contradict each other there
      return std::nullopt;
    }
  }

 private:
  const MechanismScene scene_;
  const std::shared_ptr<const FreedScene> freed_;
  CompleteOptions options_;
};

/// What is refused at every place is refused at once.
void expect_solvable(const MechanismScene& scene, const std::optional<Rational>& load) {
  MechanismScene there = scene;
  there.load = load;
  reduced(space_problem(there), there.mechanism);
}

}  // namespace

MotionSet motion_set(const SolvedSpace& solved) {
  MotionSet set;
  set.in_space = true;
  set.complete = solved.complete() && std::ranges::all_of(solved.motions, &SpaceMotion::exists);
  for (const SpaceMotion& motion : solved.motions) {
    if (!motion.exists) continue;
    MechanismMode mode;
    for (const std::string& one : motion.modes) mode.push_back(state_of(one));
    motion.is_continuum() ? set.continua.push_back(std::move(mode)) : set.motions.push_back({std::move(mode)});
  }
  std::ranges::sort(set.motions);
  std::ranges::sort(set.continua);
  return set;
}

Plane space_plane(const MechanismScene& scene, const MechanismAxes& axes, std::string id, Work effort) {
  const auto freed = freed_for(scene, axes);
  Plane plane = plane_frame(scene, *freed, axes, std::move(id));
  expect_solvable(scene, scene.load.value_or(plane.y.from));
  plane.note += (plane.note.empty() ? "" : " ") +
                std::string(
                    "All motions are known at the dots, where it is not said otherwise; colours between dots "
                    "are guesses.");
  const auto solver = std::make_shared<const PlaceSolver>(scene, freed, effort);
  plane.place = [solver](const Rational& x, const Rational& y) { return solver->at(x, y); };
  return plane;
}

SetsAlong space_along(const MechanismScene& scene, const MechanismAxes& axes, std::size_t parts, Work effort,
                      const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  const auto freed = freed_for(scene, axes);
  expect_solvable(scene, scene.load);
  const PlaceSolver solver(scene, freed, effort);
  const AxisChoice choice(*freed, scene, axes);
  return sets_along(
      choice.across(), parts, [&](const Rational& x) { return solver.at(x, scene.load); }, progress);
}

}  // namespace slipproof
