// Contact problems at real size as JSON Lines: each line has a problem with its answer.
#pragma once

#include <string>

#include "base/input/diagnostic.hpp"
#include "contact/formats/json_problem.hpp"
#include "records/problems/contact_file.hpp"
#include "records/reading/options.hpp"

namespace slipproof {

/// Calls read() and returns its result; turns an InputError into a BrokenRecord.
template <class Read>
auto of_line(const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    std::string messages;
    for (const Diagnostic& d : error.diagnostics()) messages += (messages.empty() ? "" : "; ") + d.message;
    throw BrokenRecord{error.diagnostics().front().column, messages};
  }
}

/// Judges a problem in a line as one of a file, by `options.contact`; its output is in `members`. Throws BrokenRecord,
/// also if decimals are to be exact.
RecordJudgement judge_contact_line(const JsonProblem& json, const CertifyOptions& options);

/// The verdict on an answer to a problem at real size, as one of a record.
RecordJudgement as_record(const JudgedProblem& problem, std::size_t answer);

}  // namespace slipproof
