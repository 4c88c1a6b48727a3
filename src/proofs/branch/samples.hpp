// Sample values of the variables. If a polynomial is negative at a sample that satisfies the hypotheses, no search for
// a proof that it is positive can succeed. Samples only exclude attempts: a wrong sign here can cost a proof, but
// cannot create one, so binary64 is enough.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "proofs/statement/polynomial.hpp"

namespace slipproof::prove {

inline constexpr std::size_t kSamples = 1024;

/// A set of samples.
class SampleSet {
 public:
  void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  SampleSet& operator|=(const SampleSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    return *this;
  }
  SampleSet& operator&=(const SampleSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
  }
  friend SampleSet operator|(SampleSet x, const SampleSet& y) { return x |= y; }
  static SampleSet all() {
    SampleSet result;
    result.words_.fill(~std::uint64_t{0});
    return result;
  }
  bool empty() const {
    return std::all_of(words_.begin(), words_.end(), [](std::uint64_t word) { return word == 0; });
  }
  bool contains(const SampleSet& other) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if ((other.words_[i] & ~words_[i]) != 0) return false;
    }
    return true;
  }

 private:
  std::array<std::uint64_t, kSamples / 64> words_{};
};

/// The samples at which a polynomial is clearly positive or negative, beyond rounding errors.
struct SignPattern {
  SampleSet positive;
  SampleSet negative;
};

class Samples {
 public:
  /// Variables in `positive` get positive values, the others both signs. The same values at every call.
  Samples(const Ring& ring, const std::vector<bool>& positive);

  SignPattern signs(const Polynomial& p) const;

 private:
  using Column = std::array<double, kSamples>;
  std::vector<Column> values_;  ///< by variable
};

}  // namespace slipproof::prove
