// proofs/two-contacts/sets.csv: each set of motions that occurs together, with a body that has it.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mechanics/two_contacts/body.hpp"

namespace slipproof::test::two_contacts {

struct Example {
  Modes modes;
  Body body;
};

/// What stands between the characters `at`.
std::vector<std::string> split(const std::string& text, char at);
/// The lines of the file. Throws std::runtime_error for another header, a line that has more or fewer entries, or an
/// entry that cannot be read.
std::vector<Example> shipped_sets();
/// Four bodies on a belt whose sets the file has in a mirror image only: forwards at contact two is the other way.
std::vector<Example> mirrored_on_a_belt();
/// Their sets, without the bodies.
std::set<Modes> sets_of(const std::vector<Example>& examples, Below below);

/// A set under all names that it may have: slip counts positive to the other side at a contact at rest, or the contacts
/// are exchanged, if there is the same below both.
std::set<Modes> names_of(const Modes& modes, Below below);
/// The listed sets that differ in more than names, each by its first name, with the number of its names.
std::vector<std::pair<Modes, std::size_t>> up_to_names(const std::vector<Example>& examples, Below below);

}  // namespace slipproof::test::two_contacts
