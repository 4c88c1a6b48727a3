// prove and theorem files: written whole or not at all; what is accepted is kept.
#include <doctest/doctest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "support/papers/small_claims.hpp"
#include "support/run_program.hpp"

using slipproof::test::quoted;
using slipproof::test::read_file;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

std::string statement(const std::string& name, const std::string& shown) {
  return "slipproof-statement 1\ntheorem " + name + "\nreal x\nshow " + shown + "\n";
}

std::string paper(const std::vector<std::string>& ids) {
  std::string claims;
  for (const std::string& id : ids) {
    claims += "[[claim]]\nid = \"" + id +
              "\"\nline = 1\nstatement = \"it rolls\"\nkind = \"interval\"\nmode = \"stick/stick\"\nregion = \"b > "
              "5\"\nforces = \"0 < F < 4/(4 - 5/b)\"\n";
  }
  return slipproof::test::SmallClaims{
      .parameters = "b = { domain = \"b > 0\", line = 1, meaning = \"half the distance of the axles\" }\n",
      .claims = claims}
      .text();
}

std::size_t place(const std::string& text, const std::string& name) {
  return text.find("slipproof-statement 1\ntheorem " + name + ".");
}

}  // namespace

TEST_CASE("prove writes one file for a claims file, in the order of the claims, and says what changed") {
  const TemporaryFolder folder;
  const auto claims = folder.write("paper.toml", paper({"second", "first"}));
  const auto theorems = folder.path() / "paper.theorems";
  const auto once = run({"prove", claims});
  CHECK(once.exit_code == 0);
  CHECK(once.out.find("wrote     " + theorems.string() + ": 6 new, 0 changed, 0 removed, 0 as before\n") !=
        std::string::npos);
  const std::string text = read_file(theorems);
  CHECK(text.starts_with("slipproof-claims 1\n"));
  CHECK(place(text, "second") < place(text, "first"));
  CHECK(run({folder.path()}, "slipproof-check").exit_code == 0);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 2);

  // Nothing to do: the file is not touched.
  const auto before = std::filesystem::last_write_time(theorems);
  const auto again = run({"prove", claims});
  CHECK(again.out.ends_with("s PROVED 6 proved (6 kept), 0 undecided\n"));
  CHECK(again.out.find("wrote") == std::string::npos);
  CHECK(std::filesystem::last_write_time(theorems) == before);

  // A mutated byte of a certificate is refused, and that certificate alone is searched for again.
  std::string mutated = text;
  mutated.replace(mutated.find("\nterm 1 "), 8, "\nterm 3 ");
  folder.write("paper.theorems", mutated);
  CHECK(run({folder.path()}, "slipproof-check").exit_code == 5);
  CHECK(run({"verify", claims, "--samples", "20", "--lines", "0", "--quiet"}).exit_code == 5);
  const Json json = Json::parse(run({"prove", claims, "--json"}).out);
  REQUIRE(json["files"].size() == 1);
  CHECK(json["files"][0]["changed"] == 1);
  CHECK(json["files"][0]["as_before"] == 5);
  CHECK(read_file(theorems) == text);

  // A claim that is gone takes its theorems along; what is kept is kept byte for byte.
  folder.write("paper.toml", paper({"first"}));
  const auto less = run({"prove", claims});
  CHECK(less.out.find("removed   second.always: no claim says this\n") != std::string::npos);
  CHECK(less.out.find(": 0 new, 0 changed, 3 removed, 3 as before\n") != std::string::npos);
  CHECK(read_file(theorems).ends_with(text.substr(place(text, "first"))));
}

TEST_CASE("a theorem file that cannot be written whole stays as it is") {
  const TemporaryFolder folder;
  const auto claims = folder.write("claims.toml", paper({"first"}));
  const auto theorems = folder.path() / "claims.theorems";
  REQUIRE(run({"prove", claims}).exit_code == 0);
  const std::string before = read_file(theorems);
  folder.write("claims.toml", paper({"first", "second"}));
  const std::string program = SLIPPROOF_BINARY_DIR "/slipproof";  // no file may grow at all
  const int full = std::system(
      ("ulimit -f 0 && " + quoted(program) + " prove " + quoted(claims.string()) + " >/dev/null 2>&1").c_str());
  CHECK(WEXITSTATUS(full) == 6);
  CHECK(read_file(theorems) == before);
  if (::geteuid() != 0) {
    std::filesystem::permissions(folder.path(),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    CHECK(run({"prove", claims}).exit_code == 6);
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
    CHECK(read_file(theorems) == before);
  }
  // What prove cannot read it does not replace.
  folder.write("claims.theorems", "my notes\n");
  const auto refused = run({"prove", claims});
  CHECK(refused.exit_code == 3);
  CHECK(refused.err.find("claims.theorems:1: found another text, expected `slipproof-claims 1`") != std::string::npos);
  CHECK(read_file(theorems) == "my notes\n");
}

TEST_CASE("the folder of an earlier version is read, by all programs, and prove makes a file of it") {
  const TemporaryFolder folder;
  const auto claims = folder.write("claims.toml", paper({"first"}));
  const auto theorems = folder.path() / "claims.theorems";
  REQUIRE(run({"prove", claims}).exit_code == 0);
  const std::string text = read_file(theorems);
  std::filesystem::create_directory(folder.path() / "certificates");
  folder.write("certificates/claims.canonical", read_file(theorems / "claims.canonical"));
  for (const char* name : {"first.always", "first.only-then", "first.defined"}) {
    for (const std::string ending : {".statement", ".cert"}) {
      const std::string part = read_file(theorems / (name + ending));
      REQUIRE_FALSE(part.empty());
      // A comment tells the certificate from one that is found again.
      folder.write("certificates/" + (name + ending), part + (ending == ".cert" ? "# of before\n" : ""));
    }
  }
  std::filesystem::remove(theorems);
  CHECK(run({folder.path()}, "slipproof-check")
            .out.ends_with("s ACCEPTED 3 accepted, 0 rejected, 0 missing, 0 undecided, 0 unreadable\n"));
  const Json verified = Json::parse(run({"verify", claims, "--samples", "30", "--lines", "0", "--json"}).out);
  CHECK(verified["claims"][0]["verdict"] == "proved");
  const auto proved = run({"prove", claims});
  CHECK(proved.out.find("kept      first.always\n") != std::string::npos);
  CHECK(proved.out.find("left      " + (folder.path() / "certificates").string() + ": claims.theorems replaces it\n") !=
        std::string::npos);
  CHECK(read_file(theorems / "first.always.cert").ends_with("# of before\n"));
  CHECK(std::filesystem::exists(folder.path() / "certificates/first.always.cert"));
  // From now on the file counts, and not the folder.
  folder.write("certificates/first.always.cert", "junk\n");
  CHECK(Json::parse(run({"verify", claims, "--samples", "30", "--lines", "0", "--json"}).out)["claims"][0]["verdict"] ==
        "proved");
}

TEST_CASE("prove takes theorem files of one's own") {
  const TemporaryFolder folder;
  const std::string texts = statement("two", "x^2 >= 0") + statement("one", "x^2 + 1 > 0");
  const auto file = folder.write("mine.theorems", texts);
  const auto copied = run({"prove", file, "--out", folder.path() / "out"});
  CHECK(copied.exit_code == 0);
  CHECK(read_file(file) == texts);
  const auto copy = folder.path() / "out" / "mine.theorems";
  CHECK(run({copy}, "slipproof-check").exit_code == 0);
  CHECK(run({"prove", file}).out == "proved    two\nproved    one\nwrote     " + file.string() +
                                        ": 0 new, 2 changed, 0 removed, 0 as before\ns PROVED 2 proved, 0 undecided\n");
  CHECK(read_file(file) == read_file(copy));
  CHECK(run({"prove", file}).out == "kept      two\nkept      one\ns PROVED 2 proved (2 kept), 0 undecided\n");
  CHECK(run({"prove", folder.path() / "out"}).exit_code == 0);
  CHECK(run({"prove", file, "--smtlib", folder.path() / "smt"}).exit_code == 0);
  CHECK(read_file(folder.path() / "smt" / "mine" / "one.smt2").find("; theorem one\n") != std::string::npos);
  // The mistakes of all statements, at their lines in the whole file.
  folder.write("mine.theorems", texts + statement("three", "x > y") + statement("four", "1/0 > 0"));
  const auto bad = run({"prove", file});
  CHECK(bad.exit_code == 3);
  CHECK(bad.err.find("mine.theorems:12:") != std::string::npos);
  CHECK(bad.err.find(": three: ") != std::string::npos);
  CHECK(bad.err.find("mine.theorems:16:") != std::string::npos);
}

TEST_CASE("theorems by hand beside a claims file are proved with it, and stay in their file") {
  const TemporaryFolder folder;
  const auto claims = folder.write("claims.toml", paper({"first"}));
  const std::string texts = statement("square", "x^2 >= 0");
  folder.write("by-hand.theorems", texts);
  const auto proved = run({"prove", claims, "--out", folder.path() / "out"});
  CHECK(proved.exit_code == 0);
  CHECK(proved.out.ends_with("s PROVED 4 proved, 0 undecided\n"));
  CHECK(read_file(folder.path() / "by-hand.theorems") == texts);
  CHECK(run({"prove", claims}).exit_code == 0);
  CHECK(read_file(folder.path() / "by-hand.theorems") == read_file(folder.path() / "out" / "by-hand.theorems"));
  CHECK(read_file(folder.path() / "claims.theorems" / "square.statement").empty());
  CHECK(run({folder.path()}, "slipproof-check").exit_code == 0);
}
