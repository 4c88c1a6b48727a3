#include "claims/identity/vacuous.hpp"

#include <algorithm>

#include "claims/statements/claim_statements.hpp"

namespace slipproof {

bool is_vacuous(const ClaimsFile& file, std::size_t claim, Reading reading, LemmaBook& book) {
  const ClaimsFile read = as_read(file, reading);
  const Claim& c = read.claims[claim];
  const Implications logic(read, c.setting, book);
  Lemmas lemmas;
  return logic.has_interval_of_forces() && logic.of_any_force().has_value({}, c.printed.region, lemmas) &&
         c.kind().says_nothing(logic, claim, c.printed);
}

bool is_nowhere(const ClaimsFile& file, std::size_t claim, Reading reading, LemmaBook& book) {
  const auto statements = claim_refutation(file, file.claims[claim], reading);
  return !statements.empty() && std::all_of(statements.begin(), statements.end(),
                                            [&](const NamedStatement& s) { return !book.certificate(s.text).empty(); });
}

}  // namespace slipproof
