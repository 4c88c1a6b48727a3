#include "mechanics/lines/motion_changes.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "mechanics/kernel/motions.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "mechanics/lines/scene_line.hpp"

namespace slipproof {

namespace {

MotionsThere motions_there(const LoadCell& cell) {
  MotionsThere there;
  for (const MotionOverLoads& motion : cell.motions) there.motions.push_back(motion.all_modes());
  there.continua = cell.continua;
  std::ranges::sort(there.motions);
  std::ranges::sort(there.continua);
  return there;
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
    add_change(changes,
               {{*point, *point}, motions_there(cells[i - 1]), motions_there(cells[i + 1]), motions_there(cells[i])});
  }
  return changes;
}

/// A scene with one parameter free, at its load.
class ChangesAlong {
 public:
  ChangesAlong(const MechanismScene& scene, const std::string& parameter)
      : scene_(scene),
        parameter_(parameter),
        line_(scene, parameter, SceneLine::Load::own, max_change_modes, "how they change along a parameter") {}

  std::vector<MotionChange> between(const Rational& from, const Rational& to) const {
    const std::vector<LineCell> cells = line_cells(inside(from, to), {from, to});
    std::vector<MotionChange> changes;
    MotionsThere below = at(*cells[1].sample);
    for (std::size_t i = 2; i + 1 < cells.size(); i += 2) {
      const LineCell& change = cells[i];
      MotionsThere above = at(*cells[i + 1].sample);
      std::optional<MotionsThere> here;
      if (change.sample) here = at(*change.sample);
      add_change(changes, {*change.lower, below, above, std::move(here)});
      below = std::move(above);
    }
    return changes;
  }

 private:
  std::vector<RealRoot> inside(const Rational& from, const Rational& to) const {
    std::vector<RealRoot> roots;
    for (RealRoot& root : line_.points(from).roots) {
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
      return motions_there(cell_of(motions_of(friction_problem(there.mechanism, there.values), there.load)));
    } catch (const NoValue& error) {
      throw std::invalid_argument(error.what());
    }
  }

  const MechanismScene& scene_;
  const std::string& parameter_;
  const SceneLine line_;
};

}  // namespace

std::vector<MotionChange> motion_changes(const MechanismScene& scene, const std::string& parameter,
                                         const Rational& from, const Rational& to) {
  if (scene.mechanism.load && scene.mechanism.load->symbol == parameter) return along_load(scene, from, to);
  return ChangesAlong(scene, parameter).between(from, to);
}

}  // namespace slipproof
