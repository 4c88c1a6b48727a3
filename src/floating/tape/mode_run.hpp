// Decides the modes of a mechanism at several points side by side, in binary64: consistent, not consistent, or unsure.
// An answer other than unsure is always correct.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "floating/tape/linear_mode.hpp"
#include "floating/tape/mode_code.hpp"

namespace slipproof {

/// The answers about one mode at the points of a run, one mask for each answer. Aligned as RunningError is.
struct LaneModes {
  alignas(sizeof(LaneBits)) LaneBits inconsistent{};
  alignas(sizeof(LaneBits)) LaneBits boundary{};  ///< consistent, and surely not strict
  alignas(sizeof(LaneBits)) LaneBits strict{};    ///< a point in none of these masks is unsure
  alignas(sizeof(LaneBits)) LaneBits valid{};     ///< the mode's programs are valid there
};

/// constant + slopes . t for a mode, at several points.
struct LaneForm {
  RunningError constant;
  std::array<RunningError, LinearMode<RunningError>::most_free> slopes;

  RunningError at(std::span<const RunningError> free) const;
};

/// One block of points. Not shared between threads; used again for many blocks.
class ModeRun {
 public:
  /// The code must outlive the run.
  explicit ModeRun(const ModeCode& code);

  /// Sets an input of one of the points: `value` is exact if `exact`, otherwise the nearest binary64 of what is meant.
  void set(std::size_t input, std::size_t lane, double value, bool exact = true);
  /// Sets cosine and sine from tan(angle/2).
  void set_angle(std::size_t angle, std::size_t lane, double tan_half, bool exact = true);

  /// Decides every mode at every point. Takes one pass over the tape, without a branch on a value.
  void decide();
  /// Points that are surely in the domain, apart from the load's; surely have a load in its domain; and at which surely
  /// none of the file's divisors is 0.
  LaneBits in_domain() const { return in_domain_; }
  LaneBits in_load_domain() const { return in_load_domain_; }
  const std::vector<LaneModes>& modes() const { return modes_; }

  /// A mode that is surely strict and has the accelerations of every other mode that may be consistent, if it is also
  /// sure which of these modes are strict. Otherwise nothing.
  std::optional<std::size_t> only_motion(std::size_t lane) const;

  /// Accelerations, forces and conditions of a mode at all points; no decision is needed before.
  struct Values {
    std::vector<LaneForm> accelerations, forces, conditions;
  };
  const Values& compute_values(std::size_t mode);
  /// Computes the scales that zeros are compared with; at() then returns them. Call decide() or compute_values() first.
  void compute_scales();
  const RunningError& at(TapeRef ref) const { return results_[code_->place(ref)]; }

 private:
  friend struct JudgeKernel;
  friend struct ValuesKernel;

  void compute_angles();
  void find_domain();
  LaneBits holds(const TruthProgram& program) const;
  LaneModes judge(const ModeProgram& program, const LaneBits& valid) const;

  const ModeCode* code_;
  std::vector<RunningError> results_;
  std::vector<RunningError> tan_halves_;
  std::vector<LaneModes> modes_;
  std::vector<LaneForm> conditions_;  ///< of the mode being judged, with the sign of its divisor applied
  Values values_;
  alignas(sizeof(LaneBits)) LaneBits in_domain_{};
  alignas(sizeof(LaneBits)) LaneBits in_load_domain_{};
};

}  // namespace slipproof
