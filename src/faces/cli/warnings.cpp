#include "faces/cli/warnings.hpp"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "mechanics/checks/checks.hpp"

namespace slipproof::cli {

namespace {

void print_findings(const Mechanism& mechanism, const std::vector<MechanismFinding>& findings) {
  std::set<std::string> told;
  for (const MechanismFinding& finding : findings) {
    const std::string text = to_string(mechanism, finding);
    if (finding.checkable && told.insert(text).second) std::cerr << text << '\n';
  }
}

}  // namespace

void print_warnings(const Mechanism& mechanism, const CommonOptions& common) {
  if (!common.quiet && !mechanism.shipped) print_findings(mechanism, check_mechanism(mechanism));
}

void print_warnings(const MechanismScene& scene, const CommonOptions& common) {
  if (common.quiet || scene.mechanism.shipped) return;
  try {
    std::vector<MechanismFinding> findings = check_mechanism(scene.mechanism);
    std::ranges::move(check_numbers(scene), std::back_inserter(findings));
    print_findings(scene.mechanism, findings);
  } catch (const InputError&) {
    return;  // too many elements for motions, by which most is checked
  }
}

void print_warnings(const ClaimsFile& claims, const CommonOptions& common) {
  std::set<const Mechanism*> told;
  for (const Setting& setting : claims.settings) {
    if (told.insert(setting.mechanism.get()).second) print_warnings(*setting.mechanism, common);
  }
}

void refuse_impact(const MechanismScene& scene, const std::string& command) {
  if (!scene.mechanism.impact) return;
  throw InputError({{scene.mechanism.file, 0, 0,
                     "found an impact, by [impact], expected a mechanism without it for `" + command +
                         "`: after an impact there are velocities, and no accelerations"}});
}

}  // namespace slipproof::cli
