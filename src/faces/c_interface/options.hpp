// The options of a judgement, for C.
#pragma once

#include "faces/c_interface/slipproof.h"
#include "records/certify/contact_file.hpp"
#include "records/certify/judge.hpp"

namespace slipproof::c {

struct Options {
  JudgeOptions scene;
  JudgeOptions exact;            ///< for contact problems whose solutions are all computed
  ContactFileOptions enclosure;  ///< for the others
};

/// NULL: the usual ones. Throws BadArgument.
Options options_of(const slipproof_certify_options* given);

}  // namespace slipproof::c
