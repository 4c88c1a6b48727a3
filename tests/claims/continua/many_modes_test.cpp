// Claims of a closed setting about boundary modes, beyond the number of modes that are all tried.
#include <doctest/doctest.h>

#include <string>

#include "claims/judge/judge.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "mechanics/family/solved_sample.hpp"

using namespace slipproof;

TEST_CASE("a table on six feet rests in a mode at its border, and in no other motion") {
  std::string text =
      "schema = \"slipproof/claims/1\"\npaper = { title = \"x\", authors = [\"x\"], source = \"x\" }\n"
      "[[setting]]\nid = \"b\"\nmechanism = \"six-feet.toml\"\nmotions = \"closed\"\n[setting.parameters]\n";
  for (const char* symbol : {"m", "a", "mu", "g"}) {
    text += std::string(symbol) + " = { domain = \"" + symbol + " > 0\", meaning = \"x\" }\n";
  }
  const auto claim = [&](const std::string& id, const std::string& says) {
    text += "[[claim]]\nid = \"" + id + "\"\nline = 1\nstatement = \"x\"\n" + says +
            "\nforces = \"-mu*m*g <= F and F <= mu*m*g\"\n";
  };
  claim("lifted", "kind = \"interval\"\nmode = \"lift/stick/stick/stick/stick/stick\"");
  claim("right", "kind = \"motions\"\nmodes = [\"lift/stick/stick/stick/stick/stick\"]");
  claim("both",
        "kind = \"motions\"\nmodes = [\"lift/stick/stick/stick/stick/stick\", \"stick/lift/stick/stick/stick/lift\"]");
  claim("wrong", "kind = \"motions\"\nmodes = [\"lift/lift/lift/stick/stick/stick\"]");
  claim("unique", "kind = \"unique\"\nclaims = [\"lifted\"]");
  const ClaimsFile file = parse_claims(text, SLIPPROOF_SOURCE_DIR "/tests/claims/continua/claims.toml");
  const CompiledClaims compiled(file);
  const auto sample = SolvedSample::make(compiled.settings[0], {2, 1, Rational(1, 2), 10});
  REQUIRE(sample);
  const auto outcome = [&](std::size_t claim) {
    return judge(file, compiled, claim, Reading::printed, *sample).outcome;
  };
  CHECK(outcome(0) == Outcome::holds);
  CHECK(outcome(1) == Outcome::holds);
  CHECK(outcome(2) == Outcome::holds);
  CHECK(outcome(3) == Outcome::refuted);
  CHECK(outcome(4) == Outcome::holds);
}
