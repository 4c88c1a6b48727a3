// Bounds the distance of answers from the motion of a mode, for several records side by side.
#pragma once

#include <span>

#include "floating/tape/mode_run.hpp"
#include "records/record/record_block.hpp"

namespace slipproof {

/// Upper bounds on the largest relative error of a component, as defined by RecordAnswer, for some rows of a block.
/// They are compared with the motion of a mode whose values and scales the run has computed at these rows. Infinite if
/// nothing is known.
Lanes answer_errors(const RecordBlock& block, std::span<const std::uint16_t> rows, const RecordFields& fields,
                    const ModePrograms& programs, std::size_t mode, const ModeRun& run, const ModeRun::Values& values);

}  // namespace slipproof
