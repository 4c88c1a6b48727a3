// What a scene's contacts have to say of every q: whatever else pushes the bodies.
#pragma once

#include <optional>
#include <string>

#include "contact/problem/every_load.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

/// A clause: `one motion whatever else pushes it, by the mode determinants`.
std::string in_words(const EveryLoad& every);
/// The same as a line of its own; empty where the theorem is not about such contacts.
std::string every_load_line(const std::optional<EveryLoad>& every);
/// null where the theorem is not about such contacts.
Json every_load_json(const std::optional<EveryLoad>& every);

}  // namespace slipproof
