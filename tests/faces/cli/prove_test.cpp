#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/papers/small_claims.hpp"
#include "support/run_program.hpp"

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

std::string interval(const std::string& id, const std::string& forces, const std::string& more) {
  return "[[claim]]\nid = \"" + id +
         "\"\nline = 1\nstatement = \"it rolls\"\nkind = \"interval\"\nmode = \"stick/stick\"\n" +
         "region = \"b > 5\"\nforces = \"" + forces + "\"\n" + more;
}

/// The bicycle rolls for 0 < F < 4/(4 - 5/b).
std::string intervals(const std::string& claims) {
  return slipproof::test::SmallClaims{
      .parameters = "b = { domain = \"b > 0\", line = 1, meaning = \"half the distance of the axles\" }\n",
      .claims = claims}
      .text();
}

const std::string proofs = SLIPPROOF_SOURCE_DIR "/proofs/rozenblat-yashin/claims.theorems/";

}  // namespace

TEST_CASE("prove writes the certificates that check accepts, the same bytes at any number of threads") {
  const TemporaryFolder folder;
  const auto claims = folder.write("claims.toml", one_claim);
  for (const char* theorem : {"A2.4.statement", "A3.2.statement"}) folder.write(theorem, read_file(proofs + theorem));
  const auto out = folder.path() / "out";
  const auto proved = run({"prove", claims, "--out", out});
  CHECK(proved.exit_code == 0);
  CHECK(proved.out.ends_with("s PROVED 3 proved, 0 undecided\n"));
  CHECK(read_file(out / "claims.theorems" / "ahead.statement").find("assume motion") != std::string::npos);
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
  // Scheiderer's form: a sum of squares with real numbers, but with no rational ones.
  const std::string hard =
      "slipproof-statement 1\ntheorem hard\nreal x y z\nshow x^4 + x*y^3 + y^4 - 3*x^2*y*z - 4*x*y^2*z + 2*x^2*z^2 + "
      "x*z^3 + y*z^3 + z^4 >= 0\n";
  folder.write("more/hard.statement", hard);
  const auto one = run({"prove", file});
  CHECK(one.exit_code == 0);
  CHECK(one.out == "proved    means\ns PROVED 1 proved, 0 undecided\n");
  CHECK(run({folder.path() / "means.cert"}, "slipproof-check").exit_code == 0);
  const auto both = run({"prove", file, folder.path() / "more", "--out", folder.path() / "out", "--effort", "500000"});
  CHECK(both.exit_code == 4);
  CHECK(both.out.ends_with("s UNDECIDED 2 proved, 1 undecided\n"));
  CHECK(read_file(folder.path() / "out" / "means.statement") == means);
  CHECK(std::filesystem::exists(folder.path() / "out" / "deep" / "A2.4.cert"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "more" / "deep" / "A2.4.cert"));
  CHECK(run({"check", folder.path() / "out" / "deep"}).exit_code == 0);
  CHECK(run({"prove", file, "--smtlib", folder.path() / "smt"}).exit_code == 0);
  CHECK(read_file(folder.path() / "smt" / "means.smt2").find("(check-sat)") != std::string::npos);
  std::filesystem::create_directory(folder.path() / "empty");
  CHECK(run({"prove", folder.path() / "empty"}).err.find("a folder without statements") != std::string::npos);
  const auto mixed = run({"prove", file, folder.write("claims.toml", one_claim)});
  CHECK(mixed.exit_code == 3);
  CHECK(mixed.err.find("claims.toml: found another file, expected a statement, a theorem file or a folder") !=
        std::string::npos);
  CHECK(run({"prove", folder.path() / "nothing.statement"}).exit_code == 3);
  const auto twin = folder.write("empty/means.statement", means);
  for (const char* option : {"--out", "--smtlib"}) {
    const auto twins = run({"prove", file, twin, option, folder.path() / "both"});
    CHECK(twins.exit_code == 3);
    CHECK(twins.err.find("means.statement: found a statement of the same name as ") != std::string::npos);
  }
  CHECK_FALSE(std::filesystem::exists(folder.path() / "both"));
  CHECK(run({"prove", file, twin}).exit_code == 0);
}

TEST_CASE("an undecided search leaves no values to export") {
  const TemporaryFolder folder;
  const auto file = folder.write("t.statement", "slipproof-statement 1\ntheorem t\nreal x\nshow x^2 >= 0\n");
  folder.write("t.cert", "slipproof-undecided 1\ntheorem t\nbecause the budget is spent\n");
  const auto exported = run({"prove", file, "--smtlib", folder.path() / "smt"});
  CHECK(exported.exit_code == 0);
  CHECK(exported.out.find("s EXPORTED 0 *.witness.smt2 to ") != std::string::npos);
  for (const char* program : {"slipproof", "slipproof-check"}) {
    std::vector<std::string> arguments{folder.path()};
    if (std::string(program) == "slipproof") arguments.insert(arguments.begin(), "check");
    const auto checked = run(arguments, program);
    CHECK(checked.exit_code == 4);
    CHECK(checked.out.ends_with("s UNDECIDED 0 accepted, 0 rejected, 0 missing, 1 undecided, 0 unreadable\n"));
  }
  CHECK(run({"check", "--json", folder.path()}).out.find("\"verdict\": \"undecided\"") != std::string::npos);
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

TEST_CASE("prove says what is false, and where, with exit code 1") {
  const TemporaryFolder folder;
  const auto file =
      folder.write("wrong.statement", "slipproof-statement 1\ntheorem wrong\nreal x\nassume a: x^2 = 4\nshow x > 0\n");
  const auto wrong = run({"prove", file});
  CHECK(wrong.exit_code == 1);
  CHECK(wrong.out == "refuted   wrong at x = -2\ns REFUTED 0 proved, 1 refuted, 0 undecided\n");
  CHECK(read_file(folder.path() / "wrong.cert") ==
        "slipproof-undecided 1\ntheorem wrong\nbecause it is false at x = -2\n");
  const Json json = Json::parse(run({"prove", file, "--json"}).out);
  CHECK(json["theorems"][0]["verdict"] == "refuted");
  CHECK(json["theorems"][0]["counterexample"] == Json{{"x", "-2"}});
  folder.write("wrong.statement", "slipproof-statement 1\ntheorem wrong\nreal x\nassume a: x^2 < x - 1\nshow x > 0\n");
  CHECK(run({"prove", file}).out.starts_with("proved    wrong, its assumptions contradict each other\n"));
  CHECK(run({"prove", file}).out.starts_with("kept      wrong, its assumptions contradict each other\n"));
}

TEST_CASE("prove keeps what is proved, and writes why it has no proof of the rest") {
  const TemporaryFolder folder;
  const auto one = folder.write("one.statement", "slipproof-statement 1\ntheorem one\nreal x\nshow x^2 >= 0\n");
  folder.write("two.statement", "slipproof-statement 1\ntheorem two\nreal x y\nshow x^4 + y^4 >= x^3*y + x*y^3\n");
  const auto first = run({"prove", folder.path(), "--effort", "3000"});
  CHECK(first.exit_code == 4);
  CHECK(first.out.starts_with("proved    one\nundecided two\n"));
  CHECK(first.out.find("          more steps may help: --effort 30000\n") != std::string::npos);
  CHECK(read_file(folder.path() / "two.cert")
            .starts_with("slipproof-undecided 1\ntheorem two\nbecause left with no step left of 3000\n"));
  const std::string certificate = read_file(folder.path() / "one.cert");
  // A comment tells the file from one that is written again.
  folder.write("one.cert", certificate + "# kept\n");
  const auto again = run({"prove", folder.path()});
  CHECK(again.exit_code == 0);
  CHECK(again.out == "kept      one\nproved    two\ns PROVED 2 proved (1 kept), 0 undecided\n");
  CHECK(read_file(folder.path() / "one.cert") == certificate + "# kept\n");
  CHECK(run({"prove", "--again", one}).out == "proved    one\ns PROVED 1 proved, 0 undecided\n");
  CHECK(read_file(folder.path() / "one.cert") == certificate);
  // What is accepted is not given up for want of steps; another statement has no proof yet.
  const std::string two = read_file(folder.path() / "two.cert");
  CHECK(run({"prove", "--again", folder.path() / "two.statement", "--effort", "3000"})
            .out.starts_with("kept      two\n"));
  CHECK(read_file(folder.path() / "two.cert") == two);
  folder.write("one.statement", "slipproof-statement 1\ntheorem one\nreal x\nshow x^2 >= -1\n");
  CHECK(run({"prove", folder.path()}).out.starts_with("proved    one\nkept      two\n"));
}

TEST_CASE("all malformed statements are reported, before any search") {
  const TemporaryFolder folder;
  folder.write("a.statement", "slipproof-statement 1\ntheorem a\nreal x\nshow x > y\n");
  folder.write("b.statement", "slipproof-statement 1\ntheorem b\nreal x\nshow x >= x\n");
  folder.write("c.statement", "slipproof-statement 1\ntheorem c\nshow 1/0 > 0\n");
  const auto outcome = run({"prove", folder.path()});
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.err.find("a.statement:4:") != std::string::npos);
  CHECK(outcome.err.find("c.statement:3:") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "b.cert"));
}

TEST_CASE("an interval is refuted both ways, whatever is expected of it") {
  const TemporaryFolder folder;
  const std::string expected = "expect = \"refuted\"\n";
  const auto claims = folder.write("claims.toml", intervals(interval("right", "0 < F < 4/(4 - 5/b)", "") +
                                                            interval("wide", "0 < F < 8/(4 - 5/b)", expected) +
                                                            interval("narrow", "0 < F < 1/(4 - 5/b)", expected)));
  const auto theorems = folder.path() / "claims.theorems";
  const auto as_expected = run({"prove", claims});
  CHECK(as_expected.exit_code == 0);
  CHECK(as_expected.out.find("settled   wide.refuted: the claim is refuted by wide.always.refuted\n") !=
        std::string::npos);
  CHECK(as_expected.out.find("proved    narrow.refuted\n") != std::string::npos);
  CHECK(run({theorems}, "slipproof-check").exit_code == 0);
  const auto verified = run({"verify", claims, "--samples", "30", "--json"});
  CHECK(verified.exit_code == 0);
  const Json json = Json::parse(verified.out);
  CHECK(json["claims"][0]["verdict"] == "proved");
  CHECK(json["claims"][1]["certificates"] == Json{"wide.always.refuted.met.cert", "wide.always.refuted.fails.cert"});
  CHECK(json["claims"][2]["certificates"] == Json{"narrow.refuted.cert"});
  // The same without being told.
  folder.write("claims.toml",
               intervals(interval("wide", "0 < F < 8/(4 - 5/b)", "") + interval("narrow", "0 < F < 1/(4 - 5/b)", "")));
  const auto not_expected = run({"prove", claims});
  CHECK(not_expected.exit_code == 1);
  CHECK(not_expected.out.find("refuted   wide.always at b = ") != std::string::npos);
  CHECK(not_expected.out.find("refuted   narrow.only-then at b = ") != std::string::npos);
  CHECK(not_expected.out.find("removed   right.always: no claim says this\n") != std::string::npos);
  const Json again = Json::parse(run({"verify", claims, "--samples", "30", "--json"}).out);
  CHECK(not_expected.out.find("removed   narrow") == std::string::npos);  // what refutes a claim is kept
  for (const Json& claim : again["claims"]) {
    CHECK(claim["verdict"] == "refuted");
    CHECK(claim["certificates"].size() > 0);
  }
}

TEST_CASE("decimals stand for what they are, in boundaries and definitions, too") {
  const TemporaryFolder folder;
  const auto claims = folder.write(
      "claims.toml",
      slipproof::test::SmallClaims{
          .parameters = "b = { domain = \"b > 0.25\", line = 1, meaning = \"half the distance of the axles\" }\n",
          .in_setting = "boundaries = [\"b = 0.5\", \"b = max(1.5, k)\"]\n"
                        "definition = [{ symbol = \"k\", line = 1, printed = \"max(0.5, 1e-1)\" }]\n",
          .claims = interval("decimal", "0.0 < F < 0.5", "expect = \"refuted\"\n")}
          .text());
  CHECK(run({"prove", claims}).exit_code == 0);
  const std::string statement = read_file(folder.path() / "claims.theorems" / "decimal.refuted.statement");
  CHECK(statement.find("# split: b - (1 / 2)\n") != std::string::npos);
  CHECK(statement.find("max") == std::string::npos);
}

TEST_CASE("a claim whose statement cannot be read fails, and no other with it") {
  const TemporaryFolder folder;
  const auto claims = folder.write(
      "claims.toml",
      slipproof::test::SmallClaims{
          .parameters = "b = { domain = \"b > 0\", line = 1, meaning = \"b\" }\n",
          .claims = "[[claim]]\nid = \"large\"\nline = 12\nstatement = \"large\"\nkind = \"formula\"\nmode = "
                    "\"stick/stick\"\nholds = \"(a + a_y + phi + eps2 + eps3 + S2 + S3 + N2)^20 > 0\"\n" +
                    interval("small", "false", "expect = \"refuted\"\n")}
          .text());
  const auto outcome = run({"prove", claims});
  CHECK(outcome.exit_code == 4);
  CHECK(outcome.out.find("proved    small.refuted\n") != std::string::npos);
  CHECK(outcome.out.find("failed    large: large:") != std::string::npos);
  CHECK(outcome.out.find("a product has more than 200000 terms") != std::string::npos);
  CHECK(outcome.out.ends_with("s UNDECIDED 1 proved, 0 undecided, 1 claim failed\n"));
  const Json document = Json::parse(run({"prove", "--json", claims}).out);
  REQUIRE(document["failed"].size() == 1);
  CHECK(document["failed"][0]["claim"] == "large");
  CHECK(read_file(folder.path() / "claims.theorems" / "small.refuted.cert") != "");
}

TEST_CASE("several claims files in a folder keep their certificates apart, and all are judged") {
  const TemporaryFolder folder;
  const std::string one = intervals(interval("right", "0 < F < 4/(4 - 5/b)", ""));
  const auto first = folder.write("claims.toml", one);
  CHECK(run({"prove", first}).exit_code == 0);
  const std::string certificate = read_file(folder.path() / "claims.theorems" / "right.always.cert");
  const auto second =
      folder.write("second.toml", intervals(interval("right", "0 < F < 1/(4 - 5/b)", "expect = \"refuted\"\n")));
  const auto proved = run({"prove", second});
  CHECK(proved.exit_code == 0);
  const auto second_theorems = folder.path() / "second.theorems";
  CHECK(proved.out == "proved    right.refuted\nwrote     " + second_theorems.string() +
                          ": 1 new, 0 changed, 0 removed, 0 as before\ns PROVED 1 proved, 0 undecided\n");
  CHECK(read_file(second_theorems / "right.refuted.cert") != "");
  CHECK(read_file(folder.path() / "claims.theorems" / "right.always.cert") == certificate);
  CHECK(read_file(folder.path() / "claims.theorems" / "right.refuted.cert").empty());
  CHECK(run({"prove", first}).out.ends_with("s PROVED 3 proved (3 kept), 0 undecided\n"));

  const Json both = Json::parse(run({"verify", folder.path(), "--samples", "30", "--lines", "0", "--json"}).out);
  REQUIRE(both["papers"].size() == 2);
  const std::string name = folder.path().filename().string();
  CHECK(both["papers"][0]["name"] == name);
  CHECK(both["papers"][0]["proved"] == 1);
  CHECK(both["papers"][1]["name"] == name + ".second");
  CHECK(both["papers"][1]["refuted"] == 1);
  CHECK(both["papers"][1]["missing"] == 0);
  folder.write("mechanism.toml", "schema = \"slipproof/mechanism/1\"\n");
  folder.write("empty.toml", "");
  CHECK(Json::parse(run({"verify", folder.path(), "--samples", "30", "--lines", "0", "--json"}).out)["papers"].size() ==
        2);
}

TEST_CASE("prove of a claims file leaves the papers in folders below alone") {
  const TemporaryFolder folder;
  const auto claims = folder.write("claims.toml", intervals(interval("right", "0 < F < 4/(4 - 5/b)", "")));
  const std::string mine = "slipproof-statement 1\ntheorem mine\nreal x\nshow x^2 >= 0\n";
  for (const char* below : {"lemmas", "other/lemmas", "papers/one/certificates", "out/certificates"}) {
    std::filesystem::create_directories(folder.path() / below);
    folder.write(std::string(below) + "/" + std::to_string(std::string_view(below).size()) + ".statement", mine);
  }
  folder.write("other/claims.toml", "");  // whatever is in it
  folder.write("papers/one/paper.toml", "# a paper\nschema = 'slipproof/claims/1'\n");
  const auto outcome = run({"prove", claims});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.ends_with("s PROVED 4 proved, 0 undecided\n"));
  CHECK(std::filesystem::exists(folder.path() / "lemmas" / "6.cert"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "other/lemmas/12.cert"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "papers/one/certificates/23.cert"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "out/certificates/16.cert"));
}
