// Conditions of a domain over numbers whose signs may be unsure, at one point or at several side by side.
#pragma once

#include <vector>

#include "floating/tape/mode_programs.hpp"
#include "floating/tape/running_error.hpp"

namespace slipproof {

/// Bits of points at which a condition surely holds, and at which it surely does not. Aligned as RunningError is.
template <class Mask>
struct YesNo {
  alignas(sizeof(Mask)) Mask yes{};
  alignas(sizeof(Mask)) Mask no{};
};

/// compared(step) says whether the difference of a step has its relation to 0; `all` are the bits of all points.
template <class Mask, class Compared>
YesNo<Mask> truth_of(const TruthProgram& program, const Mask& all, const Compared& compared) {
  std::vector<YesNo<Mask>> found;
  for (const auto& step : program.steps) {
    switch (step.operation) {
      case Operation::truth:
        found.push_back(step.truth ? YesNo<Mask>{all, {}} : YesNo<Mask>{{}, all});
        break;
      case Operation::logical_not:
        found.push_back({found[step.first].no, found[step.first].yes});
        break;
      case Operation::logical_and:
        found.push_back({found[step.first].yes & found[step.second].yes, found[step.first].no | found[step.second].no});
        break;
      case Operation::logical_or:
        found.push_back({found[step.first].yes | found[step.second].yes, found[step.first].no & found[step.second].no});
        break;
      default:
        found.push_back(compared(step));
    }
  }
  return found.back();
}

/// What a relation to 0 says: positive(x), not_negative(x) and not_zero(x), zero(x) are the bits of what is sure.
template <class Mask, class N, class Signs>
YesNo<Mask> related_to_zero(Relation relation, const N& x, const Signs& signs) {
  switch (relation) {
    case Relation::less:
      return {signs.positive(-x), signs.not_negative(x)};
    case Relation::less_equal:
      return {signs.not_negative(-x), signs.positive(x)};
    case Relation::greater:
      return {signs.positive(x), signs.not_negative(-x)};
    case Relation::greater_equal:
      return {signs.not_negative(x), signs.positive(-x)};
    case Relation::equal:
      return {signs.zero(x), signs.not_zero(x)};
    default:
      return {signs.not_zero(x), signs.zero(x)};
  }
}

struct LaneSigns {
  LaneBits positive(const RunningError& x) const { return surely_positive(x); }
  LaneBits not_negative(const RunningError& x) const { return surely_not_negative(x); }
  LaneBits zero(const RunningError& x) const { return surely_zero(x); }
  LaneBits not_zero(const RunningError& x) const { return surely_not_zero(x); }
};

}  // namespace slipproof
