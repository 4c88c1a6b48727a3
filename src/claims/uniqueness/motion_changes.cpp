#include "claims/uniqueness/motion_changes.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "claims/lines/critical.hpp"
#include "claims/uniqueness/scene_setting.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"

namespace slipproof {

namespace {

MotionsThere motions_there(std::vector<std::vector<MechanismMode>> motions, std::vector<MechanismMode> continua) {
  std::ranges::sort(motions);
  std::ranges::sort(continua);
  return {std::move(motions), std::move(continua)};
}

std::vector<MechanismMode> joined(std::vector<MechanismMode> modes, const std::vector<MechanismMode>& more) {
  modes.insert(modes.end(), more.begin(), more.end());
  return modes;
}

MotionsThere of_load(const MotionsAtLoad& found) {
  std::vector<std::vector<MechanismMode>> motions;
  std::vector<MechanismMode> continua;
  for (const MotionAtLoad& motion : found.motions) motions.push_back(motion.all_modes());
  for (const ContinuumAtLoad& continuum : found.continua) continua.push_back(continuum.mode);
  return motions_there(std::move(motions), std::move(continua));
}

MotionsThere of_cell(const LoadCell& cell) {
  std::vector<std::vector<MechanismMode>> motions;
  for (const MotionOverLoads& motion : cell.motions) motions.push_back(joined(motion.modes, motion.boundary_modes));
  return motions_there(std::move(motions), cell.continua);
}

bool share_a_mode(const std::vector<MechanismMode>& x, const std::vector<MechanismMode>& y) {
  return std::ranges::any_of(x, [&](const MechanismMode& mode) { return std::ranges::find(y, mode) != y.end(); });
}

/// Whether the motions are the same functions of the parameter: those of one mode are, whatever else its forces allow.
bool alike(const MotionsThere& x, const MotionsThere& y) {
  if (x.motions.size() != y.motions.size() || x.continua.empty() != y.continua.empty()) return false;
  if (!x.continua.empty() && !share_a_mode(x.continua, y.continua)) return false;
  return std::ranges::all_of(x.motions, [&](const auto& modes) {
    return std::ranges::count_if(y.motions, [&](const auto& other) { return share_a_mode(modes, other); }) == 1;
  });
}

void add_change(std::vector<MotionChange>& changes, MotionChange change) {
  const bool changes_here = change.here && !alike(*change.here, change.below);
  if (!alike(change.below, change.above) || changes_here) changes.push_back(std::move(change));
}

std::vector<MotionChange> along_load(const MechanismScene& scene, const Rational& from, const Rational& to) {
  const auto solved = motions_over_loads(without_equations(friction_problem(scene.mechanism, scene.values)));
  const std::vector<LoadCell> cells = solved->cells(Detail::modes);
  std::vector<MotionChange> changes;
  for (std::size_t i = 1; i + 1 < cells.size(); ++i) {
    const auto point = cells[i].loads.lower();
    if (point != cells[i].loads.upper() || *point <= from || to <= *point) continue;
    add_change(changes, {{*point, *point}, of_cell(cells[i - 1]), of_cell(cells[i + 1]), of_cell(cells[i])});
  }
  return changes;
}

/// A scene with one parameter free, at its load.
class ChangesAlong {
 public:
  ChangesAlong(const MechanismScene& scene, std::string parameter)
      : scene_(scene), parameter_(std::move(parameter)), setting_(setting_along(scene, parameter_)) {
    if (const auto& load = scene.mechanism.load) {
      if (!scene.load) throw std::invalid_argument("the scene has no value of " + load->symbol + ", expected one");
      setting_.scene[load->symbol] = make_number(*scene.load);
    }
    if (mode_count(setting_.kinds()) > static_cast<double>(max_change_modes)) {
      throw std::invalid_argument("found more than " + std::to_string(max_change_modes) +
                                  " contact modes, expected fewer: how they change along a parameter takes too long");
    }
  }

  std::vector<MotionChange> between(const Rational& from, const Rational& to) const {
    std::vector<RealRoot> roots = inside(from, to);
    const std::vector<Rational> points = cell_points(roots, {from, to});
    std::vector<MotionChange> changes;
    MotionsThere below = at(points.front());
    for (std::size_t i = 0; i < roots.size(); ++i) {
      MotionsThere above = at(points[i + 1]);
      std::optional<MotionsThere> here;
      if (roots[i].is_rational()) here = at(roots[i].lower);
      add_change(changes, {std::move(roots[i]), below, above, std::move(here)});
      below = std::move(above);
    }
    return changes;
  }

 private:
  std::vector<RealRoot> inside(const Rational& from, const Rational& to) const {
    const CompiledSetting compiled(setting_);
    ClaimParts parts;
    parts.modes = modes_of(setting_.kinds());
    std::vector<RealRoot> roots;
    for (RealRoot& root : points_on({{Rational(0)}, {Rational(1)}, from}, compiled, parts).roots) {
      while (!root.is_rational() &&
             ((root.lower <= from && from <= root.upper) || (root.lower <= to && to <= root.upper)))
        halve(root);
      if (from < root.lower && root.upper < to) roots.push_back(std::move(root));
    }
    return roots;
  }

  MotionsThere at(const Rational& value) const {
    const MechanismScene there = with_values(scene_, {{parameter_, value}});
    try {
      return of_load(motions_of(friction_problem(there.mechanism, there.values), there.load));
    } catch (const NoValue& error) {
      throw std::invalid_argument(error.what());
    }
  }

  const MechanismScene& scene_;
  std::string parameter_;
  Setting setting_;
};

}  // namespace

std::vector<MotionChange> motion_changes(const MechanismScene& scene, const std::string& parameter,
                                         const Rational& from, const Rational& to) {
  if (scene.mechanism.load && scene.mechanism.load->symbol == parameter) return along_load(scene, from, to);
  return ChangesAlong(scene, parameter).between(from, to);
}

}  // namespace slipproof
