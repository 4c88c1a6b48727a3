// Judging one solver output: is it the one motion of its scene?
#pragma once

#include <string>

#include "contact/problem/solutions.hpp"
#include "contact/problem/yardstick.hpp"
#include "records/certify/record.hpp"

namespace slipproof {

enum class RecordVerdict : std::uint8_t {
  certified,   ///< the answer is the one motion, within the tolerance
  ambiguous,   ///< it is one of several motions
  inaccurate,  ///< the right motion, with an error above the tolerance
  wrong,       ///< no motion is near
  invalid,     ///< NaN, infinity, outside the domain, or no record at all
  undecided    ///< it would take more work than the effort allows
};
inline constexpr std::size_t record_verdict_count = 6;
std::string_view name(RecordVerdict verdict);

struct JudgeOptions {
  /// Largest relative error of a component, as contact/yardstick.hpp defines it.
  double tolerance = 1e-9;
  /// An answer of which each component is within this of a motion's, relative to the yardstick of its kind where that
  /// is larger, is that motion, computed badly; beyond it the answer is wrong.
  double near = 1e-2;
  /// What one record may take; beyond it the verdict is undecided.
  Work effort = ContactSolver::usual_effort;
  /// Of contact problems also whether there is one solution for every q. It depends on W and mu alone, so that many
  /// records of one system need not ask, and takes as long as the verdict, or twice.
  bool every_q = false;
};

/// What was found, and what the reader needs to see of it.
struct RecordJudgement {
  RecordVerdict verdict = RecordVerdict::invalid;
  Tier tier = Tier::exact;
  std::uint16_t modes = 0;  ///< of the motion that the answer is, bit i for the mode with index i
  std::size_t motions = 0;  ///< how many motions the scene has
  bool continuum = false;   ///< and infinitely many more
  double max_error = 0;  ///< upper bound on the largest relative error of a component; certified, ambiguous, inaccurate
  bool contact_problem = false;
  std::string mode_names;    ///< of a contact problem, in place of `modes`: a list of JSON texts without the brackets
  std::string details;       ///< further JSON members, `,"violated":...`; empty for a certified record
  double rho = 0;            ///< of a contact problem with rho: from the answer to a solution, in each component
  std::string members = {};  ///< all JSON members after the record's number, where they are other ones
};

/// The record is complete (see incomplete()).
RecordJudgement judge(const Record& record, const JudgeOptions& options = {});

/// The same for who calls the library: `judge(scene, {.a = 2, .S2 = 2, .S3 = 0, .N2 = 7, .N3 = 3}).verdict`.
RecordJudgement judge(const ForcedScene<double>& scene, const SolverOutput& output, const JudgeOptions& options = {});
RecordJudgement judge(const ForcedScene<Rational>& scene, const SolverOutput& output, const JudgeOptions& options = {});

}  // namespace slipproof
