// The result about every q in JSON documents and lines.
#pragma once

#include <nlohmann/json.hpp>

#include "base/number/format.hpp"
#include "contact/problem/every_load.hpp"

namespace slipproof {

/// {"verdict", "by"}, and of `not unique` {"mode", "determinant"}; `mode` is the name of that mode.
inline nlohmann::ordered_json to_json(const EveryLoad& every, const std::string& mode) {
  nlohmann::ordered_json object{{"verdict", name(every.verdict)}, {"by", name(every.reason)}};
  if (every.mode) object["mode"] = mode, object["determinant"] = exact_text(every.determinant);
  return object;
}

}  // namespace slipproof
