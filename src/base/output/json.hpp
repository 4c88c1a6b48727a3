// JSON that slipproof writes: members stand in the order in which they were put.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof {

using Json = nlohmann::ordered_json;

/// JSON on one line, or indented by `indent` spaces a level. Replaces invalid UTF-8.
std::string json_text(const Json& json, int indent = -1);

/// The members of an object or the elements of an array, without the enclosing brackets.
std::string inner_json_text(const Json& json);

/// A list of numbers as texts, `["3/4", ...]`.
Json exact_texts(const std::vector<Rational>& values);

}  // namespace slipproof
