#include <doctest/doctest.h>

#include <random>
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
  check_bad_inputs(folder + "bad_mechanisms.toml", 60,
                   [](const std::string& text) { parse_mechanism(text, "bad.toml"); });
  CHECK_NOTHROW(parse_mechanism(good_input(folder + "bad_mechanisms.toml"), "good.toml"));
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
  check_bad_inputs(folder + "suspicious_mechanisms.toml", 40, warn, 0);
  CHECK_NOTHROW(warn(good_input(folder + "suspicious_mechanisms.toml")));
}

TEST_CASE("every malformed scene of a mechanism gets its messages") {
  check_bad_inputs(folder + "bad_scenes.toml", 25, read_good_scene);
  CHECK_NOTHROW(read_good_scene(good_input(folder + "bad_scenes.toml")));
}

TEST_CASE("a mistake that is made many times is told at once and in time") {
  std::string text = good_input(folder + "bad_mechanisms.toml");
  for (int i = 0; i < 3000; ++i) text += "[[contact]]\nname = \"c" + std::to_string(i) + "\"\ngap = \"ay\"\n";
  CHECK_THROWS_AS(parse_mechanism(text, "many.toml"), InputError);
  std::string large = good_input(folder + "bad_mechanisms.toml");
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
  const std::string scene = good_input(folder + "bad_scenes.toml");
  std::vector<std::string> texts{good_input(folder + "bad_mechanisms.toml"), scene};
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
