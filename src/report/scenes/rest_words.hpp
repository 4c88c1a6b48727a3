// Parts of the report on a scene at rest: numbers, virtual motions, maps of two loads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/rest/rest_answer.hpp"
#include "report/document/document.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

/// A short number exactly, a longer one as a decimal.
std::string brief(const Rational& x, int digits);
Json named_json(const std::vector<std::string>& names, const std::vector<Rational>& values);
Json virtual_motion_json(const RestProblem& problem, const std::optional<VirtualMotion>& motion);
/// `toe slips, heel opens`.
std::string contact_words(const RestProblem& problem, const VirtualMotion& motion);

/// `X + 1/2 Y <= 5`: where nothing is proved against rest.
std::string border_text(const RestMap& map, const RestMap::Border& border, int digits);
/// Corners, borders and what is left open, in a section.
void write_rest_map(Document& section, const RestAnswer& answer, int digits);
/// The part `map` of slipproof/rest/1.
Json rest_map_json(const RestAnswer& answer);

}  // namespace slipproof
