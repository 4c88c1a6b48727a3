// proofs/two-contacts/rules.csv and sets.csv for contact one on a belt: what no rule excludes occurs.
#include "mechanics/two_contacts/belt.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace slipproof::test::two_contacts {

namespace {

/// These sets, and those with the other name of forwards at contact two.
std::set<Modes> with_both_names(const std::map<Modes, std::set<int>>& sets) {
  std::set<Modes> result;
  for (const auto& [modes, sums] : sets) result.merge(names_of(modes, Below::belt));
  return result;
}

bool includes(const Modes& set, const Modes& part) {
  return std::ranges::includes(set, part);
}

}  // namespace

TEST_CASE("one contact on a belt: the indices and the rules leave the sets that occur, and no others") {
  const auto left = left_on_a_belt(shipped_rules().belt);
  CHECK(left.size() == 117);
  std::set<Modes> occur;
  std::set<int> sums, sums_left;
  for (const Example& example : shipped_sets()) {
    if (example.body.below != Below::belt) continue;
    occur.merge(names_of(example.modes, Below::belt));
    CHECK(left.contains(named_along(example.body, example.modes)));
    const auto indices = by_cramers_rule(example.body);
    REQUIRE(indices);
    sums.insert(sum(*indices));
  }
  CHECK(with_both_names(left) == occur);
  for (const auto& [modes, of_modes] : left) sums_left.insert(of_modes.begin(), of_modes.end());
  CHECK(sums_left == std::set<int>{-1, 0, 1, 2});
  CHECK(sums == sums_left);
}

TEST_CASE("one contact on a belt: each rule is needed") {
  const std::vector<Rule> rules = shipped_rules().belt;
  const std::vector<std::vector<Rule>> others = without_one(rules);
  for (std::size_t i = 0; i < rules.size(); ++i) {
    CAPTURE(text(rules[i]));
    CHECK(left_on_a_belt(others[i]).size() > 117);
  }
}

TEST_CASE("one contact on a belt: five sets exclude each other, and what contains none of them occurs together") {
  const std::vector<Modes> five{
      {"O+", "O-"}, {"++", "+-", "O-"}, {"++", "+S", "O-", "OS"}, {"++", "+S", "O-", "OO"}, {"++", "+O", "O-", "OO"}};
  const auto left = left_on_a_belt(shipped_rules().belt);
  std::set<Modes> occur;
  for (const std::vector<Example>& examples : {shipped_sets(), mirrored_on_a_belt()}) {
    for (const Example& example : examples) {
      if (example.body.below == Below::belt) occur.insert(named_along(example.body, example.modes));
    }
  }
  for (unsigned bits = 0; bits < 256; ++bits) {
    Modes set;
    for (std::size_t i = 0; i < belt_modes.size(); ++i) {
      if ((bits >> i & 1) != 0) set.insert(belt_modes[i]);
    }
    CAPTURE(text(set));
    const bool excluded = std::ranges::any_of(five, [&](const Modes& one) { return includes(set, one); });
    CHECK(excluded == std::ranges::none_of(left, [&](const auto& one) { return includes(one.first, set); }));
    CHECK(excluded == std::ranges::none_of(occur, [&](const Modes& one) { return includes(one, set); }));
  }
}

}  // namespace slipproof::test::two_contacts
