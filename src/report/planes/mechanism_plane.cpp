#include "report/planes/mechanism_plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <utility>

#include "base/input/near_match.hpp"
#include "base/number/format.hpp"
#include "base/number/parse.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "mechanics/mechanism/names.hpp"
#include "mechanics/scene/degrees.hpp"
#include "mechanics/scene/domain_sampler.hpp"
#include "report/phase/plane_words.hpp"
#include "report/values/mode_json.hpp"
#include "report/values/motions_json.hpp"

namespace slipproof {

namespace {

/// The horizontal variable: tan(angle/2), a parameter, or several of these.
struct AcrossVariable {
  std::string symbol, unit;
  std::optional<std::size_t> angle;
  Rational own;                                                     ///< value of the parameter in the scene
  std::vector<std::pair<std::size_t, Affine<Rational>>> sets = {};  ///< the parameters as functions of the variable
};

/// The points of a scene's mechanism across a plane, and the motions there.
class MechanismColumns {
 public:
  MechanismColumns(const MechanismScene& scene, AcrossVariable across)
      : mechanism_(scene.mechanism),
        values_(scene.values),
        across_(std::move(across)),
        maker_(mechanism_),
        sampler_(mechanism_, maker_) {}
  MechanismColumns(const MechanismColumns&) = delete;
  MechanismColumns& operator=(const MechanismColumns&) = delete;

  const Mechanism& mechanism() const { return mechanism_; }
  const AcrossVariable& across() const { return across_; }

  /// The scene's own value; nothing for a half turn.
  std::optional<Rational> own() const {
    if (!across_.angle) return across_.own;
    const MechanismValues::Circle& point = values_.angles[*across_.angle];
    if (point.cosine == -1) return std::nullopt;
    return Rational(point.sine / (1 + point.cosine));
  }

  /// The values at x, inside or outside the domain; parameters that are tied to x follow it.
  MechanismValues values(const Rational& x) const {
    MechanismValues changed = values_;
    if (across_.angle) changed.angles[*across_.angle] = point_of_tan_half(x);
    for (const auto& [parameter, value] : across_.sets) changed.parameters[parameter] = value.at(x);
    sampler_.restore(changed, across_.angle ? changed.parameters.size() : across_.sets.front().first);
    return changed;
  }

  bool contains(const Rational& x) const { return sampler_.contains(values(x)); }

  /// Nothing if there is no problem.
  std::optional<FrictionProblem> problem(const Rational& x) const {
    const MechanismValues there = values(x);
    if (!sampler_.contains(there)) return std::nullopt;
    try {
      return maker_.problem(there);
    } catch (const NoValue&) {
      return std::nullopt;
    }
  }

  std::optional<PhaseColumn> column(const Rational& x) const {
    auto there = problem(x);
    if (!there) return std::nullopt;
    PhaseColumn column;
    column.cells = motions_over_loads(std::move(*there))->cells(Told::modes);
    return column;
  }

  std::vector<LoadCell> numbers(const Rational& x) const { return motions_over_loads(*problem(x))->cells(); }

  /// A condition that does not hold at x; empty if all hold.
  std::string broken(const Rational& x) const {
    const auto all = maker_.broken(values(x));
    return all.empty() ? std::string() : to_string(all.front().condition->expression);
  }

  /// The parameters that differ from the scene's somewhere between two values of x.
  std::vector<std::string> followers(const Rational& from, const Rational& to) const {
    std::vector<std::string> symbols;
    const MechanismValues left = values(from), right = values(to);
    for (std::size_t i = 0; i < values_.parameters.size(); ++i) {
      if (std::ranges::any_of(across_.sets, [&](const auto& set) { return set.first == i; })) continue;
      const Rational& own = values_.parameters[i];
      if (left.parameters[i] != own || right.parameters[i] != own) symbols.push_back(mechanism_.parameters[i].symbol);
    }
    return symbols;
  }

 private:
  const Mechanism mechanism_;
  const MechanismValues values_;
  const AcrossVariable across_;
  const ProblemMaker maker_;
  const DomainSampler sampler_;
};

AcrossVariable find_across(const MechanismScene& scene, const std::string& x) {
  const Mechanism& mechanism = scene.mechanism;
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    const MechanismParameter& parameter = mechanism.parameters[i];
    if (parameter.symbol == x && !scene.values.given[i]) throw std::invalid_argument("the scene has no " + x);
    if (parameter.symbol == x) return {x, parameter.unit, {}, scene.values.parameters[i], {{i, {0, 1}}}};
    known.push_back(parameter.symbol);
  }
  for (const CombinedParameter& combined : scene.combined) {
    known.push_back(combined.symbol);
    if (combined.symbol != x) continue;
    AcrossVariable across{x, combined.unit, {}, combined.value};
    for (const auto& [symbol, value] : combined.sets) {
      const auto same = std::ranges::find(mechanism.parameters, symbol, &MechanismParameter::symbol);
      across.sets.emplace_back(static_cast<std::size_t>(same - mechanism.parameters.begin()), value);
    }
    return across;
  }
  for (std::size_t i = 0; i < mechanism.angles.size(); ++i) {
    if (mechanism.angles[i].name == x) return {x, {}, i, {}};
    known.push_back(mechanism.angles[i].name);
  }
  if (mechanism.load && mechanism.load->symbol == x) {
    throw std::invalid_argument("found the load " + x + " across, expected a parameter or an angle: the load goes up");
  }
  throw std::invalid_argument(unknown_name("parameter or angle", x, known));
}

Rational two_digits(const Rational& x) {
  return parse_rational(decimal_text(x, 2));
}

void expect_order(const std::string& symbol, const Rational& from, const Rational& to) {
  if (from < to) return;
  throw std::invalid_argument(fmt::format("found the range of {} from {} to {}, expected one that begins below its end",
                                          symbol, exact_text(from), exact_text(to)));
}

/// Chooses those ends of both axes that are not given.
class AxisChoice {
 public:
  AxisChoice(const MechanismColumns& columns, const MechanismScene& scene, const MechanismAxes& wanted)
      : columns_(columns), scene_(scene), wanted_(wanted) {}

  Axis across() const {
    const AcrossVariable& variable = columns_.across();
    Axis axis;
    axis.symbol = variable.symbol;
    axis.is_angle = variable.angle.has_value();
    axis.unit = variable.unit;
    const auto [from, to] = axis.is_angle ? angle_range() : parameter_range(axis.symbol);
    axis.from = wanted_.x_from ? end(axis.symbol, *wanted_.x_from) : from;
    axis.to = wanted_.x_to ? end(axis.symbol, *wanted_.x_to) : to;
    expect_order(axis.symbol, wanted_.x_from.value_or(axis.from), wanted_.x_to.value_or(axis.to));
    expect_order(axis.symbol, axis.from, axis.to);
    expect_inside(axis);
    return axis;
  }

  /// All loads at which something changes at one value of x, with a margin.
  Axis up(const Axis& across) const {
    const MechanismLoad& load = *columns_.mechanism().load;
    Axis axis;
    axis.symbol = load.symbol;
    axis.unit = load.unit;
    const auto problem = columns_.problem(typical(across));
    const ForceInterval domain = problem ? problem->load_domain : ForceInterval();
    auto [low, high] = changes(problem);
    const Rational margin = (high - low) / 6;
    low = low - margin, high = high + margin;
    if (domain.lower() && low < *domain.lower()) low = *domain.lower();
    if (domain.upper() && high > *domain.upper()) high = *domain.upper();
    axis.from = wanted_.y_from ? *wanted_.y_from : two_digits(low);
    axis.to = wanted_.y_to ? *wanted_.y_to : two_digits(high);
    expect_order(axis.symbol, axis.from, axis.to);
    ForceInterval seen = ForceInterval::between(axis.from, true, axis.to, true);
    seen.intersect(domain);
    if (!seen.empty() && !seen.is_point()) return axis;
    throw std::invalid_argument(fmt::format("found the range of {} from {} to {}, expected one with values in {}",
                                            axis.symbol, exact_text(axis.from), exact_text(axis.to),
                                            to_string(domain)));
  }

 private:
  using Ends = std::pair<Rational, Rational>;

  Rational end(const std::string& symbol, const Rational& given) const {
    if (!columns_.across().angle) return given;
    if (abs(given) < 180) {
      const MechanismValues::Circle point = angle_from_degrees(given).point;
      return Rational(point.sine / (1 + point.cosine));
    }
    throw std::invalid_argument(fmt::format("found {} degrees for {}, expected an angle between -180 and 180 degrees",
                                            exact_text(given), symbol));
  }

  /// The range in the domain around the scene's own angle; at most +-90 degrees unless that angle is larger.
  Ends angle_range() const {
    const auto own = columns_.own();
    if (!own) return {Rational(-1), Rational(1)};
    constexpr int steps = 32;
    const Rational far = std::max(Rational(1), two_digits(2 * abs(*own)));
    Rational from = -far, to = far;
    for (int i = -steps; i <= steps; ++i) {
      const Rational x = far * Rational(i, steps);
      if (columns_.contains(x)) continue;
      if (x < *own) from = x;
      if (x > *own && x < to) to = x;
    }
    return {from, to};
  }

  /// From zero to twice the scene's own value; on both sides of zero if the other sign is possible.
  Ends parameter_range(const std::string& symbol) const {
    const Rational own = *columns_.own(), size = own.is_zero() ? Rational(1, 2) : Rational(abs(own));
    const bool down = own < 0 || columns_.contains(-size), up = own > 0 || columns_.contains(size);
    if (!down && !up && !(wanted_.x_from && wanted_.x_to)) {
      throw std::invalid_argument(fmt::format("found {} = 0 and no range, expected a range of {}", symbol, symbol));
    }
    return {down ? two_digits(-2 * size) : Rational(0), up ? two_digits(2 * size) : Rational(0)};
  }

  /// Requires that some neighbouring values are in the domain.
  void expect_inside(const Axis& axis) const {
    constexpr int steps = 64;
    bool before = false;
    for (int i = 0; i <= steps; ++i) {
      const bool here = columns_.problem(axis.from + (axis.to - axis.from) * Rational(i, steps)).has_value();
      if (here && before) return;
      before = here;
    }
    std::string condition;
    for (int i = 0; i <= steps && condition.empty(); ++i) {
      condition = columns_.broken(axis.from + (axis.to - axis.from) * Rational(i, steps));
    }
    throw std::invalid_argument("no values side by side of " + axis.symbol + " in its range are in the domain" +
                                (condition.empty() ? "" : ", expected " + condition));
  }

  /// The scene's own x if it is inside; otherwise the value in the domain that is nearest to the middle.
  Rational typical(const Axis& axis) const {
    const auto own = columns_.own();
    if (own && axis.from <= *own && *own <= axis.to) return *own;
    constexpr int steps = 32;
    const Rational middle = (axis.from + axis.to) / 2, step = (axis.to - axis.from) / (2 * steps);
    for (int i = 0; i <= steps; ++i) {
      for (const Rational& x : {Rational(middle + step * i), Rational(middle - step * i)}) {
        if (columns_.problem(x)) return x;
      }
    }
    return middle;
  }

  Ends changes(const std::optional<FrictionProblem>& problem) const {
    std::optional<Rational> low, high;
    const auto see = [&](const Rational& load) {
      low = low ? std::min(*low, load) : load;
      high = high ? std::max(*high, load) : load;
    };
    see(Rational(0));
    if (scene_.load) see(*scene_.load);
    if (problem) {
      for (const LoadCell& cell : motions_over_loads(*problem)->cells(Told::modes)) {
        if (cell.loads.is_point()) see(*cell.loads.lower());
      }
      if (!problem->load_domain.empty() && !problem->load_domain.contains(Rational(0)) && *low == *high) {
        see(problem->load_domain.sample());
      }
    }
    if (*low == *high) return {*low - 1, *high + 1};
    return {*low, *high};
  }

  const MechanismColumns& columns_;
  const MechanismScene& scene_;
  const MechanismAxes& wanted_;
};

std::string note_of(const MechanismColumns& columns, const MechanismScene& scene, const Axis& across) {
  std::string note;
  const auto followers = columns.followers(across.from, across.to);
  if (!followers.empty()) {
    note = fmt::format("With {}, {} changes as the domain asks.", across.symbol, fmt::join(followers, ", "));
  }
  const auto add = [&](const std::string& sentence) { note += (note.empty() ? "" : " ") + sentence; };
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

bool shows(const Axis& axis, const Rational& x) {
  return axis.from <= x && x <= axis.to;
}

Json across_json(const Axis& axis, const Rational& x) {
  if (!axis.is_angle) return to_json(x);
  const MechanismValues::Circle point = point_of_tan_half(x);
  return {{"cos", to_json(point.cosine)}, {"sin", to_json(point.sine)}};
}

}  // namespace

Plane mechanism_plane(const MechanismScene& scene, const MechanismAxes& axes, std::string id) {
  if (!scene.mechanism.load) {
    throw std::invalid_argument("the mechanism " + scene.mechanism.name +
                                " has no load, expected one, or a parameter that takes its place");
  }
  refuse_too_many_modes(scene.mechanism, element_kinds(scene.mechanism, scene.values.starts, scene.values.given));
  const auto columns = std::make_shared<const MechanismColumns>(
      scene, find_across(scene, axes.x.empty() ? usual_parameter(scene) : axes.x));
  const AxisChoice choice(*columns, scene, axes);
  Plane plane;
  plane.id = std::move(id);
  plane.title = scene.name;
  plane.x = choice.across();
  plane.y = choice.up(plane.x);
  plane.finds_domain = plane.joins_alike = true;
  plane.note = note_of(*columns, scene, plane.x);
  const auto own = columns->own();
  if (scene.load && own && shows(plane.x, *own) && shows(plane.y, *scene.load))
    plane.mark = Plane::Mark{*own, *scene.load, "the scene"};
  tell_of_mechanism(plane, scene.mechanism);
  plane.solve = [columns](const Rational& x) { return columns->column(x); };
  plane.numbers = [columns](const Rational& x) { return columns->numbers(x); };
  return plane;
}

std::string map_json(const PhaseDiagram& diagram, const MechanismScene& scene) {
  const Axis &x = diagram.plane.x, &y = diagram.plane.y;
  Json document, columns = Json::array();
  document["schema"] = "slipproof/map/2";
  document["mechanism"] = scene.mechanism.name;
  document["scene"] = scene.name;
  document["values"] = values_json(scene.mechanism, scene.values);
  document["x"] = {{"symbol", x.symbol},
                   {"kind", x.is_angle ? "angle" : "parameter"},
                   {"range", Json::array({across_json(x, x.from), across_json(x, x.to)})}};
  document["load"] = {{"symbol", y.symbol}, {"range", Json::array({to_json(y.from), to_json(y.to)})}};
  document["note"] = diagram.plane.note;
  for (const PhaseColumn& column : diagram.columns) {
    Json cells = Json::array();
    for (const LoadCell& cell : column.cells) cells.push_back(cell_json(cell));
    columns.push_back({{"x", across_json(x, column.x)}, {"cells", std::move(cells)}});
  }
  document["columns"] = std::move(columns);
  return dump(document);
}

}  // namespace slipproof
