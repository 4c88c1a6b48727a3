#include "certify/judge.hpp"

#include <bit>
#include <cmath>

#include "certify/exact_judge.hpp"
#include "filter/bounded_motion.hpp"
#include "filter/vector_clones.hpp"

namespace slipproof {

namespace {

/// Upper bound on the relative error of the answer against the motion of a mode; infinite where that is not known.
template <class N>
double largest_error(const ReducedDynamics<N, N>& dynamics, ContactMode mode, const Record& r, double weight) {
  constexpr double up = 1 + 8 * unit_roundoff;
  const ReducedMotion<N, N> motion(dynamics, mode);
  double worst = 0;
  for (std::size_t i = 0; i < answer_count; ++i) {
    const auto field = static_cast<Field>(parameter_count + i);
    if (!r.has(field)) continue;
    const double z = r[field];
    const Bounded x = bounded(motion.quantity(answer_quantities[i]));
    const double distance = (std::fabs(z - x.value) * up + x.error) * up + 2 * unit_roundoff * std::fabs(z);
    const double size = std::fabs(x.value) - x.error;
    if (size > 0) {
      worst = std::max(worst, distance / size * up);
    } else {
      const bool lifted = mode[i == 5 || i == 7 ? Wheel::rear : Wheel::front] == ContactState::lift;
      const bool exactly_zero = i >= 5 ? lifted : (i == 1 || i == 2) && mode.on_road();
      if (!exactly_zero) return HUGE_VAL;
      const double scale = i >= 5 ? weight : i == 1 ? r[Field::g] : r[Field::g] / r[Field::R];
      worst = std::max(worst, std::fabs(z) / scale * (1 + 16 * unit_roundoff));
    }
  }
  return worst;
}

/// The one mode of the scene, and a bound on the answer's error in it; no modes where that is not certain.
struct Verified {
  std::uint16_t modes = 0;
  double error = 0;
};

/// `dynamics` are those of the tier.
template <class N>
Verified verify_answer(const ReducedDynamics<N, N>& dynamics, const Record& r, const ForcedScene<double>& s) {
  const ModeSets sets = decide_modes(dynamics, s.bicycle.J.has_value());
  if (sets.undecided != 0 || std::popcount(sets.consistent) != 1) return {};
  const ContactMode mode = all_modes()[static_cast<std::size_t>(std::countr_zero(sets.consistent))];
  if (r.mode && *r.mode != mode) return {};
  return {sets.consistent, largest_error(dynamics, mode, r, s.bicycle.M * s.road.g)};
}

SLIPPROOF_VECTOR_CLONES("avx2")
SLIPPROOF_FLATTEN Verified verify_by_filter(const Record& r, const ForcedScene<double>& s) {
  return verify_answer(tracked_dynamics<Tracked>(s), r, s);
}

Verified verify_by_double_double(const Record& r, const ForcedScene<double>& s) {
  return verify_answer(tracked_dynamics<TrackedDouble2>(s), r, s);
}

}  // namespace

std::string_view name(RecordVerdict verdict) {
  constexpr std::array<std::string_view, record_verdict_count> names{"certified", "ambiguous", "inaccurate",
                                                                     "wrong",     "invalid",   "undecided"};
  return names[static_cast<std::size_t>(verdict)];
}

RecordJudgement judge(const Record& record, const JudgeOptions& options) {
  if (const std::string reason = outside_domain(record); !reason.empty()) return invalid_judgement(reason);
  const auto rounded = rounded_scene(record);
  if (rounded && within_input_limit(*rounded)) {
    Verified found = verify_by_filter(record, *rounded);
    Tier tier = Tier::filter;
    const auto certified = [&] { return found.modes != 0 && found.error <= options.tolerance; };
    if (!certified() && record.is_exact() && !record.has(Field::h0)) {
      found = verify_by_double_double(record, *rounded);
      tier = Tier::double_double;
    }
    if (certified()) return {RecordVerdict::certified, tier, found.modes, 1, false, found.error, false, {}, {}};
  }
  return judge_exactly(record, options);
}

RecordJudgement judge(const ForcedScene<double>& scene, const SolverOutput& output, const JudgeOptions& options) {
  return judge(to_record(scene, output), options);
}

RecordJudgement judge(const ForcedScene<Rational>& scene, const SolverOutput& output, const JudgeOptions& options) {
  return judge(to_record(scene, output), options);
}

}  // namespace slipproof
