#include "contact/judge/all_solutions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"

namespace slipproof {

namespace {

bool have_same_velocities(const FoundSolution& a, const FoundSolution& b) {
  return std::ranges::equal(a.u, b.u, [](const Range& x, const Range& y) {
    return x.lower && x.lower == x.upper && y.lower == x.lower && y.upper == x.lower;
  });
}

}  // namespace

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
  if (dimension == 1 && families() > 0) return true;
  const FoundSolution* first = nullptr;
  for (const FoundSolution& s : solutions) {
    if (!s.others.empty() || s.moves) return true;
    if (!s.exists) continue;
    if (first != nullptr && (dimension == 1 || !have_same_velocities(*first, s))) return true;
    first = &s;
  }
  return false;
}

bool AllSolutions::one_motion() const {
  const auto moves_alone = [](const FoundSolution& s) { return s.exists && s.one_motion; };
  return complete() && !solutions.empty() && !several_motions() && std::ranges::all_of(solutions, moves_alone);
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
  return several_motions() ? ContactVerdict::ambiguous : ContactVerdict::solution_within_rho;
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
