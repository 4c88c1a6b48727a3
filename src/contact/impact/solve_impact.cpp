#include "contact/impact/solve_impact.hpp"

#include <algorithm>

#include "base/input/diagnostic.hpp"
#include "contact/judge/all_solutions.hpp"
#include "contact/space/solve_space.hpp"
#include "mechanics/scene/solve_mechanism.hpp"

namespace slipproof {

namespace {

[[noreturn]] void refuse(const Mechanism& mechanism, const std::string& message) {
  throw InputError({{mechanism.file, 0, 0, message}});
}

/// Numbers of the instant before, and the matrix of the kinetic energy.
class Before {
 public:
  explicit Before(const MechanismScene& scene) : m_(scene.mechanism), maker_(m_), at_(maker_.at(scene.values)) {
    if (m_.load && !scene.load) refuse(m_, "found no value of " + m_.load->symbol + ", expected one");
    if (scene.load) at_.set(maker_.compiled().load(), *scene.load);
  }

  void fill(SolvedImpact& result) {
    const MechanismImpact& impact = *m_.impact;
    for (const Expression& velocity : impact.velocities) result.velocities.push_back(number(velocity));
    for (const MechanismImpact::Contact& contact : impact.contacts) {
      result.contacts.push_back({contact.opening != nullptr, number(contact.opening), number(contact.sliding),
                                 number(contact.second), number(contact.restored), number(contact.slip_restored),
                                 number(contact.second_restored)});
    }
    result.driven =
        std::ranges::any_of(impact.prescribed, [&](const Expression& one) { return !number(one).is_zero(); });
    read_masses();
    result.energy = *energy(points(result.velocities)).lower;
  }

  /// Half of v M v. Exact for points; otherwise a range that holds it.
  Range energy(const std::vector<Range>& velocities) const {
    Range sum{Rational(0), Rational(0)};
    for (std::size_t i = 0; i < masses_.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const Rational factor = i == j ? Rational(masses_[i][i] / 2) : Rational((masses_[i][j] + masses_[j][i]) / 2);
        if (!factor.is_zero()) add(sum, factor, product(velocities[i], velocities[j], i == j));
      }
    }
    return sum;
  }

 private:
  /// 0 for null.
  Rational number(const Expression& expression) {
    if (!expression) return 0;
    auto value = at_.number(maker_.compiled().compile(expression));
    if (!value.number) refuse(m_, "a velocity before the impact has no value: it divides by zero");
    return std::move(*value.number);
  }

  void read_masses() {
    const std::size_t size = m_.impact->velocities.size();
    for (std::size_t i = 0; i < size; ++i) {
      auto row = coefficients(maker_.compiled().equations[i], at_, m_.unknowns.size());
      if (!row) refuse(m_, "the equation " + m_.equations[i].name + " has no value: it divides by zero");
      row->resize(size);
      masses_.push_back(std::move(*row));
    }
  }

  static Range product(const Range& x, const Range& y, bool square) {
    if (!x.lower || !x.upper || !y.lower || !y.upper) return {};
    std::vector<Rational> corners;
    for (const Rational& one : {*x.lower, *x.upper}) {
      for (const Rational& other : {*y.lower, *y.upper}) corners.push_back(one * other);
    }
    if (square) {
      corners = {*x.lower * *x.lower, *x.upper * *x.upper};
      if (x.lower->sign() < 0 && x.upper->sign() > 0) corners.emplace_back(0);
    }
    const auto [least, most] = std::ranges::minmax(corners);
    return {least, most};
  }

  static void add(Range& sum, const Rational& factor, Range term) {
    if (factor.sign() < 0) std::swap(term.lower, term.upper);
    const auto end = [&](std::optional<Rational>& to, const std::optional<Rational>& by) {
      to = to && by ? std::optional(Rational(*to + factor * *by)) : std::nullopt;
    };
    end(sum.lower, term.lower);
    end(sum.upper, term.upper);
  }

  const Mechanism& m_;
  const ProblemMaker maker_;
  Evaluator<Rational> at_;
  std::vector<std::vector<Rational>> masses_;
};

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
  Before before(result.scene);
  before.fill(result);
  refuse_without_approach(result);
  if (mechanism.dimension == 3) {
    result.space = solve_space(result.scene);
    result.undecided = result.space->undecided;
    add_outcomes(*result.space, result.outcomes);
  } else {
    result.plane = solve_mechanism(result.scene);
    add_outcomes(*result.plane->at_load, result.outcomes);
  }
  for (ImpactOutcome& outcome : result.outcomes) {
    outcome.energy = before.energy(outcome.motion);
    if (result.driven) continue;
    if (outcome.energy.lower && *outcome.energy.lower > result.energy) outcome.gains = true;
    if (outcome.energy.upper && *outcome.energy.upper <= result.energy) outcome.gains = false;
  }
  return result;
}

}  // namespace slipproof
