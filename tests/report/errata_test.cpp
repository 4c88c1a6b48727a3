// The errata of the shipped paper, and that none of its numbered equations is left out.
#include "report/errata.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/shipped.hpp"

using namespace slipproof;
using Json = nlohmann::ordered_json;

namespace {

const std::vector<Finding>& findings() {
  static const std::vector<Finding> list = [] {
    VerifyOptions options;
    options.samples = 300;
    return errata(test::shipped_paper(), verify(test::shipped_paper(), options));
  }();
  return list;
}

const Finding& finding(const std::string& id) {
  const auto found = std::find_if(findings().begin(), findings().end(), [&](const Finding& f) { return f.id == id; });
  REQUIRE(found != findings().end());
  return *found;
}

}  // namespace

TEST_CASE("every numbered equation of the paper has a claim, and the table shows it") {
  CHECK(test::shipped_paper().paper.equations.size() == 31);  // (1.1)-(1.5), (2.1)-(2.8), (3.1), (4.1)-(4.17)
  CHECK(uncovered_equations(test::shipped_paper()).empty());
  CHECK(coverage_markdown(test::shipped_paper()).find("| (4.9) | 308 | E4.9.plus, E4.9.minus |") != std::string::npos);
  ClaimsFile less = test::shipped_paper();
  std::erase_if(less.claims, [](const Claim& claim) { return claim.equation == "4.9"; });
  CHECK(uncovered_equations(less) == std::vector<std::string>{"4.9"});
}

TEST_CASE("each finding says where, what is wrong, and how sure that is") {
  const Finding& b1 = finding("3.1.b1");
  CHECK(b1.line == 193);
  CHECK(b1.grade == Grade::misprint);
  CHECK(b1.printed == "b1 = f * h * (2 * M1)");
  CHECK(b1.repair == "b1 = f * h / (2 * M1)");
  CHECK(finding("4.12.z").repair == "z = g");
  CHECK(finding("E4.1.2").mended == Certainty::proved);
  CHECK(finding("T4.8.1").grade == Grade::wrong);
  CHECK(finding("T4.8.1").repair.empty());
  CHECK(finding("R2.3.2").error == Certainty::sampled);  // something that was not found, no certificate at hand
  const Finding& equilibrium = finding("T2.8.7");
  CHECK(equilibrium.grade == Grade::wrong);
  CHECK(equilibrium.repair.find("sigma != 1") != std::string::npos);
  for (const Finding& f : findings()) {
    CAPTURE(f.id);
    CHECK(f.line > 0);
    CHECK_FALSE(f.wrong.empty());
  }
}

TEST_CASE("every finding is listed once, with the claims that it touches") {
  CHECK(finding("E4.14.1.minus_plus").claims == std::vector<std::string>{"E4.14.1.minus_plus", "E4.14.1.plus_plus",
                                                                         "E4.14.1.plus_minus", "E4.14.1.minus_minus"});
  CHECK(finding("A2.4").claims == std::vector<std::string>{"A2.4", "A2.cover"});
  CHECK(finding("A2.4").wrong.find("A2.cover: no line speaks of this bicycle") != std::string::npos);
  CHECK(finding("4.3.F_sigma").claims == std::vector<std::string>{"E4.3.plus", "E4.3.minus"});
  CHECK(finding("4.8.EST").repair == "EST = F * sigma");
  for (const Claim& claim : test::shipped_paper().claims) {  // every graded claim is there, once or as a part
    if (!claim.grade) continue;
    CAPTURE(claim.id);
    const auto touches = [&](const Finding& f) {
      return std::find(f.claims.begin(), f.claims.end(), claim.id) != f.claims.end();
    };
    CHECK(std::any_of(findings().begin(), findings().end(), touches));
    const auto own =
        std::count_if(findings().begin(), findings().end(), [&](const Finding& f) { return f.id == claim.id; });
    CHECK(own <= (claim.part_of.empty() ? 1 : 0));
  }
}

TEST_CASE("what is true instead makes an error certain") {
  VerifyOptions options;
  options.samples = 50;
  options.only = "R2.3";
  VerifyResult result = verify(test::shipped_paper(), options);
  for (ClaimResult& r : result.claims) {
    if (test::shipped_paper().claims[r.claim].id != "R2.3.3") continue;
    r.proved = true;
    r.certificates = {"R2.3.3"};
  }
  const auto list = errata(test::shipped_paper(), result);
  const auto found = std::find_if(list.begin(), list.end(), [](const Finding& f) { return f.id == "R2.3.2"; });
  REQUIRE(found != list.end());
  CHECK(error_certainty(*found) == "proved for all parameters (R2.3.3)");
}

TEST_CASE("text, Markdown, JSON and SARIF hold the same findings") {
  const Json json = Json::parse(errata_json(test::shipped_paper(), findings())),
             sarif = Json::parse(errata_sarif(test::shipped_paper(), findings()));
  CHECK(json["schema"] == "slipproof/errata/1");
  CHECK(sarif["version"] == "2.1.0");
  const Json& results = sarif["runs"][0]["results"];
  REQUIRE(json["findings"].size() == findings().size());
  REQUIRE(results.size() == findings().size());
  const std::string text = errata_text(test::shipped_paper(), findings()),
                    markdown = errata_markdown(test::shipped_paper(), findings());
  for (std::size_t i = 0; i < findings().size(); ++i) {
    const Finding& f = findings()[i];
    CHECK(json["findings"][i]["id"] == f.id);
    CHECK(results[i]["locations"][0]["physicalLocation"]["region"]["startLine"] == f.line);
    CHECK(results[i]["message"]["text"].get<std::string>().find(f.wrong) != std::string::npos);
    CHECK(text.find("[" + f.id + "]") != std::string::npos);
    CHECK(markdown.find("## Line " + std::to_string(f.line) + ", " + f.id) != std::string::npos);
  }
}
