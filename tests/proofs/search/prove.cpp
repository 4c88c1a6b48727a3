// The prover finds the shipped certificates again, byte for byte, and says undecided of what is false.
#include "proofs/search/prove.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "proofs/check/files.hpp"
#include "proofs/search/prove_files.hpp"
#include "proofs/search/small_statement.hpp"
#include "support/crew_ranks.hpp"
#include "support/how_many.hpp"
#include "support/papers/shipped.hpp"
#include "support/replaced.hpp"
#include "support/run_program.hpp"

using slipproof::test::read_file;
using slipproof::test::replaced;
using slipproof::test::shipped_certificates;
using slipproof::test::shipped_folder;
using slipproof::test::TemporaryFolder;

TEST_CASE("certificates of Assertions 1 to 4 are found again, byte for byte") {
  for (const char* name : {"A1.1.always", "A1.1.only-then", "A2.1.repaired.always", "A2.2.repaired.only-then",
                           "A3.1.always", "A3.2", "A4.1.always", "A4.3", "A5.1.repaired.3"}) {
    const auto statement = shipped_certificates / (std::string(name) + ".statement");
    const slipproof::ProofOutcome outcome = slipproof::prove_statement(statement.string(), read_file(statement));
    CHECK(outcome.theorem == name);
    REQUIRE(outcome.proved());
    CHECK(outcome.certificate == read_file(shipped_certificates / (std::string(name) + ".cert")));
  }
}

TEST_CASE("a statement that no sample refutes and no search proves stays undecided, with what was left") {
  // The wrong end of Assertion 1: the motion exists up to xi1, not up to 2 xi1.
  const std::string text =
      replaced(read_file(shipped_certificates / "A1.1.always.statement"), "F * sigma < xi1", "F * sigma < 2*xi1");
  slipproof::prove::Limits limits;
  limits.split_depth = 0;
  limits.quick_samples = limits.samples = 0;
  const slipproof::ProofOutcome outcome = slipproof::prove_statement("false", text, limits);
  CHECK(outcome.verdict == slipproof::ProofOutcome::Verdict::undecided);
  CHECK(!outcome.leftover.empty());
}

TEST_CASE("the limit on steps ends a search, the same way each time") {
  const std::string text = read_file(shipped_folder / "by-hand.theorems" / "A5.2.cell.lifts.3.statement");
  slipproof::prove::Limits limits;
  limits.steps = 20'000;
  const slipproof::ProofOutcome first = slipproof::prove_statement("limited", text, limits);
  CHECK(!first.proved());
  REQUIRE(!first.leftover.empty());
  CHECK(first.leftover.front() == "no step left of 20000");
  CHECK(slipproof::prove_statement("limited", text, limits).leftover == first.leftover);
}

TEST_CASE("what the checker refuses for its limits is undecided, not proved") {
  const std::string text = slipproof::test::statement(
      "real x y z u\nassume p: x > 0 and y > 0 and u > 0\nassume q: x^50*z = y + x^50*x^20\n"
      "assume r: u*z = x^20*u - x^10*y\nshow false\n");
  const slipproof::ProofOutcome outcome = slipproof::prove_statement("powers", text);
  CHECK(outcome.verdict == slipproof::ProofOutcome::Verdict::undecided);
  CHECK(outcome.certificate.empty());
  REQUIRE(!outcome.leftover.empty());
  CHECK(outcome.leftover.front().ends_with("an exponent is out of range"));
}

TEST_CASE("neither the number of threads nor that of ranks changes a byte") {
  std::vector<std::filesystem::path> statements = slipproof::statements_in(shipped_folder / "by-hand.theorems");
  std::erase_if(statements,
                [](const auto& path) { return path.filename().string().find("cell") != std::string::npos; });
  REQUIRE(statements.size() > 20);
  const auto every = slipproof::test::how_many<std::size_t>("SLIPPROOF_BY_HAND_EVERY", 6);
  for (std::size_t i = 0; i * every < statements.size(); ++i) statements[i] = statements[i * every];
  statements.resize((statements.size() + every - 1) / every);
  slipproof::ProveOptions options;
  options.again = true;
  options.threads = 1;
  const auto one = slipproof::prove_files(slipproof::read_statements(statements), options);
  std::vector<slipproof::FileOutcome> several;
  slipproof::test::by_crew(
      3, [&](std::string_view request) { return slipproof::answer_statement(request, options); },
      [&](slipproof::Crew& crew) {
        options.crew = &crew;
        several = slipproof::prove_files(slipproof::read_statements(statements), options);
      });
  REQUIRE(one.size() == several.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    INFO(one[i].outcome.theorem);
    CHECK(one[i].outcome.proved());
    CHECK(!one[i].kept);
    CHECK(one[i].outcome.certificate == several[i].outcome.certificate);
    CHECK(one[i].outcome.certificate == read_file(std::filesystem::path(statements[i]).replace_extension(".cert")));
  }
}

TEST_CASE("of the shipped statements those hold of nothing that the page on mathematics lists") {
  std::set<std::string> vacuous;
  for (const auto& file : slipproof::statements_in(shipped_folder.parent_path())) {
    const std::string certificate = read_file(slipproof::certificate_of(file)), name = file.stem().string();
    if (!slipproof::uses_assumptions_only(certificate)) continue;
    if (slipproof::claims_contradiction(file.string(), read_file(file))) continue;
    const bool paper = file.string().starts_with(shipped_folder.string());
    const bool rest = name.find(".rest.") != std::string::npos;  // nothing is beyond claims that cover everything
    if (paper || !rest) vacuous.insert(name);
  }
  std::set<std::string> listed{"A5.2.repaired.A2.1", "A5.2.repaired.A2.1.exists", "A5.2.repaired.A2.1.one"};
  for (const char* pair : {"1-4", "2-3", "2-4", "3-4", "4-4"}) {
    listed.insert(std::string("A5.2.repaired.rest.one.") + pair);
  }
  listed.insert({"P5.2.1", "P5.2.3"});
  listed.insert({"B1.4", "B7a.4", "B7b.4", "R2.4", "R4.3", "R5.4", "M1.4"});  // of impacts
  listed.insert({"P1.10", "P1.11", "P1.12", "P1.22", "P1.23", "P1.24"});
  listed.insert({"C2.2", "C2.3", "C2.4", "C3.2", "C3.3", "C3.4"});
  CHECK(vacuous == listed);
}

TEST_CASE("an equation is made use of where the signs of all its coefficients are unknown") {
  const auto proved = [](const char* conclusion) {
    const std::string text = std::string("slipproof-statement 1\ntheorem t\nreal a b c x y z\n") +
                             "assume e: a*x + b*y + c*z = 0\nshow " + conclusion + "\n";
    slipproof::prove::Limits limits;
    limits.split_depth = 0;
    limits.products = 0;
    const slipproof::ProofOutcome outcome = slipproof::prove_statement("t.statement", text, limits);
    if (!outcome.proved()) return false;
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "t.statement") << text;
    std::ofstream(folder.path() / "t.cert") << outcome.certificate;
    CHECK(slipproof::check::check_file(folder.path() / "t.cert").verdict == slipproof::check::Verdict::accepted);
    return true;
  };
  CHECK(proved("a*x + b*y + c*z = 0"));
  CHECK(proved("(a + x)*(a*x + b*y + c*z) <= 0"));
  CHECK(!proved("a*x + b*y - c*z = 0"));
  CHECK(!proved("a*x + b*y + c*z + 1 <= 0"));
}

TEST_CASE("a malformed statement is an input error with its line") {
  try {
    slipproof::prove_statement("bad.statement",
                               "slipproof-statement 1\ntheorem t\nreal x\nassume a: x > y\nshow false\n");
    FAIL("no error");
  } catch (const slipproof::InputError& error) {
    REQUIRE(error.diagnostics().size() == 1);
    CHECK(error.diagnostics()[0].file == "bad.statement");
    CHECK(error.diagnostics()[0].line == 4);
  }
}
