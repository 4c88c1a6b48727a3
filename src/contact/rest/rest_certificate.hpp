// The claims `rest` and `no-rest` of a certificate (src/proofs/check_contact/FORMAT.md).
#pragma once

#include <string>

#include "contact/rest/rest_answer.hpp"

namespace slipproof {

/// The contact problem of the scene at its load, and what is proved about its rest; empty where nothing is. Throws
/// InputError for what such a problem cannot express: equations as printed, and friction with a limit of its own.
std::string rest_certificate(const RestAnswer& answer);

}  // namespace slipproof
