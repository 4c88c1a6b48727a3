#include "claims/uniqueness/ranges.hpp"

#include <algorithm>
#include <tuple>

namespace slipproof {

namespace {

/// The result for every q, without the value of the determinant.
auto said_of_every_q(const MotionsAtParameter& motions) {
  using Said = std::tuple<EveryLoad::Verdict, EveryLoad::Reason, std::optional<ProblemMode>, int>;
  const auto& every = motions.for_every_q;
  return every ? std::optional(Said(every->verdict, every->reason, every->mode, every->determinant.sign()))
               : std::nullopt;
}

bool alike(const MotionsAtParameter& x, const MotionsAtParameter& y) {
  return std::ranges::equal(x.apart, y.apart, &LoadsApart::is_like) && said_of_every_q(x) == said_of_every_q(y);
}

}  // namespace

std::vector<ParameterRange> ranges(const UniquenessAlong& along) {
  std::vector<ParameterRange> result;
  bool joins = false;            // whether the last range extends to this cell
  std::vector<RealRoot> unseen;  // irrational values since the last cell that was examined
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
    if (joins && alike(result.back().motions, *cell.motions)) {
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
