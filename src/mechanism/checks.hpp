// What is suspicious in a mechanism though it can be read: signs that break reciprocity, gravity that lifts, sums of
// different units.
#pragma once

#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace slipproof {

struct MechanismFinding {
  enum class Check { reciprocity, gravity, units };
  Check check = Check::reciprocity;
  bool checkable = true;  ///< false: the check could not be made, and the message says why
  Place place;            ///< in the mechanism's file
  std::string message;
};

/// "FILE:LINE:COLUMN: warning: MESSAGE"; "FILE: not checkable: MESSAGE" without a place.
std::string to_string(const Mechanism& mechanism, const MechanismFinding& finding);

/// All checks; nothing is found in a mechanism as it should be.
std::vector<MechanismFinding> check_mechanism(const Mechanism& mechanism);

/// By virtual work the accelerations (gap, slip, zero) depend on the forces (N, S, R) by a symmetric and positive
/// semidefinite matrix. Tried at sampled points, four at least. Nothing if the file says `reciprocal = false`.
std::vector<MechanismFinding> check_reciprocity(const Mechanism& mechanism);

/// Without the forces of contacts and friction elements, and without load, no contact at rest opens; and where there is
/// gravity (a parameter g, or one in m/s^2), something falls. Tried at sampled points, four at least.
std::vector<MechanismFinding> check_gravity(const Mechanism& mechanism);

/// Where units are given, both operands of each sum, comparison and equation have the same.
std::vector<MechanismFinding> check_units(const Mechanism& mechanism);

}  // namespace slipproof
