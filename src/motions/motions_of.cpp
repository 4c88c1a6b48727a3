#include "motions/motions_of.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "parallel/stop.hpp"

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
  return with(solutions, differences, effort).has_value();
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
  const std::vector<ConsistentMode> lower_modes = ModeSolver(*lowered, load).consistent();
  const MotionsAtLoad left = gather(*lowered, lower_modes);
  if (left.motions.size() != 1 || !left.continua.empty()) return {};
  std::vector<MechanismMode> gone = modes_with_motions(consistent);
  const std::vector<MechanismMode> stay = modes_with_motions(lower_modes);
  std::erase_if(gone, [&](const auto& mode) { return std::find(stay.begin(), stay.end(), mode) != stay.end(); });
  return gone;
}

using OverLoads = std::vector<Affine<Rational>>;
using ForcesOverLoads = std::vector<std::optional<Affine<Rational>>>;

/// Forms that are determined on a space, over the load; nothing for others.
ForcesOverLoads values_on(const AffineSpace& space, const std::vector<AffineForm>& forms) {
  ForcesOverLoads values;
  for (const AffineForm& form : forms) {
    const AffineForm whole = space.on(form);
    if (is_free_of_unknowns(whole)) {
      values.emplace_back(Affine<Rational>(whole.constant, whole.coefficients.back()));
    } else {
      values.emplace_back();
    }
  }
  return values;
}

/// A mode for all its loads.
struct ModeOfCells {
  const ConsistentMode* found;
  bool regular = false;     ///< its equations leave one solution for each load
  OverLoads accelerations;  ///< of a determined mode
  ForcesOverLoads forces;   ///< of such a one, too

  ModeOfCells(const FrictionProblem& problem, const ConsistentMode& mode) : found(&mode) {
    const AffineSpace& space = mode.solutions.space;
    regular = space.dimension() == 0 && space.load_is_free();
    if (!mode.determined) return;
    for (auto& value : values_on(space, problem.accelerations)) accelerations.push_back(std::move(*value));
    forces = values_on(space, problem.forces);
  }
};

/// The same at one load.
OverLoads at(const OverLoads& values, const Rational& load) {
  OverLoads result;
  for (const auto& value : values) result.emplace_back(value.at(load));
  return result;
}
ForcesOverLoads at(const ForcesOverLoads& values, const Rational& load) {
  ForcesOverLoads result;
  for (const auto& value : values) result.push_back(value ? std::optional<Affine<Rational>>(value->at(load)) : value);
  return result;
}

/// Where two motions that are affine in the load are the same, if at one load only.
std::optional<Rational> crossing(const OverLoads& x, const OverLoads& y) {
  std::optional<Rational> load;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Affine<Rational> d = x[i] - y[i];
    if (d.beta.is_zero()) {
      if (!d.alpha.is_zero()) return std::nullopt;
      continue;
    }
    const Rational root = -d.alpha / d.beta;
    if (load && *load != root) return std::nullopt;
    load = root;
  }
  return load;
}

/// The cells of the loads, from the modes.
class Cells {
 public:
  Cells(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent) : problem_(problem) {
    for (const ConsistentMode& mode : consistent) modes_.emplace_back(problem, mode);
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
      form.constant -= modes_[other].accelerations[i].alpha;
      form.coefficients.back() -= modes_[other].accelerations[i].beta;
      differences.push_back(std::move(form));
    }
    if (const auto common = with(continuum.solutions, differences)) add_ends(points, common->loads);
  }

  std::vector<Rational> breakpoints() const {
    std::vector<Rational> points;
    add_ends(points, problem_.load_domain);
    for (const ModeOfCells& mode : modes_) add_ends(points, mode.found->solutions.loads);
    for (std::size_t i = 0; i < modes_.size(); ++i) {
      stop_if_asked();
      for (std::size_t j = 0; j < modes_.size(); ++j) {
        if (!modes_[j].found->determined || i == j) continue;
        if (!modes_[i].found->determined) {
          add_containment(points, *modes_[i].found, j);
        } else if (j < i) {
          if (auto load = crossing(modes_[i].accelerations, modes_[j].accelerations))
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

  /// The motions at one load, or at all loads of an open interval: inside they are those at one, and affine in it.
  LoadCell cell(const ForceInterval& loads) const {
    LoadCell result{loads, {}, {}};
    const Rational load = loads.sample();
    std::vector<Polyhedron> continua;
    for (const ModeOfCells& mode : modes_) {
      const ConsistentMode& found = *mode.found;
      if (!found.solutions.loads.contains(load)) continue;
      if (mode.regular) {
        const bool strict = loads.is_point() ? strict_at(found.solutions, load) : found.solutions.strict;
        add_motion(result, mode, strict);
        continue;
      }
      auto solutions = at_load(found.solutions, load);
      if (!solutions) continue;
      ConsistentMode here = consistent_mode(problem_, found.mode, std::move(*solutions));
      if (!here.determined) {
        result.continua.push_back(here.mode);
        continua.push_back(std::move(here.solutions));
      } else {
        add_motion(result, loads.is_point() ? ModeOfCells(problem_, here) : mode, here.solutions.strict);
      }
    }
    std::erase_if(result.motions, [&](const MotionOverLoads& motion) {
      std::vector<Rational> accelerations;
      for (const auto& value : motion.accelerations) accelerations.push_back(value.at(load));
      return std::any_of(continua.begin(), continua.end(), [&](const Polyhedron& solutions) {
        return contains(problem_, solutions, accelerations, nullptr);
      });
    });
    return result;
  }

  /// A mode's motion, or the mode to those of the same motion; forces that differ among them are undetermined.
  static void add_motion(LoadCell& cell, const ModeOfCells& mode, bool strict) {
    const bool point = cell.loads.is_point();
    const Rational load = point ? cell.loads.sample() : Rational();
    OverLoads accelerations = point ? at(mode.accelerations, load) : mode.accelerations;
    ForcesOverLoads forces = point ? at(mode.forces, load) : mode.forces;
    auto motion = std::find_if(cell.motions.begin(), cell.motions.end(),
                               [&](const MotionOverLoads& m) { return m.accelerations == accelerations; });
    if (motion == cell.motions.end()) {
      cell.motions.push_back({{}, {}, std::move(accelerations), std::move(forces)});
      motion = cell.motions.end() - 1;
    } else {
      for (std::size_t k = 0; k < forces.size(); ++k) {
        if (motion->forces[k] != forces[k]) motion->forces[k].reset();
      }
    }
    (strict ? motion->modes : motion->boundary_modes).push_back(mode.found->mode);
  }

  const FrictionProblem& problem_;
  std::vector<ModeOfCells> modes_;
};

}  // namespace

std::vector<MechanismMode> MotionAtLoad::all_modes() const {
  std::vector<MechanismMode> all = modes;
  all.insert(all.end(), boundary_modes.begin(), boundary_modes.end());
  return all;
}

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
    if (is_new) result.motions.push_back({std::move(accelerations), {}});
    result.motions[place->second].modes.push_back(i);
  }
  std::erase_if(result.motions, [&](const MergedModes::Motion& motion) {
    return std::any_of(result.continua.begin(), result.continua.end(), [&](std::size_t i) {
      return contains(problem, consistent[i].solutions, motion.accelerations, effort);
    });
  });
  return result;
}

MotionsAtLoad motions_of(const FrictionProblem& problem, const std::optional<Rational>& load) {
  const FrictionProblem solved = without_equations(problem);
  ModesOf modes = modes_of(solved, load);
  MotionsAtLoad result = gather(solved, modes.consistent);
  result.hysteresis = hysteresis(solved, result, modes.consistent, load);
  result.rejected = std::move(modes.rejected);
  return result;
}

std::vector<LoadCell> cells_of(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent) {
  return Cells(problem, consistent).all();
}

}  // namespace slipproof
