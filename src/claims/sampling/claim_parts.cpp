#include "claims/sampling/claim_parts.hpp"

namespace slipproof {

namespace {

void append(std::vector<const Program*>& list, const std::vector<Program>& programs) {
  for (const Program& program : programs) list.push_back(&program);
}

}  // namespace

ClaimParts parts_of(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading) {
  const Claim& c = file.claims[claim];
  const Setting& setting = file.settings[c.setting];
  const ClaimKind::Traits& kind = c.kind().traits();
  const ClaimBody& body = c.body(reading);
  const CompiledBody& programs = compiled.claims[claim].body(reading);
  ClaimParts parts;
  parts.conditions = {&programs.region, &programs.forces};
  parts.modes = body.modes;
  (parts.modes.empty() ? parts.conditions : parts.of_motions).push_back(&programs.holds);
  if (kind.of_all_motions) {
    const auto kinds = setting.kinds();
    parts.too_many_modes = mode_count(kinds) > max_line_modes;
    if (!parts.too_many_modes) parts.modes = modes_of(kinds);
  }
  // Boundary motions count in closed settings, where a motion may be in several modes.
  using Compares = ClaimKind::Traits::Compares;
  parts.modes_meet = kind.compares_modes == Compares::always ||
                     (kind.compares_modes == Compares::in_closed_settings && !setting.strict);
  if (!body.parameter.empty()) parts.grows = setting.parameter_index(body.parameter);
  for (const std::size_t other : body.references()) {
    const CompiledBody& referred = compiled.claims[other].body(reading);
    if (c.kind().is_linear()) {
      append(parts.equations, referred.equations);
    } else {
      parts.conditions.push_back(&referred.region);
      if (c.kind().has("forces")) parts.conditions.push_back(&referred.forces);
    }
  }
  append(parts.equations, programs.equations);
  append(parts.equations, programs.assume);
  parts.model_equations = c.kind().is_linear() && body.from_model();
  return parts;
}

}  // namespace slipproof
