// How many claims have which verdict, as a bar.
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
  VerdictCounts printed{}, repaired{};
  std::size_t claims = 0;
};
VerdictTotals count_verdicts(const VerifyResult& result);

/// What a bar is cut into.
struct BarPart {
  std::string css_class;
  std::size_t count = 0;
};
/// A bar cut in proportion to its counts, nothing for one that is 0; not read out, so its numbers must stand beside it.
void add_bar(const Element& parent, const std::vector<BarPart>& parts, double width, double height);

/// One bar cut in proportion to its counts, with its numbers written out below; nothing where there are none.
void add_verdict_bar(const Element& parent, std::string_view label, const VerdictCounts& counts);

}  // namespace slipproof
