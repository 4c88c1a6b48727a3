#include "floating/filter/filter.hpp"

#include "base/number/binary64.hpp"
#include "floating/filter/vector_kernel.hpp"

namespace slipproof {

namespace {

bool decided(const ModeSets& sets) {
  return sets.undecided == 0;
}

ConsistentModes by_tier(const ModeSets& sets, Tier tier) {
  return {sets.consistent, sets.consistent, tier};
}

}  // namespace

std::string_view name(Tier tier) {
  switch (tier) {
    case Tier::filter:
      return "filter";
    case Tier::double_double:
      return "double-double";
    case Tier::exact:
      break;
  }
  return "exact";
}

ForcedScene<double> nearest_binary64(const ForcedScene<Rational>& scene) {
  return convert<Rational, double>(scene, [](const Rational& x) { return nearest_binary64(x); });
}

ModeSets filter_modes(const ForcedScene<double>& scene) {
  return in_registers_of_four([&] {
    if (!within_input_limit(scene)) return all_undecided;
    return decide_modes(tracked_dynamics<Tracked>(scene), scene.bicycle.J.has_value());
  });
}

ModeSets double_double_modes(const ForcedScene<double>& exact) {
  if (!within_input_limit(exact)) return all_undecided;
  return decide_modes(tracked_dynamics<TrackedDouble2>(exact), exact.bicycle.J.has_value());
}

ModeSets double_double_modes(const ForcedScene<Rational>& exact, const ForcedScene<double>& rounded) {
  if (!within_input_limit(rounded)) return all_undecided;
  return decide_modes(tracked_dynamics<TrackedDouble2>(exact), exact.bicycle.J.has_value());
}

ConsistentModes exact_modes(const ForcedScene<Rational>& scene) {
  const ModeTable table(scene.bicycle, scene.road, scene.force_kind);
  ConsistentModes result{0, 0, Tier::exact};
  for (const ModeSolution& s : table.solutions()) {
    const auto bit = 1U << s.mode().index();
    if (s.closed().contains(scene.F)) result.consistent = static_cast<std::uint16_t>(result.consistent | bit);
    if (s.strict().contains(scene.F)) result.strict = static_cast<std::uint16_t>(result.strict | bit);
  }
  return result;
}

ConsistentModes consistent_modes(const ForcedScene<double>& exact) {
  if (const ModeSets sets = filter_modes(exact); decided(sets)) return by_tier(sets, Tier::filter);
  if (const ModeSets sets = double_double_modes(exact); decided(sets)) return by_tier(sets, Tier::double_double);
  return exact_modes(to_rational(exact));
}

ConsistentModes consistent_modes(const ForcedScene<Rational>& exact) {
  const ForcedScene<double> rounded = nearest_binary64(exact);
  if (const ModeSets sets = filter_modes(rounded); decided(sets)) return by_tier(sets, Tier::filter);
  if (const ModeSets sets = double_double_modes(exact, rounded); decided(sets)) {
    return by_tier(sets, Tier::double_double);
  }
  return exact_modes(exact);
}

}  // namespace slipproof
