#include "verify/reach.hpp"

#include <algorithm>
#include <utility>

namespace slipproof {

namespace {

void keep_common(std::vector<ForceInterval>& parts, const ForceInterval& forces) {
  for (ForceInterval& part : parts) part.intersect(forces);
}

}  // namespace

std::vector<ForceInterval> reach(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                 SolvedSample& sample) {
  const Claim& c = file.claims[claim];
  const CompiledBody& programs = compiled.claims[claim].printed;
  if (!sample.force_domain()) return {};
  Truth inside = Truth::yes;
  if (c.kind == ClaimKind::limit) {
    inside = sample.eventually(programs.region, file.settings[c.setting].parameter_index(c.printed.parameter));
  } else if (c.kind != ClaimKind::cover) {
    inside = sample.region(programs.region);
  }
  if (inside != Truth::yes) return {};
  const bool some_forces = c.kind == ClaimKind::impossible || c.kind == ClaimKind::formula ||
                           c.kind == ClaimKind::motions || c.kind == ClaimKind::unique || c.kind == ClaimKind::exists;
  if (!some_forces) return {*sample.force_domain()};
  auto parts = sample.true_at(programs.forces);
  if (!parts) return {};
  const bool strict = file.settings[c.setting].strict;
  const auto& modes = c.printed.modes;
  if (c.kind == ClaimKind::exists || (c.kind == ClaimKind::formula && modes.size() == 1)) {
    for (const ContactMode mode : modes) {
      if (const ModeSolution* s = sample.table().find(mode)) keep_common(*parts, sample.forces_of(*s, strict));
    }
  }
  std::erase_if(*parts, [](const ForceInterval& forces) { return forces.empty(); });
  return *parts;
}

}  // namespace slipproof
