// Results that depend on polynomials alone, computed once.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "proofs/statement/polynomial.hpp"

namespace slipproof::prove {

/// Caches results that are computed from `count` polynomials and a number. Branches of a search differ in one or two
/// facts, so the same results are needed again and again. A cached result spends as many steps of the ring's budget as
/// computing it did. Polynomials are distinguished by identity(), which is cheap: copies are recognised, equal
/// polynomials that were computed separately are not. Value must have a length(), in terms; above a certain total
/// length nothing more is cached. For one thread at a time, as the ring's budget.
template <class Value, std::size_t count>
class Memo {
 public:
  /// compute(), for this number and these polynomials.
  template <class Compute, class... Polynomials>
  Value get(const Compute& compute, std::size_t number, const Polynomials&... of) {
    static_assert(sizeof...(of) == count);
    Budget& budget = std::get<0>(std::tie(of...)).ring().budget();
    const Key key{reinterpret_cast<std::uintptr_t>(of.identity())..., number};
    if (const auto found = entries_.find(key); found != entries_.end()) {
      budget.spend(found->second.steps);
      return found->second.value;
    }
    const std::uint64_t before = budget.spent();
    Value value = compute();
    const auto steps = static_cast<std::size_t>(budget.spent() - before);
    length_ += value.length() + 1;
    if (length_ <= longest) entries_.emplace(key, Entry{{of...}, value, steps});
    return value;
  }

 private:
  static constexpr std::size_t longest = 1'000'000;  // a term takes some 30 bytes

  using Key = std::array<std::uintptr_t, count + 1>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::size_t hash = 0;
      for (const std::uintptr_t part : key) hash = (hash ^ part) * 0x9e3779b97f4a7c15 ^ hash >> 29;
      return hash;
    }
  };
  struct Entry {
    std::array<Polynomial, count> of;  ///< keeps their identities from being reused
    Value value;
    std::size_t steps;
  };

  std::unordered_map<Key, Entry, Hash> entries_;
  std::size_t length_ = 0;
};

}  // namespace slipproof::prove
