#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/small_claims.hpp"

using slipproof::test::read_file;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

/// A paper with one claim.
const std::string one_claim =
    slipproof::test::SmallClaims{
        .parameters = "b = { domain = \"b > 0\", line = 1, meaning = \"half the distance of the axles\" }\n",
        .detachment = true,
        .claims = R"([[claim]]
id = "ahead"
line = 1
statement = "it goes ahead"
kind = "formula"
mode = "stick/stick"
holds = "a > 0"
)"}
        .text();

const std::string proofs = SLIPPROOF_SOURCE_DIR "/proofs/rozenblat-yashin/certificates/";

}  // namespace

TEST_CASE("prove writes the certificates that check accepts, the same bytes at any number of threads") {
  const TemporaryFolder folder;
  const auto claims = folder.write("claims.toml", one_claim);
  for (const char* theorem : {"A2.4.statement", "A3.2.statement"}) folder.write(theorem, read_file(proofs + theorem));
  const auto out = folder.path() / "out";
  const auto proved = run({"prove", claims, "--out", out});
  CHECK(proved.exit_code == 0);
  CHECK(proved.out.ends_with("s PROVED 3 proved, 0 undecided\n"));
  CHECK(read_file(out / "certificates" / "ahead.statement").find("assume motion") != std::string::npos);
  const std::string certificate = read_file(out / "A2.4.cert");
  CHECK_FALSE(certificate.empty());
  CHECK(run({"prove", claims, "--out", out, "--threads", "1"}).exit_code == 0);
  CHECK(read_file(out / "A2.4.cert") == certificate);
  CHECK(run({"check", out}).exit_code == 0);
  CHECK(run({out / "A2.4.cert"}, "slipproof-check").exit_code == 0);
  const Json document = Json::parse(run({"check", "--json", out}).out);
  CHECK(document["schema"] == "slipproof/check/1");
  CHECK(document["certificates"].size() == 3);
}

TEST_CASE("prove --smtlib writes every statement, also those of folders below, and searches for no proof") {
  const TemporaryFolder folder;
  const auto claims = folder.write("claims.toml", "");
  std::filesystem::create_directory(folder.path() / "more");
  folder.write("A2.4.statement", read_file(proofs + "A2.4.statement"));
  folder.write("more/A3.2.statement", read_file(proofs + "A3.2.statement"));
  const auto out = folder.path() / "smt";
  CHECK(run({"prove", claims, "--smtlib", out}).exit_code == 0);
  CHECK(read_file(out / "A2.4.smt2").find("(check-sat)") != std::string::npos);
  CHECK(read_file(out / "more" / "A3.2.smt2").find("; theorem A3.2\n") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "A2.4.cert"));
  folder.write("more/bad.statement", "slipproof-statement 1\ntheorem bad\nshow x > 0\n");
  const auto bad = run({"prove", claims, "--smtlib", out});
  CHECK(bad.exit_code == 3);
  CHECK(bad.err.find("bad.statement:3:") != std::string::npos);
}

TEST_CASE("prove takes statements of one's own, files and folders, without a claims file") {
  const TemporaryFolder folder;
  const std::string means = "slipproof-statement 1\ntheorem means\nreal x y\nshow (x + y)^2 >= 4*x*y\n";
  const auto file = folder.write("means.statement", means);
  std::filesystem::create_directories(folder.path() / "more" / "deep");
  folder.write("more/deep/A2.4.statement", read_file(proofs + "A2.4.statement"));
  folder.write("more/wrong.statement", "slipproof-statement 1\ntheorem wrong\nreal x\nshow x > 0\n");
  const auto one = run({"prove", file});
  CHECK(one.exit_code == 0);
  CHECK(one.out == "proved    means\ns PROVED 1 proved, 0 undecided\n");
  CHECK(run({folder.path() / "means.cert"}, "slipproof-check").exit_code == 0);
  const auto both = run({"prove", file, folder.path() / "more", "--out", folder.path() / "out"});
  CHECK(both.exit_code == 4);
  CHECK(both.out.ends_with("s UNDECIDED 2 proved, 1 undecided\n"));
  CHECK(read_file(folder.path() / "out" / "means.statement") == means);
  CHECK(std::filesystem::exists(folder.path() / "out" / "deep" / "A2.4.cert"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "more" / "deep" / "A2.4.cert"));
  CHECK(run({"check", folder.path() / "out" / "deep"}).exit_code == 0);
  CHECK(run({"prove", file, "--smtlib", folder.path() / "smt"}).exit_code == 0);
  CHECK(read_file(folder.path() / "smt" / "means.smt2").find("(check-sat)") != std::string::npos);
  std::filesystem::create_directory(folder.path() / "empty");
  CHECK(run({"prove", folder.path() / "empty"}).err.find("a folder without *.statement") != std::string::npos);
  const auto mixed = run({"prove", file, folder.write("claims.toml", one_claim)});
  CHECK(mixed.exit_code == 3);
  CHECK(mixed.err.find("claims.toml: found another file, expected a statement or a folder") != std::string::npos);
  CHECK(run({"prove", folder.path() / "nothing.statement"}).exit_code == 3);
  const auto twin = folder.write("empty/means.statement", means);
  for (const char* option : {"--out", "--smtlib", "--coq"}) {
    const auto twins = run({"prove", file, twin, option, folder.path() / "both"});
    CHECK(twins.exit_code == 3);
    CHECK(twins.err.find("means.statement: found a statement of the same name as ") != std::string::npos);
  }
  CHECK_FALSE(std::filesystem::exists(folder.path() / "both"));
  CHECK(run({"prove", file, twin}).exit_code == 0);
}

TEST_CASE("a certificate of another statement is rejected with exit code 5") {
  const TemporaryFolder folder;
  folder.write("A2.4.statement", read_file(proofs + "A2.4.statement"));
  folder.write("A2.4.cert", read_file(proofs + "A3.2.cert"));
  for (const char* program : {"slipproof", "slipproof-check"}) {
    std::vector<std::string> arguments{folder.path() / "A2.4.cert"};
    if (std::string(program) == "slipproof") arguments.insert(arguments.begin(), "check");
    const auto outcome = run(arguments, program);
    CHECK(outcome.exit_code == 5);
    CHECK(outcome.out.find("s REJECTED") != std::string::npos);
  }
}

TEST_CASE("what is not there, or is no statement, exits with 3") {
  const TemporaryFolder folder;
  CHECK(run({"check", folder.path() / "nothing.cert"}).exit_code == 3);
  CHECK(run({"check", folder.path()}).exit_code == 3);
  const auto claims = folder.write("claims.toml", one_claim);
  folder.write("bad.statement", "this is no statement\n");
  const auto outcome = run({"prove", claims, "--out", folder.path() / "out"});
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.err.find("bad.statement:") != std::string::npos);
  CHECK(run({"prove", "/nonexistent/claims.toml"}).exit_code == 3);
}
