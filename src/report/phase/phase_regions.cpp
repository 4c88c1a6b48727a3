#include "report/phase/phase_regions.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

/// Neighbouring columns with the same regions in the same order.
struct Run {
  std::size_t first, last;
  double left, right;  ///< the ends of the drawn area
  bool after_gap;      ///< a gap in the domain precedes it
};

class RegionDrawing {
 public:
  explicit RegionDrawing(const PhaseDiagram& diagram)
      : diagram_(diagram),
        columns_(diagram.columns),
        low_(value(diagram.plane.y.from)),
        high_(value(diagram.plane.y.to)),
        far_(20 * (high_ - low_)) {
    for (const PhaseColumn& column : columns_) bands_.push_back(bands(column, diagram.plane.joins_alike));
  }

  PhaseRegions all() {
    const std::vector<Run> all_runs = runs();
    for (const Run& run : all_runs) {
      add_strips(run);
      add_edges(run);
    }
    add_single_columns(all_runs);
    for (std::size_t r = 1; r < all_runs.size(); ++r) {
      if (!all_runs[r].after_gap) add_upright(all_runs[r - 1], all_runs[r]);
    }
    for (std::size_t c = 0; c < diagram_.plane.curves.size(); ++c) add_idle(c);
    for (std::size_t k = 0; k < diagram_.plane.claims.size(); ++k) add_refuted(k);
    const auto unseen = [&](const PhaseLine& line) {
      const auto outside = [&](const PlanePoint& p) { return p.y < low_ || p.y > high_; };
      return std::all_of(line.points.begin(), line.points.end(), outside);
    };
    std::erase_if(regions_.lines, unseen);
    find_sets();
    regions_.leaves_domain = diagram_.plane.finds_domain && leaves_domain();
    return std::move(regions_);
  }

 private:
  static double value(const Rational& x) { return nearest_binary64(x); }
  double x(std::size_t column) const { return value(columns_[column].x); }
  /// An end, moved to just outside the picture if it is farther away.
  double clamped(const std::optional<Rational>& y, double infinite) const {
    if (!y) return infinite;
    return std::clamp(value(*y), low_ - far_, high_ + far_);
  }
  double lower(const ForceInterval& forces) const { return clamped(forces.lower(), low_ - far_); }
  double upper(const ForceInterval& forces) const { return clamped(forces.upper(), high_ + far_); }
  double lower(const PhaseBand& band) const { return clamped(band.lower, low_ - far_); }
  double upper(const PhaseBand& band) const { return clamped(band.upper, high_ + far_); }

  /// Whether a column is missing at a side or between others, or ends inside the picture.
  bool leaves_domain() const {
    const double step = (value(diagram_.plane.x.to) - value(diagram_.plane.x.from)) / 500;
    if (x(0) > value(diagram_.plane.x.from) + step || x(columns_.size() - 1) < value(diagram_.plane.x.to) - step) {
      return true;
    }
    return std::any_of(columns_.begin(), columns_.end(), [&](const PhaseColumn& column) {
      if (column.after_gap || column.cells.empty()) return true;
      const auto &from = column.cells.front().loads.lower(), &to = column.cells.back().loads.upper();
      return (from && *from > diagram_.plane.y.from) || (to && *to < diagram_.plane.y.to);
    });
  }

  /// The runs of each part of the domain.
  std::vector<Run> runs() const {
    std::vector<Run> all;
    for (std::size_t first = 0, last = 0; first < columns_.size(); first = last + 1) {
      last = first;
      while (last + 1 < columns_.size() && !columns_[last + 1].after_gap) ++last;
      std::vector<Run> part = runs_within(first, last);
      part.front().after_gap = columns_[first].after_gap;
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

  std::vector<Run> runs_within(std::size_t first, std::size_t last) const {
    std::vector<Run> all;
    std::vector<MotionSet> sets;
    for (std::size_t i = first; i <= last; ++i) {
      std::vector<MotionSet> here;
      for (const PhaseBand& band : bands_[i]) here.push_back(band.set);
      if (all.empty() || here != sets) {
        all.push_back({i, i, x(i), x(i), false});
        sets = std::move(here);
      }
      all.back().last = i;
      all.back().right = x(i);
    }
    return joined(std::move(all));
  }

  /// Treats a column that differs from both neighbours as a line: both sides extend to it.
  std::vector<Run> joined(std::vector<Run> all) const {
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
    // The picture begins and ends with the axis, even near an open end of a domain.
    const double edge = (value(diagram_.plane.x.to) - value(diagram_.plane.x.from)) / 1000;
    wide.back().right = all.back().right;
    if (wide.front().left - value(diagram_.plane.x.from) < edge) wide.front().left = value(diagram_.plane.x.from);
    if (value(diagram_.plane.x.to) - wide.back().right < edge) wide.back().right = value(diagram_.plane.x.to);
    return wide;
  }

  /// An end of the k-th cell in the columns of a run, extended to the run's borders.
  template <class End>
  std::vector<PlanePoint> along(const Run& run, std::size_t k, End end) const {
    std::vector<PlanePoint> points;
    for (std::size_t i = run.first; i <= run.last; ++i) {
      points.push_back({x(i), end(bands_[i][k])});
    }
    if (run.left < points.front().x) points.insert(points.begin(), {run.left, points.front().y});
    if (run.right > points.back().x) points.push_back({run.right, points.back().y});
    return points;
  }

  void add_strips(const Run& run) {
    const auto& cells = bands_[run.first];
    for (std::size_t k = 0; k < cells.size(); ++k) {
      regions_.strips.push_back({cells[k].set, along(run, k, [&](const PhaseBand& band) { return lower(band); }),
                                 along(run, k, [&](const PhaseBand& band) { return upper(band); })});
    }
  }

  /// Adds regions that occur in a single column as lines.
  void add_single_columns(const std::vector<Run>& all_runs) {
    std::vector<bool> drawn(columns_.size());
    for (const Run& run : all_runs) std::fill_n(drawn.begin() + index(run.first), run.last - run.first + 1, true);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (!drawn[i]) add_strips({i, i, x(i), x(i), false});
    }
  }
  static std::ptrdiff_t index(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

  bool on_curve(const Rational& y, std::size_t column, std::size_t curve) const {
    return columns_[column].curves[curve] && *columns_[column].curves[curve] == y;
  }

  /// The curve on which the border above the k-th cell lies exactly in both columns i and j; nothing if there is none.
  std::optional<std::size_t> curve_of(std::size_t k, std::size_t i, std::size_t j) const {
    const Rational& left = *bands_[i][k].upper;
    const Rational& right = *bands_[j][k].upper;
    for (std::size_t c = 0; c < diagram_.plane.curves.size(); ++c) {
      if (on_curve(left, i, c) && on_curve(right, j, c)) return c;
    }
    return std::nullopt;
  }

  void add_edges(const Run& run) {
    const std::size_t cells = bands_[run.first].size();
    for (std::size_t k = 0; k + 1 < cells; ++k) {
      const auto points = along(run, k, [&](const PhaseBand& band) { return upper(band); });
      const std::size_t offset = run.left < x(run.first) ? 1 : 0;
      PhaseLine line;
      for (std::size_t i = 0; i + 1 < points.size() || i == 0; ++i) {
        // The columns of the segment; outside the first and last column it continues unchanged.
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

  /// Where two runs meet: adds a vertical border between different sets that both have some height there.
  void add_upright(const Run& left, const Run& right) {
    const auto &a = bands_[left.last], &b = bands_[right.first];
    const auto named = [&](const Plane::Line& line) { return value(line.x) == right.left; };
    const auto& lines = diagram_.plane.lines;
    const bool known = diagram_.plane.curves.empty() || std::any_of(lines.begin(), lines.end(), named);
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      const double low = std::max(lower(a[i]), lower(b[j]));
      const double above_a = upper(a[i]), above_b = upper(b[j]), high = std::min(above_a, above_b);
      if (high - low > (high_ - low_) / 100 && !(a[i].set == b[j].set)) {
        regions_.lines.push_back({known ? PhaseLine::Kind::edge : PhaseLine::Kind::extra,
                                  std::nullopt,
                                  {{right.left, low}, {right.left, high}}});
      }
      if (above_a <= above_b) ++i;
      if (above_b <= above_a) ++j;
    }
  }

  /// Adds the parts of a curve that are not a border.
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
      const LoadCell* cell = find_cell(columns_[i], *y);
      const bool border = cell != nullptr && cell->loads.is_point();
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
        visible = visible || (strip.lower[i].y < high_ && strip.upper[i].y > low_);
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
  std::vector<std::vector<PhaseBand>> bands_;  ///< by column
  const double low_, high_, far_;
  PhaseRegions regions_;
};

}  // namespace

namespace {

/// Each place as the rectangle around it; neighbours in a column with the same motions are one.
class RasterDrawing {
 public:
  explicit RasterDrawing(const PhaseDiagram& diagram) : plane_(diagram.plane), raster_(*diagram.raster) {}

  PhaseRegions all() {
    for (std::size_t first = 0, last = 0; first < raster_.places.size(); first = last + 1) {
      last = first;
      const auto& set = raster_.places[first].set;
      while ((last + 1) % raster_.up != 0 && raster_.places[last + 1].set == set) ++last;
      set ? add(first, last) : (void)(regions_.leaves_domain = true);
    }
    return std::move(regions_);
  }

 private:
  void add(std::size_t first, std::size_t last) {
    const double across = value(plane_.x.to - plane_.x.from) / static_cast<double>(raster_.across) / 2,
                 up = value(plane_.y.to - plane_.y.from) / static_cast<double>(raster_.up) / 2;
    const auto &low = raster_.places[first], &high = raster_.places[last];
    const double left = value(low.x) - across, right = value(low.x) + across;
    const double bottom = value(low.y) - up, top = value(high.y) + up;
    regions_.strips.push_back({*low.set, {{left, bottom}, {right, bottom}}, {{left, top}, {right, top}}});
    if (std::ranges::find(regions_.sets, *low.set) == regions_.sets.end()) regions_.sets.push_back(*low.set);
  }
  static double value(const Rational& x) { return nearest_binary64(x); }

  const Plane& plane_;
  const PhaseRaster& raster_;
  PhaseRegions regions_;
};

}  // namespace

PhaseRegions phase_regions(const PhaseDiagram& diagram) {
  if (diagram.raster) return RasterDrawing(diagram).all();
  return diagram.columns.empty() ? PhaseRegions{} : RegionDrawing(diagram).all();
}

}  // namespace slipproof
