// Sets of the eight modes are bits here, in the order of belt_modes.
#include "mechanics/two_contacts/belt.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace slipproof::test::two_contacts {

namespace {

using Set = unsigned;
constexpr Set all_sets = 256;

Set bit(const std::string& mode) {
  return Set{1} << (std::ranges::find(belt_modes, mode) - belt_modes.begin());
}

/// Pairs of modes whose loads have a border in common: they differ in one contact, and not in its direction only.
std::vector<std::pair<Set, Set>> borders() {
  std::vector<std::pair<Set, Set>> result;
  for (const std::string& a : belt_modes) {
    for (const std::string& b : belt_modes) {
      const bool one = a[0] != b[0], two = a[1] != b[1];
      const bool reverse = two && a[1] != 'S' && b[1] != 'S' && a[1] != 'O' && b[1] != 'O';
      const bool stick_lift = two && ((a[1] == 'S' && b[1] == 'O') || (a[1] == 'O' && b[1] == 'S'));
      if (a < b && one != two && !reverse && !stick_lift) result.emplace_back(bit(a), bit(b));
    }
  }
  return result;
}

/// Each choice of an index for each mode: the modes with index -1. Where contact one lifts and contact two does not
/// slip, the index is 1.
std::vector<Set> choices() {
  std::vector<Set> result;
  for (Set negative = 0; negative < all_sets; ++negative) {
    if ((negative & (bit("OO") | bit("OS"))) == 0) result.push_back(negative);
  }
  return result;
}

int sum_of_set(Set set, Set negative) {
  return std::popcount(set & ~negative) - std::popcount(set & negative);
}

/// A rule for bits.
struct Masks {
  Set there = 0, absent = 0, positive = 0, negative = 0;

  explicit Masks(const Rule& rule) {
    for (const Item& i : rule.items) {
      if (i.motion == Item::Motion::there) there |= bit(i.mode);
      if (i.motion == Item::Motion::absent) absent |= bit(i.mode);
      if (i.index) (*i.index > 0 ? positive : negative) |= bit(i.mode);
    }
  }
  bool excludes(Set set, Set negative_modes) const {
    return (set & there) == there && (set & absent) == 0 && (positive & negative_modes) == 0 &&
           (negative & ~negative_modes) == 0;
  }
};

/// Whether there are sets on the two sides of the border of two modes. Where the indices are equal, one motion becomes
/// the other; else both appear, or disappear. Other motions stay.
bool is_met(const std::set<Set>& sets, const std::pair<Set, Set>& border, Set negative) {
  const auto& [a, b] = border;
  const bool equal = ((negative & a) != 0) == ((negative & b) != 0);
  for (Set others = 0; others < all_sets; ++others) {
    if ((others & (a | b)) != 0) continue;
    const Set here = equal ? others | a : others, there = equal ? others | b : others | a | b;
    if (sets.contains(here) && sets.contains(there)) return true;
  }
  return false;
}

Modes modes_in(Set set) {
  Modes result;
  for (const std::string& mode : belt_modes) {
    if ((set & bit(mode)) != 0) result.insert(mode);
  }
  return result;
}

}  // namespace

std::map<Modes, std::set<int>> left_on_a_belt(const std::vector<Rule>& rules) {
  const std::vector<Masks> masks(rules.begin(), rules.end());
  std::map<Modes, std::set<int>> left;
  for (const Set negative : choices()) {
    std::map<int, std::set<Set>> by_sum;
    for (Set set = 0; set < all_sets; ++set) {
      const auto excludes = [&](const Masks& rule) { return rule.excludes(set, negative); };
      if (std::ranges::none_of(masks, excludes)) by_sum[sum_of_set(set, negative)].insert(set);
    }
    for (const auto& [total, sets] : by_sum) {
      const auto met = [&, &sets = sets](const auto& border) { return is_met(sets, border, negative); };
      if (!std::ranges::all_of(borders(), met)) continue;
      for (const Set set : sets) left[modes_in(set)].insert(total);
    }
  }
  return left;
}

Modes named_along(const Body& body, const Modes& modes) {
  return slip_alike(body) ? modes : flipped(modes, 1);
}

Indices named_along(const Body& body, const Indices& indices) {
  if (slip_alike(body)) return indices;
  Indices result;
  for (const auto& [mode, index] : indices) result.emplace(*flipped({mode}, 1).begin(), index);
  return result;
}

}  // namespace slipproof::test::two_contacts
