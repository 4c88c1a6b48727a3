#include "contact/rest/rest_proof.hpp"

#include <algorithm>

namespace slipproof {

namespace {

/// At least factor times the length of the vector.
bool is_at_least(const Rational& x, const Rational& factor, const std::vector<Rational>& vector) {
  if (x.sign() < 0) return false;
  Rational square;
  for (const Rational& part : vector) square += part * part;
  return x * x >= factor * factor * square;
}

}  // namespace

Rational power_along(const VirtualMotion& motion, const RestPush& push) {
  Rational power;
  for (std::size_t i = 0; i < push.f.size(); ++i) power += motion.rates[i] * push.f[i];
  for (std::size_t l = 0; l < push.limits.size(); ++l) power -= motion.rubbing[l] * push.limits[l];
  return power;
}

bool holds(const RestProblem& problem, const RestPush& push, const std::vector<Rational>& forces) {
  std::vector<Rational> sum = push.f;
  std::vector<bool> may_act(forces.size());
  for (const std::size_t force : problem.free) may_act[force] = true;
  for (const RestProblem::Contact& contact : problem.contacts) {
    may_act[contact.normal] = true;
    std::vector<Rational> tangent;
    for (const std::size_t force : contact.tangents) {
      may_act[force] = true;
      tangent.push_back(forces[force]);
    }
    const Rational most = contact.mu * forces[contact.normal];
    if (forces[contact.normal].sign() < 0 || !is_at_least(most, 1, tangent)) return false;
  }
  for (std::size_t l = 0; l < problem.limits.size(); ++l) {
    const RestProblem::Limit& limit = problem.limits[l];
    may_act[limit.force] = true;
    Rational most = push.limits[l];
    for (const auto& [force, value] : limit.terms) most += value * forces[force];
    if (most < abs(forces[limit.force])) return false;
  }
  for (std::size_t j = 0; j < forces.size(); ++j) {
    if (forces[j].is_zero()) continue;
    if (!may_act[j]) return false;
    for (const auto& [row, value] : problem.along[j]) sum[row] += value * forces[j];
  }
  return std::ranges::all_of(sum, &Rational::is_zero);
}

std::optional<VirtualMotion> virtual_motion(const RestProblem& problem, const RestPush& push,
                                            const std::vector<Rational>& multipliers) {
  VirtualMotion motion;
  Rational largest;
  const std::size_t rows = problem.rows.size();
  for (std::size_t i = 0; i < rows; ++i) largest = std::max(largest, abs(multipliers[i]));
  for (std::size_t l = 0; largest.is_zero() && l < problem.limits.size(); ++l) largest = abs(multipliers[rows + l]);
  if (largest.is_zero()) return std::nullopt;
  for (std::size_t i = 0; i < rows; ++i) motion.rates.push_back(-multipliers[i] / largest);
  std::vector<Rational> rates;  // along each force, less what the limits that it raises can take
  for (std::size_t j = 0; j < problem.along.size(); ++j) rates.push_back(problem.rate_along(j, motion.rates));
  for (std::size_t l = 0; l < problem.limits.size(); ++l) {
    const RestProblem::Limit& limit = problem.limits[l];
    const Rational rubbing = -2 * multipliers[rows + l] / largest;
    if (rubbing < abs(rates[limit.force])) return std::nullopt;
    motion.opens_or_resists = motion.opens_or_resists || rubbing.sign() > 0;
    for (const auto& [force, value] : limit.terms) rates[force] -= rubbing * value;
    motion.rubbing.push_back(rubbing);
  }
  for (const std::size_t force : problem.free) {
    if (!rates[force].is_zero()) return std::nullopt;
  }
  for (const RestProblem::Contact& contact : problem.contacts) {
    std::vector<Rational> slip;
    for (const std::size_t force : contact.tangents) slip.push_back(rates[force]);
    const Rational& opening = rates[contact.normal];
    if (!is_at_least(opening, contact.mu, slip)) return std::nullopt;
    motion.opens_or_resists = motion.opens_or_resists || opening.sign() > 0;
  }
  motion.power = power_along(motion, push);
  return motion;
}

}  // namespace slipproof
