#include "mechanics/rest_on_slope/lyapunov.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mechanics/rest_on_slope/motion.hpp"

namespace slipproof::test::rest_on_slope {

namespace {

double value(const Body& body, const Numbers& n, double kappa, const State& state) {
  const auto [x, v1, v2] = state.velocity;
  const double z1 = state.at[1], z2 = state.at[2];
  const double om = (v2 - v1) / 2, xc = x - body.h * om, zc = (body.b2() * v1 + body.b1() * v2) / 2;
  const double energy = (xc * xc + zc * zc + body.J * om * om) / 2;
  const double n1 = (body.b2() - body.t * body.h) / 2, n2 = (body.b1() + body.t * body.h) / 2;
  return energy + n1 * z1 + n2 * z2 + kappa * std::abs(x) * zc + n.K1 * (v1 * v1 / 2 + z1) + n.K2 * (v2 * v2 / 2 + z2) +
         n.K3 * (v1 * v2 + z1 + z2) + (n.B1 * v1 * std::abs(v1) + n.B2 * v2 * std::abs(v2)) / 2 +
         n.E * std::abs(v1 * v2);
}

double value_beyond(const State& state) {
  const auto [x, v1, v2] = state.velocity;
  const double p = std::abs(x), q1 = std::abs(v1), q2 = std::abs(v2);
  return 24 * x * x + 17 * x * p + 9 * v1 * v1 + 6 * v1 * q1 + 13 * v2 * v2 + 2 * v2 * q2 + (14 * x + 10 * p) * v1 +
         (7 * x + 7 * p) * q1 - (4 * x - 4 * p) * v2 - 6 * v1 * v2 + 2 * v1 * q2 - 4 * q1 * v2 + 4 * q1 * q2 +
         9 * state.at[1] + 24 * state.at[2];
}

/// Impacts accumulate under a body that still slides: below the rounding of V the feet stay on the ground.
void settle(State& state, double v) {
  constexpr double small = 1e-12;
  for (const std::size_t i : feet) {
    if (std::abs(state.velocity[i]) > small * std::sqrt(v) || state.at[i] > small * small * v) return;
  }
  for (const std::size_t i : feet) state.at[i] = state.velocity[i] = 0;
}

}  // namespace

Falling falling(const Body& body, const Numbers& numbers, double kappa) {
  const double t = std::abs(body.t), e = std::abs(numbers.E);
  const double d1 = kappa * body.b2() / 2, d2 = kappa * body.b1() / 2;
  return {[=](const State& state) { return value(body, numbers, kappa, state); },
          std::min({kappa - t, numbers.B1 - e - t * d1, numbers.B2 - e - t * d2})};
}

Falling falling_beyond() {
  return {value_beyond, 0.1};
}

Seen follow(const Body& body, const Falling& falling, State state, Dice& dice, int limit) {
  constexpr double rounding = 1e-10;
  Seen seen;
  const double start = falling.value(state);
  double before = start;
  while (!seen.rests && seen.rise.empty() && seen.stretches + seen.hits < limit) {
    const State from = state;
    double way = 0;
    if (state.hits()) {
      hit(body, state, dice);
      ++seen.hits;
    } else {
      way = flow(body, state, dice);
      ++seen.stretches;
    }
    seen.way += way;
    if (!state.hits()) settle(state, before);
    const double after = falling.value(state);
    const double slack = (after + falling.rate * way - before) / before;
    seen.slack = std::max(seen.slack, slack);
    seen.rests = state.at_rest() || after < 1e-8 * start;
    if (!(slack <= rounding) || (!state.at_rest() && !(after > 0))) {
      seen.rise = fmt::format("{}; V = {} at {}, then {} at {}, {} on the way", text(body), before, text(from), after,
                              text(state), way);
    }
    before = after;
  }
  return seen;
}

}  // namespace slipproof::test::rest_on_slope
