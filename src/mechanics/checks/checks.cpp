#include "mechanics/checks/checks.hpp"

#include <iterator>

#include "mechanics/checks/check_parts.hpp"

namespace slipproof {

namespace {

/// In space, of ten bodies: problems at points are dense.
constexpr std::size_t most_accelerations = 60;

}  // namespace

std::string to_string(const Mechanism& mechanism, const MechanismFinding& finding) {
  const std::string kind = finding.checkable ? "warning: " : "not checkable: ";
  return to_string(Diagnostic{mechanism.file, finding.place.line, finding.place.column, kind + finding.message});
}

std::vector<MechanismFinding> check_mechanism(const Mechanism& mechanism) {
  using namespace mechanism_checks;
  UnitReport units = check_units(mechanism);
  std::vector<MechanismFinding> findings = std::move(units.findings);
  std::ranges::move(check_names(mechanism), std::back_inserter(findings));
  const auto not_tried = [&](std::string why) {
    findings.push_back(not_checkable(MechanismFinding::Check::points, std::move(why)));
    return std::move(findings);
  };
  if (mechanism.dimension == 3 && mechanism.accelerations > most_accelerations) {
    return not_tried("more than " + std::to_string(most_accelerations) + " accelerations are not tried at points");
  }
  const CheckPoints points(mechanism);
  if (points.all().size() < CheckPoints::needed) {
    return not_tried("too few points of the domain were found to try equations and contacts at");
  }
  std::ranges::move(check_inertia(points, units.scaled_well), std::back_inserter(findings));
  for (auto* check : {check_reciprocity, check_gravity, check_elements, check_geometry, check_drawing, check_solids}) {
    if (mechanism.dimension == 3 && check == check_geometry) continue;  // of two coordinates
    std::ranges::move(check(points), std::back_inserter(findings));
  }
  return findings;
}

std::vector<MechanismFinding> check_numbers(const MechanismScene& scene) {
  using namespace mechanism_checks;
  if (!scene.mechanism.bodies) return {};
  const ProblemMaker maker(scene.mechanism);
  std::vector<MechanismFinding> findings = check_drawing_at(scene.mechanism, maker, scene.values);
  std::ranges::move(check_solids_at(scene.mechanism, maker, scene.values), std::back_inserter(findings));
  return findings;
}

}  // namespace slipproof
