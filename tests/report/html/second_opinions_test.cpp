// Second opinions: read from the table beside the certificates, shown with the claims; nothing of them without it.
#include "report/html/second_opinions.hpp"

#include <doctest/doctest.h>

#include <pugixml.hpp>

#include "base/input/diagnostic.hpp"
#include "proofs/check/files.hpp"
#include "report/html/page.hpp"
#include "support/papers/shipped.hpp"
#include "support/run_program.hpp"

using namespace slipproof;

namespace {

const std::vector<std::string> three{"A1.1a", "A1.1.always", "A1.1.only-then"};

/// What a bad table is refused with, without the file's name.
std::string refusal(const std::string& table) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("opinions.csv", table);
  try {
    read_second_opinions(path, three);
    return "read";
  } catch (const InputError& error) {
    std::string all;
    for (const Diagnostic& d : error.diagnostics()) {
      CHECK(d.file == path);
      all += std::to_string(d.line) + ":" + std::to_string(d.column) + ": " + d.message + "\n";
    }
    return all;
  }
}

/// The text of the evidence of a claim's first reading in a page made with a table, or without one.
struct EvidencePage {
  explicit EvidencePage(const std::string& table) {
    const test::TemporaryFolder folder;
    const auto claims = folder.write("claims.toml", test::read_file(test::shipped_folder / "claims.toml"));
    std::vector<std::string> names = three;
    names.insert(names.end(), {"A1.1.defined", "A1.1a.defined"});
    const auto shipped = [&](const std::string& name) {
      const std::filesystem::path part = test::shipped_certificates / name;
      return test::read_file(part.string() + ".statement") + test::read_file(part.string() + ".cert");
    };
    std::string theorems;
    for (const std::string& name : names) theorems += shipped(name);
    folder.write("claims.theorems", theorems);
    folder.write("by-hand.theorems", shipped("A1.2a"));
    if (!table.empty()) folder.write("second-opinions.csv", table);
    VerifyOptions options;
    options.samples = 5;
    options.only = "A1.1";
    options.certificates = std::make_shared<Certificates>(folder.path());
    const VerifyResult result = verify(test::shipped_paper(), options);
    PageInput input = gather({claims, {}, {}, {}, {}}, test::shipped_paper(), *options.certificates);
    input.result = &result;
    sources = input.sources.size();
    html = page_html(input);
    tree.load_string(html.c_str(), pugi::parse_default | pugi::parse_doctype | pugi::parse_ws_pcdata);
  }

  std::string text(const std::string& path) const {
    std::string all;
    for (const auto& found : tree.select_nodes((path + "//text()").c_str())) {
      const std::string_view text = found.node().value();
      if (text.find_first_not_of(" \n") != text.npos) all += text;
    }
    return all;
  }

  std::string html;
  std::size_t sources = 0;
  pugi::xml_document tree;
};

}  // namespace

TEST_CASE("a table of second opinions is read, also with other ends of lines and without the last one") {
  const test::TemporaryFolder folder;
  const auto path =
      folder.write("opinions.csv", "statement,z3,cvc5,coq\r\nA1.1a,unsat,timeout,accepted\r\nA1.1.always,unknown,-,-");
  const SecondOpinions opinions = read_second_opinions(path, three);
  REQUIRE(opinions.size() == 2);
  CHECK(opinions.at("A1.1a") == Opinions{Opinion::agrees, Opinion::timeout, Opinion::agrees});
  CHECK(opinions.at("A1.1.always") == Opinions{Opinion::unknown, Opinion::not_asked, Opinion::not_asked});
}

TEST_CASE("the tables of the shipped papers are about their statements") {
  for (const char* paper : {"rozenblat-yashin", "rear-drive"}) {
    const std::filesystem::path folder = std::filesystem::path(SLIPPROOF_SOURCE_DIR) / "proofs" / paper;
    std::vector<std::string> statements;
    for (const auto& file : check::certificates_in(folder)) {
      statements.push_back(file.lexically_relative(folder).replace_extension().generic_string());
    }
    CHECK(read_second_opinions(folder / "second-opinions.csv", statements).size() == statements.size());
  }
}

TEST_CASE("a bad table is refused with all that is wrong, and where") {
  const std::string header = "statement,z3,cvc5,coq\n";
  const std::string no_header = "expected 'statement,z3,cvc5,coq'\n";
  CHECK(refusal("") == "1:1: found the header '', " + no_header);
  CHECK(refusal("statement,z3,coq\n") == "1:1: found the header 'statement,z3,coq', " + no_header);
  CHECK(refusal(header + "A1.1a,unsat,unsat\n") == "2:1: found 3 cells, expected 4\n");
  CHECK(refusal(header + "A1.1a,unsat,unsat,-,-\n") == "2:1: found 5 cells, expected 4\n");
  CHECK(refusal(header + "A1.1b,-,-,-\n") ==
        "2:1: there is no statement 'A1.1b' beside this file; did you mean 'A1.1a'?\n");
  CHECK(refusal(header + "A1.1a,-,-,-\n\nA1.1a,-,-,-\n") == "4:1: statement 'A1.1a' has a line before this one\n");
  CHECK(refusal(header + "A1.1a,sat,unsat ,unsat\n") ==
        "2:7: found 'sat', expected unsat, timeout, unknown or -, as z3 has it\n"
        "2:11: found 'unsat ', expected unsat, timeout, unknown or -, as cvc5 has it\n"
        "2:18: found 'unsat', expected accepted, timeout, unknown or -, as Coq has it\n");
  CHECK(refusal(header + "A1.1a,,accepted,\n") ==
        "2:7: found '', expected unsat, timeout, unknown or -, as z3 has it\n"
        "2:8: found 'accepted', expected unsat, timeout, unknown or -, as cvc5 has it\n"
        "2:17: found '', expected accepted, timeout, unknown or -, as Coq has it\n");
  CHECK_THROWS_AS(read_second_opinions("nowhere.csv", three), InputError);
}

TEST_CASE("the evidence says who agrees and who timed out, the first screen counts, from the table alone") {
  const EvidencePage page(
      "statement,z3,cvc5,coq\n"
      "claims.theorems/A1.1.always,unsat,timeout,accepted\n"
      "claims.theorems/A1.1.only-then,unsat,unsat,-\n"
      "by-hand.theorems/A1.2a,unknown,-,accepted\n");
  CHECK(page.text("//details[@id='claim-A1.1']")
            .find("Second opinions. z3 confirms A1.1.only-then and A1.1.always, was not asked of A1.1.defined; cvc5 "
                  "confirms A1.1.only-then, timed out on A1.1.always, was not asked of A1.1.defined; Coq accepts "
                  "A1.1.always, was not asked of A1.1.only-then and A1.1.defined.") != std::string::npos);
  CHECK(page.text("//details[@id='claim-A1.1a']").find("opinion") == std::string::npos);  // nobody was asked
  // Where the source's lines are not shown, a claim leads to where they can be read.
  CHECK(
      page.tree.select_node("//details[@id='claim-A1.1']//p[@class='place' and contains(., 'line 203')]/a"
                            "[.='arXiv:2105.00851' and @href='https://arxiv.org/abs/2105.00851']"));
  const std::string card = page.text("//section[@id='overview']//li[contains(., 'second opinion')]");
  CHECK(card.starts_with("3"));
  CHECK(card.find("z3 2, cvc5 1, Coq 2") != std::string::npos);
  CHECK(page.text("//table[@class='opinions']//tbody/tr[2]") == "cvc51104");
  CHECK(page.text("//details[@id='certificate-A1.2a']/summary/small") == "also Coq");
  CHECK(page.text("//details[@id='certificate-A1.1.always']/summary/small") == "also z3, Coq");
}

TEST_CASE("without the table, the page says nothing of second opinions") {
  const EvidencePage without(""), with("statement,z3,cvc5,coq\nclaims.theorems/A1.1a,unknown,-,timeout\n");
  CHECK(without.text("//body").find("econd opinion") == std::string::npos);
  CHECK(with.text("//details[@id='claim-A1.1a']")
            .find("Second opinions. z3 could not tell of A1.1a, was not asked of A1.1a.defined; Coq timed out on "
                  "A1.1a, was "
                  "not asked of A1.1a.defined.") != std::string::npos);
  CHECK(with.sources == without.sources + 1);
}

TEST_CASE("a statement that the table has and the folder lacks is refused when the page is made") {
  CHECK_THROWS_AS(EvidencePage("statement,z3,cvc5,coq\nA9.9,unsat,-,-\n"), InputError);
}
