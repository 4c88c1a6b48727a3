// What `slipproof verify --mutants` says: how every mutant of a claims file ended, and why.
#pragma once

#include <string>
#include <vector>

#include "claims/mutation/mutation.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// The lemmas of all arguments, each once, in the order in which they are first used.
std::vector<const Lemma*> lemmas_of(const MutationResult& result);

/// For people: counts for each formula, then every mutant that no failing claim catches, with the bicycle or the
/// argument. The status is `s TIGHT` or, with survivors, `s LOOSE`, with counts.
Document mutation_document(const MutationResult& result);

/// One JSON document, schema slipproof/mutants/1, ending in a newline. Lemmas are given by their number, from 1.
std::string mutation_json(const MutationResult& result);

}  // namespace slipproof
