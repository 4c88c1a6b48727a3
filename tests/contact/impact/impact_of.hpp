// Impacts of shipped scenes and of texts, for tests.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact/impact/solve_impact.hpp"
#include "mechanics/reading/read_mechanism.hpp"

namespace slipproof::test {

using NamedValues = std::vector<std::pair<std::string, Rational>>;

/// Of a scene in cases/impact, with other values.
inline SolvedImpact impact(const std::string& name, ImpactLaw law, const NamedValues& values = {}) {
  const std::string file = SLIPPROOF_SOURCE_DIR "/cases/impact/" + name + ".toml";
  return solve_impact(with_values(read_scene(file, {Dimensions::any, ImpactRequest{law}}), values));
}

/// Of a mechanism in numbers.
inline SolvedImpact impact_of_text(const std::string& text, std::optional<ImpactLaw> law = {}) {
  const std::string head = "schema = \"slipproof/mechanism/1\"\nname = \"test\"\ngravity = \"none\"\n";
  return solve_impact(parse_scene(head + text, "test.toml", {Dimensions::any, ImpactRequest{law}}));
}

inline const Range& range_after(const SolvedImpact& solved, const ImpactOutcome& outcome, const std::string& name) {
  const auto names = acceleration_names(solved.scene.mechanism);
  const auto found = std::ranges::find(names, name);
  REQUIRE_MESSAGE(found != names.end(), name);
  return outcome.motion[static_cast<std::size_t>(found - names.begin())];
}

/// A velocity of the only outcome, which is known exactly.
inline Rational after(const SolvedImpact& solved, const std::string& name) {
  REQUIRE(solved.outcomes.size() == 1);
  const Range& range = range_after(solved, solved.outcomes.front(), name);
  REQUIRE(range.is_point());
  return *range.lower;
}

/// An impulse of the only outcome.
inline Rational impulse(const SolvedImpact& solved, const std::string& name) {
  REQUIRE(solved.outcomes.size() == 1);
  const auto names = force_names(solved.scene.mechanism);
  const auto found = std::ranges::find(names, name);
  REQUIRE_MESSAGE(found != names.end(), name);
  const auto& range = solved.outcomes.front().impulses[static_cast<std::size_t>(found - names.begin())];
  REQUIRE((range && range->is_point()));
  return *range->lower;
}

inline Rational energy_after(const SolvedImpact& solved) {
  REQUIRE(solved.outcomes.size() == 1);
  REQUIRE(solved.outcomes.front().energy.is_point());
  return *solved.outcomes.front().energy.lower;
}

}  // namespace slipproof::test
