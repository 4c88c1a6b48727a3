// What is printed and what is our own are counted apart in every form of a report.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "claims/reading/read_claims_file.hpp"
#include "report/html/gallery.hpp"
#include "report/html/page.hpp"
#include "report/papers/errata.hpp"
#include "report/papers/papers_report.hpp"
#include "support/papers/small_claims.hpp"

using namespace slipproof;
using Json = nlohmann::ordered_json;

namespace {

JudgedPaper judged(const std::string& claims) {
  test::SmallClaims small;
  small.parameters = "b = { domain = \"b > 0\", meaning = \"b\" }\n";
  small.claims = claims;
  VerifyOptions options;
  options.samples = 50;
  ClaimsFile file = parse_claims(small.text(), "small.toml");
  VerifyResult result = verify(file, options);
  return {"small", std::move(file), std::move(result)};
}

const char* const ours = "origin = \"ours\"\n";

/// Two as printed, of which one is refuted, and three of our own, of which one is.
const JudgedPaper& mixed() {
  static const JudgedPaper paper =
      judged(test::formula_claim("P1", "b + b = 2*b") + test::formula_claim("P2", "b > 1") +
             test::formula_claim("T1", "b + b = 2*b", ours) + test::formula_claim("T2", "b = b", ours) +
             test::formula_claim("T3", "b > 2", ours));
  return paper;
}

std::string page(const JudgedPaper& paper) {
  PageInput input;
  input.claims = &paper.file;
  input.result = &paper.result;
  return page_html(input);
}

bool stands_in(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the errata count claims as printed and of our own apart, and mark findings about our own") {
  const Errata list = errata(mixed().file, mixed().result);
  CHECK(standing_text(list).starts_with(
      "2 claims were judged as printed: 1 is proved for all parameters, 1 is refuted. 3 claims of our own were "
      "judged: 2 are proved for all parameters, 1 is refuted."));
  const std::string text = text_of(errata_document(mixed().file, list));
  CHECK(stands_in(text, "[P2]\n"));
  CHECK(stands_in(text, "[T3], our own\n"));
  const Json json = Json::parse(errata_json(mixed().file, list)), sarif = Json::parse(errata_sarif(mixed().file, list));
  CHECK(json["claims"]["judged"] == 5);
  CHECK(json["claims"]["printed"]["refuted"] == 1);
  CHECK(json["claims"]["ours"]["proved"] == 2);
  CHECK(json["findings"][0]["origin"] == "printed");
  CHECK(json["findings"][1]["origin"] == "ours");
  const Json& run = sarif["runs"][0];
  CHECK(run["properties"]["claims"]["ours"]["judged"] == 3);
  CHECK(run["results"][1]["properties"]["origin"] == "ours");
}

TEST_CASE("verify calls no claim of our own printed, in text, Markdown and JSON") {
  const Document document = verify_document(mixed().file, mixed().result);
  const std::string text = text_of(document);
  CHECK(stands_in(text, "P2          printed   refuted"));
  CHECK(stands_in(text, "T3          ours      refuted"));
  CHECK(stands_in(text, "2 claims were judged as printed"));
  CHECK(stands_in(markdown_of(document), "| T3 | ours | refuted |"));
  const Json json = Json::parse(verify_json(mixed().file, mixed().result));
  CHECK(json["printed"]["judged"] == 2);
  CHECK(json["ours"]["refuted"] == 1);
  for (const Json& claim : json["claims"]) {
    const std::string id = claim["id"];
    CHECK(claim["origin"] == (id.starts_with("P") ? "printed" : "ours"));
    CHECK(claim["reading"] == "printed");
  }
}

TEST_CASE("the list of papers has a row for what is printed and one for our own") {
  const std::vector<JudgedPaper> papers{mixed(), judged(test::formula_claim("T1", "b + b = 2*b", ours))};
  const std::string text = text_of(papers_document(papers));
  CHECK(stands_in(text, "1 source") == false);
  CHECK(stands_in(text,
                  "s REFUTED 2 sources, 2 as printed: proved 1 hold 0 refuted 1 open 0, 4 of our own: proved 3 hold 0 "
                  "refuted 1 open 0, 2 findings"));
  CHECK(stands_in(markdown_of(papers_document(papers)), "| small | ours | 1 |"));  // the second has nothing printed
  const Json json = Json::parse(papers_json(papers));
  CHECK(json["papers"][0]["claims"] == 5);
  CHECK(json["papers"][0]["printed"]["claims"] == 2);
  CHECK(json["papers"][0]["ours"]["claims"] == 3);
  const std::string index = gallery_html(papers, "0", "");
  CHECK(stands_in(index, "2 sources, 2 claims as printed, 4 of our own"));
  CHECK(stands_in(index, "3 claims of our own"));
}

TEST_CASE("a page counts both apart, and a claim of our own is stated, not printed") {
  const std::string html = page(mixed());
  pugi::xml_document tree;
  REQUIRE(tree.load_string(html.c_str(), pugi::parse_default | pugi::parse_doctype));
  const auto number = [&](const std::string& what) {
    return std::string(
        tree.select_node(("//ul[@class='cards']//a[span[@class='what']='" + what + "']/span[@class='number']").c_str())
            .node()
            .child_value());
  };
  CHECK(number("claims as printed") == "2");
  CHECK(number("refuted as printed") == "1");
  CHECK(number("claims of our own") == "3");
  CHECK(stands_in(html, "2 of them proved for all parameters, 1 refuted<"));
  CHECK(stands_in(tree.select_node("//*[@id='claim-P2']//h4").node().child_value(), "As printed"));
  CHECK(stands_in(tree.select_node("//*[@id='claim-T3']//h4").node().child_value(), "As stated"));
  CHECK(tree.select_node("//*[@id='claim-T3'][contains(@class,'ours')]//small[.='our own']"));
  CHECK(tree.select_nodes("//fieldset//input[@id='show-ours']").size() == 1);
}

TEST_CASE("a page without a paper behind it has no headings of one, no paper and nothing printed") {
  const std::string html =
      page(judged(test::formula_claim("T1.2", "b + b = 2*b", ours) + test::formula_claim("A3", "b = b", ours)));
  for (const char* words :
       {"Section ", "Assertion ", "The paper", "the paper", "as printed", "As printed", "authors."}) {
    CAPTURE(words);
    CHECK_FALSE(stands_in(html, words));
  }
  CHECK_FALSE(stands_in(html, "show-ours\""));
}
