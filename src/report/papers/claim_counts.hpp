// How many claims have which verdict, counted by whose claims they are.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "claims/verify/verify.hpp"

namespace slipproof {

struct ClaimCounts {
  std::size_t judged = 0, proved = 0, held = 0, refuted = 0;  ///< `held` does not include the proved claims
  std::vector<std::string> undecided, vacuous;                ///< ids

  std::size_t open() const { return undecided.size() + vacuous.size(); }
  void add(const ClaimCounts& other);
};

struct CountsByOrigin {
  ClaimCounts printed, ours;

  ClaimCounts& operator[](Origin origin) { return origin == Origin::printed ? printed : ours; }
  const ClaimCounts& operator[](Origin origin) const { return origin == Origin::printed ? printed : ours; }
  ClaimCounts all() const;
};

/// Counts each claim once, in its first reading.
CountsByOrigin count_claims(const ClaimsFile& file, const VerifyResult& result);

/// `8 claims as printed, 17 of our own`.
std::string claims_text(std::size_t printed, std::size_t ours);
/// How many were judged, hold, are refuted and are open. Whole sentences; empty if none was judged.
std::string counts_text(const CountsByOrigin& counts);

}  // namespace slipproof
