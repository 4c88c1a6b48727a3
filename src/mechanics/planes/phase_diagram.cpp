#include "mechanics/planes/phase_diagram.hpp"

#include <algorithm>
#include <stdexcept>

namespace slipproof {

std::vector<MechanismMode> modes_in_order(const MotionOverLoads& motion) {
  std::vector<MechanismMode> modes = motion.all_modes();
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

bool opens(const MotionSet& set) {
  if (set.motions.size() != 1) return false;
  const MechanismMode& mode = set.motions[0].front();
  return std::find(mode.begin(), mode.end(), ElementState::lift) != mode.end();
}

std::string mode_name(const MotionSet& set, const MechanismMode& mode) {
  std::string text = name(mode);
  if (set.in_space) std::erase(text, '+');
  return text;
}

std::string name(const MotionSet& set) {
  std::string text;
  const auto add = [&](const std::string& one) { text += (text.empty() ? "" : ", ") + one; };
  for (const auto& modes : set.motions) add(set.in_space ? mode_name(set, modes.front()) : equal_modes(modes));
  for (const MechanismMode& mode : set.continua) add(mode_name(set, mode) + " (continuum)");
  if (!set.complete) return text.empty() ? "not decided" : text + ", perhaps others";
  return text.empty() ? "no motion" : text;
}

std::vector<PhaseBand> bands(const PhaseColumn& column, bool joined) {
  std::vector<PhaseBand> all;
  bool alike = false;  // the band below has the same motions, also at the point between
  for (const LoadCell& cell : column.cells) {
    MotionSet set = motion_set(cell);
    if (cell.loads.is_point()) {
      alike = joined && !all.empty() && all.back().set == set;
    } else if (alike && all.back().set == set) {
      all.back().upper = cell.loads.upper();
    } else {
      all.push_back({std::move(set), cell.loads.lower(), cell.loads.upper()});
    }
  }
  return all;
}

std::vector<const LoadCell*> open_cells(const PhaseColumn& column) {
  std::vector<const LoadCell*> open;
  for (const LoadCell& cell : column.cells) {
    if (!cell.loads.is_point()) open.push_back(&cell);
  }
  return open;
}

const LoadCell* find_cell(const PhaseColumn& column, const Rational& y) {
  const auto found = std::find_if(column.cells.begin(), column.cells.end(),
                                  [&](const LoadCell& cell) { return cell.loads.contains(y); });
  return found == column.cells.end() ? nullptr : &*found;
}

namespace {

/// Whether two columns have the same regions, in the same order, inside the picture.
bool alike(const PhaseColumn& a, const PhaseColumn& b, bool joined) {
  const auto x = bands(a, joined), y = bands(b, joined);
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](const PhaseBand& c, const PhaseBand& d) { return c.set == d.set; });
}

class Columns {
 public:
  Columns(const Plane& plane, std::size_t count)
      : plane_(plane), narrow_((plane.x.to - plane.x.from) / Rational(64 * count)) {}

  /// Whether x is in the domain.
  bool add(const Rational& x, bool even) {
    Found found = solve(x, even);
    if (!found.inside && !plane_.finds_domain) return false;
    found_.push_back(std::move(found));
    return found_.back().inside;
  }

  std::vector<PhaseColumn> refined() {
    std::sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) { return a.column.x < b.column.x; });
    std::vector<Found> all;
    for (Found& found : found_) {
      if (!all.empty()) between(all, Found(all.back()), found);
      all.push_back(std::move(found));
    }
    return inside(std::move(all));
  }

 private:
  struct Found {
    PhaseColumn column;  ///< if it is outside the domain, only its x is set
    bool inside = true;
  };

  Found solve(const Rational& x, bool even) const {
    auto column = plane_.solve(x);
    Found found{column ? std::move(*column) : PhaseColumn{}, column.has_value()};
    found.column.x = x;
    found.column.even = even;
    return found;
  }

  /// Adds, in order, the columns that show where `left` changes to `right`, or leaves the domain.
  void between(std::vector<Found>& all, const Found& left, const Found& right) {
    if (right.column.x - left.column.x <= narrow_) return;
    if (left.inside == right.inside && (!left.inside || alike(left.column, right.column, plane_.joins_alike))) return;
    const Found middle = solve((left.column.x + right.column.x) / 2, false);
    if (!middle.inside && !plane_.finds_domain) return;
    between(all, left, middle);
    all.push_back(middle);
    between(all, middle, right);
  }

  static std::vector<PhaseColumn> inside(std::vector<Found> all) {
    std::vector<PhaseColumn> columns;
    bool gap = false;
    for (Found& found : all) {
      if (found.inside) {
        found.column.after_gap = gap && !columns.empty();
        columns.push_back(std::move(found.column));
      }
      gap = !found.inside;
    }
    return columns;
  }

  const Plane& plane_;
  const Rational narrow_;
  std::vector<Found> found_;
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
    // If the end of an axis is outside an open domain, takes a value just next to it.
    if (!there && i == 0) columns.add(plane.x.from + step / 64, false);
    if (!there && i == count) columns.add(plane.x.to - step / 64, false);
  }
  for (const Plane::Line& line : plane.lines) {
    const Rational place = (line.x - plane.x.from) / step;
    const bool there = denominator(place) == 1;
    if (plane.x.from < line.x && line.x < plane.x.to && !there) columns.add(line.x, false);
  }
  std::vector<PhaseColumn> all = columns.refined();
  all.erase(std::unique(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.x == b.x; }), all.end());
  return {std::move(plane), std::move(all)};
}

std::size_t PhaseRaster::complete() const {
  return static_cast<std::size_t>(std::ranges::count_if(places, &Place::is_complete));
}

PhaseDiagram raster_diagram(Plane plane, std::size_t across, std::size_t up,
                            const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  const auto middle = [](const Axis& axis, std::size_t i, std::size_t count) {
    return axis.from + (axis.to - axis.from) * Rational(2 * i + 1, 2 * count);
  };
  PhaseRaster raster{across, up, {}};
  for (std::size_t i = 0; i < across; ++i) {
    for (std::size_t j = 0; j < up; ++j) {
      const Rational x = middle(plane.x, i, across), y = middle(plane.y, j, up);
      raster.places.push_back({x, y, plane.place(x, y)});
      if (progress) progress(raster.places.size(), across * up);
    }
  }
  return {std::move(plane), {}, std::move(raster)};
}

}  // namespace slipproof
