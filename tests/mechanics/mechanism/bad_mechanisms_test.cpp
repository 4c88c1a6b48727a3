#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "mechanics/checks/checks.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/scene/scene.hpp"
#include "program/bad_input/table.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::string folder = SLIPPROOF_SOURCE_DIR "/tests/mechanics/mechanism/";

/// Every row says what the table has, and no row is there twice.
template <class Read>
void check_table(const std::string& file, std::size_t at_least, Read&& read) {
  const auto rows = read_bad_inputs(folder + file);
  CHECK(rows.size() >= at_least);
  std::set<std::string> names;
  for (const BadInput& row : rows) {
    CAPTURE(row.what);
    CHECK(names.insert(row.what).second);
    const auto messages = said(row, read);
    for (std::size_t i = 0; i < std::max(messages.size(), row.says.size()); ++i) {
      const std::string expected = i < row.says.size() ? row.says[i] : "nothing more";
      const std::string found = i < messages.size() ? messages[i] : "nothing more";
      CHECK(found == expected);
    }
  }
}

/// The good text of a table.
std::string good_text(const std::string& file) {
  Mistakes mistakes(file);
  const auto table = parse_toml(read_text_file(folder + file), mistakes);
  REQUIRE(table);
  return table->find("good")->value.text.text();
}

/// A sum of symbols that nobody knows, in brackets.
std::string unknown_symbols(int from, int to) {
  if (to - from == 1) return "q" + std::to_string(from);
  const int middle = (from + to) / 2;
  return "(" + unknown_symbols(from, middle) + "+" + unknown_symbols(middle, to) + ")";
}

void read_good_scene(const std::string& text) {
  parse_scene(text, "scene.toml");
}

}  // namespace

TEST_CASE("every malformed mechanism gets its messages") {
  check_table("bad_mechanisms.toml", 60, [](const std::string& text) { parse_mechanism(text, "bad.toml"); });
  CHECK_NOTHROW(parse_mechanism(good_text("bad_mechanisms.toml"), "good.toml"));
}

TEST_CASE("every suspicious mechanism gets its warnings") {
  const auto warn = [](const std::string& text) {
    const Mechanism m = parse_mechanism(text, "suspicious.toml");
    std::vector<Diagnostic> warnings;
    for (const MechanismFinding& finding : check_mechanism(m)) {
      if (finding.checkable) warnings.push_back({m.file, finding.place.line, finding.place.column, finding.message});
    }
    if (!warnings.empty()) throw InputError(warnings);
  };
  check_table("suspicious_mechanisms.toml", 40, warn);
  CHECK_NOTHROW(warn(good_text("suspicious_mechanisms.toml")));
}

TEST_CASE("every malformed scene of a mechanism gets its messages") {
  check_table("bad_scenes.toml", 25, read_good_scene);
  CHECK_NOTHROW(read_good_scene(good_text("bad_scenes.toml")));
}

TEST_CASE("a mistake that is made many times is told at once and in time") {
  std::string text = good_text("bad_mechanisms.toml");
  for (int i = 0; i < 3000; ++i) text += "[[contact]]\nname = \"c" + std::to_string(i) + "\"\ngap = \"ay\"\n";
  CHECK_THROWS_AS(parse_mechanism(text, "many.toml"), InputError);
  std::string large = good_text("bad_mechanisms.toml");
  std::string definitions = "d0 = \"m\"\n";
  for (int i = 1; i < 100; ++i) {
    const std::string before = "d" + std::to_string(i - 1);
    definitions += "d" + std::to_string(i) + " = \"" + before + "*" + before + "\"\n";
  }
  const std::string header = "[definitions]\n";
  large.insert(large.find(header) + header.size(), definitions);
  try {
    parse_mechanism(large, "large.toml");
    CHECK(false);
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).find("too large to evaluate") != std::string::npos);
  }
}

TEST_CASE("no bytes crash the readers") {
  std::mt19937 random(11);
  const std::string scene = good_text("bad_scenes.toml");
  std::vector<std::string> texts{good_text("bad_mechanisms.toml"), scene};
  for (const ShippedMechanism& shipped : shipped_mechanisms()) texts.emplace_back(shipped.text);
  const std::string bytes = "\"[]{}=\n*+-/^()<>.,# \t_aFmNS019\\\x01\xff";
  std::size_t read = 0, refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = texts[random() % texts.size()];
    for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t position = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[position] = bytes[random() % bytes.size()];
          break;
        case 1:
          text.erase(position, 1 + random() % 12);
          break;
        default:
          text.insert(position, text.substr(random() % text.size(), random() % 40));
          break;
      }
    }
    try {
      if (text.starts_with(scene.substr(0, 4))) read_good_scene(text);
      parse_mechanism(text, "bytes.toml");
      ++read;
    } catch (const InputError& error) {
      CHECK(!error.diagnostics().empty());
      ++refused;
    }
  }
  CHECK(read > 100);
  CHECK(refused > 1000);
}

TEST_CASE("a large file of mistakes is refused without delay") {
  std::string names, definitions;
  for (int i = 0; i < 900; ++i) names += "p" + std::to_string(i) + " = \"real\"\n";
  for (int i = 0; i < 900; ++i) {  // each needs the next, and ninety have hundreds of unknown symbols each
    definitions += "d" + std::to_string(i) + " = \"d" + std::to_string(i + 1) + " + " +
                   (i % 10 == 0 ? unknown_symbols(i * 1000, i * 1000 + 700) : "1") + "\"\n";
  }
  const std::string text = "schema = \"slipproof/mechanism/1\"\nname = \"large\"\n[parameters]\n" + names +
                           "[definitions]\n" + definitions +
                           "[unknowns]\naccelerations = [\"ax\"]\n[motion]\nax = \"ax = 0\"\n";
  CHECK_THROWS_AS(parse_mechanism(text, "large.toml"), InputError);
}
