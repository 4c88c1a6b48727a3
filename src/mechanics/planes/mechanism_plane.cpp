#include "mechanics/planes/mechanism_plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "base/number/format.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "mechanics/planes/axis_choice.hpp"
#include "mechanics/planes/plane_words.hpp"
#include "mechanics/points/degrees.hpp"

namespace slipproof {

namespace {

std::string note_of(const FreedScene& freed, const MechanismScene& scene, const Axis& across) {
  std::string note;
  const auto followers = freed.followers(across.from, across.to);
  if (!followers.empty()) {
    note = fmt::format("With {}, {} changes as the domain asks.", across.symbol, fmt::join(followers, ", "));
  }
  const auto add = [&](const std::string& sentence) { note += (note.empty() ? "" : " ") + sentence; };
  if (across.is_angle) {
    add(fmt::format("The axis is even in tan({0}/2), so the degrees of {0} are not evenly spaced.", across.symbol));
  }
  const auto differ = [](const PlacedExpression& x, const PlacedExpression& y) { return x.expression != y.expression; };
  const bool two = std::any_of(scene.mechanism.contacts.begin(), scene.mechanism.contacts.end(),
                               [&](const auto& c) { return differ(c.static_friction, c.kinetic_friction); }) ||
                   std::any_of(scene.mechanism.friction.begin(), scene.mechanism.friction.end(),
                               [&](const auto& f) { return differ(f.static_limit, f.kinetic_limit); });
  if (two) add("With a static above the kinetic coefficient, rest and sliding coexist by definition.");
  for (const MechanismContact& contact : scene.mechanism.contacts) {
    for (const std::size_t parameter : missing_for_lift(contact, scene.values.given)) {
      add(fmt::format("Without {}, that {} opens is not modelled.", scene.mechanism.parameters[parameter].symbol,
                      contact.name));
    }
  }
  return note;
}

std::string beyond_words(const std::string& note, const Axis& load, const std::vector<Rational>& beyond) {
  std::vector<std::string> numbers;
  for (const Rational& one : beyond) numbers.push_back(decimal_text(one, 6));
  return fmt::format("{}Beyond the picture motions change at {} near {}.", note.empty() ? "" : " ", load.symbol,
                     fmt::join(numbers, ", "));
}

bool shows(const Axis& axis, const Rational& x) {
  return axis.from <= x && x <= axis.to;
}

}  // namespace

std::shared_ptr<const FreedScene> freed_for(const MechanismScene& scene, const MechanismAxes& axes) {
  return std::make_shared<const FreedScene>(scene, find_symbol(scene, axes.x.empty() ? usual_parameter(scene) : axes.x),
                                            FreedScene::Tied::follow);
}

Plane plane_frame(const MechanismScene& scene, const FreedScene& freed, const MechanismAxes& axes, std::string id) {
  if (!scene.mechanism.load) {
    throw std::invalid_argument("the mechanism " + scene.mechanism.name +
                                " has no load, expected one, or a parameter that takes its place");
  }
  const AxisChoice choice(freed, scene, axes);
  Plane plane;
  plane.id = std::move(id);
  plane.title = scene.name;
  plane.x = choice.across();
  plane.note = note_of(freed, scene, plane.x);
  if (scene.mechanism.dimension == 3) {
    plane.y = choice.up_in_space();
  } else {
    AxisChoice::Up up = choice.up(plane.x);
    plane.y = std::move(up.axis);
    if (!up.beyond.empty() && !axes.y_from && !axes.y_to) plane.note += beyond_words(plane.note, plane.y, up.beyond);
  }
  plane.finds_domain = plane.joins_alike = true;
  const auto own = freed.own();
  if (scene.load && own && shows(plane.x, *own) && shows(plane.y, *scene.load))
    plane.mark = Plane::Mark{*own, *scene.load, "the scene"};
  tell_of_mechanism(plane, scene.mechanism);
  return plane;
}

Plane mechanism_plane(const MechanismScene& scene, const MechanismAxes& axes, std::string id) {
  const auto freed = freed_for(scene, axes);
  Plane plane = plane_frame(scene, *freed, axes, std::move(id));
  plane.solve = [freed](const Rational& x) -> std::optional<PhaseColumn> {
    auto there = freed->problem(x);
    if (!there) return std::nullopt;
    PhaseColumn column;
    column.cells = motions_over_loads(std::move(*there))->cells(Detail::modes);
    return column;
  };
  plane.numbers = [freed](const Rational& x) { return motions_over_loads(*freed->problem(x))->cells(); };
  return plane;
}

}  // namespace slipproof
