// The result about every q in JSON documents and lines.
#pragma once

#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "contact/problem/every_load.hpp"

namespace slipproof {

/// {"verdict", "by"}; of `not unique` {"mode", "determinant"}, or {"modes", "q"} by pairs, and by pairs
/// {"undetermined"}; `mode` and `other` are the names of the modes.
inline Json to_json(const EveryLoad& every, const std::string& mode, const std::string& other = {}) {
  Json object{{"verdict", name(every.verdict)}, {"by", name(every.reason)}};
  if (every.other) {
    object["modes"] = {mode, other};
    object["q"] = Json::array();
    for (const Rational& x : every.q) object["q"].push_back(exact_text(x));
  } else if (every.mode) {
    object["mode"] = mode, object["determinant"] = exact_text(every.determinant);
  }
  if (every.undetermined != 0) object["undetermined"] = every.undetermined;
  return object;
}

}  // namespace slipproof
