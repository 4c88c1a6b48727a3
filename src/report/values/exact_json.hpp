// Exact values as JSON: rationals are strings, an infinite end is null.
#pragma once

#include "base/number/affine.hpp"
#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "mechanics/elements/force_interval.hpp"

namespace slipproof {

inline Json to_json(const Rational& x) {
  return exact_text(x);
}
/// [alpha, beta].
inline Json to_json(const Affine<Rational>& x) {
  return Json::array({exact_text(x.alpha), exact_text(x.beta)});
}
inline Json to_json(const std::optional<Rational>& x) {
  return x ? Json(exact_text(*x)) : Json(nullptr);
}

/// Adds the ends of a nonempty interval under `key`, and under "closed" which of them belong to it.
inline void put_interval(Json& object, const char* key, const ForceInterval& interval) {
  object[key] = Json::array({to_json(interval.lower()), to_json(interval.upper())});
  object["closed"] = Json::array({interval.lower_closed(), interval.upper_closed()});
}

/// The document in the form of all outputs.
inline std::string dump(const Json& document) {
  return json_text(document, 2) + '\n';
}

}  // namespace slipproof
