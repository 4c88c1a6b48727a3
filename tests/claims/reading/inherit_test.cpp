// Settings that name only what differs from another.
#include <doctest/doctest.h>

#include "base/input/diagnostic.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "support/replaced.hpp"

using namespace slipproof;

namespace {

const std::string base = R"(schema = "slipproof/claims/1"
[paper]
title = "small"
authors = []
source = "none.tex"
[[setting]]
id = "first"
line = 3
statement = "the first"
motions = "closed"
boundaries = ["b = 1"]
[setting.parameters]
b = { domain = "b > 0", meaning = "b" }
c = { domain = "c > 0", meaning = "c" }
[setting.force]
symbol = "P"
kind = "internal"
domain = "P > 0"
[setting.scene]
M = "1"
R = "1"
h = "b"
b2 = "b"
b3 = "c"
I1 = "0"
I2 = "0"
I3 = "0"
r1 = "1"
r2 = "1"
L = "1"
f = "1"
g = "1"
F = "P"
[setting.realisable]
wide = "b + c > 2"
[[setting.definition]]
symbol = "w"
line = 1
printed = "b + c"
[[setting.definition]]
symbol = "v"
line = 1
printed = "2*w"
)";

std::string setting(const std::string& keys) {
  return "[[setting]]\n" + keys;
}

std::string claims = R"([[claim]]
id = "X"
setting = "first"
line = 1
statement = "s"
kind = "formula"
holds = "b > 0"
)";

ClaimsFile read(const std::string& settings) {
  return parse_claims(base + settings + claims, "small.toml");
}

std::string refused_with(const std::string& settings) {
  try {
    read(settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a setting inherits what it does not name, table by table and key by key") {
  const ClaimsFile file = read(setting(R"(id = "second"
inherits = "first"
[setting.parameters]
c = { domain = "c > 1", meaning = "another" }
d = { domain = "d > 0", meaning = "d" }
[setting.force]
kind = "external"
[setting.scene]
h = "d"
J = "d"
[setting.realisable]
low = "d < 5"
[[setting.definition]]
symbol = "w"
line = 2
printed = "b + c + d"
[[setting.definition]]
symbol = "u"
line = 2
printed = "v/2"
)"));
  REQUIRE(file.settings.size() == 2);
  const Setting &first = file.settings[0], &second = file.settings[1];
  CHECK(second.statement.empty());
  CHECK(second.line == 0);
  CHECK_FALSE(second.strict);
  CHECK(second.boundaries.size() == 1);
  REQUIRE(second.parameters.size() == 3);
  CHECK(to_string(second.parameters[0].domain) == "b > 0");
  CHECK(to_string(second.parameters[1].domain) == "c > 1");
  CHECK(second.parameters[2].symbol == "d");
  CHECK(to_string(second.scene.at("external")) == "1");
  CHECK(second.force.symbol == "P");
  CHECK(to_string(second.scene.at("h")) == "d");
  CHECK(to_string(second.scene.at("b2")) == "b");
  CHECK(second.scene.contains("J"));
  CHECK_FALSE(first.scene.contains("J"));
  REQUIRE(second.realisable.size() == 2);
  CHECK(second.realisable[0].name == "wide");
  REQUIRE(second.definitions.size() == 3);
  CHECK(to_string(second.definitions[0].printed) == "b + c + d");
  CHECK(to_string(second.definitions[1].printed) == "2 * w");
  CHECK(second.definitions[2].symbol == "u");
}

TEST_CASE("settings inherit what others inherited; boundaries are replaced") {
  const ClaimsFile file = read(setting("id = \"second\"\ninherits = \"first\"\nboundaries = []\n") +
                               setting("id = \"third\"\ninherits = \"second\"\n[setting.scene]\nL = \"2\"\n"));
  REQUIRE(file.settings.size() == 3);
  CHECK(file.settings[2].boundaries.empty());
  CHECK(to_string(file.settings[2].scene.at("L")) == "2");
  CHECK(to_string(file.settings[1].scene.at("L")) == "1");
}

TEST_CASE("unknown ids, settings that stand later and circles are mistakes with their places") {
  CHECK(refused_with(setting("id = \"second\"\ninherits = \"frist\"\n"))
            .find("small.toml:46:13: inherits: unknown setting 'frist', did you mean 'first'?") != std::string::npos);
  CHECK(refused_with(setting("id = \"second\"\ninherits = \"third\"\n") +
                     setting("id = \"third\"\ninherits = \"first\"\n"))
            .find("found 'third', which stands later, expected a setting before this one") != std::string::npos);
  const std::string circle = refused_with(setting("id = \"second\"\ninherits = \"third\"\n") +
                                          setting("id = \"third\"\ninherits = \"second\"\n"));
  CHECK(circle.find("found a circle: 'second' inherits 'third' inherits 'second'") != std::string::npos);
  CHECK(refused_with(setting("id = \"second\"\ninherits = \"second\"\n"))
            .find("found a circle: 'second' inherits 'second'") != std::string::npos);
  CHECK(refused_with(setting("id = \"second\"\ninherits = 3\n")).find("inherits") != std::string::npos);
}

TEST_CASE("a mistake in what is inherited is told once") {
  const std::string text = test::replaced(base, "b = 1\"]", "b = zz\"]");
  try {
    parse_claims(text + setting("id = \"second\"\ninherits = \"first\"\n") + claims, "small.toml");
    FAIL("it was read");
  } catch (const InputError& error) {
    const std::string what = error.what();
    CHECK(what.find("'zz'") == what.rfind("'zz'"));
  }
}

TEST_CASE("what can be built is a condition over parameters and definitions") {
  CHECK(refused_with(setting("id = \"second\"\ninherits = \"first\"\nrealisable = { x = \"P > 0\" }\n")).find("P") !=
        std::string::npos);
  CHECK(refused_with(setting("id = \"second\"\ninherits = \"first\"\nrealisable = { x = \"b + 1\" }\n")).find("x") !=
        std::string::npos);
  CHECK(refused_with(setting("id = \"second\"\ninherits = \"first\"\nrealisable = { x = \"v > 0\" }\n")).empty());
}
