// Converts the options of a judgement from C.
#pragma once

#include "faces/c_interface/slipproof.h"
#include "records/judging/judge.hpp"
#include "records/problems/contact_file.hpp"

namespace slipproof::c {

struct Options {
  JudgeOptions scene;
  JudgeOptions exact;            ///< for contact problems for which all solutions are computed
  ContactFileOptions enclosure;  ///< for the other contact problems
};

/// NULL stands for the defaults. Throws BadArgument.
Options options_of(const slipproof_certify_options* given);

}  // namespace slipproof::c
