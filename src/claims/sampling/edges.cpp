#include "claims/sampling/edges.hpp"

#include <optional>

#include "claims/sampling/sampler.hpp"

namespace slipproof {

namespace {

std::optional<Rational> lower_end(const FreeParameter& parameter, const CompiledSetting& compiled,
                                  const std::vector<Rational>& values) {
  const Node& domain = *parameter.domain;
  if (domain.operation != Operation::compare || domain.relations.size() != 1) return std::nullopt;
  const bool above = domain.relations[0] == Relation::greater || domain.relations[0] == Relation::greater_equal;
  if (!above || domain.operands[0]->operation != Operation::symbol || domain.operands[0]->symbol != parameter.symbol) {
    return std::nullopt;
  }
  Evaluator<Rational> evaluator(compiled.scope());
  for (std::size_t k = 0; k < values.size(); ++k) evaluator.set(CompiledSetting::parameter_slot(k), values[k]);
  return evaluator.number(compiled.compile(domain.operands[1], Reading::printed)).number;
}

}  // namespace

std::vector<Rational> toward_edges(const Setting& setting, const CompiledSetting& compiled,
                                   const std::vector<Rational>& values, std::uint64_t variation) {
  std::vector<Rational> moved = values;
  for (std::size_t k = 0; k < moved.size(); ++k) {
    variation = variation * 6364136223846793005U + 1442695040888963407U;
    // Out of eight: two values go closer to the end, one goes away from it.
    const auto die = static_cast<unsigned>(variation >> 61U);
    const unsigned power = 1U << (1 + static_cast<unsigned>((variation >> 58U) & 7U));
    const auto lower = lower_end(setting.parameters[k], compiled, moved);
    if (!lower || die > 2) continue;
    const Rational distance = moved[k] - *lower;
    moved[k] = *lower + (die < 2 ? Rational(distance / power) : Rational(distance * power));
  }
  return in_domain(compiled, moved) ? moved : values;
}

}  // namespace slipproof
