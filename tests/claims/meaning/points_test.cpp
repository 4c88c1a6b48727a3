// A point of a mechanism is one only where each coefficient has a value: to samples, and to statements.
#include <doctest/doctest.h>

#include <algorithm>

#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "claims/verify/verify.hpp"
#include "proofs/search/prove.hpp"
#include "proofs/statement/statement.hpp"
#include "support/papers/proved.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using test::proved;

namespace {

/// A block on a floor, with something that divides by p - q, and claims about p and q.
struct Divided {
  std::string equation = "m*ax = F", contact = "friction = \"mu\"\nslip = \"ax\"", more = {}, definitions = {};
  std::string domain = "true", mode = "lift";

  ClaimsFile read(const std::string& claims) const {
    const test::TemporaryFolder folder;
    folder.write("block.toml",
                 "schema = \"slipproof/mechanism/1\"\nname = \"block\"\n[parameters]\nm = \"m > 0\"\n"
                 "mu = \"mu >= 0\"\np = \"real\"\nq = \"real\"\n[definitions]\nd = \"1/(p - q)\"\n" +
                     definitions + "[load]\nsymbol = \"F\"\n[unknowns]\naccelerations = [\"ax\", \"ay\"]\n" +
                     "[motion]\nax = \"" + equation + "\"\nay = \"m*ay = -10*m\"\n[[contact]]\n" +
                     "name = \"floor\"\ngap = \"ay\"\n" + contact + "\n" + more);
    std::string text =
        "schema = \"slipproof/claims/1\"\n[paper]\ntitle = \"own\"\nauthors = [\"nobody\"]\n"
        "source = \"none\"\n[[setting]]\nid = \"all\"\nline = 1\nstatement = \"all\"\n"
        "mechanism = \"block.toml\"\nmotions = \"strict\"\nforce = { symbol = \"F\", domain = \"true\" }\n"
        "[setting.parameters]\nm = { domain = \"m > 0\", meaning = \"m\" }\n"
        "mu = { domain = \"mu >= 0\", meaning = \"mu\" }\nq = { domain = \"q = 2\", meaning = \"q\" }\n"
        "p = { domain = \"" +
        domain + "\", meaning = \"p\" }\n" + claims;
    for (std::size_t i = 0; (i = text.find("[[claim]]\n", i)) != std::string::npos; i += 10) {
      text.insert(i + 10, "line = 1\nstatement = \"own\"\n");
    }
    return parse_claims(text, (folder.path() / "claims.toml").string());
  }
};

std::string claims_about_p(const std::string& mode) {
  const std::string interval = "kind = \"interval\"\nforces = \"false\"\nmode = \"" + mode + "\"\n";
  return "[[claim]]\nid = \"formula\"\nkind = \"formula\"\nholds = \"p != 2\"\n"
         "[[claim]]\nid = \"equivalence\"\nkind = \"equivalence\"\nforces = \"F > 0\"\nholds = \"F > 0 and p != 2\"\n"
         "[[claim]]\nid = \"less\"\nregion = \"p < 2\"\n" +
         interval + "[[claim]]\nid = \"more\"\nregion = \"p > 2\"\n" + interval +
         "[[claim]]\nid = \"cover\"\nkind = \"cover\"\nclaims = [\"less\", \"more\"]\n"
         "[[claim]]\nid = \"force-cover\"\nkind = \"force-cover\"\nforces = \"p = 2\"\nclaims = [\"less\"]\n";
}

}  // namespace

TEST_CASE("a coefficient without a value makes no point: nothing is refuted there") {
  const std::vector<Divided> all = {
      {.equation = "m*ax = F/(p - q)"},
      {.equation = "m*ax = F + d - d"},
      {.equation = "m*ax + 0*d = F"},
      {.equation = "m*ax*(p - q)^-1 = F"},
      {.contact = "friction = \"mu + 1/(p - q) - 1/(p - q)\"\nslip = \"ax\""},
      {.contact = "friction = { static = \"mu + d - d\", kinetic = \"mu\" }\nslip = \"ax\""},
      {.contact = "friction = \"mu\"\nslip = \"ax - ay/(p - q)\""},
      {.more = "[[friction]]\nname = \"brake\"\nslip = \"ax\"\nlimit = \"1 + 0/(p - q)\"\n", .mode = "lift/stick"},
      {.more = "[[link]]\nname = \"bar\"\nzero = \"ax + d*ay\"\n"},
      {.equation = "m*ax = F + e - e", .definitions = "e = \"1/d\"\n"},
  };
  for (const Divided& one : all) {
    CAPTURE(one.equation + one.contact + one.more);
    const ClaimsFile file = one.read(claims_about_p(one.mode));
    VerifyOptions options;
    options.samples = 60;
    options.simplify = false;
    for (const ClaimResult& result : verify(file, options).claims) {
      const Claim& claim = file.claims[result.claim];
      if (claim.kind().name() == "interval") continue;  // they are there to be covered
      CAPTURE(claim.id);
      CHECK(result.verdict != Verdict::refuted);
    }
    for (const char* id : {"formula", "equivalence", "cover", "force-cover"}) {
      for (const NamedStatement& statement : claim_statements(file, *file.find(id), Reading::printed)) {
        CAPTURE(statement.text);
        CHECK(proved(statement) == ProofOutcome::Verdict::proved);
      }
    }
  }
}

TEST_CASE("a limit goes to the last value at which there is a mechanism") {
  const Divided block{.equation = "m*ax = F/(p - q)", .domain = "0 < p and p <= 1 or p = 2"};
  const ClaimsFile file =
      block.read("[[claim]]\nid = \"limit\"\nkind = \"limit\"\nparameter = \"p\"\nholds = \"p > 3/2\"\nfrom = \"1\"\n");
  const auto statements = claim_statements(file, file.claims.front(), Reading::printed);
  CHECK(std::any_of(statements.begin(), statements.end(), [](const NamedStatement& statement) {
    return proved(statement) == ProofOutcome::Verdict::refuted;
  }));
  VerifyOptions options;
  options.samples = 20;
  CHECK(verify(file, options).claims.front().verdict == Verdict::refuted);
}

TEST_CASE("a limit is not proved where its region and `from` have no value") {
  const ClaimsFile file = Divided{}.read(
      "[[claim]]\nid = \"limit\"\nkind = \"limit\"\nparameter = \"p\"\nregion = \"1/mu > 0\"\nholds = \"p*mu > "
      "1\"\nfrom = \"1/mu\"\n");
  const auto statements = claim_statements(file, file.claims.front(), Reading::printed);
  CHECK_FALSE(std::all_of(statements.begin(), statements.end(), [](const NamedStatement& statement) {
    return proved(statement) == ProofOutcome::Verdict::proved;
  }));
}

TEST_CASE("where a guarded division divides by zero, a claim is refuted by numbers all the same") {
  const ClaimsFile file = Divided{.domain = "p <= 0"}.read(
      "[[claim]]\nid = \"guarded\"\nkind = \"formula\"\nregion = \"p >= 0 and (p <= 0 or 1/p > 100)\"\nholds = \"p > "
      "0\"\n"
      "[[claim]]\nid = \"none\"\nkind = \"formula\"\nholds = \"1/(p - p) > 0\"\n");
  const NamedStatement statement = claim_statements(file, file.claims.front(), Reading::printed).front();
  const ProofOutcome outcome = prove_statement(statement.name, statement.text, {});
  REQUIRE(outcome.verdict == ProofOutcome::Verdict::refuted);
  for (const NamedStatement& shown : refutation_at(statement, outcome.counterexample)) {
    CAPTURE(shown.text);
    CHECK(proved(shown) == ProofOutcome::Verdict::proved);
  }
  const NamedStatement none = claim_statements(file, file.claims.back(), Reading::printed).front();
  CHECK(none.text.ends_with("show false\n"));
}

TEST_CASE("a motion is in a mode by other forces, too: no refutation says that it is in another one only") {
  const test::TemporaryFolder folder;
  std::string text =
      "schema = \"slipproof/claims/1\"\n[paper]\ntitle = \"own\"\nauthors = [\"nobody\"]\nsource = \"none\"\n"
      "[[setting]]\nid = \"all\"\nline = 1\nstatement = \"all\"\nmechanism = \"block-shaken\"\nmotions = \"closed\"\n"
      "force = { symbol = \"A\", domain = \"true\" }\n[setting.scene]\nm = \"1\"\nb = \"1\"\nh = \"1\"\nI = \"1\"\n"
      "g = \"1\"\n[setting.parameters]\nmu = { domain = \"mu = 1/2\", meaning = \"friction\" }\n";
  for (const char* kind : {"motions\"\nmodes = [\"slip+/stick\"]", "unique\"\nclaims = [\"slides\"]"}) {
    text += "[[claim]]\nid = \"" + std::string(kind, 4) +
            "\"\nline = 1\nstatement = \"own\"\nforces = \"A = 0\"\nkind = \"" + kind + "\n";
  }
  text +=
      "[[claim]]\nid = \"slides\"\nline = 1\nstatement = \"own\"\nkind = \"interval\"\nforces = \"A = 0\"\n"
      "mode = \"slip+/stick\"\n";
  const ClaimsFile file = parse_claims(text, "own.toml");
  VerifyOptions options;
  options.samples = 3;
  for (const ClaimResult& result : verify(file, options).claims) {
    const Claim& claim = file.claims[result.claim];
    if (claim.kind().name() == "interval") continue;
    CAPTURE(claim.id);
    CHECK(result.verdict == Verdict::holds);
    for (const NamedStatement& statement : claim_refutation(file, claim, Reading::printed)) {
      CHECK(proved(statement) != ProofOutcome::Verdict::proved);
    }
  }
}
