#include "contact/impact/poisson_in_space.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "contact/judge/all_in_space.hpp"
#include "contact/space/from_contacts.hpp"
#include "contact/space/solve_space.hpp"
#include "contact/space/space_problem.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

namespace {

/// Of each contact of the problem.
std::vector<Rational> restitutions(const MechanismScene& scene, const SpaceProblem& problem) {
  const ProblemMaker maker(scene.mechanism);
  Evaluator<Rational> at = maker.at(scene.values);
  std::vector<Rational> result;
  for (const SpaceContact& contact : problem.contacts) {
    const auto& contacts = scene.mechanism.bodies->contacts;
    const auto found = std::ranges::find(contacts, contact.contact, &BodyContact::contact);
    if (found == contacts.end()) {  // a joint that can open
      result.emplace_back(0);
      continue;
    }
    auto value = at.number(maker.compiled().compile(found->restitution.expression));
    if (!value.number) throw InputError({{scene.mechanism.file, 0, 0, "a restitution divides by zero"}});
    result.push_back(std::move(*value.number));
  }
  return result;
}

class TwoPhases {
 public:
  TwoPhases(const ExactContacts& one, std::vector<Rational> restitution)
      : one_(one), restitution_(std::move(restitution)) {
    std::size_t next = 0;
    for (std::size_t k = 0; k < one.contacts(); ++k) {
      parts_.push_back({next++, {}, 0});
      if (one.has_friction(k) && !restitution_[k].is_zero()) parts_.back().given = next++;
      parts_.back().beyond = next++;
    }
    both_.q.resize(3 * next);
    both_.W.assign(3 * next, std::vector<Rational>(3 * next));
    both_.mu.resize(next);
    for (std::size_t k = 0; k < one.contacts(); ++k) add_contact(k);
  }

  const ExactContacts& problem() const { return both_; }

  /// As a solution of the problem of one phase: u = W r + q with the impulses of both.
  FoundSolution whole(const FoundSolution& found) const {
    FoundSolution result = found;
    result.states.clear(), result.r.clear(), result.u.clear(), result.around.clear(), result.others.clear();
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      result.states.push_back(found.states[parts_[k].beyond]);
      for (std::size_t t = 0; t < 3; ++t) {
        const auto weights = weights_of(k, t);
        std::vector<Rational> all(both_.size());
        for (const auto& [component, weight] : weights) all[component] = weight;
        result.r.push_back(weighted(all, found.r, 0));
        result.u.push_back(found.u[3 * parts_[k].beyond + t]);
        if (!found.around.empty()) result.around.push_back(found.around[3 * parts_[k].beyond + t]);
      }
    }
    for (const FoundSolution& other : found.others) result.others.push_back(whole(other));
    return result;
  }

  /// The same in compression: only the states matter.
  FoundSolution compression(const FoundSolution& found) const {
    FoundSolution result;
    for (const Parts& parts : parts_) {
      result.states.push_back(found.states[parts.compression]);
      for (std::size_t t = 0; t < 3; ++t) {
        result.r.push_back(found.r[3 * parts.compression + t]);
        result.u.push_back(found.u[3 * parts.compression + t]);
      }
    }
    return result;
  }

 private:
  /// Which contact of both phases is c, a and b of one.
  struct Parts {
    std::size_t compression;
    std::optional<std::size_t> given;
    std::size_t beyond;
  };

  /// A component of the whole impulse of a contact, as a sum over those of its parts.
  std::vector<std::pair<std::size_t, Rational>> weights_of(std::size_t contact, std::size_t t) const {
    const Parts& parts = parts_[contact];
    std::vector<std::pair<std::size_t, Rational>> result{{3 * parts.compression + t, 1}, {3 * parts.beyond + t, 1}};
    if (t == 0) result.front().second += restitution_[contact];
    if (t > 0 && parts.given) result.emplace_back(3 * *parts.given + t, 1);
    return result;
  }

  void add_contact(std::size_t k) {
    const Parts& parts = parts_[k];
    both_.mu[parts.compression] = both_.mu[parts.beyond] = one_.mu[k];
    for (std::size_t t = 0; t < 3; ++t) {
      add_row(3 * parts.compression + t, 3 * k + t, true);
      add_row(3 * parts.beyond + t, 3 * k + t, false);
      if (parts.given && t > 0) add_row(3 * *parts.given + t, 3 * k + t, false);
    }
    if (!parts.given) return;
    both_.mu[*parts.given] = one_.mu[k];
    const std::size_t gap = 3 * *parts.given;
    const Rational& own = one_.W[3 * k][3 * k];
    const Rational unit = own.is_zero() ? Rational(1) : own;  // as other gaps have it
    both_.W[gap][gap] = unit;
    both_.W[gap][3 * parts.compression] = -restitution_[k] * unit;
  }

  /// A velocity at the end of compression, or after both phases.
  void add_row(std::size_t row, std::size_t of, bool in_compression) {
    both_.q[row] = one_.q[of];
    for (std::size_t j = 0; j < parts_.size(); ++j) {
      for (std::size_t s = 0; s < 3; ++s) {
        const Rational& w = one_.W[of][3 * j + s];
        if (in_compression) {
          both_.W[row][3 * parts_[j].compression + s] = w;
          continue;
        }
        for (const auto& [component, weight] : weights_of(j, s)) both_.W[row][component] = weight * w;
      }
    }
  }

  const ExactContacts& one_;
  const std::vector<Rational> restitution_;
  std::vector<Parts> parts_;
  ExactContacts both_;
};

/// What one phase is: the mechanism of the impact, which restores nothing.
MechanismScene one_phase(MechanismScene scene) {
  scene.mechanism.impact->law = ImpactLaw::newton;
  return scene;
}

}  // namespace

PoissonInSpace solve_poisson_in_space(MechanismScene scene, const CompleteOptions& options) {
  const SpaceProblem problem = space_problem(one_phase(scene));
  const ReducedSpace free = reduced(problem, scene.mechanism);
  const TwoPhases phases(free.contacts, restitutions(scene, problem));
  const SolutionTree tree{all_solutions(phases.problem(), options), {}};
  AllSolutions all = all_solutions_of(tree), compression = all;
  for (FoundSolution& found : compression.solutions) found = phases.compression(found);
  for (FoundSolution& found : all.solutions) found = phases.whole(found);
  PoissonInSpace result{read_motions(scene, problem, free, all), {}};
  result.space.programs = tree.solutions.programs;
  for (SpaceMotion& motion : read_motions(std::move(scene), problem, free, compression).motions) {
    result.compression.push_back(std::move(motion.modes));
  }
  return result;
}

}  // namespace slipproof
