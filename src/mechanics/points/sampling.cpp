#include "mechanics/points/sampling.hpp"

#include <array>
#include <random>

#include "base/number/format.hpp"
#include "mechanics/points/domain_sampler.hpp"

namespace slipproof {

namespace {

/// Small numbers; the first ones of the list are the most frequent.
Rational small_number(std::mt19937_64& random) {
  static const std::array<Rational, 16> pool{Rational(1),     Rational(2),     Rational(1, 2),  Rational(3),
                                             Rational(3, 2),  Rational(1, 3),  Rational(5),     Rational(2, 5),
                                             Rational(7, 10), Rational(10),    Rational(0),     Rational(-1),
                                             Rational(-2),    Rational(-1, 2), Rational(1, 10), Rational(50)};
  return pool[random() % pool.size()];
}

/// A small number; if several of them violated a condition, one near the ends of the conditions, or between two.
Rational draw(const DomainSampler::Drawing& drawing, std::mt19937_64& random) {
  constexpr int patience = 8;
  Rational small = small_number(random);
  if (drawing.roots->empty() || (drawing.attempt < patience && !drawing.fixed)) return small;
  const std::vector<Rational>& roots = *drawing.roots;
  if (drawing.fixed && drawing.attempt < patience) return roots.front();
  const Rational &one = roots[random() % roots.size()], &other = roots[random() % roots.size()];
  return one == other ? Rational(one + small) : Rational((one + other) / 2);
}

}  // namespace

std::vector<MechanismValues> sample_values(const Mechanism& mechanism, const ProblemMaker& maker, std::size_t count,
                                           std::uint64_t seed) {
  const DomainSampler sampler(mechanism, maker);
  std::mt19937_64 random(seed);
  const std::vector<bool> given(mechanism.parameters.size(), true);
  std::vector<MechanismValues> result;
  for (std::size_t tries = 0; result.size() < count && tries < 20 * count; ++tries) {
    auto values = sampler.sample(given, [&](const auto& drawing) { return draw(drawing, random); });
    if (values) result.push_back(std::move(*values));
  }
  return result;
}

std::string values_text(const Mechanism& mechanism, const MechanismValues& values, const ShownValues& shown) {
  std::string text;
  const auto add = [&](const std::string& value) { text += (text.empty() ? "" : ", ") + value; };
  for (std::size_t i = 0; i < values.parameters.size(); ++i) {
    if (shown.parameters[i]) add(mechanism.parameters[i].symbol + " = " + exact_text(values.parameters[i]));
  }
  for (std::size_t i = 0; i < values.angles.size(); ++i) {
    const MechanismValues::Circle& point = values.angles[i];
    if (!shown.angles[i]) continue;
    add(mechanism.angles[i].name + ": cos " + exact_text(point.cosine) + ", sin " + exact_text(point.sine));
  }
  return text;
}

std::string values_text(const Mechanism& mechanism, const MechanismValues& values) {
  return values_text(mechanism, values, {values.given, std::vector<bool>(values.angles.size(), true)});
}

}  // namespace slipproof
