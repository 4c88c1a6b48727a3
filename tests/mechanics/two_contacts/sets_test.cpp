// The sets of motions that proofs/two-contacts lists, each with its body.
#include "mechanics/two_contacts/sets.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "mechanics/two_contacts/table.hpp"
#include "support/run_program.hpp"

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

// SLIPPROOF_WRITE_TABLE, if set, writes both files anew.
TEST_CASE("the table of two contacts and its picture are those of its sets") {
  const auto compare = [](const std::string& name, const std::string& contents) {
    CAPTURE(name);
    const std::filesystem::path file = std::filesystem::path(SLIPPROOF_SOURCE_DIR "/proofs/two-contacts") / name;
    if (std::getenv("SLIPPROOF_WRITE_TABLE") != nullptr) std::ofstream(file, std::ios::binary) << contents;
    const bool same = contents == read_file(file);
    CHECK(same);
  };
  compare("table.txt", table_text(shipped_sets()));
  compare("table.svg", table_picture(shipped_sets()));
}

}  // namespace slipproof::test::two_contacts
