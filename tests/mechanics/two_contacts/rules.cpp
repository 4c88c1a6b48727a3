#include "mechanics/two_contacts/rules.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/input/text_file.hpp"
#include "mechanics/two_contacts/sets.hpp"

namespace slipproof::test::two_contacts {

namespace {

Item item(std::string text) {
  Item result;
  if (text.front() == '!') result.motion = Item::Motion::absent;
  if (text.front() == '?') result.motion = Item::Motion::either;
  if (result.motion != Item::Motion::there) text.erase(0, 1);
  result.mode = text.substr(0, 2);
  if (text.size() > 2) result.index = std::stoi(text.substr(3));
  return result;
}

}  // namespace

Rules shipped_rules() {
  Rules rules;
  const std::vector<std::string> lines =
      split(read_text_file(SLIPPROOF_SOURCE_DIR "/proofs/two-contacts/rules.csv"), '\n');
  if (lines.at(0) != "state.one,state.two,excluded,statements") throw std::runtime_error("rules.csv: another header");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i], ',');
    if (cells.size() != 4) throw std::runtime_error("rules.csv: not 4 entries: " + lines[i]);
    Rule rule;
    for (const std::string& text : split(cells[2], ' ')) rule.items.push_back(item(text));
    rule.statements = split(cells[3], ' ');
    (cells[0] != "rest" ? rules.belt : cells[1] == "rest" ? rules.rest : rules.alike).push_back(rule);
  }
  return rules;
}

std::string text(const Rule& rule) {
  std::string result;
  for (const Item& i : rule.items) {
    const char* mark = i.motion == Item::Motion::absent ? "!" : i.motion == Item::Motion::either ? "?" : "";
    result += (result.empty() ? "" : " ") + (mark + i.mode) + (i.index ? ":" + std::to_string(*i.index) : "");
  }
  return result;
}

bool meets(const Indices& motions, const Rule& rule, const Indices& body) {
  return std::ranges::all_of(rule.items, [&](const Item& i) {
    const Indices& indices = i.motion == Item::Motion::either ? body : motions;
    const auto found = indices.find(i.mode);
    const bool is_there = found != indices.end();
    if (i.motion == Item::Motion::absent || !is_there) return is_there == (i.motion != Item::Motion::absent);
    return !i.index || *i.index == found->second;
  });
}

std::vector<std::vector<Rule>> without_one(const std::vector<Rule>& rules) {
  std::vector<std::vector<Rule>> result(rules.size(), rules);
  for (std::size_t i = 0; i < rules.size(); ++i) result[i].erase(result[i].begin() + static_cast<std::ptrdiff_t>(i));
  return result;
}

}  // namespace slipproof::test::two_contacts
