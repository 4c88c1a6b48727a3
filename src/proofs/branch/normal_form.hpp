// The normal form of a fact: without the factors whose signs are known, without numerical factors, and without odd
// powers of a single factor. It assumes that the known signs are strict: a factor that may be 0 cannot be divided out.
#pragma once

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove {

/// The content of a fact relative to the known facts.
enum class News : std::uint8_t {
  none,          ///< it is true anyway
  some,          ///< it is to be kept, in the form that it has now
  contradiction  ///< it cannot be true; the steps say so
};

/// Derives the normal form of the fact, and puts it in its place.
News normalize(Context& context, State& state, Fact& fact);

}  // namespace slipproof::prove
