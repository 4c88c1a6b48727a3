#include "mechanics/checks/checks.hpp"

#include <iterator>

#include "mechanics/checks/check_parts.hpp"

namespace slipproof {

std::string to_string(const Mechanism& mechanism, const MechanismFinding& finding) {
  const std::string kind = finding.checkable ? "warning: " : "not checkable: ";
  return to_string(Diagnostic{mechanism.file, finding.place.line, finding.place.column, kind + finding.message});
}

std::vector<MechanismFinding> check_mechanism(const Mechanism& mechanism) {
  using namespace mechanism_checks;
  UnitReport units = check_units(mechanism);
  std::vector<MechanismFinding> findings = std::move(units.findings);
  std::ranges::move(check_names(mechanism), std::back_inserter(findings));
  if (mechanism.dimension == 3) return findings;  // the others know the plane
  const CheckPoints points(mechanism);
  if (points.all().size() < CheckPoints::needed) {
    findings.push_back(not_checkable(MechanismFinding::Check::points,
                                     "too few points of the domain were found to try equations and contacts at"));
    return findings;
  }
  std::ranges::move(check_inertia(points, units.scaled_well), std::back_inserter(findings));
  for (auto* check : {check_reciprocity, check_gravity, check_elements, check_geometry, check_drawing}) {
    std::ranges::move(check(points), std::back_inserter(findings));
  }
  return findings;
}

}  // namespace slipproof
