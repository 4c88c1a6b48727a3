#include "contact/impact/solve_impact.hpp"

#include <algorithm>

#include "base/input/diagnostic.hpp"
#include "base/output/listed.hpp"
#include "contact/impact/poisson_in_space.hpp"
#include "contact/judge/all_solutions.hpp"
#include "contact/space/solve_space.hpp"
#include "mechanics/impact/impact_energy.hpp"
#include "mechanics/scene/solve_mechanism.hpp"

namespace slipproof {

namespace {

[[noreturn]] void refuse(const Mechanism& mechanism, const std::string& message) {
  throw InputError({{mechanism.file, 0, 0, message}});
}

/// Of each contact, before.
void add_contacts(const ProblemMaker& maker, SolvedImpact& result) {
  const Mechanism& mechanism = result.scene.mechanism;
  Evaluator<Rational> at = maker.at(result.scene.values);
  if (result.scene.load) at.set(maker.compiled().load(), *result.scene.load);
  const auto number = [&](const Expression& expression) -> Rational {  // 0 for null
    if (!expression) return 0;
    auto value = at.number(maker.compiled().compile(expression));
    if (!value.number) throw NoValue("a velocity before the impact has no value: it divides by zero");
    return std::move(*value.number);
  };
  for (const MechanismImpact::Contact& contact : mechanism.impact->contacts) {
    result.contacts.push_back({contact.opening != nullptr, number(contact.opening), number(contact.sliding),
                               number(contact.second), number(contact.restored), number(contact.slip_restored),
                               number(contact.second_restored)});
  }
}

/// All that is known before the outcomes.
ImpactEnergy fill(SolvedImpact& result) {
  const MechanismScene& scene = result.scene;
  const Mechanism& mechanism = scene.mechanism;
  if (mechanism.load && !scene.load)
    refuse(mechanism, "found no value of " + mechanism.load->symbol + ", expected one");
  try {
    const ProblemMaker maker(mechanism);
    add_contacts(maker, result);
    ImpactEnergy energy(mechanism, maker, scene.values, scene.load);
    result.velocities = energy.velocities();
    result.energy = energy.before();
    result.driven = energy.is_driven();
    return energy;
  } catch (const NoValue& none) {
    refuse(mechanism, none.what());
  }
}

template <class Values>
std::vector<std::optional<Range>> optional_ranges(const Values& ranges) {
  return {ranges.begin(), ranges.end()};
}

void add_modes(ImpactOutcome& outcome, const std::vector<MechanismMode>& modes) {
  for (const MechanismMode& mode : modes) outcome.modes.push_back(name(mode));
}

void add_outcomes(const MotionsAtLoad& found, std::vector<ImpactOutcome>& outcomes) {
  for (const MotionAtLoad& motion : found.motions) {
    ImpactOutcome outcome;
    add_modes(outcome, motion.modes);
    add_modes(outcome, motion.boundary_modes);
    outcome.strict = motion.strict();
    outcome.motion = points(motion.accelerations);
    outcome.impulses = optional_ranges(motion.forces);
    outcomes.push_back(std::move(outcome));
  }
  for (const ContinuumAtLoad& continuum : found.continua) {
    ImpactOutcome outcome;
    add_modes(outcome, {continuum.mode});
    outcome.strict = continuum.strict;
    outcome.continuum = true;
    outcome.unique = false;
    outcome.motion = continuum.accelerations;
    outcome.impulses = optional_ranges(continuum.forces);
    outcomes.push_back(std::move(outcome));
  }
}

void add_outcomes(const SolvedSpace& found, std::vector<ImpactOutcome>& outcomes) {
  for (const SpaceMotion& motion : found.motions) {
    ImpactOutcome outcome;
    outcome.modes = {mode_of(motion)};
    outcome.strict = motion.strict;
    outcome.exists = motion.exists;
    outcome.unique = motion.unique;
    outcome.continuum = motion.is_continuum();
    outcome.motion = outcome.continuum ? motion.all_accelerations : motion.accelerations;
    outcome.impulses = motion.forces;
    outcomes.push_back(std::move(outcome));
  }
}

void refuse_without_approach(const SolvedImpact& impact) {
  const auto approaches = [](const SolvedImpact::Contact& contact) {
    return contact.closed && contact.opening.sign() < 0;
  };
  if (std::ranges::any_of(impact.contacts, approaches)) return;
  refuse(impact.scene.mechanism,
         "found no contact that approaches, expected one: velocities of bodies (velocity, spin, or rates in [state]) "
         "with which a gap closes");
}

}  // namespace

SolvedImpact solve_impact(MechanismScene scene) {
  SolvedImpact result;
  result.scene = std::move(scene);
  const Mechanism& mechanism = result.scene.mechanism;
  if (!mechanism.impact) refuse(mechanism, "found a scene without an impact, expected bodies, read with a law");
  const ImpactEnergy energy = fill(result);
  refuse_without_approach(result);
  if (mechanism.dimension == 3 && mechanism.impact->law == ImpactLaw::poisson) {
    PoissonInSpace found = solve_poisson_in_space(result.scene);
    result.space = std::move(found.space);
    result.undecided = result.space->undecided;
    add_outcomes(*result.space, result.outcomes);
    for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
      result.outcomes[i].modes.front() += " after " + listed(found.compression[i], "/");
    }
  } else if (mechanism.dimension == 3) {
    result.space = solve_space(result.scene);
    result.undecided = result.space->undecided;
    add_outcomes(*result.space, result.outcomes);
  } else {
    result.plane = solve_mechanism(result.scene);
    add_outcomes(*result.plane->at_load, result.outcomes);
  }
  for (ImpactOutcome& outcome : result.outcomes) {
    outcome.energy = energy.of(outcome.motion);
    const EnergyBalance balance = energy.balance(outcome.energy);
    if (balance == EnergyBalance::gained) outcome.gains = true;
    if (balance == EnergyBalance::not_gained) outcome.gains = false;
  }
  return result;
}

}  // namespace slipproof
