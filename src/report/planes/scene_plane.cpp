#include "report/planes/scene_plane.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/number/format.hpp"
#include "base/number/parse.hpp"
#include "mechanics/bicycle/domain.hpp"
#include "mechanics/bicycle_modes/bicycle_motions.hpp"
#include "report/phase/plane_words.hpp"

namespace slipproof {

namespace {

constexpr std::array<std::string_view, 17> parameters{"f",  "g",  "M",  "R",  "h",  "h0", "b", "b2", "b3",
                                                      "I1", "I2", "I3", "r1", "r2", "L",  "J", "mu"};

/// The member that a parameter is; null for those that are made of several.
Rational* member(Scene& scene, std::string_view parameter) {
  Bicycle<Rational>& p = scene.bicycle;
  const std::array<std::pair<std::string_view, Rational*>, 14> members{{{"f", &scene.road.f},
                                                                        {"g", &scene.road.g},
                                                                        {"M", &p.M},
                                                                        {"R", &p.R},
                                                                        {"h", &p.h},
                                                                        {"b2", &p.b2},
                                                                        {"b3", &p.b3},
                                                                        {"I1", &p.I1},
                                                                        {"I2", &p.I2},
                                                                        {"I3", &p.I3},
                                                                        {"r1", &p.r1},
                                                                        {"r2", &p.r2},
                                                                        {"L", &p.L},
                                                                        {"J", p.J ? &*p.J : nullptr}}};
  const auto found = std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.first == parameter; });
  return found == members.end() ? nullptr : found->second;
}

/// Two significant digits are enough for the end of an axis.
Rational rounded(const Rational& x) {
  return parse_rational(decimal_text(x, 2));
}

std::vector<LoadCell> cells_of_scene(const Scene& scene) {
  return bicycle_motions(scene.bicycle, scene.road, scene.force_kind)->cells();
}

/// All forces at which something changes at one value of the parameter, and a little more.
void choose_forces(const Scene& scene, SceneAxes& axes) {
  Rational low(0), high(0);
  for (const LoadCell& cell : cells_of_scene(scene)) {
    if (!cell.loads.is_point()) continue;
    low = std::min(low, *cell.loads.lower());
    high = std::max(high, *cell.loads.lower());
  }
  if (scene.F) {
    low = std::min(low, *scene.F);
    high = std::max(high, *scene.F);
  }
  if (low == high) high = scene.bicycle.M * scene.road.g, low = -high;
  const Rational margin = (high - low) / 6;
  if (!axes.y_from) axes.y_from = rounded(low - margin);
  if (!axes.y_to) axes.y_to = rounded(high + margin);
}

void choose_parameter(const Scene& scene, SceneAxes& axes) {
  const Rational value = *scene_parameter(scene, axes.x), size = abs(value);
  const bool any_sign = axes.x == "h" || axes.x == "L" || axes.x == "b2" || axes.x == "b3";
  if (!axes.x_from) axes.x_from = any_sign && value < 0 ? rounded(-2 * size) : Rational(0);
  if (!axes.x_to) axes.x_to = size.is_zero() ? Rational(1) : rounded(2 * size);
}

}  // namespace

std::vector<std::string_view> scene_parameters() {
  return {parameters.begin(), parameters.end()};
}

std::optional<Rational> scene_parameter(const Scene& scene, std::string_view parameter) {
  const Bicycle<Rational>& p = scene.bicycle;
  if (parameter == "b") return (p.b2 + p.b3) / 2;
  if (parameter == "h0") return Rational(p.h + p.R);
  if (parameter == "mu") return Rational(p.r2 / p.r1);
  Scene copy = scene;
  const Rational* value = member(copy, parameter);
  return value ? std::optional(*value) : std::nullopt;
}

std::optional<Scene> with_parameter(const Scene& scene, std::string_view parameter, const Rational& value) {
  Scene changed = scene;
  Bicycle<Rational>& p = changed.bicycle;
  if (parameter == "b") {
    p.b2 = p.b3 = value;
  } else if (parameter == "h0") {
    p.h = value - p.R;
  } else if (parameter == "mu") {
    p.r2 = value * p.r1;
  } else if (Rational* there = member(changed, parameter)) {
    *there = value;
  } else {
    return std::nullopt;
  }
  return in_domain(changed.bicycle, changed.road) ? std::optional(std::move(changed)) : std::nullopt;
}

namespace {

void expect_range(const std::string& symbol, const Rational& from, const Rational& to) {
  if (from < to) return;
  throw std::invalid_argument("found the range of " + symbol + " from " + exact_text(from) + " to " + exact_text(to) +
                              ", expected one that begins below its end");
}

}  // namespace

Plane scene_plane(const Scene& scene, const SceneAxes& wanted, std::string id) {
  SceneAxes axes = wanted;
  const auto value = scene_parameter(scene, axes.x);
  if (!value) {
    const bool known = std::find(parameters.begin(), parameters.end(), axes.x) != parameters.end();
    throw std::invalid_argument(known ? "the scene has no " + axes.x : "a scene has no parameter " + axes.x);
  }
  choose_parameter(scene, axes);
  expect_range(axes.x, *axes.x_from, *axes.x_to);
  if (!axes.y_from || !axes.y_to) {
    const auto middle = with_parameter(scene, axes.x, (*axes.x_from + *axes.x_to) / 2);
    const bool inside = *axes.x_from < *value && *value < *axes.x_to;
    if (!inside && !middle) throw std::invalid_argument("no value of " + axes.x + " in its range makes a scene");
    choose_forces(inside ? scene : *middle, axes);
  }
  expect_range("F", *axes.y_from, *axes.y_to);
  const auto scene_at = [scene, x = axes.x](const Rational& at) { return with_parameter(scene, x, at); };
  if (!scene_at((*axes.x_from + *axes.x_to) / 2)) {
    throw std::invalid_argument("the range of " + axes.x + " is not inside its domain");
  }
  Plane plane;
  plane.id = std::move(id);
  plane.title = scene.name;
  plane.x = {axes.x, *axes.x_from, *axes.x_to};
  plane.y = {"F", *axes.y_from, *axes.y_to};
  if (!scene.bicycle.J) plane.note = "Without J, motions with a wheel off the road are not modelled.";
  if (scene.F) plane.mark = Plane::Mark{*value, *scene.F, "the scene"};
  tell_of_bicycles(plane);
  plane.solve = [scene_at](const Rational& at) -> std::optional<PhaseColumn> {
    const auto there = scene_at(at);
    if (!there) return std::nullopt;
    PhaseColumn column;
    column.cells = cells_of_scene(*there);
    return column;
  };
  return plane;
}

}  // namespace slipproof
