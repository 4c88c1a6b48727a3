// The verdict on a certificate, from its text and that of its statement.
#pragma once

#include "proofs/check/theorem.hpp"
#include "proofs/check/verdict.hpp"

namespace slipproof::check {

struct Judgement {
  Verdict verdict = Verdict::unreadable;
  std::string theorem;             ///< empty where the statement is malformed
  bool about_certificate = false;  ///< the message, and not about the statement
  std::string message;  ///< `LINE: RULE: what is wrong`; of `undecided`, `: REASON; REASON`, if any; else empty
};

/// Reads the rest of a record `slipproof-undecided 1`, and returns the reasons that it gives.
inline std::string read_undecided(const Statement& statement, Reader& reader) {
  reader.rule = "undecided";
  reader.expect_line("theorem " + statement.theorem);
  std::string reasons;
  while (reader.next_line()) {
    reader.expect("because");
    require(!reader.at_end(), "expected a reason");
    const std::string_view reason =
        reader.line().substr(reader.line().find("because") + std::string_view("because").size());
    reasons.append(reasons.empty() ? ":" : ";").append(reason);
  }
  return reasons;
}

/// Never throws because of what the texts contain.
inline Judgement judge(std::string statement_text, std::string certificate_text) {
  Judgement result;
  FormulaReader statement_reader(std::move(statement_text)), reader(std::move(certificate_text));
  try {
    const Statement statement(statement_reader);
    result = {Verdict::rejected, statement.theorem, true, ""};
    reader.need_line();
    if (reader.line() == "slipproof-undecided 1") {
      result.message = read_undecided(statement, reader);
      result.verdict = Verdict::undecided;
    } else {
      require(reader.line() == "slipproof-certificate 1", "expected 'slipproof-certificate 1'");
      Proof(statement, reader);
      result.verdict = Verdict::accepted;
    }
  } catch (const Rejection& rejection) {
    result.message = (result.about_certificate ? reader : statement_reader).place() + rejection.what();
  }
  return result;
}

}  // namespace slipproof::check
