// The table of proofs/two-contacts: which motions occur together at rest, a row for the sets that differ only in names.
#pragma once

#include <string>
#include <vector>

#include "mechanics/two_contacts/sets.hpp"

namespace slipproof::test::two_contacts {

/// What table.txt should contain: a line for each of up_to_names() at rest, a column for each mode.
std::string table_text(const std::vector<Example>& examples);

/// What table.svg should contain: the same rows as a picture. Its columns stand in groups: both contacts stick, one
/// sticks, both slip, one slips, both open.
std::string table_picture(const std::vector<Example>& examples);

}  // namespace slipproof::test::two_contacts
