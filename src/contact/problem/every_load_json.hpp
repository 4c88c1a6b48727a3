// The result about every q in JSON documents and lines.
#pragma once

#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "contact/problem/every_load.hpp"

namespace slipproof {

/// {"verdict", "by"}, and of `not unique` {"mode", "determinant"}; `mode` is the name of that mode.
inline Json to_json(const EveryLoad& every, const std::string& mode) {
  Json object{{"verdict", name(every.verdict)}, {"by", name(every.reason)}};
  if (every.mode) object["mode"] = mode, object["determinant"] = exact_text(every.determinant);
  return object;
}

}  // namespace slipproof
