// Nothing that is put into a document can become markup, and every document is well-formed.
#include "report/markup/element.hpp"

#include <doctest/doctest.h>

#include <pugixml.hpp>
#include <random>

#include "report/markup/number.hpp"

using namespace slipproof;

namespace {

pugi::xml_document parsed(const std::string& html) {
  pugi::xml_document tree;
  const auto result = tree.load_string(html.c_str(), pugi::parse_default | pugi::parse_ws_pcdata_single);
  INFO(result.description() << " at " << result.offset);
  REQUIRE(result);
  return tree;
}

}  // namespace

TEST_CASE("text comes back as it was, whatever it looks like") {
  for (const std::string text :
       {"</p><script>alert(1)</script>", "a & b < c > \"d\" 'e'", "&lt;", "]]>", "<!--", "ξ ≤ ∞"}) {
    CAPTURE(text);
    const ElementTree document("html");
    document.root().add("p").set("title", text).text(text);
    const auto tree = parsed(document.html());
    CHECK(tree.child("html").child("p").text().get() == text);
    CHECK(tree.child("html").child("p").attribute("title").value() == text);
    CHECK(tree.child("html").first_element_by_path("script").empty());
  }
}

TEST_CASE("what XML cannot hold becomes U+FFFD") {
  const ElementTree document("html");
  document.root().add("p").text(std::string("a\0b\x01\x7F\xC0\xAFz\xED\xA0\x80\xEF\xBF\xBF", 14));
  const std::string text = parsed(document.html()).child("html").child("p").text().get();
  CHECK(text.substr(0, 8) ==
        "a\xEF\xBF\xBD"
        "b\xEF\xBF\xBD");
  CHECK(text.find('z') != text.npos);
  for (const char c : text) CHECK((static_cast<unsigned char>(c) >= 0x20 && c != 0x7F));
}

TEST_CASE("any bytes give a well-formed document") {
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    std::string bytes(1 + random() % 60, ' ');
    for (char& c : bytes) c = static_cast<char>(random() % 256);
    const ElementTree document("html");
    document.root().add("p").set("title", bytes).text(bytes);
    parsed(document.html());
    parsed(document.xml());
  }
}

TEST_CASE("a script must not end its own element") {
  const ElementTree document("html");
  const std::string code = "if (a < b && c > d) { e(); }";
  document.root().add("script").code(code);
  const std::string html = document.html();
  CHECK(html.find(code) != html.npos);
  parsed(html);
  CHECK_THROWS_AS(document.root().add("script").code("x('</script>')"), std::invalid_argument);
  CHECK_THROWS_AS(document.root().add("style").code("a]]>b"), std::invalid_argument);
}

TEST_CASE("empty elements have an end tag where HTML asks for one, and only there") {
  const ElementTree document("html");
  document.root().add("td");
  document.root().add("br");
  const std::string html = document.html();
  CHECK(html.find("<td></td>") != html.npos);
  CHECK(html.find("</br>") == html.npos);
}

TEST_CASE("lengths are short") {
  CHECK(short_number(1.0 / 3) == "0.33");
  CHECK(short_number(-0.001) == "0");
  CHECK(short_number(12) == "12");
  CHECK(short_number(-2.5) == "-2.5");
}
