#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/rest_on_slope/motion.hpp"

namespace slipproof::test::rest_on_slope {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-13;  // of accelerations and forces, whose unit is the weight

/// When z is 0 for the first time from now on.
double time_to_ground(double z, double velocity, double acceleration) {
  const double discriminant = velocity * velocity - 2 * acceleration * z;
  if (velocity < 0) return discriminant < 0 ? never : 2 * z / (std::sqrt(discriminant) - velocity);
  return acceleration < 0 ? (velocity + std::sqrt(discriminant)) / -acceleration : never;
}

double time_to_stop(double velocity, double acceleration) {
  return velocity * acceleration < 0 ? -velocity / acceleration : never;
}

/// The integral of |velocity|.
double way(double velocity, double acceleration, double time) {
  const double stop = std::min(time_to_stop(velocity, acceleration), time), after = time - stop;
  return std::abs(velocity * stop + acceleration * stop * stop / 2) + std::abs(acceleration) * after * after / 2;
}

}  // namespace

std::vector<Triple> accelerations(const Body& body, const State& state) {
  if (!state.on_ground(1) && !state.on_ground(2)) return {body.load()};
  std::vector<Triple> result;
  for (const int slip : {1, -1, 0}) {
    const Contact contact(body, body.load(), slip);
    for (const std::array<bool, 3> pushing :
         {std::array{false, true, false}, {false, false, true}, {false, true, true}}) {
      const Triple forces = contact.keeping(pushing, {});
      Triple found = contact.acceleration(forces);
      bool lawful = contact.lawful(state.velocity[0], forces);
      for (const std::size_t i : feet) {
        if (pushing[i]) {
          lawful = lawful && state.on_ground(i) && forces[i] >= -rounding;
          found[i] = 0;
        } else if (state.on_ground(i)) {
          lawful = lawful && found[i] >= -rounding;
          found[i] = std::max(found[i], 0.);
        }
      }
      if (lawful) result.push_back(found);
    }
  }
  return result;
}

double flow(const Body& body, State& state, Dice& dice) {
  const std::vector<Triple> choice = accelerations(body, state);
  if (choice.empty()) throw std::runtime_error("no motion from " + text(state));
  const Triple& a = choice[static_cast<std::size_t>(dice.number(0, static_cast<int>(choice.size()) - 1))];
  Triple times{time_to_stop(state.velocity[0], a[0]), never, never};
  for (const std::size_t i : feet) {
    if (!state.on_ground(i)) times[i] = time_to_ground(state.at[i], state.velocity[i], a[i]);
  }
  const auto next = static_cast<std::size_t>(std::min_element(times.begin(), times.end()) - times.begin());
  double time = times[next];
  if (time == never) throw std::runtime_error("no end from " + text(state));
  const bool early = dice.chance(4);
  if (early) time *= between(dice, 0.01, 0.99);
  double result = 0;
  const State before = state;
  for (std::size_t i = 0; i < 3; ++i) {
    result += way(before.velocity[i], a[i], time);
    state.at[i] += before.velocity[i] * time + a[i] * time * time / 2;
    state.velocity[i] += a[i] * time;
  }
  for (const std::size_t i : feet) state.at[i] = std::max(state.at[i], 0.);
  if (!early && next == 0) state.velocity[0] = 0;
  if (!early && next > 0) {
    state.at[next] = 0;
    const double v = before.velocity[next];
    state.velocity[next] = -std::sqrt(std::max(v * v - 2 * a[next] * before.at[next], 0.));
  }
  return result;
}

}  // namespace slipproof::test::rest_on_slope
