#include "proofs/check/judge.hpp"

#include "proofs/check/theorem.hpp"

namespace slipproof::check {

namespace {

/// Reads the rest of a record `slipproof-undecided 1`, and returns the reasons that it gives.
std::string read_undecided(const Statement& statement, Reader& reader) {
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

}  // namespace

Judgement judge(std::string statement_text, std::string certificate_text) {
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
