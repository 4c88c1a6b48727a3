// The errata of the shipped paper, and that none of its numbered equations is left out.
#include "report/papers/errata.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "claims/reading/read_claims_file.hpp"
#include "support/papers/shipped.hpp"
#include "support/papers/small_claims.hpp"

using namespace slipproof;
using Json = nlohmann::ordered_json;

namespace {

const Errata& shipped_errata() {
  static const Errata all = [] {
    VerifyOptions options;
    options.samples = 300;
    return errata(test::shipped_paper(), verify(test::shipped_paper(), options));
  }();
  return all;
}
const std::vector<Finding>& findings() {
  return shipped_errata().findings;
}

/// The errata of a small claims file.
struct Judged {
  explicit Judged(const test::SmallClaims& small) : file(parse_claims(small.text(), "small.toml")) {
    VerifyOptions options;
    options.samples = 100;
    result = verify(file, options);
    all = errata(file, result);
  }
  ClaimsFile file;
  VerifyResult result;
  Errata all;
};

test::SmallClaims with_claims(const std::string& claims) {
  test::SmallClaims small;
  small.parameters = "b = { domain = \"b > 0\", meaning = \"b\" }\nf = { domain = \"f > 0\", meaning = \"f\" }\n";
  small.claims = claims;
  return small;
}

/// In whatever form the errata are written.
std::vector<std::string> all_forms(const Judged& judged) {
  const Document document = errata_document(judged.file, judged.all);
  return {text_of(document), markdown_of(document), errata_json(judged.file, judged.all),
          errata_sarif(judged.file, judged.all)};
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
  CHECK(markdown_of(coverage_document(test::shipped_paper())).find("| (4.9) | 308 | E4.9.plus, E4.9.minus |") !=
        std::string::npos);
  ClaimsFile less = test::shipped_paper();
  std::erase_if(less.claims, [](const Claim& claim) { return claim.equation == "4.9"; });
  CHECK(uncovered_equations(less) == std::vector<std::string>{"4.9"});
}

TEST_CASE("each finding says where, what is wrong, and how sure that is") {
  const Finding& b1 = finding("3.1.b1");
  CHECK(b1.line == 193);
  CHECK(b1.grade == Grade::misprint);
  CHECK(to_string(b1.printed) == "b1 = f * h * (2 * M1)");
  CHECK(to_string(b1.repair) == "b1 = f * h / (2 * M1)");
  CHECK(to_string(finding("4.12.z").repair) == "z = g");
  CHECK(finding("E4.1.2").mended == Certainty::proved);
  CHECK(finding("T4.8.1").grade == Grade::wrong);
  CHECK(finding("T4.8.1").repair.empty());
  CHECK(finding("R2.3.2").error == Certainty::sampled);  // something that was not found, no certificate at hand
  const Finding& equilibrium = finding("T2.8.7");
  CHECK(equilibrium.grade == Grade::wrong);
  CHECK(to_string(equilibrium.repair).find("sigma != 1") != std::string::npos);
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
  CHECK(finding("A2.4").wrong.find("A2.cover: no case of the claim covers this bicycle") != std::string::npos);
  CHECK(finding("4.3.F_sigma").claims == std::vector<std::string>{"E4.3.plus", "E4.3.minus"});
  CHECK(to_string(finding("4.8.EST").repair) == "EST = F * sigma");
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
  const auto list = errata(test::shipped_paper(), result).findings;
  const auto found = std::find_if(list.begin(), list.end(), [](const Finding& f) { return f.id == "R2.3.2"; });
  REQUIRE(found != list.end());
  CHECK(error_certainty(*found) == "proved for all parameters (R2.3.3)");
}

TEST_CASE("text, Markdown, JSON and SARIF hold the same findings") {
  const Json json = Json::parse(errata_json(test::shipped_paper(), shipped_errata())),
             sarif = Json::parse(errata_sarif(test::shipped_paper(), shipped_errata()));
  CHECK(json["schema"] == "slipproof/errata/1");
  CHECK(sarif["version"] == "2.1.0");
  const Json& results = sarif["runs"][0]["results"];
  REQUIRE(json["findings"].size() == findings().size());
  REQUIRE(results.size() == findings().size());
  const Document document = errata_document(test::shipped_paper(), shipped_errata());
  const std::string text = text_of(document), markdown = markdown_of(document);
  for (std::size_t i = 0; i < findings().size(); ++i) {
    const Finding& f = findings()[i];
    CHECK(json["findings"][i]["id"] == f.id);
    CHECK(results[i]["locations"][0]["physicalLocation"]["region"]["startLine"] == f.line);
    CHECK(results[i]["message"]["text"].get<std::string>().find(f.wrong) != std::string::npos);
    const std::string place = test::shipped_paper().paper.source + ":" + std::to_string(f.line) + ": " + grade_text(f);
    CHECK(text.find("\n\n" + place + " [" + f.id + "]\n") != std::string::npos);
    CHECK(markdown.find("\n\n## " + place + " \\[" + f.id + "]\n") != std::string::npos);
  }
}

TEST_CASE("a refuted claim without a grade is a finding, false until somebody says otherwise, and that is said") {
  const Judged judged(
      with_claims(test::formula_claim("X1", "b = 2*b") + test::formula_claim("X2", "b < 0", "grade = \"gap\"\n")));
  REQUIRE(judged.all.findings.size() == 2);
  CHECK(judged.all.findings[0].grade == Grade::wrong);
  CHECK_FALSE(judged.all.findings[0].graded);
  CHECK(judged.all.findings[1].graded);
  CHECK(grade_text(judged.all.findings[0]) == "false (no grade is given)");
  for (const std::string& form : all_forms(judged)) {
    CAPTURE(form);
    CHECK(form.find("X1") != form.npos);
    CHECK((form.find("no grade is given") != form.npos || form.find("\"graded\": false") != form.npos));
  }
  CHECK(all_forms(judged).front().find("2 findings: 0 misprint, 1 gap, 0 boundary, 1 false") != std::string::npos);
}

TEST_CASE("a refuted part of a finding that was not judged is a finding itself") {
  Judged judged(with_claims(test::formula_claim("X1", "b = b + 1", "grade = \"false\"\n") +
                            test::formula_claim("X2", "b = b + 2", "part_of = [\"X1\"]\n")));
  CHECK(judged.all.findings.size() == 1);
  std::erase_if(judged.result.claims, [](const ClaimResult& r) { return r.claim == 0; });
  const Errata rest = errata(judged.file, judged.result);
  REQUIRE(rest.findings.size() == 1);
  CHECK(rest.findings[0].id == "X2");
}

TEST_CASE("no form of the errata is an all-clear where claims are undecided, vacuous, or none was judged") {
  const Judged open(with_claims(test::formula_claim("X1", "b/(b - b) = 1") + test::formula_claim("X2", "b > 0")));
  CHECK(open.all.findings.empty());
  for (const std::string& form : all_forms(open)) {
    CAPTURE(form);
    CHECK(form.find("1 is undecided (X1)") != form.npos);
    CHECK(form.find("no all-clear") != form.npos);
  }
  const Judged empty(with_claims(test::formula_claim("X1", "b > 0", "region = \"b < 0\"\n")));
  CHECK(standing_text(empty.all).find("1 is vacuous (X1)") != std::string::npos);
  CHECK(standing_text(empty.all).find("no all-clear") != std::string::npos);
  const Errata none = errata(open.file, VerifyResult{});
  CHECK(standing_text(none) == "No claim was judged: nothing is known.");
  const Judged fine(with_claims(test::formula_claim("X1", "b + f > b")));
  CHECK(standing_text(fine.all).find("no all-clear") == std::string::npos);
}

TEST_CASE("the counts of the shipped paper add up, in words") {
  const Standing& s = shipped_errata().standing;
  const ClaimCounts& printed = s.claims.printed;
  CHECK(printed.proved + printed.held + printed.refuted + printed.open() == printed.judged);
  CHECK(s.claims.ours.judged == 0);
  CHECK(printed.refuted - s.shared + s.definitions + s.others == findings().size());
  const std::string sum = sum_text(shipped_errata());
  CHECK(sum.starts_with(std::to_string(printed.refuted) + " claims are refuted, and there are " +
                        std::to_string(findings().size()) + " findings."));
}

TEST_CASE("a condition that is always true is said in words") {
  for (const Finding& f : findings()) {
    CAPTURE(f.id);
    CHECK(to_string(f.printed).find(": true") == std::string::npos);
    CHECK(to_string(f.repair).find(": true") == std::string::npos);
  }
}
