// Contact one on a belt, on which it slides forwards, contact two at rest: which sets of modes the indices and the
// rules leave. Forwards at contact two is the direction in which it slips along while both stay closed.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mechanics/two_contacts/rules.hpp"
#include "mechanics/two_contacts/sets.hpp"

namespace slipproof::test::two_contacts {

inline const std::array<std::string, 8> belt_modes{"OO", "+O", "++", "+-", "+S", "O+", "O-", "OS"};

/// The sets that some body may have by the rules and by the theorem of proofs/two-contacts/README.md: the indices
/// of the motions have the same sum under each load, and each border between two modes is met. To each set the sums.
std::map<Modes, std::set<int>> left_on_a_belt(const std::vector<Rule>& rules);

/// The motions of a body on a belt by the names that left_on_a_belt() uses.
Modes named_along(const Body& body, const Modes& modes);
Indices named_along(const Body& body, const Indices& indices);

}  // namespace slipproof::test::two_contacts
