// Contact problems at real size as JSON Lines: a problem with its answer in each line.
#pragma once

#include <string_view>

#include "records/certify/certify.hpp"

namespace slipproof {

/// What `read_problem_line` reads, judged by `options.contact`, and its line in `members`. Of the verdicts for records,
/// `certified` is a solution within rho or the only one, `inaccurate` also an eps-solution, and `wrong` also what has
/// no solution, near or at all. Throws BrokenRecord, also where decimals are to mean what they say.
RecordJudgement judge_contact_line(std::string_view line, const CertifyOptions& options);

}  // namespace slipproof
