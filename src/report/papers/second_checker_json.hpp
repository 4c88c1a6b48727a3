// A second checker in JSON documents.
#pragma once

#include "claims/verify/certificates.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

inline Json to_json(const SecondChecker& checker) {
  return {{"name", checker.name}, {"accepted", checker.accepted}};
}

}  // namespace slipproof
