// A document in its three forms: each has the same words, and no word becomes markup.
#include "report/document/document.hpp"

#include <doctest/doctest.h>

#include <pugixml.hpp>

#include "base/expression/parser.hpp"

using namespace slipproof;

namespace {

std::string html_of(const Document& document) {
  const ElementTree page("html");
  add_document(page.root(), document);
  pugi::xml_document tree;
  REQUIRE(tree.load_string(page.html().c_str()));
  return page.html();
}

bool found_in(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    longest = std::max(longest, end - begin);
    begin = end + 1;
  }
  return longest;
}

/// Each kind of block once.
Document example() {
  Document document;
  document.title("ladder: 2 contacts");
  document.paragraph(std::string("long ") + std::string(76, 'x') + " end");
  Document& section = document.section("Findings");
  section.fact("what",
               ReportLine{"see ", link_to("A1", "#claim-A1"), ", ", formula(parse_expression("b < 2*h", Sort::truth))});
  section.fact("why", "");
  section.item("stick/lift").line("a = 1/2");
  ReportTable& table = document.table({{"claim", {"says", true, 6}}});
  table.row({"A1", ReportCell::count(12, true)}).line("by A1.cert");
  table.row({"longer", ReportCell::count(0), "unexpected"});
  document.details("More").verbatim("a\n  b");
  document.status("s VERIFIED holds 1");
  return document;
}

}  // namespace

TEST_CASE("text: content is indented, columns fit their cells, lines have 80 columns") {
  CHECK(text_of(example()) ==
        "ladder: 2 contacts\n"
        "long\n" +
            std::string(76, 'x') +
            " end\n"
            "\nFindings\n"
            "  what: see A1, b < 2 * h\n"
            "  stick/lift\n"
            "    a = 1/2\n"
            "\n  claim     says\n"
            "  A1          12\n"
            "      by A1.cert\n"
            "  longer       0  unexpected\n"
            "\nMore\n"
            "a\n  b\n"
            "\ns VERIFIED holds 1\n");
}

TEST_CASE("text: a table without a head has narrow gaps, and the last cell of a row does not widen its column") {
  Document document;
  ReportTable& table = document.section("Rejected", {1, 3}).table({{{"", false, 6}, {"", false, 4}, ""}});
  table.row({"stick", "N", "-1"});
  table.row({"slip", "a long reason"}).line("below");
  CHECK(text_of(document) == " Rejected\n    stick  N    -1\n    slip   a long reason\n      below\n");
}

TEST_CASE("text: the rows of a titled table are indented below its title") {
  Document document;
  document.table({{"typical", {"wrong", true}}}).titled = true;
  document.table({{"equation", "claims"}});
  CHECK(text_of(document) == "typical    wrong\n\n  equation  claims\n");
  CHECK(markdown_of(document) == "| typical | wrong |\n|---|---:|\n\n| equation | claims |\n|---|---|\n");
}

TEST_CASE("Markdown: headings, lists, tables followed by the content below their rows") {
  const std::string text = markdown_of(example());
  CHECK(text.starts_with("# ladder: 2 contacts\n\nlong "));
  CHECK(found_in(text, "\n\n## Findings\n\n- **what**: see A1, `b < 2 * h`\n- stick/lift\n\n  a = 1/2\n\n"));
  CHECK(found_in(text,
                 "\n\n| claim | says |  |\n|---|---:|---|\n| A1 | 12 |  |\n| longer | 0 | unexpected |\n\n"
                 "- **A1**\n\n  by A1.cert\n\n"));
  CHECK(found_in(text, "<details><summary>More</summary>\n\n```\na\n  b\n```\n\n</details>\n\n`s VERIFIED holds 1`\n"));
}

TEST_CASE("HTML: formulas are typeset, zeros and alarming counts are marked, neighbours share a list") {
  const std::string html = html_of(example());
  CHECK(found_in(html, "<dd>see <a href=\"#claim-A1\">A1</a>, <math>"));
  CHECK(found_in(html, "<td class=\"number alarm\">12</td>"));
  CHECK(found_in(html, "<td class=\"number none\">0</td>"));
  CHECK(found_in(html, "<th scope=\"col\">says</th>"));
  CHECK(found_in(html, "<td colspan=\"2\"><p>by A1.cert</p></td>"));
  Document list;
  list.item("one");
  list.item("two");
  CHECK(found_in(html_of(list), "<ul>\n<li>one</li>\n<li>two</li></ul>"));
}

TEST_CASE("a section in a section has the next heading, in Markdown and in HTML") {
  Document document;
  document.section("outer").section("inner").line("text");
  CHECK(markdown_of(document) == "## outer\n\n### inner\n\ntext\n");
  CHECK(found_in(html_of(document), "<h3>outer</h3>\n<h4>inner</h4>\n<p>text</p>"));
}

TEST_CASE("no text becomes markup, in Markdown and in HTML") {
  const std::string hostile = "# *a* _b_ [c](d) `e` <img src=x> | f\n- g";
  Document document;
  document.paragraph(hostile);
  document.table({{"x"}}).row({ReportLine(code("a | `b`"))});
  CHECK(markdown_of(document).starts_with("\\# \\*a\\* \\_b\\_ \\[c](d) \\`e\\` \\<img src=x> \\| f - g\n"));
  CHECK(found_in(markdown_of(document), "| `` a \\| `b` `` |\n"));
  CHECK_FALSE(found_in(html_of(document), "<img"));
  // Signs that are not markup stay as they are, and so do formulas.
  Document harmless;
  harmless.paragraph("-1 <= b < 1 and 2 * h, N2_1, $\\xi_1 * b_2$, slip-/slip+");
  CHECK(markdown_of(harmless) == "-1 <= b < 1 and 2 * h, N2_1, $\\xi_1 * b_2$, slip-/slip+\n");
}

TEST_CASE("for a terminal lines end at 80 columns, and headings are bold; no word is lost") {
  Document document;
  std::string words = "a";
  for (int i = 0; i < 60; ++i) words += " word" + std::to_string(i);
  document.title(words);
  document.line("exact  blanks");
  document.section(words).fact("why", words);
  document.status("s VERIFIED");
  const std::string usual = text_of(document), narrow = text_of(document, {true, false});
  CHECK(longest_line(usual) > 80);
  CHECK(longest_line(narrow) <= 80);
  const auto pressed = [](std::string text) {
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    return text;
  };
  CHECK(pressed(usual) == pressed(narrow));
  CHECK(found_in(narrow, "\nexact  blanks\n"));
  CHECK(text_of(document, {false, true}).starts_with("\033[1ma word0 "));
  CHECK(found_in(text_of(document, {true, true}), "\ns VERIFIED\n"));
}

TEST_CASE("for a terminal the cells of a wide table are broken in their columns, others stay") {
  Document document;
  ReportTable& wide = document.table({{"by", {"before the blow", false, 60}, {"n", true}, "after it"}});
  std::string words = "2 = a";
  for (int i = 0; i < 12; ++i) words += " word" + std::to_string(i);
  wide.row({"first", words, "7", words});
  wide.row({"second", "1", "12", "3"});
  const std::string narrow = text_of(document, {true, false});
  CHECK(longest_line(text_of(document)) > 80);
  CHECK(longest_line(narrow) <= 80);
  CHECK(found_in(narrow, "\n  second  1 "));
  for (int i = 0; i < 12; ++i) CHECK(found_in(narrow, " word" + std::to_string(i)));
  // The words of a column stand below each other.
  const std::size_t row = narrow.find("  first"), line = narrow.find('\n', row) + 1;
  CHECK(narrow.compare(line, 10, "          ") == 0);
  CHECK(narrow.compare(line + 10, 4, "word") == 0);

  Document small;
  small.table({{"by", {"before", false, 40}}}).row({"first", "1"});
  CHECK(text_of(small, {true, false}) == text_of(small));
}
