// Contact problems at real size as JSON Lines: each line has a problem with its answer.
#pragma once

#include <string_view>

#include "records/problems/contact_file.hpp"
#include "records/reading/options.hpp"

namespace slipproof {

/// Judges a line that `read_problem_line` reads, by `options.contact`; its output is in `members`. Throws
/// BrokenRecord, also if decimals are to be exact.
RecordJudgement judge_contact_line(std::string_view line, const CertifyOptions& options);

/// The verdict on an answer to a problem at real size, as one of a record.
RecordJudgement as_record(const JudgedProblem& problem, std::size_t answer);

}  // namespace slipproof
