// The bicycle as the mechanism of its file, and back.
#pragma once

#include <optional>

#include "mechanics/scene/bicycle_scene.hpp"
#include "support/bicycle/bicycle.hpp"
#include "support/bicycle/contact_mode.hpp"

namespace slipproof {

/// visit(symbol, number) for each number of a bicycle on its road, by the symbols of the mechanism's parameters.
template <class Cycle, class Ground, class Visit>
void for_each_number(Cycle& p, Ground& road, Visit&& visit) {
  visit("M", p.M);
  visit("R", p.R);
  visit("h", p.h);
  visit("b2", p.b2);
  visit("b3", p.b3);
  visit("I1", p.I1);
  visit("I2", p.I2);
  visit("I3", p.I3);
  visit("r1", p.r1);
  visit("r2", p.r2);
  visit("L", p.L);
  visit("f", road.f);
  visit("g", road.g);
}

/// A bicycle as values of its parameters.
MechanismValues bicycle_values(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind);
/// The bicycle that the values of its mechanism are, whatever the states before the motion.
struct BicycleOfValues {
  Bicycle<Rational> bicycle;
  Road<Rational> road;
  ForceKind kind;
};
BicycleOfValues bicycle_of(const MechanismValues& values);

/// The same mode with a state for each element.
const MechanismMode& mechanism_mode(ContactMode mode);
/// Nothing unless it has two states of wheels.
std::optional<ContactMode> contact_mode(const MechanismMode& mode);

}  // namespace slipproof
