// Selects from a tape the results needed for decisions, and those needed in addition for the numbers of each mode, and
// assigns places to them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "floating/program/tape_code.hpp"
#include "floating/tape/mode_programs.hpp"
#include "floating/tape/running_error.hpp"

namespace slipproof {

/// May be shared by threads.
class ModeCode {
 public:
  explicit ModeCode(ModePrograms programs);

  const ModePrograms& programs() const { return programs_; }
  /// The place of a result that one of the codes computes.
  std::uint32_t place(TapeRef ref) const { return places_[ref]; }
  std::size_t places() const { return count_; }
  /// The constants, which are the same in every run.
  const std::vector<std::pair<std::uint32_t, RunningError>>& literals() const { return literals_; }

  /// The codes do not depend on each other.
  const TapeCode& decision() const { return decision_; }
  const TapeCode& scales() const { return scales_; }
  const TapeCode& values(std::size_t mode) const { return values_[mode]; }

 private:
  ModePrograms programs_;
  std::vector<std::uint32_t> places_;
  std::size_t count_ = 0;
  std::vector<std::pair<std::uint32_t, RunningError>> literals_;
  TapeCode decision_, scales_;
  std::vector<TapeCode> values_;  ///< by mode
};

}  // namespace slipproof
