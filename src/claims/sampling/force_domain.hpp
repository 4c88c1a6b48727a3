// What samples say of the forces that a setting's domain allows.
#pragma once

#include "claims/paper/claims_file.hpp"

namespace slipproof {

/// Whether there is a sample at which the forces of the setting's domain are known, and are no interval.
bool domain_is_no_interval(const Setting& setting);

}  // namespace slipproof
