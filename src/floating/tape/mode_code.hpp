// What of a tape is needed for decisions, and what else for the numbers of each mode, with places for the results.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "floating/program/tape_code.hpp"
#include "floating/tape/mode_programs.hpp"
#include "floating/tape/running_error.hpp"

namespace slipproof {

/// Shared by threads.
class ModeCode {
 public:
  explicit ModeCode(ModePrograms programs);

  const ModePrograms& programs() const { return programs_; }
  /// The place of a result that one of the codes wants.
  std::uint32_t place(TapeRef ref) const { return places_[ref]; }
  std::size_t places() const { return count_; }
  /// What does not change from run to run.
  const std::vector<std::pair<std::uint32_t, RunningError>>& literals() const { return literals_; }

  const TapeCode& decision() const { return decision_; }
  /// What follows runs after the decision.
  const TapeCode& scales() const { return scales_; }
  const TapeCode& values(std::size_t mode) const { return values_[mode]; }

 private:
  ModePrograms programs_;
  std::vector<std::uint32_t> places_;
  std::size_t count_ = 0;
  std::vector<std::pair<std::uint32_t, RunningError>> literals_;
  TapeCode decision_, scales_;
  std::vector<TapeCode> values_;  ///< of each mode
};

}  // namespace slipproof
