// The output of `slipproof verify --mutants`: the result for each mutant of a claims file, and why.
#pragma once

#include <string>
#include <vector>

#include "claims/mutation/mutation.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// The lemmas of all arguments, each once, in the order of their first use.
std::vector<const Lemma*> lemmas_of(const MutationResult& result);

/// For people: counts for each formula, then every mutant that no failing claim catches, with the bicycle or the
/// argument. The status is `s TIGHT` or, if there are survivors, `s LOOSE`, with counts.
Document mutation_document(const MutationResult& result);

/// One JSON document, schema slipproof/mutants/1, ending in a newline. Lemmas are referred to by number, from 1.
std::string mutation_json(const MutationResult& result);

}  // namespace slipproof
