// Claims that were judged wrongly once, one test for each way; what they come to is what proofs/MEANING.md says.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "base/input/diagnostic.hpp"
#include "claims/mutation/claims_mutants.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "claims/verify/verify.hpp"
#include "proofs/check/judge.hpp"
#include "proofs/search/prove.hpp"
#include "support/papers/shipped.hpp"

using namespace slipproof;

namespace {

/// The shipped paper's section 3 with its repaired formulas, changed in places, and these claims instead of its own.
struct OwnClaims {
  std::string claims;
  std::vector<std::pair<std::string, std::string>> changes = {};

  std::string text() const {
    std::ifstream file(test::shipped_folder / "claims.toml");
    const std::string whole{std::istreambuf_iterator<char>(file), {}};
    std::string paper = whole.substr(0, whole.find("[[setting]]"));
    paper.erase(paper.find("[paper.equations]"));
    const std::size_t begin = whole.find("[[setting]]"), end = whole.find("[[setting]]", begin + 1);
    std::string setting = whole.substr(begin, end - begin);
    for (const auto& [what, by] : changes) {
      const std::size_t at = setting.find(what);
      REQUIRE_MESSAGE(at != std::string::npos, what);
      setting.replace(at, what.size(), by);
    }
    std::string result = paper + setting;
    std::istringstream lines(claims);
    for (std::string line; std::getline(lines, line);) {
      result += line + '\n';
      if (line == "[[claim]]") result += "line = 1\nstatement = \"own\"\n";
    }
    return result;
  }
  ClaimsFile read() const { return as_read(parse_claims(text(), "own.toml"), Reading::repaired); }
};

struct Found {
  Verdict verdict = Verdict::undecided;
  bool proved = false;
};

/// What comes of the last claim.
Found verdict(const OwnClaims& own, std::uint64_t samples = 600, std::optional<std::uint64_t> lines = {}) {
  const ClaimsFile file = own.read();
  VerifyOptions options;
  options.samples = samples;
  options.simplify = false;
  options.lines = lines;
  const ClaimResult result = verify(file, options).claims.back();
  return {result.verdict, result.proved};
}

bool is_accepted(const NamedStatement& statement) {
  const std::string certificate =
      prove_statement(statement.name, statement.text, {.split_depth = 2, .products = 0, .steps = 300'000}).certificate;
  return check::judge(statement.text, certificate).verdict == check::Verdict::accepted;
}

bool all_accepted(const std::vector<NamedStatement>& statements) {
  return !statements.empty() && std::all_of(statements.begin(), statements.end(), is_accepted);
}

/// Whether all statements of the last claim have proofs.
bool proved(const OwnClaims& own) {
  const ClaimsFile file = own.read();
  return all_accepted(claim_statements(file, file.claims.back(), Reading::printed));
}

bool disproved(const OwnClaims& own) {
  const ClaimsFile file = own.read();
  return all_accepted(claim_refutation(file, file.claims.back(), Reading::printed));
}

std::string mistakes(const OwnClaims& own) {
  try {
    own.read();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

const std::pair<std::string, std::string> closed{"motions = \"strict\"", "motions = \"closed\""};
const std::pair<std::string, std::string> no_J{"\nJ = \"J\"\n", "\n"};

std::string claim(const std::string& rest) {
  return "[[claim]]\nid = \"c\"\n" + rest + "\n";
}
std::string formula(const std::string& rest) {
  return claim("kind = \"formula\"\n" + rest);
}

}  // namespace

TEST_CASE("1: a cover is about its own region") {
  const std::string interval =
      "[[claim]]\nid = \"i\"\nkind = \"interval\"\nmode = \"stick/stick\"\nregion = \"b > b0\"\nforces = \"0 < F*sigma "
      "< "
      "xi1\"\n";
  const OwnClaims inside{interval + claim("kind = \"cover\"\nclaims = [\"i\"]\nregion = \"b > 2*b0 and b0 > 0\"")};
  CHECK(verdict(inside).verdict == Verdict::holds);
  CHECK(proved(inside));
  CHECK(verdict({interval + claim("kind = \"cover\"\nclaims = [\"i\"]\nregion = \"b >= b0\"")}).verdict ==
        Verdict::refuted);
}

TEST_CASE("forces are covered by what claims state, in their regions, and an end that none has is missed") {
  const auto interval = [](const char* id, const std::string& forces, const std::string& region = "true") {
    return "[[claim]]\nid = \"" + std::string(id) + "\"\nkind = \"interval\"\nmode = \"stick/stick\"\nregion = \"" +
           region + "\"\nforces = \"" + forces + "\"\n";
  };
  const std::string cover = claim("kind = \"force-cover\"\nclaims = [\"i\", \"j\"]\nforces = \"F*sigma > 1\"");
  const OwnClaims whole{interval("i", "F*sigma < 2") + interval("j", "F*sigma >= 2") + cover};
  CHECK(verdict(whole).verdict == Verdict::holds);
  CHECK(proved(whole));
  const OwnClaims end_missing{interval("i", "F*sigma < 2") + interval("j", "F*sigma > 2") + cover};
  CHECK(verdict(end_missing).verdict == Verdict::refuted);
  CHECK(disproved(end_missing));
  const OwnClaims elsewhere{interval("i", "F*sigma < 2") + interval("j", "F*sigma >= 2", "b > b0") + cover};
  CHECK(verdict(elsewhere).verdict == Verdict::refuted);
  const OwnClaims no_value{interval("i", "F*sigma < 2") + interval("j", "1/(b - b) > 0 or F*sigma > 3") + cover};
  CHECK(verdict(no_value).verdict == Verdict::undecided);
  CHECK(mistakes({claim("kind = \"force-cover\"\nclaims = []")}).find("expected at least one claim") !=
        std::string::npos);
  CHECK(mistakes({interval("i", "F > 0") + claim("kind = \"formula\"\nholds = \"b > 0\"") +
                  "[[claim]]\nid = \"d\"\nkind = \"force-cover\"\nclaims = [\"c\"]\n"})
            .find("expected a claim of kind interval or motions in the same setting") != std::string::npos);
}

TEST_CASE("2: at a border the same motion in a second mode is no other motion, whatever is expected") {
  for (const char* expect : {"holds", "refuted"}) {
    const OwnClaims own{
        claim("kind = \"motions\"\nmodes = [\"stick/stick\"]\nregion = \"b > b0\"\nforces = \"F*sigma <= "
              "xi1\"\nexpect = \"" +
              std::string(expect) + "\""),
        {closed}};
    CHECK(verdict(own).verdict == Verdict::holds);
    CHECK_FALSE(disproved(own));
  }
}

TEST_CASE("3: in a strict setting a border has no motion") {
  const auto at = [](const std::string& forces) {
    return OwnClaims{
        claim("kind = \"motions\"\nmodes = [\"stick/stick\"]\nregion = \"b > b0\"\nforces = \"" + forces + "\"")};
  };
  CHECK(verdict(at("F*sigma <= xi1")).verdict == Verdict::refuted);
  CHECK(verdict(at("F*sigma = xi1")).verdict == Verdict::refuted);
  CHECK(verdict(at("F*sigma < xi1")).verdict == Verdict::holds);
}

TEST_CASE("4: without J no list of motions is complete") {
  const OwnClaims ambiguous{claim("kind = \"motions\"\nmodes = [\"stick/stick\", \"stick/slip+\"]\nregion = \"0 < b < "
                                  "b1\"\nforces = \"xi3 < F*sigma < xi2\""),
                            {no_J}};
  CHECK(verdict(ambiguous).verdict == Verdict::undecided);
  const ClaimsFile file = ambiguous.read();
  CHECK(claim_statements(file, file.claims.back(), Reading::printed).empty());
  CHECK(
      verdict({claim("kind = \"motions\"\nmodes = [\"stick/stick\"]\nregion = \"0 < b < b1\"\nforces = \"xi3 < F*sigma "
                     "< xi2\""),
               {no_J}})
          .verdict == Verdict::refuted);
}

TEST_CASE("5: what is divided by has to be shown not to vanish") {
  const Found cancelled = verdict({formula("holds = \"(R - 1234567)/(R - 1234567) = 1\"")});
  CHECK_FALSE(cancelled.proved);
  CHECK(cancelled.verdict == Verdict::undecided);  // on a line, R = 1234567 is judged
  const Found at_samples = verdict({formula("holds = \"(R - 1234567)/(R - 1234567) = 1\"")}, 300, 0);
  CHECK(at_samples.verdict == Verdict::holds);
  CHECK_FALSE(at_samples.proved);
  CHECK(verdict({formula("holds = \"(h + R)/(h + R) = 1\"")}).proved);
  CHECK(verdict({formula("forces = \"F < 5\"\nholds = \"1/(1/(F - 3)) = F - 3\"")}).verdict == Verdict::undecided);
  const OwnClaims maximum{formula("holds = \"max(1, 1/(J - 1234567)) > 0\"")};
  CHECK(verdict(maximum).verdict == Verdict::undecided);
  CHECK_FALSE(proved(maximum));
  // Where the front wheel is lifted and has no inertia, it may turn as it likes.
  const OwnClaims massless{formula("mode = \"stick/lift\"\nholds = \"eps3 = 0\""),
                           {{"I3 = \"M3*R^2\"", "I3 = \"(f - 1234567)^2\""}}};
  CHECK_FALSE(verdict(massless).proved);
}

TEST_CASE("6: an unknown of a system occurs, whatever its coefficient is at a bicycle") {
  const std::string base = "[[claim]]\nid = \"e\"\nkind = \"consequence\"\nequations = [\"a = S2 + S3\"]\n";
  const auto system = [&](const std::string& region) {
    return OwnClaims{
        base +
        claim("kind = \"system\"\nclaims = [\"e\"]\nequations = [\"h*a = h*S2 + h*S3\"]\nregion = \"" + region + "\"")};
  };
  CHECK(verdict(system("h = 0"), 4000).verdict == Verdict::refuted);
  CHECK(verdict(system("true"), 4000).verdict == Verdict::refuted);
  CHECK(verdict(system("h != 0")).verdict == Verdict::holds);
}

TEST_CASE("7: what is true is not refuted") {
  const std::vector<std::pair<std::string, std::string>> massless{
      {"I1 = \"M2*R^2/2\"", "I1 = \"0\""}, {"I2 = \"M2*R^2/2\"", "I2 = \"0\""}, {"I3 = \"M3*R^2\"", "I3 = \"0\""}};
  const auto about = [&](const std::string& holds) {
    return OwnClaims{formula("mode = \"slip-/stick\"\nholds = \"" + holds + "\""), massless};
  };
  CHECK(verdict(about("N2 > 0")).verdict == Verdict::holds);
  CHECK(verdict(about("N2 > 0 and slip2 < 0 or N3 < -1")).verdict == Verdict::holds);
  CHECK(verdict(about("slip2 < -1")).verdict == Verdict::refuted);
  CHECK(verdict(about("slip2*slip2 > 0")).verdict == Verdict::undecided);
  CHECK(
      verdict({claim("kind = \"consequence\"\nassume = [\"a = 1\", \"a = 2\"]\nequations = [\"N2 = 77\"]")}).verdict ==
      Verdict::vacuous);
  const auto bounded = [](const std::string& domain, const std::string& holds) {
    return OwnClaims{claim("kind = \"limit\"\nparameter = \"b\"\nholds = \"" + holds + "\"\nfrom = \"1/2\""),
                     {{"domain = \"b > 0\"", "domain = \"" + domain + "\""}}};
  };
  CHECK(verdict(bounded("0 < b and b < 1", "b < 1"), 200).verdict == Verdict::holds);
  CHECK(proved(bounded("0 < b and b < 1", "b < 1")));
  CHECK(verdict(bounded("0 < b and b < 1", "b < 9/10"), 200).verdict == Verdict::refuted);
  CHECK(verdict(bounded("0 < b and b <= 1", "b < 1"), 200).verdict == Verdict::refuted);
  CHECK_FALSE(proved(bounded("0 < b and b < 1/3", "b < 0")));  // beyond `from` there is nothing
}

TEST_CASE("8: what samples did not find is not refuted, and nothing unphysical is a bicycle") {
  const auto exists = [](const std::string& region) {
    return OwnClaims{claim("kind = \"exists\"\nmodes = [\"stick/stick\"]\nregion = \"" + region + "\"")};
  };
  CHECK(verdict(exists("J = 13/3")).verdict == Verdict::holds);
  CHECK(verdict(exists("6 < J and J < 7")).verdict == Verdict::holds);
  CHECK(verdict(exists("J < 0")).verdict == Verdict::refuted);  // proved: no motion where there is no bicycle
  const std::pair<std::string, std::string> any_J{"domain = \"J > 0\"", "domain = \"true\""},
      any_M3{"domain = \"M3 > 0\"", "domain = \"true\""};
  const OwnClaims positive{formula("holds = \"J > 0 and M3 >= 0\""), {any_J, any_M3}};
  CHECK(verdict(positive).verdict == Verdict::holds);
  CHECK(proved(positive));
  CHECK_FALSE(disproved(positive));
}

TEST_CASE("9: what says nothing is vacuous, not proved") {
  const Found impossible = verdict({claim("kind = \"impossible\"\nmodes = [\"stick/stick\"]\nregion = \"b < 0\"")});
  CHECK(impossible.verdict == Verdict::vacuous);
  CHECK_FALSE(impossible.proved);
  CHECK(verdict({claim("kind = \"limit\"\nparameter = \"b\"\nregion = \"b < 5\"\nholds = \"b < 6\"")}).verdict ==
        Verdict::vacuous);
  CHECK(verdict({formula("mode = \"lift/lift\"\nholds = \"a > 0\"")}).verdict == Verdict::vacuous);
}

TEST_CASE("10: nothing to cover, and nothing to follow, is refused; decimals and x^0 have statements") {
  CHECK(mistakes({claim("kind = \"cover\"\nclaims = []")}).find("expected at least one claim") != std::string::npos);
  CHECK(mistakes({claim("kind = \"consequence\"\nequations = []")}).find("expected at least one equation") !=
        std::string::npos);
  CHECK(mistakes({claim("kind = \"motions\"\nmodes = []")}).find("expected at least one mode") != std::string::npos);
  CHECK(proved({formula("holds = \"b > 0.5 - b^0\"")}));
  // What becomes cases stays one condition among others.
  CHECK(proved({claim("kind = \"consequence\"\nassume = [\"max(f, h)*N2 = T\", \"a = 1\"]\nequations = [\"a = 1\"]")}));
}

TEST_CASE("11: uniqueness leaves out the ends of the claims that it names, and no other force") {
  const auto unique = [](const std::string& forces) {
    return OwnClaims{
        "[[claim]]\nid = \"i\"\nkind = \"interval\"\nmode = \"stick/stick\"\nregion = \"b > b0\"\nforces = "
        "\"0 < F*sigma < xi1\"\n" +
        claim("kind = \"unique\"\nclaims = [\"i\"]\nregion = \"b > b0\"\nforces = \"" + forces + "\"")};
  };
  CHECK(verdict(unique("F*sigma <= xi1")).verdict == Verdict::holds);
  CHECK(verdict(unique("F*sigma <= 2*xi1")).verdict == Verdict::refuted);
  CHECK(verdict(unique("F*sigma = xi1/2")).verdict == Verdict::holds);
}
