// Claims whose force's domain depends on parameters: it may be empty, no interval, or without a value
// (proofs/MEANING.md, "Without a force").
#include <doctest/doctest.h>

#include "claims/identity/identity.hpp"
#include "claims/identity/vacuous.hpp"
#include "claims/meaning/comparison.hpp"
#include "support/how_many.hpp"

using namespace slipproof;

namespace {

using meaning::Says;

constexpr std::uint64_t quick_pairs = test::quick(120, 60);

/// How often something was proved without samples.
struct Settled {
  std::uint64_t vacuous = 0, identities = 0;
};

/// What is proved vacuous says nothing, and what is proved by an identity is right or says nothing.
std::string settled_otherwise(const test::Pair& pair, Settled& settled) {
  LemmaBook book(
      {.split_depth = 1, .slack_attempts = 20, .products = 0, .quick_samples = 0, .samples = 0, .steps = 20'000});
  const CompiledClaims compiled(pair.file);
  if (pair.file.claims[pair.claim].kind().traits().seeks) return "";
  const bool vacuous = is_vacuous(pair.file, pair.claim, Reading::printed, book);
  settled.vacuous += vacuous ? 1 : 0;
  if (vacuous && pair.says != Says::nothing) return "it is proved vacuous";
  const auto identity = find_identity(pair.file, compiled, pair.claim, Reading::printed, &book);
  const bool proved = identity && identity->proved();
  settled.identities += proved ? 1 : 0;
  if (proved && pair.says != Says::nothing && pair.says != Says::right) return "it is a proved identity";
  return "";
}

void compare(bool mechanisms, std::uint64_t seed) {
  meaning::Dice dice(seed);
  test::Stated stated;
  Settled settled;
  test::Comparison comparison(meaning::RandomClaims(seed, mechanisms, meaning::RandomClaims::Domain::of_parameters),
                              [&](const test::Pair& pair) {
                                std::string difference = test::judged_otherwise(pair);
                                if (difference.empty()) difference = settled_otherwise(pair, settled);
                                return difference.empty() ? test::stated_otherwise(pair, dice, stated) : difference;
                              });
  const auto pairs = test::how_many<std::uint64_t>("SLIPPROOF_FORCE_DOMAINS", quick_pairs);
  comparison.run(pairs);
  MESSAGE(settled.vacuous << " proved vacuous, " << settled.identities << " proved by identities");
  if (pairs < 5'000) return;  // too few to see both
  CHECK(settled.vacuous * 50 >= pairs);
  CHECK(settled.identities * 1000 >= pairs);
}

}  // namespace

TEST_CASE("claims are judged, stated and settled as the page says, whatever the domain of the force is") {
  compare(false, 11);
}

TEST_CASE("claims about random mechanisms are judged, stated and settled as the page says, whatever the domain is") {
  compare(true, 12);
}
