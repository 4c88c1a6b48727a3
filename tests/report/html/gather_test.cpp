// What is gathered for a page: a paper of one's own, measurements, solvers' outputs, certificates.
#include "base/input/diagnostic.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "proofs/statement/undecided.hpp"
#include "report/html/small_page.hpp"
#include "report/html/trade_data.hpp"
#include "report/scenes/trade_report.hpp"
#include "support/papers/small_claims.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using namespace slipproof::test;

TEST_CASE("a paper of one's own asks, answers, has numbers of its scenes, and says what it leaves open") {
  const std::string root = SLIPPROOF_SOURCE_DIR;
  test::SmallClaims small;
  small.parameters = "b = { domain = \"b > 0\", meaning = \"b\" }\n";
  small.claims = "[[claim]]\nid = \"X\"\nline = 7\nstatement = \"s\"\nkind = \"formula\"\nholds = \"b > 0\"\n";
  std::string text = small.text();
  const std::string source = "[paper]\n";
  text.insert(text.find(source) + source.size(),
              "question = \"Why?\"\nfound = \"Because.\"\nopen = [\"Whether b is 1.\", \"What else.\"]\n"
              "scenes = [\"ambiguous.toml\", \"motorcycle.toml\"]\n");
  const test::TemporaryFolder folder;
  const auto claims = folder.write("claims.toml", text);
  for (const std::string scene : {"ambiguous.toml", "motorcycle.toml"})
    folder.write(scene, test::read_file(root + "/cases/" + scene));
  const ClaimsFile file = parse_claims(text, "claims.toml");
  Certificates certificates(folder.path());
  const PageFolders folders{claims, {}, {}, {}, {}};
  PageInput input = gather(folders, file, certificates);
  const auto inputs = files_of(folders, file);
  CHECK(std::count(inputs.begin(), inputs.end(), folder.path() / "motorcycle.toml") == 1);
  VerifyOptions options;
  options.samples = 20;
  const VerifyResult result = verify(file, options);
  input.result = &result;
  const auto tree = read(page_html(input));
  CHECK(tree.select_node("//*[@id='overview']//p[.='Why?']"));
  CHECK(tree.select_node("//*[@id='overview']//p[.='Because.']"));
  CHECK(tree.select_nodes("//*[@id='open']//li").size() == 2);
  REQUIRE(tree.select_nodes("//*[@id='machines']/div/table/tbody/tr").size() == 2);
  const auto cell = [&](int row, int column) {
    return std::string(tree.select_node(("//*[@id='machines']/div/table/tbody/tr[" + std::to_string(row) + "]/td[" +
                                         std::to_string(column) + "]")
                                            .c_str())
                           .node()
                           .child_value());
  };
  CHECK(cell(1, 1) == "0.4 = 2/5");     // theorem 1 of proofs/two-wheeler
  CHECK(cell(1, 2) == "0.84 = 21/25");  // and theorem 3
  CHECK(cell(1, 3) == "1");
  CHECK(!tree.select_nodes("//*[@id='machines']//svg").empty());
  std::filesystem::remove(folder.path() / "motorcycle.toml");
  CHECK_THROWS_WITH_AS(gather(folders, file, certificates), doctest::Contains("motorcycle.toml"), InputError);
}

TEST_CASE("a claim shows the line that it judges, and the page all lines with their claims and links") {
  test::SmallClaims small;
  small.parameters = "b = { domain = \"b > 0\", meaning = \"b\" }\n";
  for (const std::string id : {"X", "Y"}) {
    small.claims +=
        "[[claim]]\nid = \"" + id + "\"\nline = 2\nstatement = \"s\"\nkind = \"formula\"\nholds = \"b > 0\"\n";
  }
  const test::TemporaryFolder folder;
  const auto page_with = [&](const std::string& lines) {
    folder.write("none.tex", lines);
    const auto claims = folder.write("claims.toml", small.text());
    const ClaimsFile file = read_claims(claims);
    Certificates certificates(folder.path());
    PageInput input = gather({claims, {}, {}, {}, {}}, file, certificates);
    VerifyOptions options;
    options.samples = 5;
    const VerifyResult result = verify(file, options);
    input.result = &result;
    return read(page_html(input));
  };
  const auto tree = page_with(
      "1. First.\n2. \"b\" < 1 & more, from https://example.org/a_(b).\n\nWhere to read\nabout it: "
      "arXiv:2105.00851.\n");
  for (const std::string id : {"X", "Y"}) {
    const std::string quote = "//*[@id='claim-" + id + "']//blockquote";
    CHECK(std::string(tree.select_node((quote + "/a[1]/@href").c_str()).attribute().value()) == "#source-2");
    CHECK(tree.select_node((quote + "/a[@href='https://example.org/a_(b)']").c_str()));
    CHECK(tree.select_node(("//li[@id='source-2']//a[@href='#claim-" + id + "']").c_str()));
  }
  CHECK(tree.select_nodes("//li[@id='source-1']//a").empty());
  CHECK(tree.select_node("//*[@id='source']/p[starts-with(., 'Where to read about it: arXiv:2105')]/a"));
  // Another text, such as LaTeX, is not shown.
  CHECK(page_with("\\section{Lines}\n1. First.\n").select_nodes("//*[@id='source']").empty());
}

TEST_CASE("fingerprints are SHA-256") {
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_CASE("a measurement of trade is read back, and drawn") {
  TradeOptions options;
  options.scenes = 2;
  options.seconds = 0;
  const Trade trade = measure_trade(options);
  const test::TemporaryFolder folder;
  const Trade back = read_trade(folder.write("trade.json", trade_json(trade)));
  REQUIRE(back.rows.size() == trade.rows.size());
  for (std::size_t i = 0; i < back.rows.size(); ++i) {
    CHECK(back.rows[i].type == trade.rows[i].type);
    CHECK(back.rows[i].wrong == trade.rows[i].wrong);
    CHECK(back.rows[i].worst_force == trade.rows[i].worst_force);
  }
  PageInput input = small_input();
  input.figures.clear();
  input.scenes.clear();
  input.trade = back;
  CHECK(!read(page_html(input)).select_nodes("//svg[@class='scatter']").empty());
  for (const std::string bad : {"", "[]", "{\"schema\":\"slipproof/trade/2\"}", "{\"schema\":\"slipproof/trade/1\"}"}) {
    CHECK_THROWS_AS(read_trade(folder.write("bad.json", bad)), InputError);
  }
}

TEST_CASE("a solver's outputs are judged as the table of cases/solvers says") {
  const SolverVerdicts verdicts = certify_solver(SLIPPROOF_SOURCE_DIR "/cases/solvers/plain-enumerator.csv");
  CHECK(verdicts.verdicts == std::array<std::uint64_t, 6>{145, 10, 7, 10, 0, 0});
  CHECK(verdicts.unfounded == 10);
}

TEST_CASE("everything that comes with the program is gathered") {
  const std::string root = SLIPPROOF_SOURCE_DIR;
  const test::TemporaryFolder folder;
  const auto claims = folder.write("claims.toml", test::read_file(root + "/proofs/rozenblat-yashin/claims.toml"));
  std::filesystem::create_directory(folder.path() / "certificates");
  for (const std::string name : {"A1.1a.statement", "A1.1a.cert", "A1.2a.statement"}) {
    folder.write("certificates/" + name, test::read_file(test::shipped_certificates / name));
  }
  folder.write("certificates/A1.1.always.statement",
               test::read_file(test::shipped_certificates / "A1.1.always.statement"));
  folder.write("certificates/A1.1.always.cert", undecided_text("A1.1.always", {"no step left of 7"}));
  Certificates certificates(folder.path());
  PageInput input = gather({claims, root + "/cases/city-bicycle.toml", root + "/cases", root + "/cases/solvers", {}},
                           test::shipped_paper(), certificates);
  CHECK(input.figures.empty());  // there is no figures.toml beside the claims
  CHECK(input.scenes.size() >= 10);
  input.scenes.clear();  // other tests draw them
  CHECK(input.solvers.size() == 12);
  REQUIRE(input.certificates.size() == 3);
  CHECK(input.certificates[0].state == CertificateState::undecided);
  CHECK(input.certificates[1].state == CertificateState::accepted);
  CHECK(input.certificates[2].state == CertificateState::missing);
  // Each is called what it is, and none of them rejected.
  VerifyOptions options;
  options.samples = 5;
  options.lines = 0;
  options.only = "A1.1";
  const VerifyResult result = verify(test::shipped_paper(), options);
  input.result = &result;
  const auto page = read(page_html(input));
  const auto text = [&](const std::string& path) {
    return std::string(page.select_node(path.c_str()).node().text().get());
  };
  CHECK(page.select_nodes("//section[@id='certificates']//span[@class='chip refuted']").empty());
  const std::string chip = "//details[@id='certificate-A1.1.always']/summary/span[@class='chip undecided']";
  CHECK(page.select_nodes(chip.c_str()).size() == 1);
  CHECK(text("//section[@id='overview']//a[@href='#certificates']/span[@class='detail']") == "1 undecided, 1 missing");
}
