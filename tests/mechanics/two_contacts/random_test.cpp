// The motions of random bodies on two contacts: the library finds what Cramer's rule finds, and proofs/two-contacts has
// listed the set.
#include <doctest/doctest.h>

#include "mechanics/two_contacts/random_body.hpp"
#include "mechanics/two_contacts/sets.hpp"
#include "support/how_many.hpp"

namespace slipproof::test::two_contacts {

TEST_CASE("random bodies on two contacts have motions that the list has") {
  const std::vector<Example> examples = shipped_sets();
  std::vector<std::set<Modes>> listed, met(all_below.size());
  for (const Below below : all_below) listed.push_back(sets_of(examples, below));
  Library library;
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
    if (body.below == Below::rest) CHECK(add_up(*indices));
    CHECK_MESSAGE(listed[below].contains(found.modes), text(found.modes));
    met[below].insert(found.modes);
  }
  CHECK(generic > wanted / 2);
  CHECK(met[0].size() > 200);
  CHECK(met[1].size() > 100);
  CHECK(met[2].size() > 10);
  MESSAGE(wanted << " bodies: " << generic << " generic, " << boundary << " with a motion on a boundary, " << special
                 << " not generic; of " << listed[0].size() << ", " << listed[1].size() << ", " << listed[2].size()
                 << " sets they have " << met[0].size() << ", " << met[1].size() << ", " << met[2].size());
}

}  // namespace slipproof::test::two_contacts
