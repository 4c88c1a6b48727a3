// proofs/two-contacts/rules.csv: what the statements exclude, and that nothing else is missing from sets.csv.
#include "mechanics/two_contacts/rules.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mechanics/two_contacts/sets.hpp"
#include "proofs/check/files.hpp"
#include "support/run_program.hpp"

namespace slipproof::test::two_contacts {

namespace {

const std::filesystem::path folder = SLIPPROOF_SOURCE_DIR "/proofs/two-contacts";

std::string turned(std::string mode) {
  for (char& c : mode) c = c == '+' ? '-' : c == '-' ? '+' : c;
  return mode;
}

/// Each rule, with the contacts exchanged, and with both directions exchanged.
std::vector<Rule> with_images(const std::vector<Rule>& rules) {
  std::vector<Rule> all;
  for (const Rule& rule : rules) {
    for (const bool exchange : {false, true}) {
      for (const bool turn : {false, true}) {
        Rule image = rule;
        for (Item& i : image.items) {
          if (exchange) std::swap(i.mode[0], i.mode[1]);
          if (turn) i.mode = turned(i.mode);
        }
        all.push_back(image);
      }
    }
  }
  return all;
}

/// Whether its modes have indices that add up to 1 and meet no rule.
bool is_left(const std::vector<std::string>& modes, const std::vector<Rule>& rules, std::size_t known,
             Indices& indices) {
  if (known == modes.size()) {
    return sum(indices) == 1 && std::ranges::none_of(rules, [&](const Rule& rule) { return meets(indices, rule); });
  }
  const std::string& mode = modes[known];
  const bool one_way = mode == "SO" || mode == "OS" || mode == "OO";
  for (const int index : mode == "SS" ? std::vector{1, 0, -1} : one_way ? std::vector{1} : std::vector{1, -1}) {
    indices[mode] = index;
    if (is_left(modes, rules, known + 1, indices)) return true;
  }
  indices.erase(mode);
  return false;
}

template <class Use>
void for_each_subset(const std::vector<std::string>& modes, Use use) {
  for (std::size_t bits = 0; bits < std::size_t{1} << modes.size(); ++bits) {
    std::vector<std::string> subset;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      if ((bits >> i & 1) != 0) subset.push_back(modes[i]);
    }
    use(subset);
  }
}

/// The sets of the ten modes that the rules leave. Both closed, both contacts slip forwards or both backwards.
std::set<Modes> left_at_rest(const std::vector<Rule>& rules) {
  const std::vector<Rule> all = with_images(rules);
  std::set<Modes> left;
  for_each_subset({"SS", "SO", "OS", "OO", "+O", "-O", "O+", "O-", "++", "--"},
                  [&](const std::vector<std::string>& modes) {
                    Indices indices;
                    if (is_left(modes, all, 0, indices)) left.emplace(modes.begin(), modes.end());
                  });
  return left;
}

/// The modes in a statement's line "# A: slip+/lift, B: lift/lift"; nothing if it does not name modes only.
std::optional<Modes> modes_of_statement(const std::string& name) {
  static const std::map<std::string, char> letters{{"stick", 'S'}, {"slip+", '+'},   {"slip-", '-'},
                                                   {"lift", 'O'},  {"slides+", '+'}, {"slides-", '-'}};
  for (const std::string& line : split(test::read_file(folder / "by-hand.theorems" / (name + ".statement")), '\n')) {
    if (!line.starts_with("# A: ")) continue;
    Modes modes;
    for (const std::string& part : split(line.substr(2), ',')) {
      const std::vector<std::string> states = split(part.substr(part.find(':') + 2), '/');
      if (states.size() != 2 || !letters.contains(states[0]) || !letters.contains(states[1])) return std::nullopt;
      modes.insert({letters.at(states[0]), letters.at(states[1])});
    }
    return modes;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("two contacts at rest: the indices and the rules leave the sets that occur, and no others") {
  std::set<Modes> occur, all;
  for (const Modes& modes : sets_of(shipped_sets(), Below::rest)) occur.merge(names_of(modes, Below::rest));
  const std::set<Modes> left = left_at_rest(shipped_rules().rest);
  for (const Modes& modes : left) {
    all.insert(modes);
    all.insert(flipped(modes, 1));
  }
  CHECK(left.size() == 204);
  CHECK(all == occur);
}

TEST_CASE("two contacts at rest: with slips counted alike, what the rules leave is what the list has") {
  const Rules rules = shipped_rules();
  std::vector<Rule> same_side = rules.rest;
  same_side.insert(same_side.end(), rules.alike.begin(), rules.alike.end());
  std::set<Modes> left = left_at_rest(same_side);
  for (const Modes& modes : left_at_rest(rules.rest)) left.insert(flipped(modes, 1));  // pressed from both sides
  CHECK(left == sets_of(shipped_sets(), Below::rest));
}

TEST_CASE("two contacts at rest: each rule is needed") {
  const std::vector<Rule> rules = shipped_rules().rest;
  const std::vector<std::vector<Rule>> others = without_one(rules);
  for (std::size_t i = 0; i < rules.size(); ++i) {
    CAPTURE(text(rules[i]));
    CHECK(left_at_rest(others[i]).size() > 204);
  }
}

TEST_CASE("the rules name all statements, and each has a certificate that is accepted") {
  const Rules rules = shipped_rules();
  std::set<std::string> found, named;
  for (const std::vector<Rule>& of : {rules.rest, rules.alike, rules.belt}) {
    for (const Rule& rule : of) named.insert(rule.statements.begin(), rule.statements.end());
  }
  const check::Report report = check::check_files({(folder / "by-hand.theorems").string()});
  for (const check::FileResult& result : report.results) {
    found.insert(result.theorem);
    CHECK(result.verdict == check::Verdict::accepted);
  }
  CHECK(found == named);
}

TEST_CASE("a rule with one statement names the modes of the statement, or of an image") {
  const Rules rules = shipped_rules();
  int compared = 0;
  for (const std::vector<Rule>& of : {rules.rest, rules.alike, rules.belt}) {
    for (const Rule& rule : of) {
      if (rule.statements.size() != 1) continue;
      const auto modes = modes_of_statement(rule.statements.front());
      if (!modes) continue;
      ++compared;
      CAPTURE(text(rule));
      CHECK(std::ranges::any_of(with_images({rule}), [&](const Rule& image) {
        Modes named;
        for (const Item& i : image.items) {
          if (i.motion != Item::Motion::either) named.insert(i.mode);
        }
        return named == *modes;
      }));
    }
  }
  CHECK(compared == 40);
}

}  // namespace slipproof::test::two_contacts
