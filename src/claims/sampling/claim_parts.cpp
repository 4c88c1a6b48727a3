#include "claims/sampling/claim_parts.hpp"

#include <algorithm>

namespace slipproof {

namespace {

void append(std::vector<const Program*>& list, const std::vector<Program>& programs) {
  for (const Program& program : programs) list.push_back(&program);
}

}  // namespace

ClaimParts parts_of(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading) {
  const Claim& c = file.claims[claim];
  const ClaimBody& body = c.body(reading);
  const CompiledBody& programs = compiled.claims[claim].body(reading);
  ClaimParts parts;
  const LinearEquations* linear = std::get_if<Consequence>(&body.says);
  if (linear == nullptr) linear = std::get_if<System>(&body.says);
  parts.conditions = {&programs.region, &programs.forces};
  parts.modes = modes(body.says);
  (c.is<Formula>() && !parts.modes.empty() ? parts.of_motions : parts.conditions).push_back(&programs.holds);
  if (c.is<Motions>() || c.is<Unique>()) {
    const auto kinds = file.settings[c.setting].kinds();
    parts.too_many_modes = mode_count(kinds) > max_line_modes;
    if (!parts.too_many_modes) parts.modes = modes_of(kinds);
  }
  // Boundary motions count in closed settings, and a motion may be in several modes there.
  const bool closed = !file.settings[c.setting].strict;
  parts.modes_meet = c.is<Unique>() || c.is<Exists>() || (c.is<Motions>() && closed);
  if (const auto* limit = std::get_if<Limit>(&body.says)) {
    parts.grows = file.settings[c.setting].parameter_index(limit->parameter);
  }
  for (const std::size_t other : references(body.says)) {
    const CompiledBody& referred = compiled.claims[other].body(reading);
    if (linear != nullptr) {
      append(parts.equations, referred.equations);
    } else {
      parts.conditions.push_back(&referred.region);
      if (!c.is<Cover>()) parts.conditions.push_back(&referred.forces);
    }
  }
  append(parts.equations, programs.equations);
  append(parts.equations, programs.assume);
  parts.model_equations = linear != nullptr && linear->from_model();
  return parts;
}

std::vector<std::size_t> slots_behind(const Scope& scope, const std::vector<const Program*>& programs) {
  std::vector<std::size_t> found;
  std::vector<const Program*> open = programs;
  while (!open.empty()) {
    const Program* program = open.back();
    open.pop_back();
    for (const std::size_t slot : program->slots()) {
      if (std::find(found.begin(), found.end(), slot) != found.end()) continue;
      found.push_back(slot);
      if (scope.slots[slot].definition) open.push_back(&*scope.slots[slot].definition);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace slipproof
