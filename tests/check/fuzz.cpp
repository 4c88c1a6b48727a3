// libFuzzer target for the checker: the input is a statement, a line `====`, and the body of a
// certificate; the header is made to fit, so that mutants reach the rules.
#include <cstdint>
#include <sstream>
#include <string>

#include "check/theorem.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slipproof::check;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = text.find("====\n");
  if (cut == std::string::npos) return 0;
  try {
    std::istringstream statement_text(text.substr(0, cut));
    FormulaReader statement_reader(statement_text);
    const Statement statement(statement_reader);
    std::istringstream certificate("slipproof-certificate 1\ntheorem " + statement.theorem + " " +
                                   statement.fingerprint + "\n" + text.substr(cut + 5));
    FormulaReader certificate_reader(certificate);
    Proof(statement, certificate_reader);
  } catch (const Rejection&) {
    // rejected, as nearly everything is
  }
  return 0;
}
