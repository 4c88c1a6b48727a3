#include "picture/phase_diagram.hpp"

#include <algorithm>
#include <stdexcept>

namespace slipproof {

std::vector<MechanismMode> modes_in_order(const MotionOverLoads& motion) {
  std::vector<MechanismMode> modes = motion.modes;
  modes.insert(modes.end(), motion.boundary_modes.begin(), motion.boundary_modes.end());
  std::sort(modes.begin(), modes.end());
  return modes;
}

MotionSet motion_set(const LoadCell& cell) {
  MotionSet set;
  for (const MotionOverLoads& motion : cell.motions) {
    set.motions.push_back(motion.modes.empty() ? motion.boundary_modes : motion.modes);
  }
  std::sort(set.motions.begin(), set.motions.end(), [](const auto& a, const auto& b) { return a.front() < b.front(); });
  set.continua = cell.continua;
  return set;
}

std::string name(const MotionSet& set) {
  std::string text;
  for (const auto& modes : set.motions) {
    text += text.empty() ? "" : ", ";
    for (const MechanismMode& mode : modes) text += (&mode == &modes.front() ? "" : " = ") + name(mode);
  }
  for (const MechanismMode& mode : set.continua) text += (text.empty() ? "" : ", ") + name(mode) + " (continuum)";
  return text.empty() ? "no motion" : text;
}

std::vector<const LoadCell*> open_cells(const PhaseColumn& column) {
  std::vector<const LoadCell*> open;
  for (const LoadCell& cell : column.cells) {
    if (!cell.loads.is_point()) open.push_back(&cell);
  }
  return open;
}

const LoadCell& cell_at(const PhaseColumn& column, const Rational& y) {
  const auto found = std::find_if(column.cells.begin(), column.cells.end(),
                                  [&](const LoadCell& cell) { return cell.loads.contains(y); });
  if (found == column.cells.end()) throw std::logic_error("the cells of a column leave a gap");
  return *found;
}

namespace {

/// The same regions one above the other, as far as the picture reaches.
bool alike(const PhaseColumn& a, const PhaseColumn& b) {
  const auto x = open_cells(a), y = open_cells(b);
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](const LoadCell* c, const LoadCell* d) { return motion_set(*c) == motion_set(*d); });
}

class Columns {
 public:
  Columns(const Plane& plane, std::size_t count)
      : plane_(plane), narrow_((plane.x.to - plane.x.from) / Rational(64 * count)) {}

  bool add(const Rational& x, bool even) {
    auto column = plane_.solve(x);
    if (!column) return false;
    column->x = x;
    column->even = even;
    found_.push_back(std::move(*column));
    return true;
  }

  std::vector<PhaseColumn> refined() {
    std::sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    std::vector<PhaseColumn> all;
    for (PhaseColumn& column : found_) {
      if (!all.empty()) between(all, PhaseColumn(all.back()), column);
      all.push_back(std::move(column));
    }
    return all;
  }

 private:
  /// Adds, in order, what it takes to see where `left` turns into `right`.
  void between(std::vector<PhaseColumn>& all, const PhaseColumn& left, const PhaseColumn& right) {
    if (right.x - left.x <= narrow_ || alike(left, right)) return;
    auto middle = plane_.solve((left.x + right.x) / 2);
    if (!middle) return;
    middle->x = (left.x + right.x) / 2;
    middle->even = false;
    between(all, left, *middle);
    all.push_back(*middle);
    between(all, *middle, right);
  }

  const Plane& plane_;
  const Rational narrow_;
  std::vector<PhaseColumn> found_;
};

}  // namespace

PhaseDiagram phase_diagram(Plane plane, std::size_t count) {
  if (count == 0 || !(plane.x.from < plane.x.to) || !(plane.y.from < plane.y.to)) {
    throw std::invalid_argument("a phase diagram needs columns, and axes with from < to");
  }
  Columns columns(plane, count);
  const Rational step = (plane.x.to - plane.x.from) / Rational(count);
  for (std::size_t i = 0; i <= count; ++i) {
    const bool there = columns.add(plane.x.from + step * Rational(i), true);
    // The end of an axis may be outside of an open domain: then just beside it.
    if (!there && i == 0) columns.add(plane.x.from + step / 64, false);
    if (!there && i == count) columns.add(plane.x.to - step / 64, false);
  }
  for (const Plane::Line& line : plane.lines) {
    const Rational place = (line.x - plane.x.from) / step;
    const bool there = boost::multiprecision::denominator(place) == 1;
    if (plane.x.from < line.x && line.x < plane.x.to && !there) columns.add(line.x, false);
  }
  std::vector<PhaseColumn> all = columns.refined();
  all.erase(std::unique(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.x == b.x; }), all.end());
  return {std::move(plane), std::move(all)};
}

}  // namespace slipproof
