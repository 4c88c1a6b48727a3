// A second checker of the certificates, as `verify` and the report name it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/verify/certificates.hpp"
#include "report/papers/papers_report.hpp"

namespace slipproof {

/// `41 certificates are accepted by slipproof-check-verified, too, a checker that is proved correct`.
std::string in_words(const SecondChecker& checker);

/// The second checker of all papers together; nothing if none was asked.
std::optional<SecondChecker> second_checker(const std::vector<JudgedPaper>& papers);

}  // namespace slipproof
