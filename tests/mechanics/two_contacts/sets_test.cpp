// The sets of motions that proofs/two-contacts lists, each with its body.
#include "mechanics/two_contacts/sets.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "mechanics/two_contacts/table.hpp"
#include "support/files/made_again.hpp"

namespace slipproof::test::two_contacts {

TEST_CASE("each set of motions of a body on two contacts is that of its body, and none is there twice") {
  const std::vector<Example> examples = shipped_sets();
  std::vector<Example> all = mirrored_on_a_belt();
  all.insert(all.end(), examples.begin(), examples.end());
  Library library;
  for (const Example& example : all) {
    CAPTURE(text(example.modes));
    const Found found = library.solve(example.body);
    CHECK(text(found.modes) == text(example.modes));
    CHECK_FALSE(found.boundary);
    const auto again = by_cramers_rule(example.body);
    REQUIRE(again);
    CHECK(text(modes_of(*again)) == text(example.modes));
    if (example.body.below == Below::rest) CHECK(sum(*again) == 1);
  }
  CHECK(examples.size() == 310 + 128 + 16);
  struct Expected {
    Below below;
    std::size_t sets, with_other_names, up_to_names;
  };
  for (const Expected& expected :
       {Expected{Below::rest, 310, 314, 57}, {Below::belt, 128, 130, 75}, {Below::belts, 16, 16, 12}}) {
    const std::set<Modes> sets = sets_of(examples, expected.below);
    CHECK(sets.size() == expected.sets);
    std::set<Modes> with_other_names;
    for (const Modes& modes : sets) with_other_names.merge(names_of(modes, expected.below));
    CHECK(with_other_names.size() == expected.with_other_names);
    CHECK(up_to_names(examples, expected.below).size() == expected.up_to_names);
    CHECK(sets.contains({}) == (expected.below != Below::rest));
    for (const Modes& modes : sets) {  // the same bodies, exchanged and in a mirror
      if (expected.below != Below::belt) CHECK(sets.contains(exchanged(modes)));
      if (expected.below == Below::rest) CHECK(sets.contains(flipped(flipped(modes, 0), 1)));
    }
  }
}

TEST_CASE("the table of two contacts and its picture are those of its sets") {
  const std::filesystem::path folder = SLIPPROOF_SOURCE_DIR "/proofs/two-contacts";
  CHECK(is_made_again(folder / "table.txt", table_text(shipped_sets())));
  CHECK(is_made_again(folder / "table.svg", table_picture(shipped_sets())));
}

}  // namespace slipproof::test::two_contacts
