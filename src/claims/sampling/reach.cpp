#include "claims/sampling/reach.hpp"

namespace slipproof {

namespace {

void keep_common(std::vector<ForceInterval>& parts, const ForceInterval& forces) {
  for (ForceInterval& part : parts) part.intersect(forces);
}

}  // namespace

std::vector<ForceInterval> reach(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                 SolvedSample& sample) {
  const Claim& c = file.claims[claim];
  const Setting& setting = file.settings[c.setting];
  const ClaimBody& body = c.printed;
  const CompiledBody& programs = compiled.claims[claim].printed;
  if (!sample.force_domain()) return {};
  const Truth inside = body.parameter.empty()
                           ? sample.region(programs.region)
                           : sample.eventually(programs.region, setting.parameter_index(body.parameter));
  if (inside != Truth::yes) return {};
  if (!body.kind->forces_say_where()) return {*sample.force_domain()};
  auto where = sample.true_at(programs.forces);
  if (!where.valued()) return {};
  for (const MechanismMode& mode : body.kind->moving(body)) {
    if (const auto s = sample.motions().find(mode)) keep_common(where.parts, sample.forces_of(*s, setting.strict));
  }
  std::erase_if(where.parts, [](const ForceInterval& forces) { return forces.empty(); });
  return where.parts;
}

}  // namespace slipproof
