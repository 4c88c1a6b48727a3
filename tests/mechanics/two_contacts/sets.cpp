#include "mechanics/two_contacts/sets.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "base/number/parse.hpp"
#include "support/run_program.hpp"

namespace slipproof::test::two_contacts {

namespace {

constexpr const char* header = "state.one,state.two,modes,I,x1,y1,mu1,x2,y2,mu2,theta2.tan_half,X,Y,M";

Below below_of(const std::string& one, const std::string& two) {
  if (one == "rest" && two == "rest") return Below::rest;
  if (one == "slides+" && two == "rest") return Below::belt;
  if (one == "slides+" && two == "slides+") return Below::belts;
  throw std::runtime_error("sets.csv: unknown states " + one + ", " + two);
}

Example example_of(const std::string& line) {
  const std::vector<std::string> entries = split(line, ',');
  if (entries.size() != 14) throw std::runtime_error("sets.csv: not 14 entries: " + line);
  Example result;
  result.body.below = below_of(entries[0], entries[1]);
  for (const std::string& mode : split(entries[2], ' ')) result.modes.insert(mode);
  const auto number = [&](std::size_t i) { return parse_rational(entries[i]); };
  result.body.inertia = number(3);
  for (std::size_t i = 0; i < 2; ++i) {
    Body::Contact& contact = result.body.contacts[i];
    contact.x = number(4 + 3 * i);
    contact.y = number(5 + 3 * i);
    contact.mu = number(6 + 3 * i);
  }
  result.body.set_normals(number(10));
  result.body.load = {number(11), number(12), number(13)};
  return result;
}

/// All modes, in the order of the table.
const std::vector<std::string> all_modes{"SS", "S+", "S-", "SO", "+S", "++", "+-", "+O",
                                         "-S", "-+", "--", "-O", "OS", "O+", "O-", "OO"};

/// For the order: fewer motions first, then those farther left in the table.
std::pair<std::size_t, std::vector<std::size_t>> rank(const Modes& modes) {
  std::vector<std::size_t> places;
  for (const std::string& mode : modes) {
    places.push_back(static_cast<std::size_t>(std::find(all_modes.begin(), all_modes.end(), mode) - all_modes.begin()));
  }
  std::sort(places.begin(), places.end());
  return {places.size(), places};
}

}  // namespace

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string entry; std::getline(stream, entry, at);) result.push_back(entry);
  return result;
}

std::vector<Example> shipped_sets() {
  const std::vector<std::string> lines = split(read_file(SLIPPROOF_SOURCE_DIR "/proofs/two-contacts/sets.csv"), '\n');
  if (lines.empty() || lines[0] != header) throw std::runtime_error("sets.csv: another header");
  std::vector<Example> result;
  for (std::size_t i = 1; i < lines.size(); ++i) result.push_back(example_of(lines[i]));
  return result;
}

std::vector<Example> mirrored_on_a_belt() {
  std::vector<Example> result;
  for (const char* line : {"slides+,rest,++ O- OS OO,1,-5,0,84,-4,-33/2,9,-1/2,244,-57,-14",
                           "slides+,rest,+O ++ +S O-,3,-5,1,41,-4,-9,6,0,7,-1/2,-11/2",
                           "slides+,rest,+O ++ O- OS,1,-5,0,190,-4,-4,5/2,-3/4,27,-3,0",
                           "slides+,rest,+- +S O+,1,7,0,23,4,9,8,2,123,-53,13"}) {
    result.push_back(example_of(line));
  }
  return result;
}

std::set<Modes> sets_of(const std::vector<Example>& examples, Below below) {
  std::set<Modes> result;
  for (const Example& example : examples) {
    if (example.body.below == below) result.insert(example.modes);
  }
  return result;
}

std::set<Modes> names_of(const Modes& modes, Below below) {
  std::set<Modes> names{modes};
  const auto add = [&](const auto& renamed) {
    for (const Modes& name : std::set<Modes>(names)) names.insert(renamed(name));
  };
  if (below == Below::rest) add([](const Modes& m) { return flipped(m, 0); });
  if (below != Below::belts) add([](const Modes& m) { return flipped(m, 1); });
  if (below != Below::belt) add(exchanged);
  return names;
}

std::vector<std::pair<Modes, std::size_t>> up_to_names(const std::vector<Example>& examples, Below below) {
  const auto before = [](const Modes& a, const Modes& b) { return rank(a) < rank(b); };
  std::map<Modes, std::size_t, decltype(before)> counts(before);
  for (const Example& example : examples) {
    if (example.body.below != below) continue;
    const std::set<Modes> names = names_of(example.modes, below);
    counts[*std::min_element(names.begin(), names.end(), before)] = names.size();
  }
  return {counts.begin(), counts.end()};
}

}  // namespace slipproof::test::two_contacts
