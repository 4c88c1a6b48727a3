#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"
#include "base/number/simplest.hpp"
#include "contact/rest/map_polygons.hpp"
#include "contact/rest/rest.hpp"

namespace slipproof {

namespace {

/// Two loads X and Y of a scene: push + X unit[0] + Y unit[1].
struct TwoLoads {
  RestProblem problem;
  RestPush push;
  std::array<RestPush, 2> unit;
  std::array<std::optional<Rational>, 2> here;
};

void add(RestPush& push, const RestPush& other, const Rational& times) {
  for (std::size_t i = 0; i < push.f.size(); ++i) push.f[i] += times * other.f[i];
  for (std::size_t i = 0; i < push.limits.size(); ++i) push.limits[i] += times * other.limits[i];
}

/// The scene with this load; its own load, if it has no value, becomes a parameter that is 0.
MechanismScene along(MechanismScene scene, const std::string& name) {
  if (scene.mechanism.load && scene.mechanism.load->symbol != name && !scene.load) scene.load = 0;
  return with_load(scene, name);
}

RestProblem problem_of(const MechanismScene& scene) {
  return RestProblemMaker(scene.mechanism).problem(scene);
}

/// The push is affine in each load, whatever the other is, so it is affine in both if one's unit is the same at two
/// values of the other.
TwoLoads two_loads(const MechanismScene& scene, const RestMapQuestion& question) {
  const auto refuse = [&](const std::string& message) { throw InputError({{scene.mechanism.file, 0, 0, message}}); };
  if (question.x == question.y) refuse("found " + question.x + " twice, expected two loads");
  MechanismScene by_x = along(scene, question.x);
  const MechanismScene by_y = along(scene, question.y);
  TwoLoads result{problem_of(by_x), {}, {}, {by_x.load, by_y.load}};
  const Rational y = by_y.load.value_or(Rational(0));
  set_value(by_x, question.y, y);
  const RestProblem at_y = problem_of(by_x);
  result.push = push_at(at_y, Rational(0));
  result.unit = {push_at(at_y, std::nullopt), push_at(problem_of(by_y), std::nullopt)};
  add(result.push, result.unit[1], -y);
  set_value(by_x, question.y, y + 1);
  if (push_at(problem_of(by_x), std::nullopt) != result.unit[0]) {
    refuse("found " + question.x + " and " + question.y + ", which multiply each other, expected two loads");
  }
  return result;
}

/// Finds the region between the polygons of points at which it rests and of half planes in which it may: from the
/// supports in four directions on, wherever the two are not one, or not near, between two neighbours, another direction
/// is asked for: that across the line between their points.
class RestMapper {
 public:
  RestMapper(const TwoLoads& loads, RestMap& map, Effort& effort)
      : loads_(loads), map_(map), solver_(loads.problem, effort) {}

  void run() {
    try {
      if (find_sides()) {
        for (std::size_t i = 0; i < 4; ++i) between(sides_[i], sides_[(i + 1) % 4]);
      }
    } catch (const TooMuchWork&) {
      map_.decided = false;
    }
    finish();
  }
  std::size_t programs() const { return solver_.programs(); }

 private:
  static constexpr double near = 0.005;  // of the widths and heights
  static constexpr std::size_t most_supports = 400;

  /// A direction, the furthest point in it that is known to rest, and how far it can be at most.
  struct Support {
    MapPoint direction, at;
    Rational most;
  };

  RestMap::Frame& frame(std::size_t axis) { return axis == 0 ? map_.x_frame : map_.y_frame; }

  RestExtreme extreme(const MapPoint& direction) {
    std::vector<VariedLoad> loads;
    for (std::size_t k = 0; k < 2; ++k) {
      loads.push_back({loads_.unit[k], -direction[k], frame(k).from, frame(k).to});
    }
    return solver_.extreme(loads_.push, loads, {near / 10, sides_.empty() ? 0 : near / 10});
  }

  /// Keeps what it proves.
  std::optional<Support> support(const MapPoint& direction) {
    const RestExtreme found = extreme(direction);
    if (found.kind == RestExtreme::Kind::found || found.kind == RestExtreme::Kind::none) {
      if (auto motion = virtual_motion(loads_.problem, loads_.push, found.multipliers)) {
        const Rational x = power_along(*motion, loads_.unit[0]), y = power_along(*motion, loads_.unit[1]);
        if (!x.is_zero() || !y.is_zero() || motion->power.sign() > 0) {
          const Rational most = -motion->power;
          map_.borders.push_back({x, y, most, std::move(*motion)});
        }
      }
    }
    last_ = found.kind;
    if (found.kind != RestExtreme::Kind::found) return std::nullopt;
    map_.inside.push_back({found.inner[0], found.inner[1], found.forces});
    return Support{direction, {found.inner[0], found.inner[1]}, dot(direction, {found.outer[0], found.outer[1]})};
  }

  /// In the four directions of the axes; false if there is no region, or an end was not found.
  bool find_sides() {
    const std::array<MapPoint, 4> directions{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    std::array<std::optional<Support>, 4> found;
    std::array<bool, 4> open{};
    for (const bool framed : {false, true}) {
      if (framed && open != std::array<bool, 4>{}) add_frame(found, open);
      for (std::size_t i = 0; i < 4; ++i) {
        if (!framed || open != std::array<bool, 4>{}) found[i] = support(directions[i]);
        if (!framed) open[i] = last_ == RestExtreme::Kind::unbounded;
        map_.none = map_.none || last_ == RestExtreme::Kind::none;
        if (map_.none) return false;
        if (!found[i] && !(open[i] && !framed)) return map_.decided = false;
      }
    }
    for (const std::optional<Support>& side : found) sides_.push_back(*side);
    for (std::size_t k = 0; k < 2; ++k) {
      const Rational width = sides_[k].most + sides_[k + 2].most;
      if (width.sign() > 0) scale_[k] = to_rational(std::exp2(std::ilogb(nearest_binary64(width))));
    }
    return true;
  }

  /// Where the region is open, some sizes beyond what is known.
  void add_frame(const std::array<std::optional<Support>, 4>& found, const std::array<bool, 4>& open) {
    map_.inside.clear();  // they may be beyond it
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<Rational> known{Rational(0)};
      if (loads_.here[k]) known.push_back(*loads_.here[k]);
      for (const std::size_t side : {k, k + 2}) {
        if (found[side]) known.push_back(found[side]->at[k]);
      }
      const auto [least, most] = std::ranges::minmax(known);
      Rational size = std::max(abs(least), abs(most));
      if (size.is_zero()) size = 1;
      if (open[k]) frame(k).to = simplest_between(most + size, most + size * Rational(Integer(5), Integer(4)));
      if (open[k + 2]) frame(k).from = simplest_between(least - size * Rational(Integer(5), Integer(4)), least - size);
    }
  }

  void between(const Support& first, const Support& second) {
    if (map_.inside.size() > most_supports) {
      map_.decided = false;
      return;
    }
    const auto direction = solver_.has_circles() ? near_direction(first, second) : exact_direction(first, second);
    if (!direction) return;
    const std::optional<Support> middle = support(*direction);
    if (!middle) {
      map_.decided = false;
      return;
    }
    if (!solver_.has_circles() && dot(*direction, middle->at) == dot(*direction, first.at)) return;
    between(first, *middle);
    between(*middle, second);
  }

  std::optional<MapPoint> exact_direction(const Support& first, const Support& second) const {
    if (first.at == second.at) return std::nullopt;
    return MapPoint{second.at[1] - first.at[1], first.at[0] - second.at[0]};
  }

  /// Nothing if all that is left between both is near to the line between their points.
  std::optional<MapPoint> near_direction(const Support& first, const Support& second) const {
    const auto corner = meeting_point(first.direction, first.most, second.direction, second.most);
    if (!corner) return std::nullopt;
    const PlainPoint a = plain(first.at), b = plain(second.at);
    if (distance_from(plain(*corner), a, b) <= near) return std::nullopt;
    const auto angle = [&](const MapPoint& d) {
      return std::atan2(nearest_binary64(d[1] * scale_[1]), nearest_binary64(d[0] * scale_[0]));
    };
    constexpr double full = 2 * std::numbers::pi, least = 1e-5;
    const double from = angle(first.direction);
    const auto beyond = [&](double other) { return std::remainder(other - from, full); };
    const double turn = beyond(angle(second.direction));
    if (turn < least) return std::nullopt;
    double middle = beyond(std::atan2(a[0] - b[0], b[1] - a[1]));
    if (!(middle > turn / 8 && middle < turn * 7 / 8)) middle = turn / 2;
    const CirclePoint point = circle_point_near(from + middle);
    return MapPoint{point[0] / scale_[0], point[1] / scale_[1]};
  }

  PlainPoint plain(const MapPoint& p) const {
    return {nearest_binary64(p[0] / scale_[0]), nearest_binary64(p[1] / scale_[1])};
  }

  void finish() {
    if (map_.none || sides_.size() < 4) {
      map_.decided = map_.decided && map_.none;
      map_.inside.clear();
      return;
    }
    keep_hull(map_);
    clip_around(map_, {sides_[0].most, sides_[1].most, -sides_[2].most, -sides_[3].most});
    std::vector<PlainPoint> hull;
    for (const RestMap::Corner& corner : map_.inside) hull.push_back(plain({corner.x, corner.y}));
    map_.exact = true;
    for (const MapPoint& corner : map_.around) {
      const bool there = std::ranges::any_of(
          map_.inside, [&](const RestMap::Corner& c) { return c.x == corner[0] && c.y == corner[1]; });
      if (there) continue;
      map_.exact = false;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < hull.size(); ++i) {
        least = std::min(least, distance_from(plain(corner), hull[i], hull[(i + 1) % hull.size()]));
      }
      map_.gap = std::max(map_.gap, least);
    }
  }

  const TwoLoads& loads_;
  RestMap& map_;
  RestSolver solver_;
  std::vector<Support> sides_;
  std::array<Rational, 2> scale_{1, 1};
  RestExtreme::Kind last_ = RestExtreme::Kind::undecided;
};

}  // namespace

RestMap rest_map(const MechanismScene& scene, const RestMapQuestion& question, Effort& effort, std::size_t& programs) {
  const TwoLoads loads = two_loads(scene, question);
  RestMap map;
  map.x = question.x, map.y = question.y;
  map.x_here = loads.here[0], map.y_here = loads.here[1];
  map.x_frame = question.x_frame, map.y_frame = question.y_frame;
  RestMapper mapper(loads, map, effort);
  mapper.run();
  programs += mapper.programs();
  return map;
}

}  // namespace slipproof
