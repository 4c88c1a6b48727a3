// Verdicts that samples alone would get wrong: at an end of a domain that stands alone.
#include <doctest/doctest.h>

#include <map>

#include "claims/reading/read_claims_file.hpp"
#include "claims/verify/verify.hpp"
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

}  // namespace

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
