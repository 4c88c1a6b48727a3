// libFuzzer target for the checker: the input is a statement, a line `====`, and the body of a
// certificate; the header is made to fit, so that mutants reach the rules.
#include <cstdint>
#include <cstdio>
#include <sstream>
#include <string>

#include "check/certificate.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = text.find("====\n");
  if (cut == std::string::npos) return 0;
  std::istringstream statement_text(text.substr(0, cut));
  try {
    const slipproof::check::Statement statement(statement_text);
    char fingerprint[17];
    std::snprintf(fingerprint, sizeof fingerprint, "%016llx", static_cast<unsigned long long>(statement.fingerprint()));
    std::istringstream certificate("slipproof-certificate 1\ntheorem " + statement.theorem() + " " + fingerprint +
                                   "\n" + text.substr(cut + 5));
    slipproof::check::check_certificate(statement, certificate);
  } catch (const slipproof::check::Failure&) {
    // rejected, as nearly everything is
  }
  return 0;
}
