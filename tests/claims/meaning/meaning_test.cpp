// The product's judge, and the statements that it writes, against the second judge, which was written from
// proofs/MEANING.md alone.
#include <doctest/doctest.h>

#include "claims/meaning/comparison.hpp"
#include "claims/meaning/random/random_kinds.hpp"
#include "claims/paper/claim_kind.hpp"
#include "support/how_many.hpp"

using namespace slipproof;

namespace {

using meaning::Says;
using test::Comparison;

constexpr std::uint64_t quick = test::quick(200, 80);

void compare_judgements(bool mechanisms, std::uint64_t seed) {
  Comparison comparison(meaning::RandomClaims(seed, mechanisms), test::judged_otherwise);
  comparison.run(test::how_many<std::uint64_t>("SLIPPROOF_MEANING_CLAIMS", mechanisms ? 2 * quick : quick));
  if (comparison.pairs < (mechanisms ? 20'000 : 2'000)) return;  // too few to see every end of every kind
  for (const std::string& kind : meaning::kinds) {
    for (const Says says : {Says::nothing, Says::no_value, Says::right, Says::wrong}) {
      if (kind == "exists" && says == Says::wrong) continue;  // at one bicycle it never is
      CAPTURE(kind);
      CAPTURE(name(says));
      CHECK(comparison.counts[kind][says] * (mechanisms ? 10'000 : 2000) >= comparison.pairs);
    }
  }
}

void compare_statements(bool mechanisms, std::uint64_t seed) {
  meaning::Dice dice(2);
  test::Stated stated;
  Comparison comparison(meaning::RandomClaims(seed, mechanisms),
                        [&](const test::Pair& pair) { return test::stated_otherwise(pair, dice, stated); });
  comparison.run(test::how_many<std::uint64_t>("SLIPPROOF_MEANING_STATEMENTS", mechanisms ? quick : quick / 2));
  if (comparison.pairs < 1'000) return;  // too few to see every kind
  for (const ClaimKind* known : claim_kinds()) {
    const std::string kind(known->name());
    CAPTURE(kind);
    CHECK(stated.claims[kind] * 500 >= comparison.pairs);
    if (kind != "limit") CHECK(stated.refutations[kind] * 500 >= comparison.pairs);
  }
}

}  // namespace

TEST_CASE("random claims are judged as the page on their meaning says") {
  compare_judgements(false, 1);
}

TEST_CASE("random claims about random mechanisms are judged as the page says") {
  compare_judgements(true, 5);
}

TEST_CASE("statements are true where the page on the meaning of claims says so") {
  compare_statements(false, 3);
}

TEST_CASE("statements about random mechanisms are true where the page says so") {
  compare_statements(true, 7);
}
