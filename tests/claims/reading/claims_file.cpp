#include <doctest/doctest.h>

#include <algorithm>

#include "base/expression/parser.hpp"
#include "claims/paper/compiled.hpp"
#include "claims/reading/small_paper.hpp"
#include "support/papers/formula.hpp"

using namespace slipproof;
using namespace slipproof::test;

TEST_CASE("a claims file is read as it is written") {
  const ClaimsFile file = parse_claims(small, "claims.toml");
  CHECK(file.paper.title == "A paper");
  CHECK(file.paper.source == "paper.tex");
  REQUIRE(file.settings.size() == 1);
  const Setting& setting = file.settings[0];
  CHECK(setting.strict);
  CHECK(setting.mechanism_name == "bicycle");
  CHECK(same(setting.scene.at("external"), number("0")));
  CHECK(setting.parameters.size() == 2);
  CHECK(same(setting.parameters[1].domain, truth("f >= 0")));
  CHECK(same(setting.scene.at("F"), number("P")));
  CHECK(setting.scene.count("J") == 0);
  REQUIRE(setting.boundaries.size() == 1);
  CHECK(setting.boundaries[0].symbol == "b");
  CHECK(same(setting.definitions[0].printed, number("f*2")));
  CHECK(same(setting.definitions[0].repaired, number("f/2")));
  CHECK_FALSE(setting.definitions[1].repaired);

  REQUIRE(file.claims.size() == 4);
  const Claim& interval = file.claims[0];
  CHECK(interval.line == 12);
  CHECK(interval.printed.mode() == (MechanismMode{ElementState::stick, ElementState::slip_forward}));
  CHECK(same(interval.printed.forces, truth("0 < P < xi")));
  CHECK(file.claims[1].printed.modes.size() == 5);
  CHECK(same(file.claims[1].printed.region, truth("true")));
  CHECK(file.claims[2].printed.claims == References{0});
  CHECK(file.claims[2].printed.except == References{1});
  CHECK(file.find("A4") == &file.claims[3]);
  CHECK(file.find("A5") == nullptr);
}

TEST_CASE("a claim has a second reading where it, or what it builds on, is repaired") {
  const ClaimsFile file = parse_claims(small, "claims.toml");
  CHECK(file.claims[0].repaired);        // uses b1
  CHECK_FALSE(file.claims[1].repaired);  // uses nothing that is repaired
  CHECK(file.claims[2].repaired);        // refers to A1
  CHECK_FALSE(file.claims[3].repaired);

  const ClaimsFile own = parse_claims(replaced(small, "forces = \"P < 3\"\n",
                                               "forces = \"P < 3\"\nexpect = \"refuted\"\nwhy = \"as said "
                                               "elsewhere\"\n[claim.repaired]\nforces = \"P <= 3\"\n"),
                                      "claims.toml");
  REQUIRE(own.claims[1].repaired);
  CHECK(same(own.claims[1].repaired->forces, truth("P <= 3")));
  CHECK(own.claims[1].repaired->modes == own.claims[1].printed.modes);
  CHECK(own.claims[1].printed.expect == Expectation::refuted);
  CHECK(own.claims[1].repaired->expect == Expectation::none);
}

TEST_CASE("both readings are compiled, and share what is the same") {
  const ClaimsFile file = parse_claims(small, "claims.toml");
  const CompiledClaims compiled(file);
  const CompiledSetting& setting = compiled.settings[0];
  Evaluator<Rational> evaluator(setting.scope());
  evaluator.set(CompiledSetting::parameter_slot(0), Rational(3));
  evaluator.set(CompiledSetting::parameter_slot(1), Rational(4));
  CHECK(*evaluator.at(setting.definition_slot(1, Reading::printed)).number == Rational(3, 8));
  CHECK(*evaluator.at(setting.definition_slot(1, Reading::repaired)).number == Rational(3, 2));
  CHECK(evaluator.truth(compiled.claims[0].body(Reading::printed).region) == Truth::no);
  CHECK(evaluator.truth(compiled.claims[0].body(Reading::repaired).region) == Truth::yes);
  REQUIRE(setting.boundaries().size() == 2);
  CHECK(*evaluator.number(setting.boundaries()[0].value).number == 8);
  CHECK(*evaluator.number(setting.boundaries()[1].value).number == 2);
  CHECK(*evaluator.number(*setting.scene().parameters[3]).number == 3);
  CHECK_FALSE(setting.scene().parameters[11]);

  const ClaimsFile plain =
      parse_claims(replaced(small, "repaired = \"f/2\"\nwhy = \"a fraction bar is lost\"\n", ""), "claims.toml");
  const CompiledClaims once(plain);
  CHECK(once.settings[0].definition_slot(1, Reading::printed) ==
        once.settings[0].definition_slot(1, Reading::repaired));
  CHECK(once.settings[0].scope().slots.size() + 2 == setting.scope().slots.size());
}

TEST_CASE("every mistake is told with its place") {
  struct Mistake {
    std::string what, by;
    std::string message;
  };
  const std::vector<Mistake> table{
      {"slipproof/claims/1", "slipproof/claims/2", "claims.toml:1:10: schema: expected \"slipproof/claims/1\""},
      {"schema = \"slipproof/claims/1\"\n", "", "claims.toml:1:1: missing schema, expected \"slipproof/claims/1\""},
      {"title =", "titel =", "claims.toml:3:1: unknown key 'titel' in [paper], did you mean 'title'?"},
      {"source = \"paper.tex\"\n", "",
       "claims.toml:2:2: missing source in [paper], expected the name of the file that line numbers refer to"},
      {"motions = \"strict\"", "motions = \"lax\"",
       "claims.toml:8:11: motions: found 'lax', expected \"strict\" or \"closed\""},
      {"\"b > 0\"", "\"b >> 0\"", "claims.toml:11:20: domain: found `>`, expected a number, a symbol or `(`"},
      {"\"b > 0\"", "\"b + 0\"", "claims.toml:11:19: domain: found a number, expected a comparison or truth value"},
      {"\"b > 0\"", "\"b1 > 0\"", "claims.toml:11:17: domain: found the defined symbol b1, expected parameters only"},
      {"\"f >= 0\"", "\"f >= c\"", "claims.toml:12:22: domain: unknown symbol 'c', expected one of b, f"},
      {"f = { domain = \"f >= 0\", meaning = \"friction\" }", "f = \"f >= 0\"",
       "claims.toml:12:5: f: found a string, expected { domain = ..., meaning = ... }"},
      {"f = { domain", "N3 = { domain",
       "claims.toml:12:1: found 'N3', which is a quantity of every motion, expected another symbol"},
      {"f = { domain", "and = { domain",
       "claims.toml:12:1: found 'and', expected a symbol: a letter, then letters, digits and underscores, and no word "
       "of the language"},
      {"symbol = \"P\"", "symbol = \"b\"", "claims.toml:14:10: found the symbol 'b' a second time in this setting"},
      {"symbol = \"xi\"", "symbol = \"b1\"", "claims.toml:39:10: found the symbol 'b1' a second time in this setting"},
      {"kind = \"internal\"", "kind = \"both\"",
       "claims.toml:15:8: kind: found 'both', expected \"internal\" or \"external\""},
      {"L = \"1\"\n", "",
       "claims.toml:17:10: missing L in [setting.scene], expected an expression over the parameters"},
      {"g = \"10\"", "g = \"P\"", "claims.toml:30:6: g: depends on the force P, expected the same for all forces"},
      {"g = \"10\"", "g = 10", "claims.toml:30:5: g: found a number, expected a string"},
      {"g = \"10\"", "g = \"1e999999\"", "claims.toml:30:"},
      {"\"b = b1\"", "\"b < b1\"", "claims.toml:9:16: boundaries: expected PARAMETER = EXPRESSION"},
      {"\"b = b1\"", "\"xi = b1\"", "claims.toml:9:16: boundaries: unknown parameter 'xi', expected one of b, f"},
      {"\"b = b1\"", "\"b = xi\"", "claims.toml:9:20: boundaries: depends on b itself"},
      {"printed = \"f*2\"", "printed = \"f*2 + xi\"", "claims.toml:35:16: printed: defines b1 by itself"},
      {"printed = \"b/b1\"", "printed = \"b/b11\"",
       "claims.toml:41:14: printed: unknown symbol 'b11', did you mean 'b1'?"},
      {"printed = \"b/b1\"", "printed = \"b/N3\"",
       "claims.toml:41:14: printed: found the quantity N3, which only `holds` of a claim with a mode knows"},
      {"printed = \"b/b1\"", "printed = \"(b/b1\"", "claims.toml:41:17: printed: found the end, expected `)`"},
      {"repaired = \"f/2\"", "repaired = \"f * 2\"",
       "claims.toml:36:12: repaired: expected an expression other than the printed one"},
      {"why = \"a fraction bar is lost\"\n", "",
       "claims.toml:32:1: missing why in [[setting.definition]], expected the reason for the repair"},
      {"line = 11", "line = 0", "claims.toml:40:8: line: expected a line number, an integer from 1"},
      {"line = 11", "line = \"eleven\"", "claims.toml:40:9: line: "},
      {"id = \"A2\"", "id = \"A1\"", "claims.toml:51:6: id: found 'A1' a second time, expected another id"},
      {"id = \"A2\"", "id = \"A 2\"",
       "claims.toml:51:6: id: found 'A 2', expected letters, digits and . _ -, a letter or digit first, at most 40"},
      {"id = \"A2\"", "id = \"-2\"",
       "claims.toml:51:6: id: found '-2', expected letters, digits and . _ -, a letter or digit first, at most 40"},
      {"id = \"A2\"", "id = \"" + std::string(41, 'A') + "\"", "claims.toml:51:6: id: found 'A"},
      {"kind = \"interval\"", "kind = \"intervall\"",
       "claims.toml:46:8: kind: unknown kind 'intervall', did you mean 'interval'?"},
      {"mode = \"stick/slip+\"", "mode = \"stick/slip\"",
       "claims.toml:47:15: mode: unknown state of front 'slip', did you mean 'slip+'?"},
      {"mode = \"stick/slip+\"", "mode = \"stick/*\"",
       "claims.toml:47:8: mode: found 'stick/*', expected one mode, without *"},
      {"mode = \"stick/slip+\"\n", "",
       "claims.toml:42:1: missing mode in [[claim]], expected a contact mode such as \"stick/slip+\""},
      {"\"*/lift\"", "\"*/off\"",
       "claims.toml:55:28: modes: unknown state of front 'off', expected one of *, stick, slip+, slip-, lift"},
      {"modes = [\"stick/stick\", \"*/lift\"]", "modes = [\"stick/stick\", 5]",
       "claims.toml:55:25: modes: found a number, expected a string"},
      {"region = \"b > b1\"", "region = \"b > b1 and xi*P > 1\"",
       "claims.toml:48:25: region: depends on the force P, expected the same for all forces"},
      {"holds = \"a = P/2\"", "holds = \"a = P/2\"\nclaims = [\"A1\"]",
       "claims.toml:71:10: claims: found in [[claim]] of kind formula, which does not have it"},
      {"claims = [\"A1\"]", "claims = [\"A9\"]", "claims.toml:62:12: claims: unknown claim 'A9', did you mean 'A1'?"},
      {"claims = [\"A1\"]", "claims = [\"A2\"]",
       "claims.toml:62:12: claims: found 'A2', expected a claim of kind interval in the same setting"},
      {"except = [\"A2\"]", "except = [\"A1\"]",
       "claims.toml:63:12: except: found 'A1', expected a claim of kind motions in the same setting"},
      {"mode = \"slip-/stick\"\n", "",
       "claims.toml:69:10: holds: found the quantity a, which only `holds` of a claim with a mode knows"},
      {"holds = \"a = P/2\"", "holds = \"a = P/2\"\nexpect = \"true\"",
       "claims.toml:71:10: expect: unknown verdict 'true', expected one of holds, refuted, undecided"},
      {"holds = \"a = P/2\"", "holds = \"a = P/2\"\npart_of = [\"nothing\"]",
       "claims.toml:71:13: part_of: found 'nothing', expected another claim with a grade and no part_of, or "
       "EQUATION.SYMBOL of a definition with a repair"},
      {"holds = \"a = P/2\"", "holds = \"a = P/2\"\ngrade = \"typo\"",
       "claims.toml:71:9: grade: unknown grade 'typo', expected one of misprint, gap, boundary, false"},
      {"holds = \"a = P/2\"", "holds = \"a = P/2\"\nsetting = \"plane\"",
       "claims.toml:71:11: setting: unknown setting 'plane', did you mean 'plain'?"},
      {"holds = \"a = P/2\"", "holds = \"a = P/2\"\n[claim.repaired]\nexpect = \"holds\"",
       "claims.toml:71:8: repaired: found a reading that changes nothing, and no definition that it uses has a repair, "
       "expected a key of the claim with another value"},
      {"holds = \"a = P/2\"", "holds = \"a = P/2\"\n[claim.repaired]\nholds = \"a = P/3\"",
       "claims.toml:64:1: missing why in [[claim]], expected the reason for the repair"},
      {"[[claim]]\nid = \"A4\"", "[[claim]\nid = \"A4\"", "claims.toml:64:"},
  };
  CHECK(mistakes(small).empty());
  for (const Mistake& mistake : table) {
    CAPTURE(mistake.what);
    CAPTURE(mistake.by);
    const auto found = mistakes(replaced(small, mistake.what, mistake.by));
    // A mistake may bring others with it, such as a missing key with a misspelt one.
    const auto told = [&](const std::string& message) { return message.starts_with(mistake.message); };
    CAPTURE(found.empty() ? "accepted" : found[0]);
    CHECK(std::any_of(found.begin(), found.end(), told));
  }
}

TEST_CASE("where a limit begins is an expression without its parameter") {
  const auto limit = [](const std::string& parameter, const std::string& from) {
    return small + "[[claim]]\nid = \"A5\"\nline = 16\nstatement = \"in the limit\"\nkind = \"limit\"\nparameter = \"" +
           parameter + "\"\nholds = \"b > f\"\nfrom = \"" + from + "\"\n";
  };
  const ClaimsFile file = parse_claims(limit("b", "2*f"), "claims.toml");
  CHECK(same(file.claims[4].printed.own.at("from"), number("2*f")));
  CHECK(mistakes(limit("b", "f + xi")) ==
        std::vector<std::string>{"claims.toml:78:13: from: depends on b itself"});  // xi = b/b1
  CHECK(mistakes(limit("b", "P")) ==
        std::vector<std::string>{"claims.toml:78:9: from: depends on the force P, expected the same for all forces"});
  CHECK(mistakes(limit("b", "f +")).size() == 1);
  CHECK(mistakes(replaced(small, "holds = \"a = P/2\"", "holds = \"a = P/2\"\nfrom = \"f\"")) ==
        std::vector<std::string>{"claims.toml:71:8: from: found in [[claim]] of kind formula, which does not have it"});
}

TEST_CASE("all mistakes of a file are told at once") {
  std::string text = replaced(small, "b/b1", "b/");
  text = replaced(text, "\"b > 0\"", "\"b > c\"");
  text = replaced(text, "kind = \"motions\"", "kind = \"motion\"");
  text = replaced(text, "*/lift", "*/left");
  const auto found = mistakes(text);
  CHECK(found.size() >= 3);
  CHECK(found[0].substr(0, 15) == "claims.toml:11:");
  CHECK(found[1].substr(0, 15) == "claims.toml:41:");
  CHECK(found[2].substr(0, 15) == "claims.toml:54:");
}

TEST_CASE("definitions that explode or nest without end are refused, not attempted") {
  const auto chain = [](int length, const std::string& formula) {
    std::string definitions;
    for (int i = 1; i <= length; ++i) {
      const std::string n = std::to_string(i), before = i == 1 ? "b" : "d" + std::to_string(i - 1);
      std::string text = formula;
      for (std::size_t at = text.find('#'); at != text.npos; at = text.find('#')) text.replace(at, 1, before);
      definitions += "[[setting.definition]]\nsymbol = \"d" + n + "\"\nline = 1\nprinted = \"" + text + "\"\n";
    }
    return replaced(small, "[[claim]]", definitions + "[[claim]]");
  };
  const auto refused = [](const std::string& text, const std::string& reason) {
    const auto found = mistakes(text);
    return std::any_of(found.begin(), found.end(),
                       [&](const std::string& message) { return message.find(reason) != std::string::npos; });
  };
  CHECK(mistakes(chain(10, "# + 1/#")).empty());
  CHECK(refused(chain(20, "#*#"), "too large to evaluate"));
  CHECK(refused(chain(5, "#^64"), "too large to evaluate"));
  CHECK(refused(chain(900, std::string(100, '-') + "#"), "nested more than 1000"));
  CHECK(refused(chain(2000, "#"), "expected at most 1000"));
}

TEST_CASE("headings of a paper stand at lines") {
  const std::string from = "source = \"paper.tex\"\n";
  const auto with = [&](const std::string& headings) {
    std::string text = small;
    return text.insert(text.find(from) + from.size(), headings);
  };
  CHECK(parse_claims(with("[paper.headings]\n7 = \"Section 1\"\n"), "small.toml").paper.place(8) == "Section 1");
  for (const char* line : {"seven", "0", "-1", "7a", "99999999999999999999999"}) {
    CAPTURE(line);
    const std::string heading = "[paper.headings]\n" + std::string(line) + " = \"Section 1\"\n";
    CHECK_THROWS_WITH_AS(parse_claims(with(heading), "small.toml"), doctest::Contains("small.toml:7:"), InputError);
  }
}
