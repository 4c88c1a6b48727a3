// The modes of a mechanism at several points side by side, in binary64: consistent, not consistent, or unsure, and
// never wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "floating/tape/mode_programs.hpp"
#include "floating/tape/running_error.hpp"

namespace slipproof {

/// results[target] = results[first] operation results[second]
struct TapeInstruction {
  TapeOperation operation;
  std::uint32_t target, first, second;
};

/// What of a tape is needed for decisions, and what else for the numbers of each mode, with places for the results.
class ModeCode {
 public:
  explicit ModeCode(ModePrograms programs);

  const ModePrograms& programs() const { return programs_; }

 private:
  friend class ModeRun;
  using Code = std::vector<TapeInstruction>;

  /// What computes the results that are wanted and not `done`, which become so.
  Code code_for(const std::vector<TapeRef>& wanted, std::vector<bool>& done);
  std::uint32_t place(TapeRef ref);

  ModePrograms programs_;
  std::vector<std::uint32_t> places_;  ///< of nodes of the tape among the results of a run
  std::uint32_t results_ = 0;
  std::vector<std::pair<std::uint32_t, RunningError>> constants_;
  Code decision_, scales_;
  std::vector<Code> values_;  ///< of each mode
};

/// A mode at the points of a run, a mask for each answer.
struct LaneModes {
  LaneBits inconsistent{}, boundary{}, strict{};  ///< none: unsure. Boundary: consistent, and surely not strict
  LaneBits valid{};                               ///< its programs mean what they say
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

  /// Computes accelerations and forces of a mode at all points, and what zeros are held against.
  void compute_values(std::size_t mode);
  void compute_scales();
  const RunningError& at(TapeRef ref) const { return results_[code_->places_[ref]]; }
  /// A form at values of what a mode leaves free.
  RunningError at(const FreeForm& form, std::span<const RunningError> free) const;

 private:
  void compute_angles();
  LaneBits holds(const TruthProgram& program) const;
  LaneModes judge(const ModeProgram& program) const;
  void judge_determined(const ModeProgram& program, LaneBits& violated, LaneModes& result) const;
  void judge_with_free(const ModeProgram& program, LaneBits& violated, LaneModes& result) const;

  const ModeCode* code_;
  std::vector<RunningError> results_;
  std::vector<RunningError> tan_halves_;
  std::vector<LaneModes> modes_;
  LaneBits in_domain_{}, in_load_domain_{};
};

}  // namespace slipproof
