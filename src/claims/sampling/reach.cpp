#include "claims/sampling/reach.hpp"

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
  if (const auto* limit = std::get_if<Limit>(&c.printed.says)) {
    inside = sample.eventually(programs.region, file.settings[c.setting].parameter_index(limit->parameter));
  } else {
    inside = sample.region(programs.region);
  }
  if (inside != Truth::yes) return {};
  const auto all = [&] { return std::vector{*sample.force_domain()}; };
  const auto some = [&](const Modes& moving) {
    auto where = sample.true_at(programs.forces);
    if (!where.valued()) where.parts.clear();
    const bool strict = file.settings[c.setting].strict;
    for (const MechanismMode& mode : moving) {
      if (const auto s = sample.motions().find(mode)) keep_common(where.parts, sample.forces_of(*s, strict));
    }
    std::erase_if(where.parts, [](const ForceInterval& forces) { return forces.empty(); });
    return where.parts;
  };
  return std::visit(Cases{[&](const Formula& f) { return some(f.modes.size() == 1 ? f.modes : Modes{}); },
                          [&](const Exists& e) { return some(e.modes); }, [&](const Impossible&) { return some({}); },
                          [&](const ForceCover&) { return some({}); }, [&](const Motions&) { return some({}); },
                          [&](const Unique&) { return some({}); }, [&](const Interval&) { return all(); },
                          [&](const Cover&) { return all(); }, [&](const Equivalence&) { return all(); },
                          [&](const Limit&) { return all(); }, [&](const Consequence&) { return all(); },
                          [&](const System&) { return all(); }},
                    c.printed.says);
}

}  // namespace slipproof
