// Random claims against the second judge, which was written from proofs/MEANING.md alone.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "claims/meaning/random/random_claims.hpp"
#include "claims/meaning/second_judge/second_judge.hpp"
#include "claims/paper/claims_file.hpp"

namespace slipproof::test {

/// One claim at one bicycle.
struct Pair {
  const meaning::File& random;
  const ClaimsFile& file;
  const meaning::World& world;
  const meaning::Values& bicycle;
  std::size_t claim;
  meaning::Says says;
};

/// How the product differs from the second judge; empty if it does not.
using Compare = std::function<std::string(const Pair&)>;

/// Goes through random claims, and counts what is found.
class Comparison {
 public:
  Comparison(meaning::RandomClaims random, Compare compare)
      : random_(std::move(random)), compare_(std::move(compare)) {}

  /// How often each kind ended in each way.
  std::map<std::string, std::map<meaning::Says, std::uint64_t>> counts;
  std::uint64_t pairs = 0, out_of_reach = 0;

  void run(std::uint64_t wanted);

 private:
  void of(const meaning::Case& random);
  std::string different(const Pair& pair) const;
  void report(const meaning::File& random, const meaning::Values& bicycle, std::size_t claim,
              const std::string& difference);
  /// Empty also where a smaller claim is none.
  std::string different_again(const meaning::File& random, const meaning::Values& bicycle, std::size_t claim) const;

  meaning::RandomClaims random_;
  Compare compare_;
  std::map<std::string, std::uint64_t> differences_;
};

/// The values of a bicycle in the order of the setting's parameters.
std::vector<Rational> in_order(const meaning::Setting& setting, const meaning::Values& bicycle);
/// The file as the product reads it, with the mechanism in a file beside it.
ClaimsFile read(const meaning::File& file);

/// What a comparison finds of the product's judge.
std::string judged_otherwise(const Pair& pair);

/// How many claims of each kind have statements, and how many have refutations.
struct Stated {
  std::map<std::string, std::uint64_t, std::less<>> claims, refutations;
};
/// What a comparison finds of statements: those of a claim say together that it says nothing or is right; its
/// refutation, that it is wrong.
std::string stated_otherwise(const Pair& pair, meaning::Dice& dice, Stated& stated);

}  // namespace slipproof::test
