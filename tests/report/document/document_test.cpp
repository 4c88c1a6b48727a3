// One document in three forms: the same words in each, and nothing in them becomes markup.
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

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// Each kind of block once.
Document example() {
  Document document;
  document.title("ladder: 2 contacts");
  document.paragraph(std::string("long ") + std::string(76, 'x') + " end");
  Document& section = document.section("Findings");
  section.fact("what", ReportLine{"see ", link("A1", "#claim-A1"), ", ", formula(parse_expression("b < 2*h"))});
  section.fact("why", "");
  section.item("stick/lift").line("a = 1/2");
  ReportTable& table = document.table({{"claim", {"says", true, 6}}});
  table.row({"A1", TableCell::count(12, true)}).line("by A1.cert");
  table.row({"longer", TableCell::count(0), "unexpected"});
  document.details("More").verbatim("a\n  b");
  document.status("s VERIFIED holds 1");
  return document;
}

}  // namespace

TEST_CASE("text: what stands below is indented, columns are as wide as what is in them, lines have 80 columns") {
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

TEST_CASE("Markdown: a heading, a list, a table with what stands below its rows after it") {
  const std::string text = markdown_of(example());
  CHECK(text.starts_with("# ladder: 2 contacts\n\nlong "));
  CHECK(has(text, "\n\n## Findings\n\n- **what**: see A1, `b < 2 * h`\n- stick/lift\n\n  a = 1/2\n\n"));
  CHECK(has(text,
            "\n\n| claim | says |  |\n|---|---:|---|\n| A1 | 12 |  |\n| longer | 0 | unexpected |\n\n"
            "- **A1**\n\n  by A1.cert\n\n"));
  CHECK(has(text, "<details><summary>More</summary>\n\n```\na\n  b\n```\n\n</details>\n\n`s VERIFIED holds 1`\n"));
}

TEST_CASE("HTML: formulas are typeset, counts of 0 and alarming ones are marked, neighbours share a list") {
  const std::string html = html_of(example());
  CHECK(has(html, "<dd>see <a href=\"#claim-A1\">A1</a>, <math>"));
  CHECK(has(html, "<td class=\"number alarm\">12</td>"));
  CHECK(has(html, "<td class=\"number none\">0</td>"));
  CHECK(has(html, "<th scope=\"col\">says</th>"));
  CHECK(has(html, "<td colspan=\"2\"><p>by A1.cert</p></td>"));
  Document list;
  list.item("one");
  list.item("two");
  CHECK(has(html_of(list), "<ul>\n<li>one</li>\n<li>two</li></ul>"));
}

TEST_CASE("no text becomes markup, in Markdown and in HTML") {
  const std::string hostile = "# *a* _b_ [c](d) `e` <img src=x> | f\n- g";
  Document document;
  document.paragraph(hostile);
  document.table({{"x"}}).row({ReportLine(code("a | `b`"))});
  CHECK(markdown_of(document).starts_with("\\# \\*a\\* \\_b\\_ \\[c](d) \\`e\\` \\<img src=x> \\| f - g\n"));
  CHECK(has(markdown_of(document), "| `` a \\| `b` `` |\n"));
  CHECK_FALSE(has(html_of(document), "<img"));
  // What is no markup stays as it is, and so do formulas.
  Document harmless;
  harmless.paragraph("b < 1 and 2 * h, N2_1, $\\xi_1 * b_2$, slip-/slip+");
  CHECK(markdown_of(harmless) == "b < 1 and 2 * h, N2_1, $\\xi_1 * b_2$, slip-/slip+\n");
}
