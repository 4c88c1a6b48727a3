#include "contact/space/search_space.hpp"

#include <algorithm>

#include "base/input/diagnostic.hpp"
#include "contact/space/solve_space.hpp"
#include "contact/space/space_problem.hpp"
#include "mechanics/impact/impact.hpp"
#include "mechanics/mechanism/forms.hpp"

namespace slipproof {

namespace {

constexpr Work sample_effort = 2'000'000'000;

MotionCount count_of(const SolvedSpace& solved) {
  const auto exist = std::ranges::count_if(solved.motions, &SpaceMotion::exists);
  if (std::ranges::any_of(solved.motions, &SpaceMotion::is_continuum)) return MotionCount::continuum;
  if (exist > 1) return MotionCount::several;
  if (!solved.complete() || static_cast<std::size_t>(exist) < solved.motions.size()) return MotionCount::undecided;
  return exist == 1 ? MotionCount::one : MotionCount::none;
}

/// Of an impact: only an outcome that exists gains energy for certain.
EnergyBalance balance_of(const SolvedSpace& solved, const ImpactEnergy& energy) {
  EnergyBalance result = energy.is_driven() ? EnergyBalance::not_judged : EnergyBalance::not_gained;
  for (const SpaceMotion& motion : solved.motions) {
    const Range after = energy.of(motion.is_continuum() ? motion.all_accelerations : motion.accelerations);
    const EnergyBalance balance = energy.balance(after);
    const bool unsure = balance == EnergyBalance::gained && !motion.exists;
    result = std::max(result, unsure ? EnergyBalance::undecided : balance);
  }
  if (!solved.complete() && !energy.is_driven()) result = std::max(result, EnergyBalance::undecided);
  return result;
}

}  // namespace

Mechanism mechanism_to_search(Mechanism mechanism, SearchOptions& options) {
  if (mechanism.dimension == 3) {
    refuse_poisson_in_space(mechanism);
    mechanism = without_load(mechanism);
    options.in_space = found_in_space;
  }
  return mechanism.impact ? with_approach(std::move(mechanism)) : mechanism;
}

FoundMotions found_in_space(const Mechanism& mechanism, const MechanismValues& values) {
  CompleteOptions options;
  options.effort = sample_effort;
  SolvedSpace solved;
  try {
    solved = solve_space(MechanismScene{mechanism.name, mechanism, values, std::nullopt, {}}, options);
  } catch (const InputError& error) {
    throw NoValue(error.what());
  }
  FoundMotions found;
  found.count = count_of(solved);
  for (const SpaceMotion& motion : solved.motions) {
    found.in_space.push_back((motion.is_continuum() ? "a continuum beside " : "") + mode_of(motion));
  }
  std::ranges::sort(found.in_space);
  if (mechanism.impact) {
    found.energy = balance_of(solved, ImpactEnergy(mechanism, ProblemMaker(mechanism), values, std::nullopt));
  }
  return found;
}

}  // namespace slipproof
