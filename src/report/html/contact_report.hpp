// The page about a contact problem at real size: what was found about each answer, with its contacts in their cones.
#pragma once

#include <string>

#include "records/certify/contact_file.hpp"

namespace slipproof {

/// The page, HTML 5, without a script; it needs nothing else. `command` is what makes it again, `version` the
/// program's. The same input gives the same bytes; of thousands of contacts it shows some, and says so.
std::string contact_report(const JudgedProblem& problem, const std::string& command, const std::string& version = {});

}  // namespace slipproof
