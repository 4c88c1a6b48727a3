// Apart from the batches, which the explorer does without.
#include "floating/batch/mechanism_batch.hpp"

namespace slipproof {

std::string_view name(Tier tier) {
  return tier == Tier::filter ? "filter" : "exact";
}

}  // namespace slipproof
