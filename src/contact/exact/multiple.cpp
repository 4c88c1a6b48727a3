#include "contact/exact/multiple.hpp"

#include <algorithm>
#include <utility>

#include "base/algebra/linear_program.hpp"
#include "base/number/binary64.hpp"
#include "contact/problem/solutions.hpp"

namespace slipproof {

namespace {

/// Two different points: some point, and one from which it differs in a coordinate by up to 1.
std::vector<std::vector<Rational>> two_points(const ContactContinuum& continuum, Effort& effort) {
  const std::size_t m = continuum.directions.size();
  const AffineForm nothing{0, std::vector<Rational>(m)};
  const std::vector<Rational> first = minimize(nothing, continuum.conditions, effort).x;
  for (std::size_t i = 0; i < m; ++i) {
    for (const int side : {1, -1}) {
      AffineForm back = nothing, near = nothing;
      back.coefficients[i] = -side;
      near.constant = 1 + side * first[i];
      near.coefficients[i] = -side;
      std::vector<AffineForm> conditions = continuum.conditions;
      conditions.push_back(near);
      const std::vector<Rational> second = minimize(back, conditions, effort).x;
      if (second[i] != first[i]) return {continuum.at(first), continuum.at(second)};
    }
  }
  return {};
}

SolutionCount counted(const ContactSolutions& found, const std::vector<Rational>& z, Effort& effort) {
  using Kind = SolutionCount::Kind;
  SolutionCount result;
  for (const ContactSolution& solution : found.solutions) result.solutions.push_back(solution.z);
  if (!found.continua.empty()) {
    const auto add = [&](std::vector<Rational> point) {
      auto& all = result.solutions;
      if (std::find(all.begin(), all.end(), point) == all.end()) all.push_back(std::move(point));
    };
    for (auto& point : two_points(found.continua.front(), effort)) add(std::move(point));
    for (const ContactContinuum& c : found.continua) {
      if (!z.empty()) add(c.nearest(z, effort));
    }
    result.kind = result.solutions.size() >= 2 ? Kind::continuum : Kind::unknown;
  } else {
    result.kind = found.solutions.empty() ? Kind::none : found.one() ? Kind::one : Kind::several;
  }
  return result;
}

}  // namespace

SolutionCount count_solutions(const MixedProblem& problem, Effort& effort, std::span<const double> answer) {
  const bool is_planar = problem.dimension == 1 || problem.dimension == 2;
  const std::size_t components = problem.size() - problem.free;
  if (!is_planar || components > max_problem_size || problem.free > max_eliminated) return {};
  if (problem.size() == 0) return {SolutionCount::Kind::one, {{}}};
  try {
    effort.spend(times(times(problem.free, problem.free), times(problem.free, 8)));
    const auto small = eliminated(problem);
    if (!small || components == 0) return {};
    const ContactSolver solver(small->problem);
    const auto found = solver.all(effort);
    if (!found) return {};
    std::vector<Rational> z;
    for (const double r : answer.subspan(answer.empty() ? 0 : problem.free)) z.push_back(to_rational(r));
    SolutionCount result = counted(*found, z, effort);
    for (auto& solution : result.solutions) solution = small->with_free(std::move(solution));
    return result;
  } catch (const TooMuchWork&) {
  }
  return {};
}

}  // namespace slipproof
