// Random motions of the body: where the laws leave a choice, the dice choose.
#pragma once

#include <vector>

#include "mechanics/rest_on_slope/body.hpp"

namespace slipproof::test::rest_on_slope {

/// The accelerations that Coulomb's law and the feet allow in a state in which no foot comes down on the ground.
std::vector<Triple> accelerations(const Body& body, const State& state);

/// A stretch with constant accelerations, to where the feet stop sliding or a foot hits the ground, or, one time in
/// four, to an earlier time. Returns the integral of |x'| + |z1'| + |z2'|. Throws std::runtime_error if there is no
/// acceleration, or no end.
double flow(const Body& body, State& state, Dice& dice);

/// A part of an impact, while State::hits(): a straight path of the velocities, to where x' or the velocity of a foot
/// that pushes is 0, or, one time in three, to an earlier point.
void hit(const Body& body, State& state, Dice& dice);

}  // namespace slipproof::test::rest_on_slope
