// What claims come to over some samples; sums do not depend on their order, and ranks tell each other theirs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/crew/bytes.hpp"
#include "base/number/simplest.hpp"
#include "claims/judge/judge.hpp"

namespace slipproof {

/// Lines of a claim are laid through the first so many samples at which it held.
inline constexpr std::size_t max_bases = 64;

/// The least numbers of all that were added, in whatever order.
class FirstSamples {
 public:
  void add(std::uint64_t i) {
    if (numbers_.size() < max_bases || i < numbers_.back()) add({&i, 1});
  }
  void add(std::span<const std::uint64_t> others);
  bool full() const { return numbers_.size() == max_bases; }
  const std::vector<std::uint64_t>& numbers() const { return numbers_; }

 private:
  std::vector<std::uint64_t> numbers_;
};

/// The simplest of some samples.
struct Simplest {
  std::vector<Rational> values;  ///< empty: there is none yet
  Complexity its_complexity;

  void keep(const std::vector<Rational>& other, const Complexity& c);
  void keep(const Simplest& other) {
    if (!other.values.empty()) keep(other.values, other.its_complexity);
  }
};

/// What one claim in one reading comes to.
struct Tally {
  std::uint64_t tried = 0, held = 0, refuted = 0, undecided = 0, unsure = 0;  ///< unsure: those of undecided
  std::uint64_t lines = 0, cells = 0;
  FirstSamples held_at, speaks_at;  ///< samples at which it held; those of them at which there is a force for it
  Simplest simplest, realisable;    ///< of the failing samples, and of those of them that can be built
  std::string failure;              ///< why it could not be judged somewhere; empty: nothing went wrong

  void add(const Judgement& judgement, const CompiledSetting& setting, const std::vector<Rational>& values);
  void add(const Tally& other);
  /// Of several reasons it keeps the first in the order of texts; an empty one is none.
  void fail(const std::string& why);
  bool empty() const { return tried == 0 && lines == 0 && failure.empty(); }
};

void write_tally(ByteWriter& bytes, const Tally& tally);
Tally read_tally(ByteReader& bytes);

}  // namespace slipproof
