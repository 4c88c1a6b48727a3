#include "faces/cli/warnings.hpp"

#include <iostream>
#include <set>

#include "mechanics/checks/checks.hpp"

namespace slipproof::cli {

void print_warnings(const Mechanism& mechanism, const CommonOptions& common) {
  if (common.quiet || mechanism.shipped) return;
  for (const MechanismFinding& finding : check_mechanism(mechanism)) {
    if (finding.checkable) std::cerr << to_string(mechanism, finding) << '\n';
  }
}

void print_warnings(const ClaimsFile& claims, const CommonOptions& common) {
  std::set<const Mechanism*> told;
  for (const Setting& setting : claims.settings) {
    if (told.insert(setting.mechanism.get()).second) print_warnings(*setting.mechanism, common);
  }
}

}  // namespace slipproof::cli
