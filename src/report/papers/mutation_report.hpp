// The output of `slipproof verify --mutants`: the result for each mutant of a claims file, and why.
#pragma once

#include <string>
#include <vector>

#include "claims/mutation/mutation.hpp"

namespace slipproof {

/// The lemmas of all arguments, each once, in the order of their first use.
std::vector<const Lemma*> lemmas_of(const MutationResult& result);

/// For people: counts for each formula, then every mutant that no failing claim catches, with the bicycle or the
/// argument. The last line is `s TIGHT` or, if there are survivors, `s LOOSE`, with counts. `quiet`: only the last
/// line.
std::string mutation_text(const MutationResult& result, bool quiet = false);

/// One JSON document, schema slipproof/mutants/1, ending in a newline. Lemmas are referred to by number, from 1.
std::string mutation_json(const MutationResult& result);

}  // namespace slipproof
