#include "records/certify/judge.hpp"

#include <bit>

#include "floating/filter/vector_kernel.hpp"
#include "records/certify/answer_error.hpp"
#include "records/certify/exact_judge.hpp"

namespace slipproof {

namespace {

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
  return {sets.consistent, largest_error<double>(
                               dynamics, mode, r.present, [&](Field f) { return r[f]; },
                               zero_scales<double>(s, [](double x) { return x; }))};
}

Verified verify_by_filter(const Record& r, const ForcedScene<double>& s) {
  return in_registers_of_four([&] { return verify_answer(tracked_dynamics<Tracked>(s), r, s); });
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
  return judged_or_undecided([&] { return judge_exactly(record, options); });
}

RecordJudgement judge(const ForcedScene<double>& scene, const SolverOutput& output, const JudgeOptions& options) {
  return judge(to_record(scene, output), options);
}

RecordJudgement judge(const ForcedScene<Rational>& scene, const SolverOutput& output, const JudgeOptions& options) {
  return judge(to_record(scene, output), options);
}

}  // namespace slipproof
