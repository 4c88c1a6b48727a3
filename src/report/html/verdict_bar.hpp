// A bar that shows how many claims have which verdict.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "claims/verify/verify.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

inline constexpr std::array<std::string_view, 5> claim_verdicts{"proved", "holds", "refuted", "undecided", "vacuous"};
using VerdictCounts = std::array<std::size_t, claim_verdicts.size()>;

struct VerdictTotals {
  VerdictCounts printed{}, ours{}, repaired{};

  void add(const VerdictTotals& other);
};
std::size_t sum(const VerdictCounts& counts);
VerdictTotals count_verdicts(const ClaimsFile& file, const VerifyResult& result);

/// A part of a bar.
struct BarPart {
  std::string css_class;
  std::size_t count = 0;
};
/// A bar divided in proportion to its counts, without parts for 0. It is not read aloud, so its numbers must be written
/// near it.
void add_bar(const Element& parent, const std::vector<BarPart>& parts, double width, double height);

/// A bar divided in proportion to its counts, with the numbers below it; nothing if all counts are 0.
void add_verdict_bar(const Element& parent, std::string_view label, const VerdictCounts& counts);

}  // namespace slipproof
