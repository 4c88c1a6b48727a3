// Counts the judgements of claims over samples. Sums do not depend on the order, and ranks can send theirs to each
// other.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/crew/bytes.hpp"
#include "base/number/simplest.hpp"
#include "claims/judge/judge.hpp"

namespace slipproof {

/// Lines of a claim go through so many of the first samples at which it held.
inline constexpr std::size_t max_bases = 64;

/// Keeps the least numbers of all that were added, in any order.
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

/// The simplest of the samples added.
struct Simplest {
  std::vector<Rational> values;  ///< empty: none was added
  Complexity its_complexity;

  void keep(const std::vector<Rational>& other, const Complexity& c);
  void keep(const Simplest& other) {
    if (!other.values.empty()) keep(other.values, other.its_complexity);
  }
};

/// The judgements of one claim in one reading.
struct Tally {
  std::uint64_t tried = 0, held = 0, refuted = 0, undecided = 0, unsure = 0;  ///< `unsure`: a part of the undecided
  std::uint64_t lines = 0, cells = 0;
  /// Samples at which it held; those among them at which it says something about a force.
  FirstSamples held_at, speaks_at;
  Simplest simplest, realisable;  ///< of the failing samples, and of the failing samples that can be built
  std::string failure;            ///< why it could not be judged at some sample; empty: nothing went wrong

  void add(const Judgement& judgement, const CompiledSetting& setting, const std::vector<Rational>& values);
  void add(const Tally& other);
  /// Of several reasons, keeps the first in alphabetical order; an empty text is not a reason.
  void fail(const std::string& why);
  bool empty() const { return tried == 0 && lines == 0 && failure.empty(); }
};

void write_tally(ByteWriter& bytes, const Tally& tally);
Tally read_tally(ByteReader& bytes);

}  // namespace slipproof
