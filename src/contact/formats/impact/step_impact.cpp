#include "contact/formats/impact/step_impact.hpp"

#include <algorithm>

#include "base/number/binary64.hpp"
#include "contact/formats/problem_file.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

std::vector<Rational> velocities_before(const ProblemFile& problem) {
  const std::vector<Rational> before = to_rationals(problem.impact->before);
  if (problem.form != ProblemForm::global) return before;
  std::vector<Rational> u = to_rationals(problem.w);
  for (std::size_t i = 0; i < problem.H.rows; ++i) {
    for (std::size_t k = problem.H.starts[i]; k < problem.H.starts[i + 1]; ++k) {
      u[problem.H.column[k]] += to_rational(problem.H.value[k]) * before[i];
    }
  }
  return u;
}

std::vector<Rational> restored_velocities(const ProblemFile& problem) {
  const StepImpact& impact = *problem.impact;
  std::vector<Rational> u = velocities_before(problem);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const std::size_t contact = i / problem.dimension;
    const bool normal = i % problem.dimension == 0;
    if (normal && impact.law == ImpactLaw::newton && u[i].sign() > 0) u[i] = 0;
    const bool none = !normal && impact.tangential_restitution.empty();
    u[i] *= none ? Rational(0) : to_rational((normal ? impact.restitution : impact.tangential_restitution)[contact]);
  }
  return u;
}

double rounding_of_restored(const ProblemFile& problem) {
  if (!problem.impact) return 0;
  const std::vector<double>& constants = problem.form == ProblemForm::global ? problem.w : problem.q;
  const std::vector<Rational> restored = restored_velocities(problem);
  Rational largest;
  for (std::size_t i = 0; i < restored.size(); ++i) {
    const double constant = constants[i] + (problem.bias.empty() ? 0 : problem.bias[i]);
    const Rational sum = to_rational(constant + nearest_binary64(restored[i]));
    largest = std::max(largest, Rational(abs(sum - to_rational(constant) - restored[i])));
  }
  return nearest_binary64(largest);
}

}  // namespace slipproof
