// The motions of random bodies on two contacts: the library finds what Cramer's rule finds, and proofs/two-contacts has
// listed the set.
#include <doctest/doctest.h>

#include "mechanics/two_contacts/belt.hpp"
#include "mechanics/two_contacts/random_body.hpp"
#include "mechanics/two_contacts/sets.hpp"
#include "support/how_many.hpp"

namespace slipproof::test::two_contacts {

namespace {

/// Checks bodies with contact one on a belt against the rules.
class OnABelt {
 public:
  void check(const Body& body, const Indices& indices) {
    const Indices named = named_along(body, indices);
    const Modes modes = modes_of(named);
    CAPTURE(text(modes));
    REQUIRE(left_.contains(modes));
    CHECK(left_.at(modes).contains(sum(indices)));
    for (const Rule& rule : rules_) CHECK_MESSAGE(!meets(named, rule), text(rule));
    met_.insert(modes);
    Body other = body;
    for (Rational& force : other.load) force = dice_.number(-500'000'000, 500'000'000);  // on no border
    const auto again = by_cramers_rule(other);
    REQUIRE(again);
    CHECK(sum(*again) == sum(indices));
  }
  std::size_t left() const { return left_.size(); }
  std::size_t met() const { return met_.size(); }
  /// Whether all that are left were met, or are those of mirrored_on_a_belt().
  bool all_occur() const {
    std::set<Modes> occur = met_;
    for (const Example& example : mirrored_on_a_belt()) occur.insert(named_along(example.body, example.modes));
    return occur.size() == left_.size();
  }

 private:
  std::vector<Rule> rules_ = shipped_rules().belt;
  std::map<Modes, std::set<int>> left_ = left_on_a_belt(rules_);
  std::set<Modes> met_;
  Dice dice_{59, 0};
};

}  // namespace

TEST_CASE("random bodies on two contacts have motions that the list has") {
  const std::vector<Example> examples = shipped_sets();
  std::vector<std::set<Modes>> listed, met(all_below.size());
  for (const Below below : all_below) listed.push_back(sets_of(examples, below));
  Library library;
  OnABelt on_a_belt;
  const int wanted = test::how_many("SLIPPROOF_TWO_CONTACTS", 3000);
  RandomBodies random(examples);
  int generic = 0, boundary = 0, special = 0;
  for (int i = 0; i < wanted; ++i) {
    const Body body = random.body(static_cast<std::uint64_t>(i));
    CAPTURE(i);
    const auto indices = by_cramers_rule(body);
    if (!indices) {
      ++special;
      continue;
    }
    const Found found = library.solve(body);
    if (found.boundary) {
      ++boundary;
      continue;
    }
    ++generic;
    const auto below = static_cast<std::size_t>(body.below);
    CHECK(text(found.modes) == text(modes_of(*indices)));
    if (body.below == Below::rest) CHECK(sum(*indices) == 1);
    CHECK_MESSAGE(listed[below].contains(found.modes), text(found.modes));
    met[below].insert(found.modes);
    if (body.below == Below::belt) on_a_belt.check(body, *indices);
  }
  CHECK(generic > wanted / 2);
  CHECK(met[0].size() > 200);
  CHECK(met[1].size() > 100);
  CHECK(met[2].size() > 10);
  if (wanted >= 1'000'000) CHECK(on_a_belt.all_occur());
  MESSAGE(wanted << " bodies: " << generic << " generic, " << boundary << " with a motion on a boundary, " << special
                 << " not generic; of " << listed[0].size() << ", " << listed[1].size() << ", " << listed[2].size()
                 << " sets they have " << met[0].size() << ", " << met[1].size() << ", " << met[2].size()
                 << "; named along the motion, " << on_a_belt.met() << " of " << on_a_belt.left() << " on a belt");
}

}  // namespace slipproof::test::two_contacts
