#include "claims/identity/vacuous.hpp"

#include <algorithm>

#include "base/expression/logic.hpp"
#include "claims/statements/claim_statements.hpp"

namespace slipproof {

bool is_vacuous(const ClaimsFile& file, std::size_t claim, Reading reading, LemmaBook& book) {
  const ClaimsFile read = as_read(file, reading);
  const Claim& c = read.claims[claim];
  const Implications logic(read, c.setting, book);
  const Expression &region = c.printed.region, never = make_truth(false);
  Lemmas lemmas;
  const auto no_force = [&](const Expression& forces) { return logic.implies({region, forces}, never, lemmas); };
  const auto no_bicycle = [&] { return no_force(make_truth(true)); };
  const auto contradictory = [&](LinearEquations equations) {
    ClaimBody body = c.printed;
    equations.equations = {make_comparison({make_number(0), make_number(1)}, {Relation::equal})};
    body.says = Consequence{std::move(equations)};
    return logic.proves(claim, body, lemmas);
  };
  return std::visit(Cases{[&](const Interval&) { return no_bicycle(); }, [&](const Cover&) { return no_bicycle(); },
                          [&](const Equivalence&) { return no_bicycle(); }, [&](const Exists&) { return false; },
                          [&](const Impossible& one) { return no_force(one.forces); },
                          [&](const Motions& one) { return no_force(one.forces); },
                          [&](const Unique& one) { return no_force(one.forces); },
                          [&](const ForceCover& one) { return no_force(one.forces); },
                          [&](const Formula& one) {
                            if (one.modes.empty()) return no_force(one.forces);
                            return std::all_of(one.modes.begin(), one.modes.end(), [&](const MechanismMode& mode) {
                              return logic.implies({region, one.forces}, never, lemmas, mode);
                            });
                          },
                          [&](const Limit& one) {
                            return logic.eventually(make_truth(true), opposite(region), one.parameter, lemmas) ||
                                   no_bicycle();
                          },
                          [&](const Consequence& one) { return contradictory(one) || no_bicycle(); },
                          [&](const System&) { return no_bicycle(); }},
                    c.printed.says);
}

bool is_nowhere(const ClaimsFile& file, std::size_t claim, Reading reading, LemmaBook& book) {
  const auto statements = claim_refutation(file, file.claims[claim], reading);
  return !statements.empty() && std::all_of(statements.begin(), statements.end(),
                                            [&](const NamedStatement& s) { return !book.certificate(s.text).empty(); });
}

}  // namespace slipproof
