#include "mechanics/kernel/motions.hpp"

#include <algorithm>
#include <iterator>
#include <list>
#include <map>
#include <utility>

#include "base/parallel/stop.hpp"
#include "mechanics/kernel/kinematic_modes.hpp"
#include "mechanics/kernel/mode_over_loads.hpp"

namespace slipproof {

namespace {

void widen(Range& range, const Range& by) {
  if (!by.lower || (range.lower && *by.lower < *range.lower)) range.lower = by.lower;
  if (!by.upper || (range.upper && *by.upper > *range.upper)) range.upper = by.upper;
}

/// Whether a mode's solutions have a motion among them.
bool contains(const FrictionProblem& problem, const Polyhedron& solutions, const std::vector<Rational>& accelerations,
              Effort* effort) {
  std::vector<AffineForm> differences;
  for (std::size_t i = 0; i < accelerations.size(); ++i) {
    differences.push_back(problem.accelerations[i]);
    differences.back().constant -= accelerations[i];
  }
  return restrict_to_zeros(solutions, differences, effort).has_value();
}

MotionsAtLoad gather(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent) {
  MotionsAtLoad result;
  MergedModes merged = merge(problem, consistent);
  for (MergedModes::Motion& motion : merged.motions) {
    MotionAtLoad& found = result.motions.emplace_back();
    found.accelerations = std::move(motion.accelerations);
    for (const std::size_t i : motion.modes) {
      const ConsistentMode& mode = consistent[i];
      (mode.solutions.strict ? found.modes : found.boundary_modes).push_back(mode.mode);
      std::vector<Range> forces = ranges(mode.solutions, problem.forces);
      if (found.forces.empty()) {
        found.forces = std::move(forces);
      } else {
        for (std::size_t k = 0; k < forces.size(); ++k) widen(found.forces[k], forces[k]);
      }
    }
    for (const std::size_t i : motion.within) found.continua.push_back(consistent[i].mode);
  }
  for (const std::size_t i : merged.continua) {
    const ConsistentMode& mode = consistent[i];
    result.continua.push_back({mode.mode, mode.solutions.strict, ranges(mode.solutions, problem.accelerations),
                               ranges(mode.solutions, problem.forces)});
  }
  return result;
}

std::vector<MechanismMode> modes_with_motions(const std::vector<ConsistentMode>& consistent) {
  std::vector<MechanismMode> modes;
  for (const ConsistentMode& found : consistent) modes.push_back(found.mode);
  return modes;
}

std::vector<MechanismMode> hysteresis(const FrictionProblem& problem, const MotionsAtLoad& found,
                                      const std::vector<ConsistentMode>& consistent,
                                      const std::optional<Rational>& load) {
  if (found.motions.size() < 2 || !found.continua.empty()) return {};
  const auto lowered = without_hysteresis(problem);
  if (!lowered) return {};
  const MergedModes left = merge(*lowered, consistent_modes(*lowered, load));
  if (left.motions.size() != 1 || !left.continua.empty()) return {};
  std::vector<MechanismMode> gone = modes_with_motions(consistent);
  const std::vector<MechanismMode> stay =
      modes_with_motions(ModeSolver(*lowered, load, states_in(gone, problem.elements.size())).consistent_among(gone));
  std::erase_if(gone, [&](const auto& mode) { return std::find(stay.begin(), stay.end(), mode) != stay.end(); });
  return gone;
}

MotionsAtLoad gather_with_hysteresis(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent,
                                     const std::optional<Rational>& load) {
  MotionsAtLoad result = gather(problem, consistent);
  result.hysteresis = hysteresis(problem, result, consistent, load);
  return result;
}

/// The cells of the loads, from the modes.
class Cells {
 public:
  Cells(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent, Detail detail)
      : problem_(problem), detail_(detail) {
    const NearForms accelerations = near(problem.accelerations);
    for (const ConsistentMode& mode : consistent) modes_.emplace_back(problem, mode, accelerations);
  }

  std::vector<LoadCell> all() {
    std::vector<LoadCell> cells;
    const ForceInterval& domain = problem_.load_domain;
    if (domain.empty()) return cells;
    std::optional<Rational> below = domain.lower();
    for (const Rational& point : breakpoints()) {
      if (below != point) add_open(cells, below, point);
      if (domain.contains(point)) cells.push_back(cell(ForceInterval::point(point)));
      below = point;
    }
    if (!below || below != domain.upper()) add_open(cells, below, domain.upper());
    return cells;
  }

 private:
  void add_ends(std::vector<Rational>& points, const ForceInterval& interval) const {
    if (interval.lower()) points.push_back(*interval.lower());
    if (interval.upper()) points.push_back(*interval.upper());
  }

  /// Where a continuum begins or ends to contain another mode's motion.
  void add_containment(std::vector<Rational>& points, const ConsistentMode& continuum, std::size_t other) const {
    std::vector<AffineForm> differences;
    for (std::size_t i = 0; i < problem_.accelerations.size(); ++i) {
      AffineForm form = problem_.accelerations[i];
      form.constant -= modes_[other].acceleration(i).alpha;
      form.coefficients.back() -= modes_[other].acceleration(i).beta;
      differences.push_back(std::move(form));
    }
    if (const auto common = restrict_to_zeros(continuum.solutions, differences)) add_ends(points, common->loads);
  }

  std::vector<Rational> breakpoints() const {
    std::vector<Rational> points;
    add_ends(points, problem_.load_domain);
    for (const ModeOfCells& mode : modes_) add_ends(points, mode.found().solutions.loads);
    for (std::size_t i = 0; i < modes_.size(); ++i) {
      stop_if_asked();
      for (std::size_t j = 0; j < modes_.size(); ++j) {
        if (!modes_[j].found().determined || i == j) continue;
        if (!modes_[i].found().determined) {
          add_containment(points, modes_[i].found(), j);
        } else if (j < i) {
          if (auto load = crossing(modes_[i], modes_[j], problem_.accelerations.size()))
            points.push_back(std::move(*load));
        }
      }
    }
    std::erase_if(points, [&](const Rational& x) { return !reaches(x); });
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

  /// Whether a load is in the domain or one of its ends.
  bool reaches(const Rational& load) const {
    const ForceInterval& domain = problem_.load_domain;
    return !(domain.lower() && load < *domain.lower()) && !(domain.upper() && load > *domain.upper());
  }

  void add_open(std::vector<LoadCell>& cells, const std::optional<Rational>& from,
                const std::optional<Rational>& to) const {
    const auto loads = ForceInterval::between(from, false, to, false);
    if (!loads.empty()) cells.push_back(cell(loads));
  }

  /// A mode of a cell at a load for which it has more than one solution.
  struct AtPoint {
    ConsistentMode mode;
    ModeOfCells of_cells;
    AtPoint(const FrictionProblem& problem, ConsistentMode here) : mode(std::move(here)), of_cells(problem, mode) {}
    AtPoint(const AtPoint&) = delete;
  };

  /// The motions at one load, or at all loads of an open interval: inside it they have the same modes, and are affine
  /// in the load.
  LoadCell cell(const ForceInterval& loads) const {
    LoadCell result{loads, {}, {}};
    const Rational load = loads.sample();
    std::vector<Polyhedron> continua;
    std::vector<const ModeOfCells*> first;  // by motion: its first mode
    std::list<AtPoint> at_point;
    for (const ModeOfCells& mode : modes_) {
      const ConsistentMode& found = mode.found();
      if (!found.solutions.loads.contains(load)) continue;
      if (mode.regular()) {
        const bool strict = loads.is_point() ? strict_at(found.solutions, load) : found.solutions.strict;
        add_motion(result, first, mode, strict);
        continue;
      }
      auto solutions = at_load(found.solutions, load);
      if (!solutions) continue;
      ConsistentMode here = consistent_mode(problem_, found.mode, std::move(*solutions));
      if (!here.determined) {
        result.continua.push_back(here.mode);
        continua.push_back(std::move(here.solutions));
        continue;
      }
      const bool strict = here.solutions.strict;
      add_motion(result, first, loads.is_point() ? at_point.emplace_back(problem_, std::move(here)).of_cells : mode,
                 strict);
    }
    if (!continua.empty()) add_continua(result, first, continua, load);
    return result;
  }

  /// To each motion, the continua that contain it.
  void add_continua(LoadCell& cell, const std::vector<const ModeOfCells*>& first,
                    const std::vector<Polyhedron>& continua, const Rational& load) const {
    for (std::size_t k = 0; k < cell.motions.size(); ++k) {
      const std::vector<Rational> accelerations = first[k]->accelerations_at(load);
      for (std::size_t i = 0; i < continua.size(); ++i) {
        if (contains(problem_, continua[i], accelerations, nullptr))
          cell.motions[k].continua.push_back(cell.continua[i]);
      }
    }
  }

  /// A mode's motion, or the mode to those of the same motion; forces that differ among them are undetermined.
  void add_motion(LoadCell& cell, std::vector<const ModeOfCells*>& first, const ModeOfCells& mode, bool strict) const {
    std::size_t k = 0;
    while (k < first.size() && !is_same(*first[k], mode, cell.loads)) ++k;
    if (k == first.size()) {
      first.push_back(&mode);
      cell.motions.emplace_back();
      if (detail_ == Detail::numbers) add_numbers(cell, mode);
    } else if (detail_ == Detail::numbers) {
      const ForcesOverLoads forces = forces_in(cell, mode);
      for (std::size_t i = 0; i < forces.size(); ++i) {
        if (cell.motions[k].forces[i] != forces[i]) cell.motions[k].forces[i].reset();
      }
    }
    (strict ? cell.motions[k].modes : cell.motions[k].boundary_modes).push_back(mode.found().mode);
  }

  /// Whether two modes have the same motion at the loads of a cell.
  bool is_same(const ModeOfCells& x, const ModeOfCells& y, const ForceInterval& loads) const {
    if (surely_differ(x, y, loads.is_point() ? loads.lower() : std::nullopt)) return false;
    for (std::size_t i = 0; i < problem_.accelerations.size(); ++i) {
      const Affine<Rational>&a = x.acceleration(i), &b = y.acceleration(i);
      if (loads.is_point() ? a.at(*loads.lower()) != b.at(*loads.lower()) : a != b) return false;
    }
    return true;
  }

  /// To the motion that was added last.
  static void add_numbers(LoadCell& cell, const ModeOfCells& mode) {
    OverLoads accelerations = mode.accelerations();
    cell.motions.back().accelerations =
        cell.loads.is_point() ? at(accelerations, *cell.loads.lower()) : std::move(accelerations);
    cell.motions.back().forces = forces_in(cell, mode);
  }

  static ForcesOverLoads forces_in(const LoadCell& cell, const ModeOfCells& mode) {
    ForcesOverLoads forces = mode.forces();
    return cell.loads.is_point() ? at(forces, *cell.loads.lower()) : forces;
  }

  const FrictionProblem& problem_;
  Detail detail_;
  std::vector<ModeOfCells> modes_;
};

}  // namespace

std::optional<FrictionProblem> without_hysteresis(const FrictionProblem& problem) {
  FrictionProblem result = problem;
  bool differs = false;
  for (ProblemElement& e : result.elements) {
    differs = differs || e.static_limit.constant != e.kinetic_limit.constant ||
              e.static_limit.coefficients != e.kinetic_limit.coefficients;
    e.static_limit = e.kinetic_limit;
  }
  if (!differs) return std::nullopt;
  return result;
}

MergedModes merge(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent, Effort* effort) {
  MergedModes result;
  std::map<std::vector<Rational>, std::size_t> places;
  for (std::size_t i = 0; i < consistent.size(); ++i) {
    if (!consistent[i].determined) {
      result.continua.push_back(i);
      continue;
    }
    std::vector<Rational> accelerations = at_origin(consistent[i].solutions.space, problem.accelerations);
    const auto [place, is_new] = places.emplace(accelerations, result.motions.size());
    if (is_new) result.motions.push_back({std::move(accelerations), {}, {}});
    result.motions[place->second].modes.push_back(i);
  }
  for (MergedModes::Motion& motion : result.motions) {
    for (const std::size_t i : result.continua) {
      if (contains(problem, consistent[i].solutions, motion.accelerations, effort)) motion.within.push_back(i);
    }
  }
  return result;
}

MotionsAtLoad motions_of(const FrictionProblem& problem, const std::optional<Rational>& load, Listing listing) {
  const FrictionProblem solved = without_equations(problem);
  if (listing == Listing::modes || !has_too_many_to_try(solved)) {
    if (auto modes = every_mode(solved, load)) {
      MotionsAtLoad result = gather_with_hysteresis(solved, modes->consistent, load);
      result.rejected = std::move(modes->rejected);
      return result;
    }
  }
  Effort effort(kinematic_effort);
  return motions_by_kinematics(solved, load, effort);
}

MotionsAtLoad motions_by_kinematics(const FrictionProblem& problem, const std::optional<Rational>& load,
                                    Effort& effort) {
  const FrictionProblem solved = without_equations(problem);
  MotionsAtLoad result = gather_with_hysteresis(solved, kinematic_modes(solved, load, effort), load);
  result.by_kinematics = true;
  return result;
}

std::vector<LoadCell> cells_of(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent,
                               Detail detail) {
  return Cells(problem, consistent, detail).all();
}

}  // namespace slipproof
