// The verdict on a certificate, from its text and that of its statement.
#pragma once

#include <string>

#include "proofs/check/verdict.hpp"

namespace slipproof::check {

struct Judgement {
  Verdict verdict = Verdict::unreadable;
  std::string theorem;             ///< empty where the statement is malformed
  bool about_certificate = false;  ///< the message, and not about the statement
  std::string message;  ///< `LINE: RULE: what is wrong`; of `undecided`, `: REASON; REASON`, if any; else empty
};

/// Never throws because of what the texts contain.
Judgement judge(std::string statement_text, std::string certificate_text);

}  // namespace slipproof::check
