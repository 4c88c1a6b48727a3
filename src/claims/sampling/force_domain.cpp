#include "claims/sampling/force_domain.hpp"

#include <algorithm>

#include "claims/sampling/sampler.hpp"
#include "mechanics/family/solved_sample.hpp"

namespace slipproof {

bool domain_is_no_interval(const Setting& setting) {
  constexpr std::uint64_t enough = 30, seed = 1;
  const CompiledSetting compiled(setting);
  const Sampler sampler(compiled, seed);
  for (std::uint64_t i = 0; i < enough; ++i) {
    std::vector<Rational> values = sampler.at(i);
    if (values.empty()) continue;
    const auto sample = SolvedSample::make(compiled, std::move(values));
    if (!sample || sample->force_domain()) continue;
    const auto known = [](const TruthCell& cell) { return cell.truth == Truth::yes || cell.truth == Truth::no; };
    if (std::ranges::all_of(sample->over_forces(compiled.force_domain()), known)) return true;
  }
  return false;
}

}  // namespace slipproof
