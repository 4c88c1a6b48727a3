#include "mechanism/sampling.hpp"

#include <array>
#include <random>

#include "mechanism/degrees.hpp"
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

/// Gives one symbol after the other a value that breaks no condition which can be decided by then.
class Sampler {
 public:
  Sampler(const Mechanism& mechanism, const ProblemMaker& maker, std::uint64_t seed)
      : mechanism_(mechanism), compiled_(maker.compiled()), random_(seed) {
    for (const auto* list : {&compiled_.angle_domains, &compiled_.parameter_domains, &compiled_.assume}) {
      for (const Program& program : *list) conditions_.push_back(&program);
    }
  }

  std::optional<MechanismValues> sample() {
    values_ = default_values(mechanism_);
    pending_ = conditions_;
    for (std::size_t i = 0; i < values_.angles.size(); ++i) {
      if (!choose(i + 1, 0, [&] { values_.angles[i] = point_of_tan_half(small_number(random_)); })) return std::nullopt;
    }
    for (std::size_t i = 0; i < values_.parameters.size(); ++i) {
      if (!choose(values_.angles.size(), i + 1, [&] { values_.parameters[i] = small_number(random_); }))
        return std::nullopt;
    }
    return values_;
  }

 private:
  template <class Draw>
  bool choose(std::size_t angles, std::size_t parameters, Draw&& draw) {
    constexpr int tries = 40;
    for (int i = 0; i < tries; ++i) {
      draw();
      if (possible(angles, parameters)) return true;
    }
    return false;
  }

  bool possible(std::size_t angles, std::size_t parameters) {
    Evaluator<Rational> at(compiled_.scope());
    for (std::size_t i = 0; i < parameters; ++i) at.set(compiled_.parameter(i), values_.parameters[i]);
    for (std::size_t i = 0; i < angles; ++i) {
      at.set(compiled_.cosine(i), values_.angles[i].cosine);
      at.set(compiled_.sine(i), values_.angles[i].sine);
    }
    std::vector<const Program*> open;
    for (const Program* condition : pending_) {
      const Truth truth = at.truth(*condition);
      if (truth == Truth::undecided) open.push_back(condition);
      if (truth == Truth::no || truth == Truth::undefined) return false;
    }
    pending_ = std::move(open);
    return true;
  }

  const Mechanism& mechanism_;
  const CompiledMechanism& compiled_;
  std::mt19937_64 random_;
  std::vector<const Program*> conditions_, pending_;
  MechanismValues values_;
};

}  // namespace

std::vector<MechanismValues> sample_values(const Mechanism& mechanism, const ProblemMaker& maker, std::size_t count,
                                           std::uint64_t seed) {
  Sampler sampler(mechanism, maker, seed);
  std::vector<MechanismValues> result;
  for (std::size_t tries = 0; result.size() < count && tries < 20 * count; ++tries) {
    if (auto values = sampler.sample()) result.push_back(std::move(*values));
  }
  return result;
}

std::string values_text(const Mechanism& mechanism, const MechanismValues& values) {
  constexpr std::size_t shown = 8;
  std::string text;
  for (std::size_t i = 0; i < values.parameters.size() && i < shown; ++i) {
    text += (i == 0 ? "" : ", ") + mechanism.parameters[i].symbol + " = " + exact_text(values.parameters[i]);
  }
  if (values.parameters.size() > shown) text += ", ...";
  for (std::size_t i = 0; i < values.angles.size(); ++i) {
    text += (text.empty() ? "" : ", ") + mechanism.angles[i].name + ": cos " + exact_text(values.angles[i].cosine) +
            ", sin " + exact_text(values.angles[i].sine);
  }
  return text;
}

}  // namespace slipproof
