#include "claims/lines/claim_lines.hpp"

#include <algorithm>
#include <utility>

#include "base/expression/logic.hpp"
#include "claims/sampling/sampler.hpp"
#include "mechanics/lines/critical.hpp"

namespace slipproof {

std::optional<ClaimLines> claim_lines(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                      Reading reading) {
  ClaimLines lines{parts_of(file, compiled, claim, reading), {}};
  if (lines.parts.too_many_modes) return std::nullopt;
  std::vector<const Program*> programs = lines.parts.conditions;
  programs.insert(programs.end(), lines.parts.of_motions.begin(), lines.parts.of_motions.end());
  lines.matters = parameters_of(compiled.settings[file.claims[claim].setting], programs,
                                lines.parts.modes.empty() ? Beside::nothing : Beside::the_scene);
  if (std::find(lines.matters.begin(), lines.matters.end(), true) == lines.matters.end()) return std::nullopt;
  return lines;
}

std::vector<bool> on_surface(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
                             const std::vector<bool>& matters) {
  const Claim& c = file.claims[claim];
  const CompiledSetting& setting = compiled.settings[c.setting];
  std::vector<bool> result = matters;
  for (const Expression& e : conjuncts({c.body(reading).region})) {
    if (e->operation != Operation::compare || e->relations.front() != Relation::equal) continue;
    const Program equation = setting.compile(e, reading);
    const std::vector<bool> tied = parameters_of(setting, {&equation}, Beside::nothing);
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = result[k] && !tied[k];
  }
  return result;
}

std::size_t visit_line(const Line& line, const CompiledSetting& compiled, const ClaimParts& parts,
                       const std::function<bool(SolvedSample&)>& visit) {
  const LinePoints points = points_on(line, compiled, parts);
  for (const Rational& t : points.values) {
    const auto sample = SolvedSample::in_domain(compiled, line.at(t));
    if (!sample) continue;
    if (!parts.modes.empty()) sample->only_modes(parts.modes);
    if (!visit(*sample)) break;
  }
  return points.cells();
}

}  // namespace slipproof
