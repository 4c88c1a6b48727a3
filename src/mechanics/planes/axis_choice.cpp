#include "mechanics/planes/axis_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/number/format.hpp"
#include "base/number/parse.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "mechanics/points/degrees.hpp"

namespace slipproof {

namespace {

Rational two_digits(const Rational& x) {
  return parse_rational(decimal_text(x, 2));
}

void expect_order(const std::string& symbol, const Rational& from, const Rational& to) {
  if (from < to) return;
  throw std::invalid_argument(fmt::format("found the range of {} from {} to {}, expected one that begins below its end",
                                          symbol, exact_text(from), exact_text(to)));
}

}  // namespace

Axis AxisChoice::across() const {
  const FreeSymbol& variable = freed_.free();
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

AxisChoice::Up AxisChoice::up(const Axis& across) const {
  const MechanismLoad& load = *freed_.mechanism().load;
  Axis axis;
  axis.symbol = load.symbol;
  axis.unit = load.unit;
  const auto problem = freed_.problem(typical(across));
  const ForceInterval domain = problem ? problem->load_domain : ForceInterval();
  const std::vector<Rational> all = changes(problem);
  const Rational reach = this->reach(all);
  Rational low = 0, high = 0;
  if (domain.lower() && *domain.lower() > 0) low = high = *domain.lower();
  if (domain.upper() && *domain.upper() < 0) low = high = *domain.upper();
  for (const Rational& load : all) {
    if (abs(load) <= reach) low = std::min(low, load), high = std::max(high, load);
  }
  if (low == high) low = low - 1, high = high + 1;
  const Rational margin = (high - low) / 6;
  low = low - margin, high = high + margin;
  if (domain.lower() && low < *domain.lower()) low = *domain.lower();
  if (domain.upper() && high > *domain.upper()) high = *domain.upper();
  axis.from = wanted_.y_from ? *wanted_.y_from : two_digits(low);
  axis.to = wanted_.y_to ? *wanted_.y_to : two_digits(high);
  expect_order(axis.symbol, axis.from, axis.to);
  ForceInterval seen = ForceInterval::between(axis.from, true, axis.to, true);
  seen.intersect(domain);
  if (!seen.empty() && !seen.is_point()) {
    std::vector<Rational> beyond;
    for (const Rational& load : all) {
      if (load < axis.from || load > axis.to) beyond.push_back(load);
    }
    return {std::move(axis), std::move(beyond)};
  }
  throw std::invalid_argument(fmt::format("found the range of {} from {} to {}, expected one with values in {}",
                                          axis.symbol, exact_text(axis.from), exact_text(axis.to), to_string(domain)));
}

Axis AxisChoice::up_in_space() const {
  const MechanismLoad& load = *freed_.mechanism().load;
  const Rational own = scene_.load.value_or(0);
  if (own.is_zero() && !(wanted_.y_from && wanted_.y_to)) {
    throw std::invalid_argument("found no load in the scene, or 0, and no range, expected a range of " + load.symbol);
  }
  Axis axis{load.symbol, std::min(Rational(0), Rational(2 * own)), std::max(Rational(0), Rational(2 * own)), load.unit};
  if (wanted_.y_from) axis.from = *wanted_.y_from;
  if (wanted_.y_to) axis.to = *wanted_.y_to;
  expect_order(axis.symbol, axis.from, axis.to);
  return axis;
}

Rational AxisChoice::end(const std::string& symbol, const Rational& given) const {
  if (!freed_.free().angle) return given;
  if (abs(given) < 180) {
    const MechanismValues::Circle point = angle_from_degrees(given).point;
    return Rational(point.sine / (1 + point.cosine));
  }
  throw std::invalid_argument(fmt::format("found {} degrees for {}, expected an angle between -180 and 180 degrees",
                                          exact_text(given), symbol));
}

AxisChoice::Ends AxisChoice::angle_range() const {
  const auto own = freed_.own();
  if (!own) return {Rational(-1), Rational(1)};
  constexpr int steps = 32;
  const Rational far = std::max(Rational(1), two_digits(2 * abs(*own)));
  Rational from = -far, to = far;
  for (int i = -steps; i <= steps; ++i) {
    const Rational x = far * Rational(i, steps);
    if (freed_.contains(x)) continue;
    if (x < *own) from = x;
    if (x > *own && x < to) to = x;
  }
  return {from, to};
}

AxisChoice::Ends AxisChoice::parameter_range(const std::string& symbol) const {
  const Rational own = *freed_.own(), size = own.is_zero() ? Rational(1, 2) : Rational(abs(own));
  const bool down = own < 0 || freed_.contains(-size), up = own > 0 || freed_.contains(size);
  if (!down && !up && !(wanted_.x_from && wanted_.x_to)) {
    throw std::invalid_argument(fmt::format("found {} = 0 and no range, expected a range of {}", symbol, symbol));
  }
  return {down ? two_digits(-2 * size) : Rational(0), up ? two_digits(2 * size) : Rational(0)};
}

void AxisChoice::expect_inside(const Axis& axis) const {
  constexpr int steps = 64;
  bool before = false;
  for (int i = 0; i <= steps; ++i) {
    const bool here = freed_.problem(axis.from + (axis.to - axis.from) * Rational(i, steps)).has_value();
    if (here && before) return;
    before = here;
  }
  std::string condition;
  for (int i = 0; i <= steps && condition.empty(); ++i) {
    condition = freed_.broken(axis.from + (axis.to - axis.from) * Rational(i, steps));
  }
  throw std::invalid_argument("no values side by side of " + axis.symbol + " in its range are in the domain" +
                              (condition.empty() ? "" : ", expected " + condition));
}

Rational AxisChoice::typical(const Axis& axis) const {
  const auto own = freed_.own();
  if (own && axis.from <= *own && *own <= axis.to) return *own;
  constexpr int steps = 32;
  const Rational middle = (axis.from + axis.to) / 2, step = (axis.to - axis.from) / (2 * steps);
  for (int i = 0; i <= steps; ++i) {
    for (const Rational& x : {Rational(middle + step * i), Rational(middle - step * i)}) {
      if (freed_.problem(x)) return x;
    }
  }
  return middle;
}

std::vector<Rational> AxisChoice::changes(const std::optional<FrictionProblem>& problem) const {
  std::vector<Rational> loads;
  if (scene_.load) loads.push_back(*scene_.load);
  if (!problem) return loads;
  for (const LoadCell& cell : motions_over_loads(*problem)->cells(Detail::modes)) {
    if (cell.loads.is_point()) loads.push_back(*cell.loads.lower());
  }
  return loads;
}

/// Begins with the scene's load, or where it has none with the middle one of all changes, and with the two changes that
/// are nearest to 0; goes on until the next change is more than five times as far.
Rational AxisChoice::reach(std::vector<Rational> changes) const {
  constexpr std::size_t at_least = 2;
  constexpr int far = 5;
  for (Rational& load : changes) load = abs(load);
  std::erase(changes, Rational(0));
  std::ranges::sort(changes);
  if (changes.empty()) return 0;
  Rational reach = scene_.load ? Rational(abs(*scene_.load)) : Rational(0);
  if (reach.is_zero()) reach = changes[(changes.size() - 1) / 2];
  reach = std::max(reach, changes[std::min(at_least, changes.size()) - 1]);
  for (const Rational& load : changes) {
    if (load > far * reach) break;
    reach = std::max(reach, load);
  }
  return reach;
}

}  // namespace slipproof
