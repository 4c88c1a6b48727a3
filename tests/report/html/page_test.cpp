// The report: well-formed, the same bytes each time, everything in it escaped, every link leading somewhere.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "claims/reading/read_claims_file.hpp"
#include "report/html/small_page.hpp"
#include "report/papers/explain.hpp"
#include "support/papers/small_claims.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::string& small_page() {
  static const std::string html = page_html(small_input());
  return html;
}

/// Every link leads somewhere in the page, every id is there once, nothing comes from elsewhere.
void check_links(const std::string& html) {
  const auto tree = read(html);
  std::set<std::string> ids;
  for (const auto& found : tree.select_nodes("//*[@id]")) {
    const std::string id = found.node().attribute("id").value();
    CAPTURE(id);
    CHECK(ids.insert(id).second);
  }
  for (const auto& found : tree.select_nodes("//a[@href]")) {
    const std::string href = found.node().attribute("href").value();
    CAPTURE(href);
    if (found.node().attribute("download")) {  // a file inside of the page
      CHECK(href.starts_with("data:text/plain"));
      continue;
    }
    if (href.starts_with("https://arxiv.org/abs/") || href.starts_with("https://doi.org/"))
      continue;  // to be read there
    REQUIRE(href.starts_with("#"));
    CHECK(ids.contains(href.substr(1)));
  }
  for (const auto& found : tree.select_nodes("//*[@fill]")) {
    const std::string fill = found.node().attribute("fill").value();
    if (fill.starts_with("url(#")) CHECK(ids.contains(fill.substr(5, fill.size() - 6)));
  }
  CHECK(tree.select_nodes("//*[@src]").empty());
  CHECK(tree.select_nodes("//link[not(starts-with(@href, 'data:'))]").empty());
  CHECK(html.find("@import") == std::string::npos);
}

}  // namespace

TEST_CASE("the page is well-formed, small, and the same bytes each time") {
  CHECK(small_page().starts_with("<!DOCTYPE html>"));
  read(small_page());
  CHECK(small_page().size() < 3'000'000);
  CHECK(page_html(small_input()) == small_page());
}

TEST_CASE("first there is a sentence of what was found and the picture of the worst finding, then the counts") {
  const auto tree = read(small_page());
  const auto overview = tree.select_node("//section[@id='overview']").node();
  std::vector<std::string> order;
  for (const auto& child : overview.children()) order.emplace_back(child.attribute("class").value());
  const auto place = [&](const std::string& css) { return std::find(order.begin(), order.end(), css) - order.begin(); };
  CHECK(place("headline") < place("worst-finding"));
  CHECK(place("worst-finding") < place("halves"));
  CHECK(place("halves") < place("cards"));
  // Of the false statements Assertion 5 has the most motions: three.
  CHECK(overview.select_nodes("figure[@class='worst-finding']//svg[@class='mechanism']").size() == 3);
  CHECK(overview.select_node("figure[@class='worst-finding']/figcaption//a[@href='#claim-A5.1']"));
  CHECK(overview.select_node("p[@class='authors']/a[@href='https://arxiv.org/abs/2105.00851']"));
  CHECK(overview.select_node("p[@class='authors']/a[@href='https://doi.org/10.48550/arXiv.2105.00851']"));
  const std::string found = small_input().claims->paper.found;
  CHECK(tree.select_node("//meta[@name='description']").node().attribute("content").value() == found);
}

TEST_CASE("the colours of verdicts are apart for readers who do not see green") {
  std::ifstream file(SLIPPROOF_SOURCE_DIR "/src/report/html/style.css");
  const std::string style{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::array<double, 3>> seen;
  for (const char* verdict : {"proved", "holds", "refuted", "undecided", "vacuous"}) {
    const std::string rule = ".fill-" + std::string(verdict) + " { fill: #";
    const std::size_t at = style.find(rule);
    REQUIRE(at != style.npos);
    std::array<double, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double value = std::stoi(style.substr(at + rule.size() + 2 * i, 2), nullptr, 16) / 255.0;
      rgb.at(i) = std::pow(value, 2.2);
    }
    const auto [r, g, b] = rgb;  // Machado, Oliveira and Fernandes (2009), deuteranopia, in linear light
    const std::array<double, 3> linear{0.367322 * r + 0.860646 * g - 0.227968 * b,
                                       0.280085 * r + 0.672501 * g + 0.047413 * b,
                                       -0.011820 * r + 0.042940 * g + 0.968881 * b};
    std::array<double, 3> shown{};
    for (std::size_t i = 0; i < 3; ++i) shown.at(i) = 255 * std::pow(std::clamp(linear.at(i), 0.0, 1.0), 1 / 2.2);
    for (const auto& other : seen) {
      CAPTURE(verdict);
      CHECK(std::hypot(shown[0] - other[0], shown[1] - other[1], shown[2] - other[2]) > 55);
    }
    seen.push_back(shown);
  }
}

TEST_CASE("hostile names are text") {
  const auto tree = read(small_page());
  for (const auto& script : tree.select_nodes("//script")) {
    CHECK(std::string(script.node().text().get()).find("alert") == std::string::npos);
  }
  CHECK(tree.select_nodes("//b[@onmouseover]").empty());
  int shown = 0;
  for (const auto& heading : tree.select_nodes("//figure//bdi")) {
    shown += std::string(heading.node().text().get()).find("<script>alert(1)</script>") != std::string::npos;
  }
  CHECK(shown == 1);
}

TEST_CASE("every link leads somewhere in the page, every id is there once, nothing comes from elsewhere") {
  check_links(small_page());
}

TEST_CASE("links to claims that were left out are no links") {
  VerifyOptions options;
  options.samples = 5;
  options.lines = 0;
  PageInput input = small_input();
  input.figures.clear();
  input.scenes.clear();
  for (const std::string only : {"A5", "E4", "T"}) {
    CAPTURE(only);
    options.only = only;
    const VerifyResult result = verify(test::shipped_paper(), options);
    input.result = &result;
    const std::string html = page_html(input);
    check_links(html);
    if (only == "A5") CHECK(html.find("A1.1") != html.npos);  // A5.2 speaks of it: as text
  }
}

TEST_CASE("every claim is there with its verdicts, every finding in the errata, every counterexample with a picture") {
  const auto tree = read(small_page());
  const VerifyResult& result = small_result();
  for (const ClaimResult& claim : result.claims) {
    const std::string id = "claim-" + small_input().claims->claims[claim.claim].id;
    CAPTURE(id);
    const auto card = tree.select_node(("//details[@id='" + id + "']").c_str()).node();
    REQUIRE(card);
    const Claim& stated = small_input().claims->claims[claim.claim];
    const std::string_view kind = stated.kind().name();
    const bool formulas = kind == "interval" || kind == "formula" || kind == "equivalence" || stated.kind().is_linear();
    CHECK((!formulas || !card.select_nodes(".//math").empty()));
    if (!claim.counterexample) continue;
    CHECK(!card.select_nodes(".//*[@class='counterexample']").empty());
    const bool moves =
        is_about_motions(stated) && claim.counterexample->motions && !claim.counterexample->motions->motions.empty();
    if (moves) CHECK(!card.select_nodes(".//svg[@class='mechanism']").empty());
  }
  CHECK(tree.select_nodes("//section[@id='errata']//li").size() > 20);
}

TEST_CASE("the arithmetic beside a counterexample comes to nothing wrong: each row ends in = 0, 11 rows a motion") {
  const auto tree = read(small_page());
  const auto tables = tree.select_nodes("//details[@class='data by-hand']/table[1]");
  CHECK(tables.size() > 5);
  for (const auto& table : tables) CHECK(table.node().select_nodes(".//tr").size() == 11);
}

TEST_CASE("a row that a formula heads has a name that can be read out") {
  const auto tree = read(small_page());
  const auto headers = tree.select_nodes("//th/math");
  CHECK(headers.size() > 60);
  for (const auto& math : headers) CHECK_FALSE(std::string(math.node().attribute("aria-label").value()).empty());
  CHECK(tree.select_nodes("//th/math[@aria-label='b2']").size() >= 1);
}

TEST_CASE("figures, machines and counterexamples lead to the explorer, where there is one, and nothing else changes") {
  PageInput input = small_input();
  input.figures.resize(1);
  input.model = read_scene(SLIPPROOF_SOURCE_DIR "/cases/city-bicycle.toml");
  input.machines.push_back(read_scene_along(SLIPPROOF_SOURCE_DIR "/cases/city-bicycle.toml"));
  const std::string without = page_html(input);
  CHECK(without.find("explorer") == without.npos);
  input.explorer = "explorer.html";
  const std::string with = page_html(input);
  const auto tree = read(with);
  const auto count = [&](const std::string& where) {
    return tree.select_nodes((where + "//a[starts-with(@href,'explorer.html#scene:=')]").c_str()).size();
  };
  CHECK(count("//figure[@class='model']") == 1);
  CHECK(count("//figure[starts-with(@class,'phase')]") == input.figures.size() + input.scenes.size() + 1);
  CHECK(count("//section[@id='machines']//td") + count("//section[@id='machines']//th") == 1);
  CHECK(count("//p[@class='download']") == tree.select_nodes("//p[@class='download']").size());
}

TEST_CASE("a page that is published names a picture for those who share it") {
  CHECK(small_page().find("og:image") == std::string::npos);
  PageInput input = small_input();
  input.figures.clear();
  input.scenes.clear();
  input.image = "https://example.org/\"a\".png";
  const auto tree = read(page_html(input));
  const auto image = tree.select_node("//meta[@property='og:image']").node();
  CHECK(image.attribute("content").value() == input.image);
}

TEST_CASE("the first page has the problem, the figure, the findings in words and the counts, in this order") {
  const std::string& html = small_page();
  std::size_t last = 0;
  PageInput input = small_input();
  input.figures.resize(1);
  input.model = read_scene(SLIPPROOF_SOURCE_DIR "/cases/city-bicycle.toml");
  const std::string page = page_html(input);
  for (const char* part : {"The problem", "class=\"model\"", "What was found", "claims are refuted, and there are",
                           "What is false", "class=\"cards\"", "id=\"phase\""}) {
    CAPTURE(part);
    const std::size_t at = page.find(part);
    REQUIRE(at != page.npos);
    CHECK(at > last);
    last = at;
  }
  CHECK(html.find("id=\"notation\"") != html.npos);
  CHECK(html.find("How to cite") != html.npos);
}

TEST_CASE("formulas of the errata are typeset, and what is always true is said in words") {
  const auto tree = read(small_page());
  std::size_t parts = 0;
  for (const auto& part : tree.select_nodes("//section[@id='errata']//div[@class='part']")) {
    ++parts;
    const std::string text = part.node().text().get();
    CHECK(text.find("true") == std::string::npos);
  }
  CHECK(parts > 20);
  CHECK(tree.select_nodes("//section[@id='errata']//dd//math").size() > 40);
  CHECK(tree.select_nodes("//section[@id='errata']//dd/code").empty());
}

TEST_CASE(
    "what is wrong has symbols as such, not only beside an operator, and leaves words and names of claims alone") {
  const auto tree = read(small_page());
  std::string plain, symbols;  // what stands beside formulas, what stands in them
  for (const auto& found : tree.select_nodes("//section[@id='errata']//dt[.='wrong']/following-sibling::dd[1]")) {
    for (const auto& text : found.node().select_nodes("text()")) plain += std::string(text.node().value()) + ' ';
    for (const auto& math : found.node().select_nodes("math")) {
      symbols += ' ';
      for (const auto& text : math.node().select_nodes(".//text()")) symbols += text.node().value();
    }
  }
  for (const char* left : {"sigma", "xi2", " f becomes", "k1 and", "with h ", "M1)", "_"}) {
    CAPTURE(left);
    CHECK(plain.find(left) == plain.npos);
  }
  for (const char* kept :
       {"and in slip-/slip+ there are motions", "There is also a motion", "A4.cover", "a continuum"}) {
    CAPTURE(kept);
    CHECK(plain.find(kept) != plain.npos);
  }
  for (const char* set : {" F1", " \xCF\x83", " k1"}) {
    CAPTURE(set);
    CHECK(symbols.find(set) != symbols.npos);
  }
}

TEST_CASE("the note of a claim is typeset as the finding is that it explains") {
  const auto tree = read(small_page());
  const auto note = tree.select_node("//*[@id='claim-R2.3.2']//p[b='Note. ']").node();
  REQUIRE(note);
  CHECK(note.select_nodes("math").size() == 8);  // gap2, phi, g, b2, and the same of the front wheel
  for (const auto& text : note.select_nodes("text()"))
    CHECK(std::string(text.node().value()).find(">=") == std::string::npos);
}

TEST_CASE("each counterexample can be saved as a scene that solve reads") {
  const auto tree = read(small_page());
  const auto links = tree.select_nodes("//a[@download]");
  CHECK(links.size() >= 15);
  const std::string href = links.first().node().attribute("href").value(), head = "data:text/plain;charset=utf-8,";
  REQUIRE(href.starts_with(head));
  std::string text;
  for (std::size_t i = head.size(); i < href.size(); ++i) {
    if (href[i] != '%') {
      text += href[i];
    } else {
      text += static_cast<char>(std::stoi(href.substr(i + 1, 2), nullptr, 16));
      i += 2;
    }
  }
  const test::TemporaryFolder folder;
  CHECK(read_scene(folder.write("scene.toml", text)).name.starts_with("counterexample to "));
}

TEST_CASE("the page of a paper with open claims and no finding is no all-clear") {
  test::SmallClaims small;
  small.parameters = "b = { domain = \"b > 0\", meaning = \"b\" }\n";
  small.claims = "[[claim]]\nid = \"X\"\nline = 7\nstatement = \"s\"\nkind = \"formula\"\nholds = \"1/(b - b) = 1\"\n";
  const ClaimsFile file = parse_claims(small.text(), "small.toml");
  VerifyOptions options;
  options.samples = 20;
  const VerifyResult result = verify(file, options);
  PageInput input;
  input.claims = &file;
  input.result = &result;
  const std::string html = page_html(input);
  CHECK(html.find("no all-clear") != html.npos);
  CHECK(html.find("Nothing was found to be wrong") == html.npos);
  CHECK(html.find("Certified solvers") == html.npos);
  CHECK(html.find("Speed and accuracy") == html.npos);
}
