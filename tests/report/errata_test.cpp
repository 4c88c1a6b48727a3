// The errata of the shipped paper, and that none of its numbered equations is left out.
#include "report/errata.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

using namespace slipproof;
using Json = nlohmann::json;

namespace {

const ClaimsFile& paper() {
  static const ClaimsFile file = read_claims(SLIPPROOF_SOURCE_DIR "/proofs/rozenblat-yashin/claims.toml");
  return file;
}

const std::vector<Finding>& findings() {
  static const std::vector<Finding> list = [] {
    VerifyOptions options;
    options.samples = 300;
    return errata(paper(), verify(paper(), options));
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
  CHECK(paper().paper.equations.size() == 31);  // (1.1)-(1.5), (2.1)-(2.8), (3.1), (4.1)-(4.17)
  CHECK(uncovered_equations(paper()).empty());
  CHECK(coverage_markdown(paper()).find("| (4.9) | 308 | E4.9.plus, E4.9.minus |") != std::string::npos);
  ClaimsFile less = paper();
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
  CHECK(finding("R2.3.2").error == Certainty::sampled);  // something that was not found
  const Finding& equilibrium = finding("T2.8.7");
  CHECK(equilibrium.grade == Grade::wrong);
  CHECK(equilibrium.repair.find("sigma != 1") != std::string::npos);
  for (const Finding& f : findings()) {
    CAPTURE(f.id);
    CHECK(f.line > 0);
    CHECK_FALSE(f.wrong.empty());
  }
}

TEST_CASE("text, Markdown, JSON and SARIF hold the same findings") {
  const Json json = Json::parse(errata_json(paper(), findings())),
             sarif = Json::parse(errata_sarif(paper(), findings()));
  CHECK(json["schema"] == "slipproof/errata/1");
  CHECK(sarif["version"] == "2.1.0");
  const Json& results = sarif["runs"][0]["results"];
  REQUIRE(json["findings"].size() == findings().size());
  REQUIRE(results.size() == findings().size());
  const std::string text = errata_text(paper(), findings()), markdown = errata_markdown(paper(), findings());
  for (std::size_t i = 0; i < findings().size(); ++i) {
    const Finding& f = findings()[i];
    CHECK(json["findings"][i]["id"] == f.id);
    CHECK(results[i]["locations"][0]["physicalLocation"]["region"]["startLine"] == f.line);
    CHECK(results[i]["message"]["text"].get<std::string>().find(f.wrong) != std::string::npos);
    CHECK(text.find("[" + f.id + "]") != std::string::npos);
    CHECK(markdown.find("## Line " + std::to_string(f.line) + ", " + f.id) != std::string::npos);
  }
}
