#include "certify/judge.hpp"

#include <bit>
#include <cmath>

#include "certify/exact_judge.hpp"
#include "filter/bounded_motion.hpp"

namespace slipproof {

namespace {

constexpr std::array<Quantity, answer_count> quantities{Quantity::a,    Quantity::a_y,  Quantity::phi,
                                                        Quantity::eps2, Quantity::eps3, Quantity::S2,
                                                        Quantity::S3,   Quantity::N2,   Quantity::N3};

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
    const Bounded x = bounded(motion.quantity(quantities[i]));
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

/// Certifies, or says nothing. `dynamics` are those of the tier.
template <class N>
bool certify(const ReducedDynamics<N, N>& dynamics, Tier tier, const Record& r, const ForcedScene<double>& s,
             const JudgeOptions& options, RecordJudgement& result) {
  const ModeSets sets = decide_modes(dynamics, s.bicycle.J.has_value());
  if (sets.undecided != 0 || std::popcount(sets.consistent) != 1) return false;
  const ContactMode mode = all_modes()[static_cast<std::size_t>(std::countr_zero(sets.consistent))];
  if (r.mode && *r.mode != mode) return false;
  const double error = largest_error(dynamics, mode, r, s.bicycle.M * s.road.g);
  if (!(error <= options.tolerance)) return false;
  result = {RecordVerdict::certified, tier, sets.consistent, 1, false, error, false, {}, {}};
  return true;
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
  RecordJudgement result;
  if (rounded && within_input_limit(*rounded)) {
    if (certify(tracked_dynamics<Tracked>(*rounded), Tier::filter, record, *rounded, options, result)) return result;
    if (record.is_exact() && !record.has(Field::h0) &&
        certify(tracked_dynamics<TrackedDouble2>(*rounded), Tier::double_double, record, *rounded, options, result)) {
      return result;
    }
  }
  return judge_exactly(record, options);
}

}  // namespace slipproof
