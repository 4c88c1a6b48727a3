// Verdicts that samples alone would get wrong: where no force is in the domain, where it is no interval, where a region
// has no value at one point, and at an end of a domain that stands alone.
#include <doctest/doctest.h>

#include <map>

#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "claims/verify/verify.hpp"
#include "support/papers/proved.hpp"
#include "support/run_program.hpp"

using namespace slipproof;

namespace {

/// Claims about a block on a floor that a force F pushes, with parameters m, mu, g and others.
struct Block {
  std::string force_domain = "true", parameters = {}, m = "m > 0", g = "g > 0";

  ClaimsFile read(const std::string& claims) const {
    const test::TemporaryFolder folder;
    folder.write("block.toml",
                 "schema = \"slipproof/mechanism/1\"\nname = \"block\"\ngravity = [\"0\", \"-g\"]\n[parameters]\n"
                 "m = \"m > 0\"\nmu = \"mu >= 0\"\ng = \"g > 0\"\n[load]\nsymbol = \"F\"\n[[body]]\nname = \"A\"\n"
                 "mass = \"m\"\nturning = \"0\"\n[[contact]]\nname = \"q\"\nof = \"A\"\npoint = [\"0\", \"0\"]\n"
                 "normal = [\"0\", \"1\"]\nthrough = [\"0\", \"0\"]\nfriction = \"mu\"\n[[force]]\non = \"A\"\n"
                 "is = [\"F\", \"0\"]\n");
    std::string text =
        "schema = \"slipproof/claims/1\"\npaper = { title = \"own\", authors = [\"nobody\"], source = \"none\" }\n"
        "[[setting]]\nid = \"all\"\nmechanism = \"block.toml\"\nmotions = \"closed\"\nforce = { symbol = \"F\", domain "
        "= \"" +
        force_domain + "\" }\n[setting.parameters]\nm = { domain = \"" + m +
        "\", meaning = \"m\" }\nmu = { domain = \"mu >= 0\", meaning = \"mu\" }\ng = { domain = \"" + g +
        "\", meaning = \"g\" }\n" + parameters + claims;
    for (std::size_t i = 0; (i = text.find("[[claim]]\n", i)) != std::string::npos; i += 10) {
      text.insert(i + 10, "line = 1\nstatement = \"own\"\n");
    }
    return parse_claims(text, (folder.path() / "claims.toml").string());
  }

  /// The results by id.
  std::map<std::string, ClaimResult> verified(const std::string& claims, std::uint64_t samples = 300) const {
    const ClaimsFile file = read(claims);
    VerifyOptions options;
    options.samples = samples;
    options.simplify = false;
    std::map<std::string, ClaimResult> found;
    for (const ClaimResult& result : verify(file, options).claims) found[file.claims[result.claim].id] = result;
    return found;
  }
};

std::string claim(const std::string& id, const std::string& rest) {
  return "[[claim]]\nid = \"" + id + "\"\n" + rest + "\n";
}

const std::string free_k = "k = { domain = \"true\", meaning = \"k\" }\n";

}  // namespace

TEST_CASE("where the force's domain is empty, claims about any force are not vacuous") {
  const Block block{.force_domain = "0 < F and F < k", .parameters = free_k};
  const std::string nowhere = "region = \"k < 0 and mu = 1/7919\"\n";  // where no sample is
  const auto found = block.verified(
      claim("consequence", "kind = \"consequence\"\nmode = \"slip+\"\nequations = [\"S_q = -2*mu*m*g\"]\n" + nowhere) +
      claim("system", "kind = \"system\"\nmode = \"slip+\"\nequations = [\"S_q = -2*mu*m*g\"]\n" + nowhere) +
      claim("interval", "kind = \"interval\"\nmode = \"slip+\"\nforces = \"F >= mu*m*g\"\n" + nowhere) +
      claim("covering", "kind = \"interval\"\nregion = \"k > 0\"\nmode = \"slip+\"\nforces = \"F >= mu*m*g\"\n") +
      claim("cover", "kind = \"cover\"\nclaims = [\"covering\"]\n" + nowhere) +
      claim("limit", "kind = \"limit\"\nparameter = \"g\"\nholds = \"g < 3\"\nregion = \"k < 0 and mu = 1/7919\"\n") +
      claim("formula", "kind = \"formula\"\nholds = \"k > 0\"\n" + nowhere) +
      claim("contradiction",
            "kind = \"consequence\"\nassume = [\"N_q = 1\", \"N_q = 2\"]\nequations = [\"N_q = 3\"]\n"
            "region = \"k < 0\"\n"));
  for (const std::string id : {"consequence", "system", "interval", "cover", "limit"}) {
    CAPTURE(id);
    CHECK(found.at(id).verdict != Verdict::vacuous);
  }
  CHECK(found.at("formula").verdict == Verdict::vacuous);
  CHECK(found.at("contradiction").verdict == Verdict::vacuous);
}

TEST_CASE("a consequence is an identity only if its divisors are not 0 at any force") {
  const Block block{.force_domain = "0 < F and F < k", .parameters = free_k};
  const auto found = block.verified(
      claim("divides",
            "kind = \"consequence\"\nmode = \"slip+\"\n"
            "equations = [\"S_q/(k + 7919/7907) = -mu*m*g/(k + 7919/7907)\"]\n") +
      claim("formula",
            "kind = \"formula\"\nmode = \"slip+\"\nholds = \"S_q/(k + 7919/7907) = -mu*m*g/(k + 7919/7907)\"\n"));
  CHECK_FALSE(found.at("divides").proved);
  CHECK(found.at("formula").proved);  // no force is in the domain where k = -7919/7907
}

TEST_CASE("where the force's domain is no interval or has no value, nothing is proved") {
  const std::string claims =
      claim("formula", "kind = \"formula\"\nmode = \"slip+\"\nholds = \"N_q = m*g\"\n") +
      claim("consequence", "kind = \"consequence\"\nmode = \"slip+\"\nequations = [\"N_q = m*g\"]\n") +
      claim("nothing", "kind = \"formula\"\nregion = \"m < 0\"\nholds = \"m > 0\"\n");
  for (const std::string domain :
       {"F != 0 or m^2 + g^2 != 5*(7919/7907)^2", "F != 0 or m != 7919/7907", "F < 1/(m - 7919/7907)"}) {
    CAPTURE(domain);
    const Block block{.force_domain = domain};
    for (const auto& [id, result] : block.verified(claims)) {
      CAPTURE(id);
      CHECK_FALSE(result.proved);
      CHECK(result.verdict != Verdict::vacuous);
      if (id == "consequence" && result.verdict == Verdict::holds) {
        CHECK(result.identity_where() == "the domain of the force is one interval");
      }
    }
    const Block there{.force_domain = domain, .m = "m = 7919/7907", .g = "g = 2*7919/7907"};
    for (const auto& [id, result] : there.verified(claims)) {
      CAPTURE(id);
      CHECK(result.verdict == Verdict::undecided);
    }
  }
}

TEST_CASE("what has no value at a point that no sample finds is not vacuous") {
  const Block block{.parameters = free_k};
  const std::string region = "region = \"1/(k - 7919/7907) > 5 and 1/(k - 7919/7907) < 4\"\n",
                    equations = "kind = \"consequence\"\nequations = [\"N_q = m*g\"]\n";
  const auto found = block.verified(
      claim("region", equations + region) +
      claim("equation",
            "kind = \"consequence\"\nassume = [\"N_q = 1\", \"N_q = 2\"]\n"
            "equations = [\"N_q/(k - 7919/7907) = 3\"]\n") +
      claim("system", "kind = \"system\"\nequations = [\"N_q = m*g\"]\n" + region) +
      claim("elsewhere", equations + "region = \"(k < 1 or 1/(k - 7919/7907) > 5) and k > 2 and k < 1\"\n"));
  CHECK(found.at("region").verdict == Verdict::undecided);
  CHECK(found.at("equation").verdict == Verdict::undecided);
  CHECK(found.at("system").verdict == Verdict::undecided);
  CHECK(found.at("elsewhere").verdict == Verdict::vacuous);  // at k = 7919/7907, too, it is false
}

TEST_CASE("an equation without a value is stated, also where the hypotheses contradict each other") {
  const Block block{.parameters = free_k};
  const ClaimsFile file = block.read(claim("c",
                                           "kind = \"consequence\"\nassume = [\"N_q = 1\", \"N_q = 2\"]\n"
                                           "equations = [\"N_q/(k - 2) = 3\"]\n"));
  const auto statements = claim_statements(file, file.claims.front(), Reading::printed);
  CHECK_FALSE(std::all_of(statements.begin(), statements.end(), [](const NamedStatement& statement) {
    return test::proved(statement) == ProofOutcome::Verdict::proved;
  }));
}

TEST_CASE("where no force is in the domain, the forces of a claim need no value") {
  const Block block{.force_domain = "0 < F and F < k", .parameters = free_k};
  const ClaimsFile file = block.read(claim("c", "kind = \"formula\"\nforces = \"1/(k + 1) > 0\"\nholds = \"k > 0\"\n"));
  for (const NamedStatement& statement : claim_statements(file, file.claims.front(), Reading::printed)) {
    CAPTURE(statement.text);
    CHECK(test::proved(statement) == ProofOutcome::Verdict::proved);
  }
}

TEST_CASE("a limit goes to an end of the domain that stands alone") {
  const auto limit = [](const std::string& id, const std::string& holds) {
    return claim(id, "kind = \"limit\"\nparameter = \"p\"\nholds = \"" + holds + "\"\n");
  };
  const std::string claims = limit("at", "p = 5") + limit("below", "p < 5") + limit("none", "1/(p - 5) < 1");
  const auto with = [](const std::string& domain) {
    return Block{.parameters = "p = { domain = \"" + domain + "\", meaning = \"p\" }\n"};
  };
  for (const std::string domain :
       {"p <= 1 or p = 5", "p < 3 and p > 2 or p < 1 or p = 5", "p = -3 or p = 5 or p = 1"}) {
    CAPTURE(domain);
    const auto found = with(domain).verified(claims, 60);
    CHECK(found.at("at").verdict == Verdict::holds);
    CHECK(found.at("below").verdict == Verdict::refuted);
    CHECK(found.at("none").verdict == Verdict::undecided);
  }
  const auto irrational = with("p <= 1 or p*p = 8 and p > 0").verified(limit("below", "p < 2"), 60);
  CHECK(irrational.at("below").verdict == Verdict::undecided);  // it is false at the square root of 8
}

TEST_CASE("a limit of a parameter with an upper end is not vacuous for what would be beyond") {
  const Block block{.parameters =
                        "p = { domain = \"0 < p and p < 1\", meaning = \"p\" }\n"
                        "q = { domain = \"q*q*q = 7919*7919*7919/7907\", meaning = \"q\" }\n"};
  // No rational number is in the domain of q, so that no sample says anything.
  const auto found =
      block.verified(claim("c", "kind = \"limit\"\nparameter = \"p\"\nregion = \"p < 5\"\nholds = \"p > 3\"\n"), 60);
  CHECK(found.at("c").verdict == Verdict::undecided);
}

TEST_CASE("a consequence is not refuted where one of its equations has no value or is not linear") {
  const Block block{.parameters = free_k};
  const auto refutation = [&](const std::string& equations) {
    const ClaimsFile file =
        block.read(claim("c", "kind = \"consequence\"\nregion = \"k = 2\"\nequations = " + equations));
    return claim_refutation(file, file.claims.front(), Reading::printed);
  };
  CHECK(refutation("[\"N_q*S_q = 1\"]").empty());
  const auto divided = refutation("[\"N_q/(k - 2) = 3\", \"N_q = m*g + 1\"]"),
             wrong = refutation("[\"N_q = m*g + 1\"]");
  REQUIRE(divided.size() == 1);
  CHECK(test::proved(divided.front()) != ProofOutcome::Verdict::proved);
  REQUIRE(wrong.size() == 1);
  CHECK(test::proved(wrong.front()) == ProofOutcome::Verdict::proved);
}
