#include "enclosure/multiple.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "contact/solutions.hpp"
#include "number/linear_program.hpp"

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

SolutionCount counted(const ContactSolutions& found, Effort& effort) {
  using Kind = SolutionCount::Kind;
  SolutionCount result;
  for (const ContactSolution& solution : found.solutions) result.solutions.push_back(solution.z);
  if (!found.continua.empty()) {
    auto points = two_points(found.continua.front(), effort);
    std::move(points.begin(), points.end(), std::back_inserter(result.solutions));
    result.kind = result.solutions.size() >= 2 ? Kind::continuum : Kind::unknown;
  } else {
    result.kind = found.solutions.empty() ? Kind::none : found.one() ? Kind::one : Kind::several;
  }
  return result;
}

}  // namespace

SolutionCount count_solutions(const MixedProblem& problem, Effort& effort) {
  const bool is_planar = problem.dimension == 1 || problem.dimension == 2;
  if (problem.free != 0 || !is_planar || problem.size() > max_problem_size) return {};
  if (problem.size() == 0) return {SolutionCount::Kind::one, {{}}};
  try {
    const ContactProblem small = contact_problem(problem);
    const ContactSolver solver(small);
    const auto found = solver.all(effort);
    if (found) return counted(*found, effort);
  } catch (const TooMuchWork&) {
  }
  return {};
}

}  // namespace slipproof
