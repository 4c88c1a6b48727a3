// The names that the writer of statements makes up, in files whose own names look like them. Independent of the writer:
// if the names of a file are changed, the statements say the same about the same variables, in the same order.
#include "claims/statements/made_up_names.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/number/dice.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "proofs/search/prove.hpp"
#include "proofs/statement/statement.hpp"
#include "support/how_many.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using Names = std::map<char, std::string>;

namespace {

/// Two blocks, pushed by F and -F. In the texts `$x` stands for a name: A and B are bodies, p and q contacts, m, u, g
/// and F symbols, and V and W claims.
const std::string scene = R"(schema = "slipproof/mechanism/1"
name = "two blocks"
gravity = ["0", "-$g"]
parameters = { $m = "$m > 0", $u = "$u >= 0", $g = "$g > 0" }
load = { symbol = "$F" }
[[body]]
name = "$A"
mass = "$m"
turning = "0"
[[body]]
name = "$B"
mass = "$m"
turning = "0"
at = ["3", "0"]
[[contact]]
name = "$p"
of = "$A"
point = ["0", "0"]
normal = ["0", "1"]
through = ["0", "0"]
friction = "$u"
[[contact]]
name = "$q"
of = "$B"
point = ["0", "0"]
normal = ["0", "1"]
through = ["3", "0"]
friction = "$u"
[[force]]
on = "$A"
is = ["$F", "0"]
[[force]]
on = "$B"
is = ["-$F", "0"]
)";

const std::string claims_text = R"(schema = "slipproof/claims/1"
paper = { title = "x", authors = ["x"], source = "x" }
[[setting]]
id = "x"
mechanism = "m.toml"
motions = "closed"
boundaries = ["$u = 1"]
[setting.parameters]
$m = { domain = "$m > 0", meaning = "x" }
$u = { domain = "$u > 0", meaning = "x" }
$g = { domain = "$g > 0", meaning = "x" }
[[claim]]
id = "M"
kind = "motions"
modes = ["slip+/slip-", "stick/stick"]
forces = "$F = $u*$m*$g"
region = "$u > 1"
[[claim]]
id = "E"
kind = "exists"
modes = ["slip+/slip-", "stick/stick"]
forces = "$F > $u*$m*$g"
[[claim]]
id = "$V"
kind = "interval"
mode = "slip+/slip-"
forces = "$F >= $u*$m*$g"
[[claim]]
id = "$W"
kind = "interval"
mode = "slip-/slip+"
forces = "$F <= -$u*$m*$g"
[[claim]]
id = "U"
kind = "unique"
claims = ["$V", "$W"]
modes = ["stick/stick"]
)";

const Names plain{{'A', "A"}, {'B', "B"}, {'p', "p"}, {'q', "q"}, {'m', "m"},
                  {'u', "u"}, {'g', "g"}, {'F', "F"}, {'V', "V"}, {'W', "W"}};

std::string with(const Names& names, const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto found = text[i] == '$' ? names.find(text[i + 1]) : names.end();
    result += found == names.end() ? std::string(1, text[i]) : found->second;
    if (found != names.end()) ++i;
  }
  std::size_t line = 0;  // the keys that every claim needs
  for (std::size_t at = result.find("kind ="); at != result.npos; at = result.find("kind =", at)) {
    const std::string needed = "line = " + std::to_string(++line) + "\nstatement = \"x\"\n";
    result.insert(at, needed);
    at += needed.size() + 1;
  }
  return result;
}

/// All statements of the claims and of their refutations.
std::vector<NamedStatement> statements(const Names& names) {
  const test::TemporaryFolder folder;
  folder.write("m.toml", with(names, scene));
  const ClaimsFile file = parse_claims(with(names, claims_text), folder.path() / "claims.toml");
  std::vector<NamedStatement> result;
  for (const Claim& claim : file.claims) {
    for (auto& some :
         {claim_statements(file, claim, Reading::printed), claim_refutation(file, claim, Reading::printed)})
      result.insert(result.end(), some.begin(), some.end());
  }
  return result;
}

bool same(const MultiPolynomial& x, const MultiPolynomial& y) {
  const std::vector<Term> some = x.terms(), others = y.terms();
  return std::ranges::equal(some, others, [](const Term& one, const Term& other) {
    return one.coefficient == other.coefficient && one.exponents == other.exponents;
  });
}

bool same(const prove::Formula& x, const prove::Formula& y) {
  return x.kind == y.kind && x.sign == y.sign &&
         std::ranges::equal(x.polynomial, y.polynomial, [](const auto& p, const auto& q) { return same(p, q); }) &&
         std::ranges::equal(x.parts, y.parts, [](const auto& p, const auto& q) { return same(p, q); });
}

/// Whether two statements say the same of their variables, which may have other names.
bool same(const prove::Statement& x, const prove::Statement& y) {
  const auto agree = [](const auto& one, const auto& other) { return same(one.second, other.second); };
  return x.ring().size() == y.ring().size() && std::ranges::equal(x.assumptions(), y.assumptions(), agree) &&
         same(x.shown(), y.shown());
}

void check_same(const Names& names) {
  static const std::vector<NamedStatement> expected = statements(plain);
  const std::vector<NamedStatement> found = statements(names);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(found[i].text);
    CHECK(same(prove::Statement(found[i].name, found[i].text), prove::Statement(expected[i].name, expected[i].text)));
  }
}

Names changed(const Names& others) {
  Names names = plain;
  for (const auto& [place, name] : others) names[place] = name;
  return names;
}

}  // namespace

TEST_CASE("made-up names: bodies and contacts that are called like those of a second motion") {
  check_same(changed({{'B', "A_2"}, {'q', "p_2"}}));
  check_same(changed({{'A', "A_2"}, {'B', "A_2_2"}}));
  check_same(changed({{'m', "ax_A_2"}}));
  check_same(changed({{'m', "ax_A_17"}, {'u', "gap_p_2"}}));
}

TEST_CASE("made-up names: parameters that are called like assumptions and states") {
  for (const char* name : {"domain", "region", "force", "motion", "motion_2", "stated", "cell", "beyond_V", "goal",
                           "p_sticks", "p_sticks_2", "force_", "gap_p_2"}) {
    CAPTURE(name);
    check_same(changed({{'m', name}}));
    check_same(changed({{'F', name}}));
  }
}

TEST_CASE("made-up names: ids of claims") {
  check_same(changed({{'V', "V-1"}, {'W', "V_1"}}));
  check_same(changed({{'V', "V"}, {'W', "V.1"}}));
  check_same(changed({{'V', "V.1.2"}, {'W', "V.1"}}));
  check_same(changed({{'V', "1"}, {'W', "1.1"}}));
}

TEST_CASE("made-up names: any names of a file") {
  const std::vector<std::string> pool{
      "A",      "A_2", "A_2_2", "A_3",      "domain", "region", "force", "motion",   "motion_2", "cell",  "goal",
      "stated", "p",   "p_2",   "p_sticks", "m",      "m_",     "ax_A",  "ax_A_2",   "N_p",      "N_p_2", "gap_p",
      "u_2",    "g_",  "F_2",   "lifts",    "given1", "a",      "x_2",   "slip_p_2", "S_p_2"};
  Dice dice(61, 9);
  int tried = 0;
  const int rounds = test::how_many("SLIPPROOF_MADE_UP_NAMES", 100);
  for (int round = 0; round < rounds; ++round) {
    Names names = plain;
    for (const char place : {'A', 'B', 'p', 'q', 'm', 'u', 'g', 'F'})
      names[place] = pool[static_cast<std::size_t>(dice.number(1, static_cast<int>(pool.size()))) - 1];
    try {
      statements(names);
    } catch (const InputError&) {
      continue;  // one name twice, or that of a quantity: the reader refuses it
    }
    ++tried;
    check_same(names);
  }
  CHECK(tried > rounds / 6);
}

TEST_CASE("made-up names: a statement about two motions is proved whatever the bodies are called") {
  int proved = 0;
  for (const NamedStatement& statement : statements(changed({{'B', "A_2"}, {'q', "p_2"}}))) {
    if (!statement.name.ends_with(".one") && statement.name != "E.refuted") continue;
    CAPTURE(statement.name);
    CHECK(prove_statement(statement.name, statement.text, {}).verdict == ProofOutcome::Verdict::proved);
    ++proved;
  }
  CHECK(proved >= 3);
}

TEST_CASE("made-up names: made fresh one after another") {
  const test::TemporaryFolder folder;
  folder.write("m.toml", with(plain, scene));
  const ClaimsFile file = parse_claims(with(plain, claims_text), folder.path() / "claims.toml");
  MadeUpNames names(SettingNames(file.settings.front()), {"ax_A", "N_p"});
  CHECK(names.ending(1).empty());
  CHECK(names.ending(2) == "_2");
  CHECK(names.take("m") == "m_");
  CHECK(names.take("m") == "m__");
  CHECK(names.take("ax_A_3") == "ax_A_3_");
  CHECK(names.take("or") == "or_");
  CHECK(names.take("1st equation") == "n1st_equation");
  CHECK(names.take("beyond_V.1") == "beyond_V.1");
  CHECK(names.take("beyond_V") == "beyond_V_");
  CHECK(names.take("beyond_V.1.2") == "beyond_V.1.2_");
  CHECK(MadeUpNames(SettingNames(file.settings.front()), {"ax_A", "m", "g"}).ending(12) == "_12");
}
