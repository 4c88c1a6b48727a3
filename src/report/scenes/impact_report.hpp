// The report on an impact: all outcomes, as text and as `slipproof/impact/1`.
#pragma once

#include <string>

#include "base/output/json.hpp"
#include "contact/impact/solved_impact.hpp"
#include "report/document/document.hpp"

namespace slipproof {

Document impact_document(const SolvedImpact& solved, int digits);
/// The document slipproof/impact/1.
Json impact_value(const SolvedImpact& solved);
std::string impact_json(const SolvedImpact& solved);

/// Whether an outcome gains energy: `GAINS 37.5 % of the energy`, `loses at least 12 % of the energy`.
std::string energy_words(const SolvedImpact& solved, const ImpactOutcome& outcome);

/// A range as JSON: a fraction where it is a point, otherwise [lower, upper].
Json range_value(const Range& range);

}  // namespace slipproof
