#include "contact/space/search_space.hpp"

#include <algorithm>

#include "base/input/diagnostic.hpp"
#include "contact/space/solve_space.hpp"

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

}  // namespace

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
  return found;
}

}  // namespace slipproof
