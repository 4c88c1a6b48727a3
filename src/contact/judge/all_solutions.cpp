#include "contact/judge/all_solutions.hpp"

#include <algorithm>

namespace slipproof {

bool AllSolutions::one() const {
  return complete() && solutions.size() == 1 && !solutions[0].is_family() && solutions[0].exists && solutions[0].alone;
}

bool AllSolutions::several_motions() const {
  return solutions.size() > 1 || std::ranges::any_of(solutions, [](const auto& s) { return !s.others.empty(); });
}

bool AllSolutions::are_points() const {
  return std::ranges::all_of(solutions, [](const auto& s) { return s.alone && !s.is_family(); });
}

std::size_t AllSolutions::families() const {
  return static_cast<std::size_t>(std::ranges::count_if(solutions, &FoundSolution::is_family));
}

ContactVerdict AllSolutions::verdict(const FoundSolution* meant) const {
  if (none()) return ContactVerdict::no_solution;
  if (meant == nullptr) return complete() ? ContactVerdict::wrong : ContactVerdict::undecided;
  if (!meant->exists) return ContactVerdict::undecided;
  if (one()) return ContactVerdict::unique;
  const bool several = families() > 0 || std::ranges::count_if(solutions, &FoundSolution::exists) > 1;
  return several ? ContactVerdict::ambiguous : ContactVerdict::solution_within_rho;
}

std::vector<Range> points(const std::vector<Rational>& values) {
  std::vector<Range> result;
  for (const Rational& value : values) result.push_back({value, value});
  return result;
}

std::vector<Rational> values_of(const std::vector<Range>& points) {
  std::vector<Rational> result;
  for (const Range& point : points) result.push_back(point.lower.value());
  return result;
}

}  // namespace slipproof
