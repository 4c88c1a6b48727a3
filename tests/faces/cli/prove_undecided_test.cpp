// Claims without a value, without a statement, or with the statement of another: what prove says of them.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/papers/small_claims.hpp"
#include "support/run_program.hpp"

using slipproof::test::run;
using slipproof::test::TemporaryFolder;
using Json = nlohmann::json;

TEST_CASE("where prove finds a point at which a claim has no value, verify knows it") {
  const TemporaryFolder folder;
  const auto claims = folder.write(
      "claims.toml",
      slipproof::test::SmallClaims{.parameters = "b = { domain = \"b > 0\", line = 1, meaning = \"b\" }\n",
                                   .claims = "[[claim]]\nid = \"H\"\nline = 1\nstatement = \"H\"\nkind = "
                                             "\"formula\"\nregion = \"b/(29*b - 37) != 0\"\nholds = \"b > 0\"\n"}
          .text());
  const std::vector<std::string> verify{"verify", claims, "--samples", "30", "--lines", "0", "--json"};
  CHECK(Json::parse(run(verify).out)["claims"][0]["verdict"] == "holds");  // no sample is b = 37/29
  const auto proved = run({"prove", claims});
  CHECK(proved.out.find("refuted   H.defined.region at b = 37/29") != std::string::npos);
  const auto verified = run(verify);
  CHECK(verified.exit_code == 4);
  const Json claim = Json::parse(verified.out)["claims"][0];
  CHECK(claim["verdict"] == "undecided");
  CHECK(claim["undecided"] == 1);
  CHECK(claim["explanation"].get<std::string>().starts_with("it has no value at 1 of "));
}

TEST_CASE("claims of which no statement is made are named, with the reason") {
  const TemporaryFolder folder;
  const std::string claims = folder.write("claims.toml", R"(schema = "slipproof/claims/1"
paper = { title = "small", authors = [], source = "none" }
[[setting]]
id = "s"
motions = "strict"
force = { symbol = "P", kind = "internal", domain = "P > 0" }
scene = { M = "1", R = "1", h = "1", b2 = "1", b3 = "1", I1 = "0", I2 = "1", I3 = "1", r1 = "1", r2 = "1", L = "1", f = "f", g = "1", F = "P" }
parameters = { f = { domain = "f > 0", meaning = "friction" } }
[[claim]]
id = "X1"
line = 1
statement = "in the end"
kind = "limit"
parameter = "f"
holds = "f > 7"
)");
  const auto text = run({"prove", claims});
  CHECK(text.exit_code == 4);
  CHECK(text.out.find("no statement of X1: a limit needs `from`: a value of f from which on it can be shown") !=
        std::string::npos);
  CHECK(text.out.find("0 proved, 0 undecided, 1 claim without a statement") != std::string::npos);
  CHECK(run({"prove", claims, "--out", folder.path() / "new"}).exit_code == 4);
  const auto json = run({"prove", "--json", claims});
  CHECK(json.out.find("\"unstated\"") != std::string::npos);
}

TEST_CASE("prove refuses claims whose statements would have one name, and writes no file") {
  const TemporaryFolder folder;
  const auto claims = folder.write(
      "claims.toml",
      slipproof::test::SmallClaims{
          .parameters = "b = { domain = \"b > 0\", line = 1, meaning = \"b\" }\n",
          .claims = "[[claim]]\nid = \"V\"\nline = 1\nstatement = \"two modes\"\nkind = \"formula\"\n"
                    "modes = [\"stick/stick\", \"slip+/stick\"]\nholds = \"a > 0\"\n"
                    "[[claim]]\nid = \"V.1\"\nline = 2\nstatement = \"b\"\nkind = \"formula\"\nholds = \"b > 0\"\n"}
          .text());
  const auto outcome = run({"prove", claims});
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.err.find("the claims V and V.1 both have a statement V.1") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "claims.theorems"));
}
