// What the contacts of a scene imply for every q, that is, whatever else pushes the bodies.
#pragma once

#include <optional>
#include <string>

#include "contact/problem/every_load.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

/// A clause: `one motion whatever else pushes it, by the mode determinants`.
std::string in_words(const EveryLoad& every);
/// The same as a line of its own; empty if the theorem does not apply to such contacts.
std::string every_load_line(const std::optional<EveryLoad>& every);
/// null if the theorem does not apply to such contacts.
Json every_load_json(const std::optional<EveryLoad>& every);

}  // namespace slipproof
