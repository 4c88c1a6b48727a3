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

/// What a mode that holds for more than one load says of it.
Affine<Rational> over_loads(const AffineForm& form) {
  return {form.constant, form.coefficients.back()};
}

/// Where two motions that are affine in the load are the same, if at one load only.
std::optional<Rational> crossing(const std::vector<Affine<Rational>>& x, const std::vector<Affine<Rational>>& y) {
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
  Cells(const FrictionProblem& problem, const std::vector<ConsistentMode>& consistent)
      : problem_(problem), consistent_(consistent) {
    for (const ConsistentMode& mode : consistent) {
      std::vector<Affine<Rational>> motion;
      if (mode.determined) {
        for (const AffineForm& form : problem.accelerations)
          motion.push_back(over_loads(mode.solutions.space.on(form)));
      }
      motions_.push_back(std::move(motion));
    }
  }

  std::vector<LoadCell> all() {
    std::vector<LoadCell> cells;
    const ForceInterval& domain = problem_.load_domain;
    if (domain.empty()) return cells;
    std::optional<Rational> below = domain.lower();
    for (const Rational& point : breakpoints()) {
      if (below != point) add_open(cells, below, point);
      if (domain.contains(point)) cells.push_back(at(point));
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
      form.constant -= motions_[other][i].alpha;
      form.coefficients.back() -= motions_[other][i].beta;
      differences.push_back(std::move(form));
    }
    if (const auto common = with(continuum.solutions, differences)) add_ends(points, common->loads);
  }

  std::vector<Rational> breakpoints() const {
    std::vector<Rational> points;
    add_ends(points, problem_.load_domain);
    for (const ConsistentMode& mode : consistent_) add_ends(points, mode.solutions.loads);
    for (std::size_t i = 0; i < consistent_.size(); ++i) {
      stop_if_asked();
      for (std::size_t j = 0; j < consistent_.size(); ++j) {
        if (!consistent_[j].determined || i == j) continue;
        if (!consistent_[i].determined) {
          add_containment(points, consistent_[i], j);
        } else if (j < i) {
          if (auto load = crossing(motions_[i], motions_[j])) points.push_back(std::move(*load));
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

  /// The modes at one load.
  std::vector<ConsistentMode> slice(const Rational& load) const {
    std::vector<ConsistentMode> result;
    for (const ConsistentMode& mode : consistent_) {
      if (!mode.solutions.loads.contains(load)) continue;
      auto solutions = at_load(mode.solutions, load);
      if (!solutions) continue;
      result.push_back(consistent_mode(problem_, mode.mode, std::move(*solutions)));
    }
    return result;
  }

  LoadCell at(const Rational& load) const {
    LoadCell cell{ForceInterval::point(load), {}, {}};
    MotionsAtLoad found = gather(problem_, slice(load));
    for (MotionAtLoad& motion : found.motions) {
      MotionOverLoads over{std::move(motion.modes), std::move(motion.boundary_modes), {}, {}};
      for (Rational& value : motion.accelerations) over.accelerations.emplace_back(std::move(value));
      for (Range& force : motion.forces) {
        over.forces.push_back(force.is_point() ? std::optional(Affine<Rational>(*force.lower)) : std::nullopt);
      }
      cell.motions.push_back(std::move(over));
    }
    for (ContinuumAtLoad& continuum : found.continua) cell.continua.push_back(std::move(continuum.mode));
    return cell;
  }

  /// Inside a cell the motions at one load are those at all, and affine in it.
  void add_open(std::vector<LoadCell>& cells, const std::optional<Rational>& from,
                const std::optional<Rational>& to) const {
    LoadCell cell{ForceInterval::between(from, false, to, false), {}, {}};
    if (cell.loads.empty()) return;
    const Rational inside = cell.loads.sample();
    const MotionsAtLoad found = gather(problem_, slice(inside));
    for (const MotionAtLoad& motion : found.motions) cell.motions.push_back(over(motion));
    for (const ContinuumAtLoad& continuum : found.continua) cell.continua.push_back(continuum.mode);
    cells.push_back(std::move(cell));
  }

  MotionOverLoads over(const MotionAtLoad& motion) const {
    MotionOverLoads result{motion.modes, motion.boundary_modes, {}, {}};
    std::vector<std::size_t> modes;
    for (const auto* names : {&motion.modes, &motion.boundary_modes}) {
      for (const MechanismMode& mode : *names) modes.push_back(place_of(mode));
    }
    result.accelerations = motions_[modes.front()];
    for (const AffineForm& force : problem_.forces) result.forces.push_back(common_value(force, modes));
    return result;
  }

  std::size_t place_of(const MechanismMode& mode) const {
    const auto place =
        std::find_if(consistent_.begin(), consistent_.end(), [&](const ConsistentMode& c) { return c.mode == mode; });
    return static_cast<std::size_t>(place - consistent_.begin());
  }

  /// What a force is in all of some modes; nothing if they, or the solutions of one, differ.
  std::optional<Affine<Rational>> common_value(const AffineForm& force, const std::vector<std::size_t>& modes) const {
    std::optional<Affine<Rational>> value;
    for (const std::size_t mode : modes) {
      const AffineForm form = consistent_[mode].solutions.space.on(force);
      if (!is_free_of_unknowns(form) || (value && *value != over_loads(form))) return std::nullopt;
      value = over_loads(form);
    }
    return value;
  }

  const FrictionProblem& problem_;
  const std::vector<ConsistentMode>& consistent_;
  std::vector<std::vector<Affine<Rational>>> motions_;  ///< of determined modes
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
