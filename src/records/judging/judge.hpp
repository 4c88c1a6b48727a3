// The verdict on one output of a solver: is it the one motion of its scene, the one solution of its problem?
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel/failure.hpp"
#include "contact/problem/solutions.hpp"
#include "floating/batch/mechanism_batch.hpp"

namespace slipproof {

enum class RecordVerdict : std::uint8_t {
  certified,   ///< the answer is the one motion, within the tolerance
  ambiguous,   ///< it is one of several motions
  inaccurate,  ///< it is the right motion, with an error above the tolerance
  wrong,       ///< no motion is near the answer
  invalid,     ///< NaN, infinity, outside the domain, or not a record
  undecided    ///< the verdict would take more work than the effort allows
};
inline constexpr std::size_t record_verdict_count = 6;
std::string_view name(RecordVerdict verdict);

struct JudgeOptions {
  /// Largest relative error of a component, as contact/problem/yardstick.hpp defines it.
  double tolerance = 1e-9;
  /// An answer counts as a badly computed motion if each component is within this of the motion's, relative to the
  /// yardstick of its kind if that is larger. Beyond this the answer is wrong.
  double near = 1e-2;
  /// The work allowed for one record; beyond it the verdict is undecided.
  Work effort = ContactSolver::default_effort;
  /// For contact problems: also decide whether there is exactly one solution for every q. This depends on W and mu
  /// only, so one record of a system suffices. It takes once or twice the time of the verdict.
  bool every_q = false;
};

/// The verdict on a record, with the facts that support it.
struct RecordJudgement {
  RecordVerdict verdict = RecordVerdict::invalid;
  Tier tier = Tier::exact;
  std::vector<std::uint16_t> modes =
      {};                       ///< modes of the motion that the answer is, as numbers among the fields' modes
  std::string mode_names = {};  ///< the same modes, or those of a contact problem, as JSON texts without the brackets
  std::size_t motions = 0;      ///< number of motions of the scene
  bool counted = true;          ///< whether they were looked for
  bool continuum = false;       ///< there are also infinitely many others
  bool others_excluded = true;  ///< for a certified answer: it is proved that there is no other motion
  /// Upper bound on the largest relative error of a component, if certified, ambiguous or inaccurate.
  double max_error = 0;
  /// Upper bound on Distance::scaled to the nearest motion, of a wrong answer, too; nothing where none is known, or
  /// where binary64 was sure of the record.
  std::optional<double> distance = std::nullopt;
  bool contact_problem = false;
  bool eps_solution = false;  ///< among the inaccurate ones: nothing stronger is proved of a contact problem's answer
  std::string details = {};   ///< further JSON members, `,"violated":...`; empty for a certified record
  /// For a contact problem with rho: bound on the distance from the answer to a solution, in each component.
  double rho = 0;
  std::string members = {};  ///< all JSON members after the record's number, if not the default ones

  /// Adds a mode of the motion.
  void add_mode(std::uint16_t mode, std::string_view name);
};

RecordJudgement invalid_judgement(const std::string& reason);
RecordJudgement undecided_judgement(const std::string& reason);

/// Returns the result of `judge`. If it fails, the record is undecided, with the reason, and the others are still
/// judged.
template <class Judge>
RecordJudgement judged_or_undecided(const Judge& judge) {
  RecordJudgement result;
  const std::string failure = failure_of([&] { result = judge(); });
  if (!failure.empty()) result = undecided_judgement(failure);
  return result;
}

/// `needed`: the work that the verdict would take; infinite if unknown.
std::string too_much_work(Work needed, Work effort);

}  // namespace slipproof
