#include "uniqueness/ranges.hpp"

#include <algorithm>

namespace slipproof {

namespace {

bool same_kind(const MotionsAtParameter& x, const MotionsAtParameter& y) {
  const auto alike = [](const LoadsApart& a, const LoadsApart& b) {
    return a.motions == b.motions && a.continuum == b.continuum;
  };
  const auto verdict = [](const MotionsAtParameter& m) {
    return m.for_every_q ? std::optional(m.for_every_q->verdict) : std::nullopt;
  };
  return std::equal(x.apart.begin(), x.apart.end(), y.apart.begin(), y.apart.end(), alike) && verdict(x) == verdict(y);
}

}  // namespace

std::vector<ParameterRange> ranges(const UniquenessAlong& along) {
  std::vector<ParameterRange> result;
  bool joins = false;            // whether the last range reaches this cell
  std::vector<RealRoot> unseen;  // since the last cell that was looked at
  for (const ParameterCell& cell : along.cells) {
    if (!cell.sample && !cell.motions) {
      unseen.push_back(*cell.lower);
      continue;
    }
    if (!cell.motions) {
      joins = false;
      unseen.clear();
      continue;
    }
    if (joins && same_kind(result.back().motions, *cell.motions)) {
      ParameterRange& range = result.back();
      range.upper = cell.upper;
      range.upper_closed = cell.is_point();
      range.unseen.insert(range.unseen.end(), unseen.begin(), unseen.end());
    } else {
      result.push_back({cell.lower, cell.upper, cell.is_point(), cell.is_point(), *cell.sample, *cell.motions, unseen});
    }
    joins = true;
    unseen.clear();
  }
  return result;
}

}  // namespace slipproof
