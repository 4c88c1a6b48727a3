// Inside the checks: each looks at one kind of mistake. See checks.hpp for what they find together.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/checks/check_points.hpp"
#include "mechanics/checks/checks.hpp"

namespace slipproof::mechanism_checks {

/// What units say of a mechanism.
struct UnitReport {
  std::vector<MechanismFinding> findings;
  /// For each row of [motion], whether its unit times that of its acceleration shows that no single row is scaled.
  std::vector<bool> scaled_well;
};

/// Checks units, if they are given: both operands of each sum, comparison and equation must have the same. By virtual
/// work, a row of [motion] times its acceleration, and a force times the motion along which it works, all have the unit
/// of power over time.
UnitReport check_units(const Mechanism& mechanism);

/// The inertia in [motion]: it is the energy's, up to one factor for all rows, or symmetric and positive semidefinite,
/// and its rows have one scale, by the energy, by units, or because they are coupled. `scaled_well` as above.
std::vector<MechanismFinding> check_inertia(const CheckPoints& points, const std::vector<bool>& scaled_well);

/// By virtual work the accelerations (gap, slip, zero) depend on the forces (N, S, R) by a symmetric and positive
/// semidefinite matrix: in a file with [equations], unless it says `reciprocal = false`. Of [motion] it follows from
/// the inertia.
std::vector<MechanismFinding> check_reciprocity(const CheckPoints& points);

/// Without the forces of contacts and friction elements, without load and without what pushes, no contact at rest
/// opens; and where there is gravity, something falls. Bodies whose gravity points up get this warning alone.
std::vector<MechanismFinding> check_gravity(const CheckPoints& points);

/// Limits and coefficients of friction that are negative, kinetic ones above static ones, motions without an
/// acceleration, links that contradict each other or hold a contact shut, one slip that has two signs.
std::vector<MechanismFinding> check_elements(const CheckPoints& points);

/// Gaps and slips of one body's contacts against `at`, `direction` and `slip_direction`: up to a turn, a mirror and a
/// shift of the axes, and a factor for each contact, they are those of points of a rigid body.
std::vector<MechanismFinding> check_geometry(const CheckPoints& points);

/// Of bodies: contacts at one place, normals into the wrong body, pins and forces beside their bodies, gravity along
/// the surface, outlines in each other.
std::vector<MechanismFinding> check_drawing(const CheckPoints& points);

/// Parameters, angles, definitions and loads that occur nowhere else.
std::vector<MechanismFinding> check_names(const Mechanism& mechanism);

/// At the first index at which a symmetric matrix is found not to be positive semidefinite.
std::optional<std::size_t> negative_direction(std::vector<std::vector<Rational>> matrix);

inline MechanismFinding warning(MechanismFinding::Check check, Place place, std::string message) {
  return {check, true, place, std::move(message)};
}
inline MechanismFinding not_checkable(MechanismFinding::Check check, std::string why, Place place = {}) {
  return {check, false, place, std::move(why)};
}

}  // namespace slipproof::mechanism_checks
