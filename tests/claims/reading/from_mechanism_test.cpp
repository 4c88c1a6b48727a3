// What a setting does not say of its mechanism's parameters, angles and load is as in the mechanism.
#include <doctest/doctest.h>

#include <string>

#include "base/input/diagnostic.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "support/replaced.hpp"

using namespace slipproof;
using test::replaced;

namespace from_mechanism_test {

namespace {

/// A setting of a shipped mechanism, with a claim.
std::string paper(const std::string& setting) {
  return R"(schema = "slipproof/claims/1"
paper = { title = "small", authors = [], source = "none.tex" }
[[setting]]
id = "first"
mechanism = "block-on-incline"
motions = "closed"
)" + setting +
         R"(
[[claim]]
id = "X"
line = 1
statement = "s"
kind = "formula"
holds = "g > 0"
)";
}

/// What is told of the symbols: domains, meanings, and the mechanism's symbols in terms of them.
std::string symbols_of(const std::string& setting) {
  const Setting read = parse_claims(paper(setting), "small.toml").settings.front();
  std::string all;
  for (const FreeParameter& one : read.parameters) {
    all += one.symbol + ": " + to_string(one.domain) + " (" + one.meaning + ")" + (one.angle ? " angle" : "") + "\n";
  }
  for (const FreeAngle& one : read.angles) all += one.name + " " + one.cosine + " " + one.sine + "\n";
  for (const auto& [symbol, value] : read.scene) all += symbol + " = " + to_string(value) + "\n";
  return all + read.force.symbol + ": " + to_string(read.force.domain);
}

std::string refused_with(const std::string& setting) {
  try {
    parse_claims(paper(setting), "small.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// All that the mechanism's file says, again.
const std::string repeated = R"([setting.parameters]
m = { domain = "m > 0", meaning = "mass" }
b = { domain = "b > 0", meaning = "half the length of the base" }
h = { domain = "h > 0", meaning = "height of the centre of mass above the incline" }
I = { domain = "I > 0", meaning = "moment of inertia about the centre of mass" }
mu_s = { domain = "mu_s >= 0", meaning = "static coefficient of friction" }
mu_k = { domain = "mu_k >= 0", meaning = "kinetic coefficient of friction" }
g = { domain = "g > 0", meaning = "gravity" }
[setting.angles]
theta = { cos = "c", sin = "s", domain = "c > 0 and s >= 0", meaning = "slope, down to the right" }
)";

}  // namespace

TEST_CASE("a setting that says nothing has the mechanism's symbols, domains and meanings") {
  CHECK(symbols_of("") == symbols_of(repeated));
}

TEST_CASE("a setting says what differs") {
  const std::string half = R"([setting.parameters]
mu = { domain = "mu >= 0", meaning = "coefficient" }
h = { domain = "h > 1" }
I = { meaning = "inertia", unit = "kg m^2" }
[setting.scene]
mu_s = "mu"
mu_k = "mu"
)";
  const std::string all = symbols_of(half);
  CAPTURE(all);
  for (const char* line : {"mu: mu >= 0 (coefficient)\n", "h: h > 1 (height of the centre of mass above the incline)\n",
                           "I: I > 0 (inertia)\n", "m: m > 0 (mass)\n", "mu_s = mu\n", "m = m\n", "theta c s\n"}) {
    CHECK(all.find(line) != std::string::npos);
  }
  CHECK(all.find("mu_s: ") == std::string::npos);
}

TEST_CASE("domains of the mechanism are told in the paper's symbols") {
  const std::string file = replaced(
      paper("[setting.parameters]\nL = { domain = \"L > 0\", meaning = \"length\" }\n[setting.scene]\nl = \"L/2\"\n"),
      "block-on-incline", "ladder");
  const Setting read = parse_claims(file, "small.toml").settings.front();
  for (const FreeParameter& one : read.parameters) {
    if (one.symbol == "d") CHECK(to_string(one.domain) == "-(L / 2) <= d and d <= L / 2");
    CHECK(one.symbol != "l");
  }
}

TEST_CASE("what the paper calls by a name of the mechanism is not taken from there") {
  CHECK(refused_with("definition = [{ symbol = \"mu_s\", line = 1, printed = \"1\" }]")
            .find("missing mu_s in [setting.scene], expected an expression over the parameters") != std::string::npos);
  CHECK(refused_with("force = { symbol = \"h\" }\nscene = { F = \"h\" }").find("missing h in [setting.scene]") !=
        std::string::npos);
  CHECK(refused_with("angles = { eta = { cos = \"c\", sin = \"s\" } }")
            .find("missing theta in [setting.scene], expected an angle") != std::string::npos);
}

TEST_CASE("a unit is the mechanism's") {
  const auto with = [](const std::string& parameter) {
    return refused_with("[setting.parameters]\n" + parameter + "\n");
  };
  CHECK(with("I = { unit = \"m^2 kg\" }") == "");
  CHECK(with("I = { unit = \"kg\" }").find("unit: found 'kg', expected that of the mechanism, 'kg m^2'") !=
        std::string::npos);
  CHECK(with("I = { unit = \"kgg\" }").find("unit: found 'kgg', expected a unit such as \"kg m^2\"") !=
        std::string::npos);
  CHECK(with("k = { unit = \"m\", domain = \"k > 0\", meaning = \"k\" }") == "");
  CHECK(with("k = { unit = \"m\" }").find("missing domain in the parameter k") != std::string::npos);
  CHECK(refused_with("force = { symbol = \"F\", unit = \"m\" }")
            .find("unit: found 'm', expected that of the mechanism, 'N'") != std::string::npos);
}

TEST_CASE("a setting may ask a mechanism for its impact by another law") {
  const auto by = [](const std::string& law) {
    return replaced(paper(law), "block-on-incline", SLIPPROOF_SOURCE_DIR "/proofs/impacts/rod.toml");
  };
  const auto law_of = [&](const std::string& law) {
    return parse_claims(replaced(by(law), "g > 0", "m > 0"), "small.toml").settings.front().mechanism->impact->law;
  };
  CHECK(law_of("") == ImpactLaw::newton);  // that of the file
  CHECK(law_of("law = \"moreau\"") == ImpactLaw::moreau);
  CHECK(law_of("law = \"poisson\"") == ImpactLaw::poisson);
  CHECK_THROWS_WITH_AS(parse_claims(by("law = \"hertz\""), "small.toml"),
                       doctest::Contains("law: found 'hertz', expected \"newton\", \"moreau\" or \"poisson\""),
                       InputError);
  CHECK(refused_with("law = \"newton\"").find("found a mechanism by its equations, expected bodies with velocities") !=
        std::string::npos);
}

}  // namespace from_mechanism_test
