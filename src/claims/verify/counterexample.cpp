#include "claims/verify/counterexample.hpp"

#include <functional>
#include <utility>

#include "claims/sampling/simplify.hpp"
#include "claims/verify/broken_comparison.hpp"

namespace slipproof {

namespace {

/// How many bicycles that can be built are tried, and how many of those that fail are made simpler.
constexpr std::uint64_t realisable_tries = 1'000;
constexpr std::size_t starts = 3;
/// How many simple ones are tried first; enough for a paper with few parameters.
constexpr std::size_t realisable_budget = 4'000;

class Maker {
 public:
  Maker(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading)
      : file_(file),
        compiled_(compiled),
        index_(claim),
        claim_(file.claims[claim]),
        setting_(compiled.settings[claim_.setting]),
        reading_(reading) {}

  /// The simplest sample that fails in the same way.
  std::optional<Simplified> simplest(const std::vector<Rational>& values, Among among) const {
    if (among == Among::all) return simplify(setting_, values, fails_like(values));
    return simplify(setting_, values, fails_like(values), among, realisable_budget);
  }

  /// The same starting from a sample that can be built, without trying all simple ones first.
  Simplified descended(const std::vector<Rational>& values) const {
    return *simplify(setting_, values, fails_like(values), Among::realisable, 0);
  }

  /// Whether the first is better: it has a force at which claim and truth differ and the second has none, or it is
  /// simpler.
  bool better(const std::vector<Rational>& values, const std::vector<Rational>& others) const {
    const bool shows = judged(values).witnesses.has_value(), other_shows = judged(others).witnesses.has_value();
    return shows != other_shows ? shows : complexity(values) < complexity(others);
  }

  Counterexample at(Simplified found) const {
    const auto sample = SolvedSample::make(setting_, found.values);
    Counterexample example;
    example.judgement = judge(file_, compiled_, index_, reading_, *sample);
    example.scene.name = "counterexample to " + claim_.id + ", " + std::string(name(reading_));
    example.scene.mechanism = *setting().mechanism;
    example.scene.values = sample->point();
    example.minimal = found.minimal;
    if (const auto& witnesses = example.judgement.witnesses; witnesses && !witnesses->empty()) {
      example.force = witnesses->sample();
      if (setting().mechanism->load) example.scene.load = sample->load(*example.force);
      // In space the motions that slip from rest are not known here.
      if (setting().mechanism->dimension == 2) example.motions = motions_of(sample->problem(), example.scene.load);
    }
    for (const std::size_t i : unrealisable(setting_, found.values)) {
      example.unrealisable.push_back(setting().realisable[i].name);
    }
    example.broken = broken_comparisons(claim_, reading_, setting_, example, *sample);
    example.values = std::move(found.values);
    return example;
  }

  /// Points that can be built and at which the claim fails; the given one comes first.
  std::vector<std::vector<Rational>> realisable(const std::vector<Rational>& given, std::uint64_t seed) const {
    std::vector<std::vector<Rational>> found;
    if (!given.empty()) found.push_back(given);
    const Sampler sampler(setting_, seed, Among::realisable);
    for (std::uint64_t i = 0; i < realisable_tries && found.size() < starts; ++i) {
      auto values = sampler.at(i);
      const bool fits = !values.empty() && unrealisable(setting_, values).empty();
      if (fits && judged(values).outcome == Outcome::refuted) found.push_back(std::move(values));
    }
    return found;
  }

 private:
  std::function<bool(const std::vector<Rational>&)> fails_like(const std::vector<Rational>& values) const {
    return [this, original = judged(values)](const std::vector<Rational>& at) {
      const Judgement j = judged(at);
      return j.outcome == Outcome::refuted && j.reason == original.reason && j.mode == original.mode &&
             j.witnesses.has_value() == original.witnesses.has_value();
    };
  }
  const Setting& setting() const { return file_.settings[claim_.setting]; }
  Judgement judged(const std::vector<Rational>& at) const {
    const auto sample = SolvedSample::make(setting_, at);
    return sample ? judge(file_, compiled_, index_, reading_, *sample) : Judgement{};
  }

  const ClaimsFile& file_;
  const CompiledClaims& compiled_;
  const std::size_t index_;
  const Claim& claim_;
  const CompiledSetting& setting_;
  const Reading reading_;
};

}  // namespace

SimplestFailures simplest_failures(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                   Reading reading, const FailingSamples& failing, Showing showing,
                                   std::uint64_t seed) {
  const Maker maker(file, compiled, claim, reading);
  if (showing == Showing::as_found) {
    const auto& found = failing.realisable.empty() ? failing.simplest : failing.realisable;
    return {{.values = found, .minimal = false}, std::nullopt};
  }
  Simplified simplest = *maker.simplest(failing.simplest, Among::all);
  if (unrealisable(compiled.settings[file.claims[claim].setting], simplest.values).empty()) {
    return {std::move(simplest), std::nullopt};
  }
  std::optional<Simplified> built = maker.simplest(failing.simplest, Among::realisable);
  if (!built || !built->minimal) {
    for (const std::vector<Rational>& start : maker.realisable(failing.realisable, seed)) {
      auto found = maker.descended(start);
      if (!built || maker.better(found.values, built->values)) built = std::move(found);
    }
  }
  if (!built) return {std::move(simplest), std::nullopt};
  const bool worth_showing = much_simpler(simplest.values, built->values);
  return {*std::move(built), worth_showing ? std::optional(std::move(simplest)) : std::nullopt};
}

Counterexamples counterexamples(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim,
                                Reading reading, const SimplestFailures& failures) {
  const Maker maker(file, compiled, claim, reading);
  return {maker.at(failures.shown), failures.simpler ? std::optional(maker.at(*failures.simpler)) : std::nullopt};
}

}  // namespace slipproof
