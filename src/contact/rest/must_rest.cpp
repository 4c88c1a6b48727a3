#include <algorithm>

#include "base/algebra/union_find.hpp"
#include "base/input/diagnostic.hpp"
#include "contact/problem/solutions.hpp"
#include "contact/rest/rest.hpp"
#include "contact/space/solve_space.hpp"
#include "mechanics/points/problem.hpp"
#include "mechanics/scene/solve_mechanism.hpp"

namespace slipproof {

namespace {

/// Whether every motion has kinetic energy: a . M a > 0, in blocks of unknowns that M connects.
bool has_inertia(const MechanismScene& scene) {
  const Mechanism& m = scene.mechanism;
  if (!m.by_virtual_work) return false;
  const ProblemMaker maker(m);
  Evaluator<Rational> at = maker.at(scene.values);
  std::vector<SparseVector> rows(m.accelerations);
  UnionFind blocks(m.accelerations);
  for (std::size_t i = 0; i < m.accelerations; ++i) {
    for (const auto& [j, program] : maker.compiled().equations[i].terms) {
      if (j >= m.accelerations) continue;
      const auto value = at.number(program);
      if (!value.number) return false;
      rows[i].emplace_back(j, *value.number);
      blocks.join(i, j);
    }
  }
  std::vector<std::vector<std::size_t>> members(m.accelerations);
  for (std::size_t i = 0; i < m.accelerations; ++i) members[blocks.find(i)].push_back(i);
  constexpr std::size_t largest_block = 60;
  for (const std::vector<std::size_t>& block : members) {
    if (block.size() > largest_block) return false;
    RationalMatrix part(block.size(), std::vector<Rational>(block.size()));
    for (std::size_t i = 0; i < block.size(); ++i) {
      for (const auto& [j, value] : rows[block[i]])
        part[i][static_cast<std::size_t>(std::ranges::find(block, j) - block.begin())] = value;
    }
    if (!block.empty() && !positive_definite(part)) return false;
  }
  return true;
}

/// Whether forces without friction hold it. Then, with accelerations a, openings u_N and forces r of any motion and
/// those forces n: a . M a = a . f + r . u = (r - n) . u <= 0, since a contact that pushes does not open, friction does
/// not push along a slip, and n, u_N >= 0.
bool normal_forces_hold(const RestProblem& problem, const RestPush& push, Effort& effort, std::size_t& programs) {
  RestProblem smooth = problem;
  for (RestProblem::Contact& contact : smooth.contacts) contact.tangents.clear();
  smooth.limits.clear();
  RestPush pushed = push;
  pushed.limits.clear();
  RestSolver solver(smooth, effort);
  const bool can = solver.decide(pushed).can == true;
  programs += solver.programs();
  return can;
}

bool is_rest(const std::vector<Rational>& accelerations) {
  return std::ranges::all_of(accelerations, &Rational::is_zero);
}

bool may_be_rest(const Range& range) {
  return (!range.lower || range.lower->sign() <= 0) && (!range.upper || range.upper->sign() >= 0);
}
bool is_zero(const Range& range) {
  return range.is_point() && range.lower->is_zero();
}

MustRest by_all_motions_in_plane(const MechanismScene& scene) {
  constexpr double most_modes = 1e8;
  MustRest result;
  const std::vector<ElementKind> kinds = element_kinds(scene.mechanism, scene.values.starts, scene.values.given);
  if (mode_count(kinds) > most_modes) {
    result.because = "there are too many contacts to find all motions";
    return result;
  }
  try {
    result.plane = std::make_shared<SolvedMechanism>(solve_mechanism(scene));
  } catch (const InputError& error) {
    result.because = "its motions were not found";
    return result;
  }
  const MotionsAtLoad& found = *result.plane->at_load;
  const bool moves =
      std::ranges::any_of(found.motions, [](const MotionAtLoad& m) { return !is_rest(m.accelerations); });
  if (moves || !found.continua.empty()) {
    result.must = false;
    result.because = "there is another motion";
  } else if (std::ranges::any_of(kinds, [](const ElementKind& kind) { return !kind.bilateral && !kind.lifts; })) {
    result.because = "the lift of a contact is not modelled";
  } else {
    result.must = true;
    result.because = "no other motion exists in any mode";
  }
  return result;
}

MustRest by_all_motions_in_space(const MechanismScene& scene, Effort& effort) {
  constexpr std::size_t most_contacts = 12;
  MustRest result;
  if (scene.mechanism.contacts.size() > most_contacts) {
    result.because = "there are too many contacts to find all motions";
    return result;
  }
  CompleteOptions options;
  constexpr Work most_effort = 2'000'000'000;  // a few seconds: what takes longer seldom ends
  options.effort = std::min(most_effort, effort.left());
  try {
    result.space = std::make_shared<SolvedSpace>(solve_space(scene, options));
  } catch (const InputError&) {
    result.because = "its motions were not found";
    return result;
  } catch (const std::runtime_error&) {
    result.because = "this build is without Clp";
    return result;
  }
  bool all_rest = true, moves = false;
  for (const SpaceMotion& motion : result.space->motions) {
    const bool rests =
        std::ranges::all_of(motion.accelerations, is_zero) && !motion.others_within && !motion.is_continuum();
    all_rest = all_rest && rests;
    moves = moves || (motion.exists && !std::ranges::all_of(motion.accelerations, may_be_rest));
  }
  if (moves) {
    result.must = false;
    result.because = "there is another motion";
  } else if (all_rest && result.space->complete()) {
    result.must = true;
    result.because = "all motions were found, and there is no other";
  } else {
    result.because = "it is open whether there are other motions";
  }
  return result;
}

}  // namespace

MustRest must_rest(const MechanismScene& scene, const RestProblem& problem, const RestPush& push,
                   const RestDecision& decision, Effort& effort, std::size_t& programs) {
  if (!decision.can) return {std::nullopt, "it is open whether it can rest", nullptr, nullptr};
  if (!*decision.can) return {false, "it cannot rest", nullptr, nullptr};
  if (problem.only_links_are_free && has_inertia(scene) && normal_forces_hold(problem, push, effort, programs)) {
    return {true, "normal forces alone hold it: another motion would gain power from nothing", nullptr, nullptr};
  }
  return scene.mechanism.dimension == 2 ? by_all_motions_in_plane(scene) : by_all_motions_in_space(scene, effort);
}

}  // namespace slipproof
