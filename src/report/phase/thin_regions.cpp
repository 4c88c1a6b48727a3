#include "report/phase/thin_regions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

constexpr std::size_t most_enlargements = 4, enlarged_columns = 48;
constexpr double clearly_seen = 10;  ///< in pixels, in an enlargement

/// A place on a strip inside a frame.
struct Spot {
  const Strip* strip = nullptr;
  std::size_t index = 0;
  double lower = 0, upper = 0;  ///< inside the frame
  double thickness = 0;         ///< vertical or horizontal, whichever is less, in pixels
};

double middle(const Spot& spot) {
  return (spot.lower + spot.upper) / 2;
}

class Spots {
 public:
  Spots(const Frame& frame, const Axis& x, const Axis& y)
      : frame_(frame),
        left_(nearest_binary64(x.from)),
        right_(nearest_binary64(x.to)),
        low_(nearest_binary64(y.from)),
        high_(nearest_binary64(y.to)) {}

  /// Nothing if it is outside the frame.
  std::optional<Spot> spot(const Strip& strip, std::size_t i) const {
    const double x = strip.lower[i].x;
    if (x < left_ || x > right_ || strip.lower[i].y >= high_ || strip.upper[i].y <= low_) return std::nullopt;
    Spot spot{&strip, i, std::max(strip.lower[i].y, low_), std::min(strip.upper[i].y, high_), 0};
    spot.thickness = std::min(pixels_up(spot.lower, spot.upper), pixels_across(0, level_width(spot)));
    return spot;
  }

  /// The thickest place of the set; the first if there are several.
  std::optional<Spot> best(const std::vector<Strip>& strips, const MotionSet& set) const {
    std::optional<Spot> best;
    for (const Strip& strip : strips) {
      if (!(strip.set == set)) continue;
      for (std::size_t i = 0; i < strip.lower.size(); ++i) {
        const auto here = spot(strip, i);
        if (here && (!best || here->thickness > best->thickness)) best = here;
      }
    }
    return best;
  }

 private:
  double pixels_across(double from, double to) const { return frame_.x_of(to) - frame_.x_of(from); }
  double pixels_up(double from, double to) const { return frame_.y_of(from) - frame_.y_of(to); }

  /// The width of the strip at the height of a spot's middle, to both sides, inside the frame.
  double level_width(const Spot& spot) const {
    const double level = middle(spot);
    const auto end = [&](std::size_t step) {
      const auto &lower = spot.strip->lower, &upper = spot.strip->upper;
      std::size_t i = spot.index;
      for (std::size_t next = i + step; next < lower.size();
           i = next, next += step) {  // an index below 0 wraps round and is past the end, too
        const double over = upper[next].y - level, under = level - lower[next].y;
        if (over > 0 && under > 0) continue;
        const double inside = over > 0 ? level - lower[i].y : upper[i].y - level, outside = over > 0 ? under : over;
        return lower[i].x + (lower[next].x - lower[i].x) * inside / (inside - outside);
      }
      return lower[i].x;
    };
    return std::min(end(1), right_) - std::max(end(static_cast<std::size_t>(-1)), left_);
  }

  const Frame& frame_;
  double left_, right_, low_, high_;
};

/// The part of a plane around a place on a strip in which the strip has about a sixth of the height.
class Window {
 public:
  Window(const Plane& plane, const Spot& spot, const Spots& spots)
      : low_(nearest_binary64(plane.y.from)), high_(nearest_binary64(plane.y.to)), spot_(spot) {
    const double height = spot.upper - spot.lower, all = high_ - low_;
    if (6 * height < all) {
      low_ = middle(spot) - 3 * height;
      high_ = middle(spot) + 3 * height;
    }
    left_ = end(spots, false);
    right_ = end(spots, true);
    const double more =
        left_ < right_ ? (right_ - left_) / 3 : nearest_binary64((plane.x.to - plane.x.from) / Rational(4000));
    left_ = std::max(left_ - more, nearest_binary64(plane.x.from));
    right_ = std::min(right_ + more, nearest_binary64(plane.x.to));
  }

  /// The plane with these axes; nothing if the numbers are too close to each other.
  std::optional<Plane> of(const Plane& plane, std::size_t number) const {
    if (!(left_ < right_) || !(low_ < high_)) return std::nullopt;
    Plane part = plane;
    part.id += "-enlarged-" + std::to_string(number);
    part.x.from = to_rational(left_), part.x.to = to_rational(right_);
    part.y.from = to_rational(low_), part.y.to = to_rational(high_);
    const auto& mark = part.mark;
    const bool seen =
        mark && part.x.from <= mark->x && mark->x <= part.x.to && part.y.from <= mark->y && mark->y <= part.y.to;
    if (!seen) part.mark.reset();
    return part;
  }

 private:
  /// How far the middle of the strip stays inside, towards one side.
  double end(const Spots& spots, bool rightwards) const {
    const Strip& strip = *spot_.strip;
    double x = strip.lower[spot_.index].x;
    // --i from 0 ends the loop, too.
    for (std::size_t i = spot_.index; i < strip.lower.size(); rightwards ? ++i : --i) {
      const auto here = spots.spot(strip, i);
      if (!here) break;
      const double rise = middle(*here) - middle(spot_), room = high_ - middle(spot_);
      const double before = strip.lower[i].x - x;
      if (std::abs(rise) > room) return x + before * room / std::abs(rise);
      x = strip.lower[i].x;
    }
    return x;
  }

  double low_, high_, left_ = 0, right_ = 0;
  const Spot& spot_;
};

void add_sets(const std::vector<MotionSet>& more, std::vector<MotionSet>& sets) {
  for (const MotionSet& set : more) {
    if (std::find(sets.begin(), sets.end(), set) == sets.end()) sets.push_back(set);
  }
}

}  // namespace

std::optional<double> thickness(const PhaseRegions& regions, const MotionSet& set, const Frame& frame) {
  const auto best = Spots(frame, frame.across(), frame.up()).best(regions.strips, set);
  return best ? std::optional(best->thickness) : std::nullopt;
}

ThinRegions thin_regions(const PhaseDiagram& diagram, PhaseRegions& regions, const Frame& frame, const Frame& small) {
  const Spots spots(frame, diagram.plane.x, diagram.plane.y);
  ThinRegions result;
  const std::size_t sets = regions.sets.size();
  for (std::size_t set = 0; set < sets; ++set) {
    const auto spot = spots.best(regions.strips, regions.sets[set]);
    if (!spot || spot->thickness >= least_seen) continue;
    ThinRegion region{set, {spot->strip->lower[spot->index].x, middle(*spot)}, spot->strip->lower.size() == 1, {}};
    const auto shows = [&](const Enlargement& e) {
      const Frame there(small.left, small.top, small.width, small.height, e.diagram.plane.x, e.diagram.plane.y);
      return thickness(e.regions, regions.sets[set], there).value_or(0) >= clearly_seen;
    };
    auto& all = result.enlargements;
    auto found = std::find_if(all.begin(), all.end(), shows);
    if (found == all.end() && all.size() < most_enlargements) {
      if (auto part = Window(diagram.plane, *spot, spots).of(diagram.plane, all.size() + 1)) {
        Enlargement enlarged{phase_diagram(std::move(*part), enlarged_columns), {}};
        enlarged.regions = phase_regions(enlarged.diagram);
        if (shows(enlarged)) found = all.insert(all.end(), std::move(enlarged));
      }
    }
    region.line = region.line && found == all.end();
    if (found != all.end()) region.enlargement = static_cast<std::size_t>(found - all.begin());
    result.regions.push_back(region);
  }
  for (const Enlargement& enlarged : result.enlargements) add_sets(enlarged.regions.sets, regions.sets);
  for (Enlargement& enlarged : result.enlargements) enlarged.regions.sets = regions.sets;
  return result;
}

}  // namespace slipproof
