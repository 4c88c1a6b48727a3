// proofs/two-contacts/rules.csv: what the statements exclude.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mechanics/two_contacts/body.hpp"

namespace slipproof::test::two_contacts {

/// A mode that a rule names. `+O` has a motion, `+O:1` has one and this index, `!+O` has none, and `?+O:1` has this
/// index, with a motion or without.
struct Item {
  std::string mode;
  std::optional<int> index;
  enum class Motion { there, absent, either } motion = Motion::there;
};
struct Rule {
  std::vector<Item> items;
  std::vector<std::string> statements;
};

struct Rules {
  std::vector<Rule> rest, belt;
  std::vector<Rule> alike;  ///< from rest, where both contacts press from the same side of the line through them
};
/// Reads the file. Throws std::runtime_error for another header or a line that has more or fewer entries.
Rules shipped_rules();
std::string text(const Rule& rule);

/// Whether these motions are what the rule excludes. `body` has the indices of all modes, for rules with `?`; without
/// it these exclude nothing.
bool meets(const Indices& motions, const Rule& rule, const Indices& body = {});

/// The rules without the first, without the second, and so on.
std::vector<std::vector<Rule>> without_one(const std::vector<Rule>& rules);

}  // namespace slipproof::test::two_contacts
