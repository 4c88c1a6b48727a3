#include "mechanism/sampling.hpp"

#include <array>
#include <random>

#include "mechanism/domain_sampler.hpp"
#include "number/format.hpp"

namespace slipproof {

namespace {

/// Small numbers, of which those that come first come often.
Rational small_number(std::mt19937_64& random) {
  static const std::array<Rational, 16> pool{Rational(1),     Rational(2),     Rational(1, 2),  Rational(3),
                                             Rational(3, 2),  Rational(1, 3),  Rational(5),     Rational(2, 5),
                                             Rational(7, 10), Rational(10),    Rational(0),     Rational(-1),
                                             Rational(-2),    Rational(-1, 2), Rational(1, 10), Rational(50)};
  return pool[random() % pool.size()];
}

}  // namespace

std::vector<MechanismValues> sample_values(const Mechanism& mechanism, const ProblemMaker& maker, std::size_t count,
                                           std::uint64_t seed) {
  const DomainSampler sampler(mechanism, maker);
  std::mt19937_64 random(seed);
  const std::vector<bool> given(mechanism.parameters.size(), true);
  std::vector<MechanismValues> result;
  for (std::size_t tries = 0; result.size() < count && tries < 20 * count; ++tries) {
    auto values = sampler.sample(given, [&](const auto&) { return small_number(random); });
    if (values) result.push_back(std::move(*values));
  }
  return result;
}

std::string values_text(const Mechanism& mechanism, const MechanismValues& values, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < values.parameters.size() && i < most; ++i) {
    if (!values.given[i]) continue;
    text += (text.empty() ? "" : ", ") + mechanism.parameters[i].symbol + " = " + exact_text(values.parameters[i]);
  }
  if (values.parameters.size() > most) text += ", ...";
  for (std::size_t i = 0; i < values.angles.size(); ++i) {
    text += (text.empty() ? "" : ", ") + mechanism.angles[i].name + ": cos " + exact_text(values.angles[i].cosine) +
            ", sin " + exact_text(values.angles[i].sine);
  }
  return text;
}

}  // namespace slipproof
