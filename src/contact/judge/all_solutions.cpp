#include "contact/judge/all_solutions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"

namespace slipproof {

bool AllSolutions::one() const {
  return complete() && solutions.size() == 1 && !solutions[0].is_family() && solutions[0].exists && solutions[0].alone;
}

std::string AllSolutions::open_words() const {
  constexpr std::size_t shown = 60;
  std::string first = unexamined.front();
  if (first.size() > shown) first = first.substr(0, shown) + "...";
  std::string text =
      fmt::format("found {}, and {} {} open, the first {}", solutions.size(), counted(unexamined.size(), "pattern"),
                  unexamined.size() == 1 ? "stays" : "stay", first);
  return open_speed ? text + fmt::format("; there no velocity is above {}", at_most(*open_speed)) : text;
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
