// Signs that an expression can have, by the domains of its symbols and the rules of signs.
#pragma once

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof::bodies_in_motion {

struct Signs {
  bool negative = true, zero = true, positive = true;
};

/// No sign is left out that some value of the domain gives.
Signs sure_signs(const Mechanism& mechanism, const Expression& expression);

}  // namespace slipproof::bodies_in_motion
