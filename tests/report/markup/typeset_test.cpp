// Formulas as MathML: what is nested stays nested, and every statement of the shipped paper is understood.
#include <doctest/doctest.h>

#include <pugixml.hpp>

#include "base/expression/parser.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "report/markup/latex.hpp"
#include "report/markup/mathml.hpp"
#include "report/markup/symbol.hpp"

using namespace slipproof;

namespace {

/// The MathML without what only structures it, for short expectations.
std::string math(std::string_view text) {
  const ElementTree document("p");
  add_sentence(document.root(), "$" + std::string(text) + "$");
  return document.xml();
}

std::string plain(const std::string& xml) {
  pugi::xml_document tree;
  REQUIRE(tree.load_string(xml.c_str()));
  std::string all;
  struct Walker : pugi::xml_tree_walker {
    std::string* all;
    bool for_each(pugi::xml_node& node) override {
      *all += node.value();
      return true;
    }
  } walker;
  walker.all = &all;
  tree.traverse(walker);
  return all;
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != text.npos;
}

}  // namespace

TEST_CASE("symbols have their letters and indices") {
  CHECK(plain_symbol("xi1") == "ξ1");
  CHECK(plain_symbol("b11") == "b11");
  CHECK(plain_symbol("a_y") == "a_y");
  CHECK(plain_symbol("F sigma") == "F σ");
  CHECK(typeset_symbol("N2_1").superscript == "1");
  CHECK(typeset_symbol("N2_1").subscript == "2");
  CHECK(typeset_symbol("gap3").letter == "gap");
  CHECK(typeset_symbol("F_sigma").subscript == "σ");
}

TEST_CASE("a letter or a Greek name with one more letter is set as with an index, so that one symbol is set one way") {
  for (const auto& [short_name, name] : {std::pair{"lr", "l_r"}, {"Iw", "I_w"}, {"muf", "mu_f"}, {"ay", "a_y"}}) {
    CAPTURE(name);
    CHECK(plain_symbol(short_name) == plain_symbol(name));
    CHECK(typeset_symbol(short_name).letter == typeset_symbol(name).letter);
    CHECK(typeset_symbol(short_name).subscript == typeset_symbol(name).subscript);
  }
  CHECK(plain_symbol("mu") == "μ");
  CHECK(plain_symbol("gap") == "gap");
  CHECK(plain_symbol("om") == "ω");
}

TEST_CASE("names of several letters do not run into their neighbours") {
  const auto set = [](const char* text) {
    const ElementTree document("p");
    add_math(document.root(), parse_expression(text, Sort::number));
    return plain(document.xml());
  };
  CHECK(set("share*B") == "share·B");
  CHECK(set("B*share*C") == "B·share·C");
  CHECK(set("share^2*B").find("·") == std::string::npos);
  CHECK(set("F*sign(x)").starts_with("F·sign"));
  CHECK(set("sx*t*D").find("·") == std::string::npos);  // s with the index x
  CHECK(set("2*mu*m").find("·") == std::string::npos);
}

TEST_CASE("fractions, indices and parentheses") {
  CHECK(contains(math("\\frac{1}{2}"), "<mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac>"));
  CHECK(contains(math("M_{0}"), "<msub>"));
  CHECK(contains(math("N_{2}^{2}"), "<msubsup>"));
  CHECK(plain(math("\\xi_{3}<F \\sigma \\leq \\left(b-f h\\right)")) == "ξ3<Fσ≤(b−fh)");
}

TEST_CASE("what is not understood stays as it was written") {
  for (const std::string latex : {"\\unknown{x}", "\\frac{1}", "a_", "{a", "a}", "\\", "\\text{a"}) {
    CAPTURE(latex);
    CHECK(contains(math(latex), "<code>"));
    CHECK(plain(math(latex)) == latex);
  }
  CHECK(contains(math(std::string(100'000, '{')), "<code>"));
  CHECK(contains(math("a" + std::string(100'000, '_')), "<code>"));
}

TEST_CASE("every statement of the shipped papers is set in full") {
  for (const char* paper : {"rozenblat-yashin", "rear-drive"}) {
    const auto claims = read_claims(std::string(SLIPPROOF_SOURCE_DIR) + "/proofs/" + paper + "/claims.toml");
    for (const Claim& claim : claims.claims) {
      const ElementTree document("p");
      add_sentence(document.root(), claim.statement);
      CAPTURE(claim.statement);
      CHECK(!contains(document.xml(), "<code>"));
      CHECK(!contains(plain(document.xml()), "$"));
    }
  }
}
