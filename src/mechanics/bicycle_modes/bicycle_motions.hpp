// The bicycle as the mechanism of its file, and its modes by the table of modes behind the interface of the kernel.
//
// ModeTable solves a bicycle several times as fast as the kernel, which is what keeps it; tests/mechanics/bicycle_modes
// holds both equal. Where a bicycle has a continuum, the kernel answers.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "mechanics/bicycle/bicycle.hpp"
#include "mechanics/bicycle/contact_mode.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "mechanics/scene/problem.hpp"

namespace slipproof {

/// The shipped mechanism `bicycle`.
const Mechanism& bicycle_mechanism();
/// The index of a parameter of it.
std::size_t bicycle_parameter(std::string_view symbol);

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

/// By the table of modes; with `only`, of these alone.
std::unique_ptr<const MotionsOverLoads> bicycle_motions(const Bicycle<Rational>& bicycle, const Road<Rational>& road,
                                                        ForceKind kind,
                                                        const std::optional<std::vector<MechanismMode>>& only = {});

}  // namespace slipproof
