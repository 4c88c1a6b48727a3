// The modes of a mechanism at several points side by side, in binary64: consistent, not consistent, or unsure, and
// never wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "floating/tape/linear_mode.hpp"
#include "floating/tape/mode_code.hpp"

namespace slipproof {

/// A mode at the points of a run, a mask for each answer. Aligned as RunningError is.
struct LaneModes {
  alignas(sizeof(LaneBits)) LaneBits inconsistent{};
  alignas(sizeof(LaneBits)) LaneBits boundary{};  ///< consistent, and surely not strict
  alignas(sizeof(LaneBits)) LaneBits strict{};    ///< none of these: unsure
  alignas(sizeof(LaneBits)) LaneBits valid{};     ///< its programs mean what they say
};

/// constant + slopes . t, of a mode at several points.
struct LaneForm {
  RunningError constant;
  std::array<RunningError, LinearMode<RunningError>::most_free> slopes;

  RunningError at(std::span<const RunningError> free) const;
};

/// One block of points. Not shared between threads; made once for many blocks.
class ModeRun {
 public:
  /// The code must outlive the run.
  explicit ModeRun(const ModeCode& code);

  /// A number of one of the points: its nearest binary64, or itself if `exact`.
  void set(std::size_t input, std::size_t lane, double value, bool exact = true);
  /// Cosine and sine from tan(angle/2).
  void set_angle(std::size_t angle, std::size_t lane, double tan_half, bool exact = true);

  /// Decides every mode at every point. Takes one pass over the tape, without a branch on a value.
  void decide();
  /// Points in the domain, apart from the load's; points with a load in its domain; points at which all that the file
  /// divides by is not 0. Surely so.
  LaneBits in_domain() const { return in_domain_; }
  LaneBits in_load_domain() const { return in_load_domain_; }
  const std::vector<LaneModes>& modes() const { return modes_; }

  /// A mode that is surely strict and has the accelerations of all other modes that may be consistent; it is also sure
  /// which of them are strict. Nothing if that is not so, or not sure.
  std::optional<std::size_t> only_motion(std::size_t lane) const;

  /// Of modes among those that only_motion() speaks of.
  bool is_same_motion(std::size_t x, std::size_t y) const {
    return code_->programs().programs[x].motion == code_->programs().programs[y].motion;
  }

  /// Accelerations, forces and conditions of a mode at all points.
  struct Values {
    std::vector<LaneForm> accelerations, forces, conditions;
  };
  const Values& compute_values(std::size_t mode);
  /// What zeros are held against; then at() has it.
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
  std::vector<LaneForm> conditions_;  ///< of the mode that is judged, with the sign that a divisor gives them
  Values values_;
  alignas(sizeof(LaneBits)) LaneBits in_domain_{};
  alignas(sizeof(LaneBits)) LaneBits in_load_domain_{};
};

}  // namespace slipproof
