// libFuzzer target for the checker: the input is a statement, a line `====`, and the body of a
// certificate; the header is made to fit, so that mutants reach the rules.
#include <cstdint>
#include <string>

#include "proofs/check/judge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slipproof::check;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = text.find("====\n");
  if (cut == std::string::npos) return 0;
  std::string statement = text.substr(0, cut), header;
  try {
    FormulaReader reader(statement);
    const Statement read(reader);
    header = "slipproof-certificate 1\ntheorem " + read.theorem + " " + read.fingerprint + "\n";
  } catch (const Rejection&) {
    // as nearly everything is
  }
  judge(std::move(statement), header + text.substr(cut + 5));
  return 0;
}
