// Inside the checks: each looks at one kind of mistake. See checks.hpp for what they find together.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/checks/check_points.hpp"
#include "mechanics/checks/checks.hpp"

namespace slipproof::mechanism_checks {

/// The result of the check of units.
struct UnitReport {
  std::vector<MechanismFinding> findings;
  /// For each row of [motion]: true if its unit times the unit of its acceleration shows that no single row is scaled.
  std::vector<bool> scaled_well;
};

/// Checks units, if they are given: both operands of each sum, comparison and equation must have the same. By virtual
/// work, a row of [motion] times its acceleration, and a force times the motion along which it works, all have the unit
/// of power over time.
UnitReport check_units(const Mechanism& mechanism);

/// The inertia in [motion]: it is the energy's, up to one factor for all rows, or symmetric and positive semidefinite,
/// and its rows have one scale, by the energy, by units, or because they are coupled. `scaled_well` as above.
std::vector<MechanismFinding> check_inertia(const CheckPoints& points, const std::vector<bool>& scaled_well);

/// Checks that the matrix from forces (N, S, R) to accelerations (gap, slip, zero) is symmetric and positive
/// semidefinite, as virtual work requires. For files with [equations], unless they say `reciprocal = false`; for
/// [motion] it follows from the inertia.
std::vector<MechanismFinding> check_reciprocity(const CheckPoints& points);

/// Checks that without load, driving forces and the forces of contacts and friction elements no contact at rest opens,
/// and that something falls if there is gravity. Bodies whose gravity points up get only this warning.
std::vector<MechanismFinding> check_gravity(const CheckPoints& points);

/// Limits and coefficients of friction that are negative, kinetic ones above static ones, motions without an
/// acceleration, links that contradict each other or hold a contact shut, one slip that has two signs.
std::vector<MechanismFinding> check_elements(const CheckPoints& points);

/// Gaps and slips of one body's contacts against `at`, `direction` and `slip_direction`: up to a turn, a mirror and a
/// shift of the axes, and a factor for each contact, they are those of points of a rigid body.
std::vector<MechanismFinding> check_geometry(const CheckPoints& points);

/// Checks the geometry of bodies: contacts at one place, normals into the wrong body, joints and forces outside their
/// bodies, gravity along the surface, overlapping outlines.
std::vector<MechanismFinding> check_drawing(const CheckPoints& points);

/// Checks inertias, centres of mass and contacts of bodies against the shapes of these.
std::vector<MechanismFinding> check_solids(const CheckPoints& points);

/// At one point, for mechanisms of bodies: surfaces and overlapping outlines; inertias, and densities.
std::vector<MechanismFinding> check_drawing_at(const Mechanism& mechanism, const ProblemMaker& maker,
                                               const MechanismValues& values);
std::vector<MechanismFinding> check_solids_at(const Mechanism& mechanism, const ProblemMaker& maker,
                                              const MechanismValues& values);

/// Parameters, angles, definitions and loads that occur nowhere else.
std::vector<MechanismFinding> check_names(const Mechanism& mechanism);

/// The first index at which elimination finds that a symmetric matrix is not positive semidefinite; nothing if it is.
std::optional<std::size_t> negative_direction(std::vector<std::vector<Rational>> matrix);

inline MechanismFinding warning(MechanismFinding::Check check, Place place, std::string message) {
  return {check, true, place, std::move(message)};
}
inline MechanismFinding not_checkable(MechanismFinding::Check check, std::string why, Place place = {}) {
  return {check, false, place, std::move(why)};
}

}  // namespace slipproof::mechanism_checks
