// The page about a contact problem at real size: the results for each answer, with its contacts in their cones.
#pragma once

#include <string>

#include "records/problems/contact_file.hpp"

namespace slipproof {

/// The page as HTML 5, without a script and without other files. `command` is the command that makes it again,
/// `version` the program's version. The same input gives the same bytes. Of thousands of contacts it shows only some,
/// and says so.
std::string contact_report(const JudgedProblem& problem, const std::string& command, const std::string& version = {});

}  // namespace slipproof
