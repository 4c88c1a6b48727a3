#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/rest_on_slope/motion.hpp"

namespace slipproof::test::rest_on_slope {

namespace {

/// What impulses of the feet do to the velocities, with friction as Coulomb's law has it.
Triple change_by(const Body& body, double velocity_along, const Triple& impulses) {
  for (const int slip : {0, 1, -1}) {
    const Contact contact(body, {}, slip);
    const Triple all = contact.with_friction(impulses);
    if (contact.lawful(velocity_along, all)) return contact.acceleration(all);
  }
  throw std::runtime_error("no friction for an impact");
}

/// A foot rests on the ground while the other one pushes: the impulse that keeps it at rest, or 0 if the foot lifts.
double holding(const Body& body, double velocity_along, std::size_t foot, const Triple& impulses) {
  std::array<bool, 3> pushing{};
  pushing[foot] = true;
  for (const int slip : {0, 1, -1}) {
    const Contact contact(body, {}, slip);
    const Triple all = contact.keeping(pushing, impulses);
    if (all[foot] >= 0 && contact.lawful(velocity_along, all)) return all[foot];
  }
  return 0;
}

/// Random impulses of the feet that come down: of one, or of both.
Triple impulses_down(const State& state, Dice& dice) {
  Triple result{};
  while (!(result[1] + result[2] > 0)) {
    for (const std::size_t i : feet) {
      if (state.comes_down(i) && !dice.chance(4)) result[i] = between(dice, 0, 1);
    }
  }
  return result;
}

}  // namespace

void hit(const Body& body, State& state, Dice& dice) {
  Triple impulses = impulses_down(state, dice);
  const double along = state.velocity[0];
  std::size_t held = 0;  // none yet: feet are 1 and 2
  for (const std::size_t i : feet) {
    if (!state.on_ground(i) || state.comes_down(i) || dice.chance(3)) continue;
    const double hold = holding(body, along, i, impulses);
    if (!(hold > 0)) continue;
    const double part = dice.chance(2) ? 1 : between(dice, 0, 1);
    Triple with = impulses;
    with[i] = part * hold;
    if (part < 1 && change_by(body, along, with)[i] > 0) continue;  // a foot that lifts does not push
    impulses = with;
    if (!(part < 1)) held = i;
  }
  Triple change = change_by(body, along, impulses);
  if (held != 0) change[held] = 0;

  double length = std::numeric_limits<double>::infinity();
  std::size_t next = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if ((i > 0 && !(impulses[i] > 0)) || !(state.velocity[i] * change[i] < 0)) continue;
    if (-state.velocity[i] / change[i] >= length) continue;
    length = -state.velocity[i] / change[i];
    next = i;
  }
  if (!std::isfinite(length)) throw std::runtime_error("an impact without an end from " + text(state));
  const bool early = dice.chance(3);
  if (early) length *= between(dice, 0.01, 0.99);
  for (std::size_t i = 0; i < 3; ++i) state.velocity[i] += length * change[i];
  if (!early) state.velocity[next] = 0;
}

}  // namespace slipproof::test::rest_on_slope
