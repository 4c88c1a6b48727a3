// A second checker in JSON documents.
#pragma once

#include "verify/certificates.hpp"
#include "wording/exact_json.hpp"

namespace slipproof {

inline Json to_json(const SecondChecker& checker) {
  return {{"name", checker.name}, {"accepted", checker.accepted}};
}

}  // namespace slipproof
