#include "picture/phase_regions.hpp"

#include <algorithm>
#include <cmath>

#include "number/binary64.hpp"

namespace slipproof {

namespace {

/// Columns with the same regions one above the other.
struct Run {
  std::size_t first, last;
  double left, right;  ///< how far it is drawn
};

class RegionDrawing {
 public:
  explicit RegionDrawing(const PhaseDiagram& diagram)
      : diagram_(diagram),
        columns_(diagram.columns),
        low_(value(diagram.plane.y.from)),
        high_(value(diagram.plane.y.to)),
        far_(20 * (high_ - low_)) {}

  PhaseRegions all() {
    const std::vector<Run> all_runs = runs();
    for (const Run& run : all_runs) {
      add_strips(run);
      add_edges(run);
    }
    for (std::size_t r = 1; r < all_runs.size(); ++r) add_upright(all_runs[r - 1], all_runs[r]);
    for (std::size_t c = 0; c < diagram_.plane.curves.size(); ++c) add_idle(c);
    for (std::size_t k = 0; k < diagram_.plane.claims.size(); ++k) add_refuted(k);
    const auto unseen = [&](const PhaseLine& line) {
      const auto outside = [&](const PlanePoint& p) { return p.y < low_ || p.y > high_; };
      return std::all_of(line.points.begin(), line.points.end(), outside);
    };
    std::erase_if(regions_.lines, unseen);
    find_sets();
    return std::move(regions_);
  }

 private:
  static double value(const Rational& x) { return nearest_binary64(x); }
  double x(std::size_t column) const { return value(columns_[column].x); }
  /// An end as far away as the picture cares.
  double clamped(const std::optional<Rational>& y, double infinite) const {
    if (!y) return infinite;
    return std::clamp(value(*y), low_ - far_, high_ + far_);
  }
  double lower(const ForceInterval& forces) const { return clamped(forces.lower(), low_ - far_); }
  double upper(const ForceInterval& forces) const { return clamped(forces.upper(), high_ + far_); }

  std::vector<Run> runs() const {
    std::vector<Run> all;
    std::vector<MotionSet> sets;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      std::vector<MotionSet> here;
      for (const LoadCell* cell : open_cells(columns_[i])) here.push_back(motion_set(*cell));
      if (all.empty() || here != sets) {
        all.push_back({i, i, x(i), x(i)});
        sets = std::move(here);
      }
      all.back().last = i;
      all.back().right = x(i);
    }
    // A column between two others that looks like neither of them is a line: both sides reach up to it.
    std::vector<Run> wide;
    for (std::size_t r = 0; r < all.size(); ++r) {
      if (all[r].first == all[r].last && all.size() > 1) continue;
      if (wide.empty()) {
        all[r].left = all.front().left;
      } else {
        const bool over_line = all[r - 1].first != wide.back().first;
        const double border = over_line ? all[r - 1].left : (wide.back().right + all[r].left) / 2;
        wide.back().right = all[r].left = border;
      }
      wide.push_back(all[r]);
    }
    if (wide.empty()) return all;
    // The picture begins and ends where the axis does, even beside an open end of a domain.
    const double edge = (value(diagram_.plane.x.to) - value(diagram_.plane.x.from)) / 1000;
    wide.back().right = all.back().right;
    if (wide.front().left - value(diagram_.plane.x.from) < edge) wide.front().left = value(diagram_.plane.x.from);
    if (value(diagram_.plane.x.to) - wide.back().right < edge) wide.back().right = value(diagram_.plane.x.to);
    return wide;
  }

  /// An end of the k-th cell of a run's columns, drawn to the run's borders.
  template <class End>
  std::vector<PlanePoint> along(const Run& run, std::size_t k, End end) const {
    std::vector<PlanePoint> points;
    for (std::size_t i = run.first; i <= run.last; ++i) {
      points.push_back({x(i), end(open_cells(columns_[i])[k]->loads)});
    }
    if (run.left < points.front().x) points.insert(points.begin(), {run.left, points.front().y});
    if (run.right > points.back().x) points.push_back({run.right, points.back().y});
    return points;
  }

  void add_strips(const Run& run) {
    const auto cells = open_cells(columns_[run.first]);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      regions_.strips.push_back({motion_set(*cells[k]), along(run, k, [&](const ForceInterval& f) { return lower(f); }),
                                 along(run, k, [&](const ForceInterval& f) { return upper(f); })});
    }
  }

  bool on_curve(const Rational& y, std::size_t column, std::size_t curve) const {
    return columns_[column].curves[curve] && *columns_[column].curves[curve] == y;
  }

  /// The border above the k-th cell of the columns i and i + 1: the curve that it is on in both, exactly.
  std::optional<std::size_t> curve_of(std::size_t k, std::size_t i, std::size_t j) const {
    const Rational& left = *open_cells(columns_[i])[k]->loads.upper();
    const Rational& right = *open_cells(columns_[j])[k]->loads.upper();
    for (std::size_t c = 0; c < diagram_.plane.curves.size(); ++c) {
      if (on_curve(left, i, c) && on_curve(right, j, c)) return c;
    }
    return std::nullopt;
  }

  void add_edges(const Run& run) {
    const std::size_t borders = open_cells(columns_[run.first]).size() - 1;
    for (std::size_t k = 0; k < borders; ++k) {
      const auto points = along(run, k, [&](const ForceInterval& f) { return upper(f); });
      const std::size_t offset = run.left < x(run.first) ? 1 : 0;
      PhaseLine line;
      for (std::size_t i = 0; i + 1 < points.size() || i == 0; ++i) {
        // The segment's columns; beyond the first and last column it goes on as it was.
        const std::size_t left = run.first + std::min(i < offset ? 0 : i - offset, run.last - run.first);
        const std::size_t right = std::min(left + 1, run.last);
        const auto curve = curve_of(k, left == right && left > run.first ? left - 1 : left, right);
        const bool known = curve || diagram_.plane.curves.empty();
        const auto kind = known ? PhaseLine::Kind::edge : PhaseLine::Kind::extra;
        if (!line.points.empty() && (line.kind != kind || line.curve != curve)) {
          regions_.lines.push_back(std::move(line));
          line = {};
        }
        if (line.points.empty()) line = {kind, curve, {points[i]}};
        if (i + 1 < points.size()) line.points.push_back(points[i + 1]);
      }
      regions_.lines.push_back(std::move(line));
    }
  }

  /// Where two runs meet, an upright border between different sets that both have some height there.
  void add_upright(const Run& left, const Run& right) {
    const auto a = open_cells(columns_[left.last]), b = open_cells(columns_[right.first]);
    const auto named = [&](const Plane::Line& line) { return value(line.x) == right.left; };
    const auto& lines = diagram_.plane.lines;
    const bool known = diagram_.plane.curves.empty() || std::any_of(lines.begin(), lines.end(), named);
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      const double low = std::max(lower(a[i]->loads), lower(b[j]->loads));
      const double above_a = upper(a[i]->loads), above_b = upper(b[j]->loads), high = std::min(above_a, above_b);
      if (high - low > (high_ - low_) / 100 && !(motion_set(*a[i]) == motion_set(*b[j]))) {
        regions_.lines.push_back({known ? PhaseLine::Kind::edge : PhaseLine::Kind::extra,
                                  std::nullopt,
                                  {{right.left, low}, {right.left, high}}});
      }
      if (above_a <= above_b) ++i;
      if (above_b <= above_a) ++j;
    }
  }

  /// A curve where it is no border.
  void add_idle(std::size_t curve) {
    PhaseLine line{PhaseLine::Kind::idle, curve, {}};
    const auto finish = [&] {
      if (line.points.size() > 1) regions_.lines.push_back(line);
      line.points.clear();
    };
    bool border_before = false;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto& y = columns_[i].curves[curve];
      if (!y) {
        finish();
        continue;
      }
      const PlanePoint here{x(i), clamped(y, 0)};
      const bool border = cell_at(columns_[i], *y).loads.is_point();
      const bool pole = !line.points.empty() && std::abs(here.y - line.points.back().y) > far_;
      if (pole || (border && border_before)) finish();
      line.points.push_back(here);
      border_before = border;
    }
    finish();
  }

  void add_refuted(std::size_t claim) {
    RefutedStrip strip{claim, {}, {}};
    const auto finish = [&] {
      if (strip.lower.size() > 1) regions_.refuted.push_back(strip);
      strip.lower.clear();
      strip.upper.clear();
    };
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto& forces = columns_[i].refuted[claim];
      if (!forces || forces->empty() || forces->is_point()) {
        finish();
        continue;
      }
      strip.lower.push_back({x(i), lower(*forces)});
      strip.upper.push_back({x(i), upper(*forces)});
    }
    finish();
  }

  void find_sets() {
    std::vector<const Strip*> seen;
    for (const Strip& strip : regions_.strips) {
      bool visible = false;
      for (std::size_t i = 0; i < strip.lower.size(); ++i) {
        visible = visible || (strip.lower[i].y < high_ && strip.upper[i].y > low_ &&
                              strip.upper[i].y - strip.lower[i].y > (high_ - low_) / 1000);
      }
      if (visible) seen.push_back(&strip);
    }
    std::stable_sort(seen.begin(), seen.end(), [&](const Strip* a, const Strip* b) {
      return std::max(a->lower.front().y, low_) < std::max(b->lower.front().y, low_);
    });
    for (const Strip* strip : seen) {
      if (std::find(regions_.sets.begin(), regions_.sets.end(), strip->set) == regions_.sets.end()) {
        regions_.sets.push_back(strip->set);
      }
    }
  }

  const PhaseDiagram& diagram_;
  const std::vector<PhaseColumn>& columns_;
  const double low_, high_, far_;
  PhaseRegions regions_;
};

}  // namespace

PhaseRegions phase_regions(const PhaseDiagram& diagram) {
  return diagram.columns.empty() ? PhaseRegions{} : RegionDrawing(diagram).all();
}

}  // namespace slipproof
