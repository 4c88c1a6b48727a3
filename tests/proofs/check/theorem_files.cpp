// Theorem files: what is in them is judged as in a folder, and what is no theorem file is refused with its line.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "proofs/check/examples.hpp"
#include "proofs/check/files.hpp"
#include "proofs/check/theorem_file.hpp"
#include "support/run_program.hpp"

using namespace slipproof::check;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

std::string statement(const std::string& name) {
  return "slipproof-statement 1\ntheorem " + name + "\nreal x\nshow x + 1 > x\n";
}

std::string proved(const std::string& name) {
  return statement(name) + header(statement(name)) + "contradiction\nterm 1 goal\nterm 1\nqed\n";
}

std::string undecided(const std::string& name) {
  return statement(name) + "slipproof-undecided 1\ntheorem " + name + "\nbecause it is late\n";
}

const std::string kClaims = "slipproof-claims 1\n# some paper\n";

std::string report(const TemporaryFolder& folder, const std::string& argument) {
  const Report found = check_files({(argument.empty() ? folder.path() : folder.path() / argument).string()});
  std::string text = found.text + found.summary;
  const std::string prefix = folder.path().string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}

}  // namespace

TEST_CASE("a theorem file is judged like a folder with the same texts, by name and by line") {
  const TemporaryFolder folder;
  const std::string text = kClaims + proved("b") + undecided("d") + statement("c") + "# no certificate\n" + proved("a");
  folder.write("some.theorems", text);
  const std::string expected =
      "accepted a\naccepted b\n"
      "missing some.theorems:20: c: there is no certificate\n"
      "undecided some.theorems:17: d: the search ended without a certificate: it is late\n";
  CHECK(report(folder, "some.theorems") ==
        expected + "s MISSING 2 accepted, 0 rejected, 1 missing, 1 undecided, 0 unreadable\n");
  CHECK(report(folder, "") == report(folder, "some.theorems"));
  CHECK(report(folder, "some.theorems/a.cert") ==
        "accepted a\ns ACCEPTED 1 accepted, 0 rejected, 0 missing, 0 undecided, 0 unreadable\n");
  CHECK(report(folder, "some.theorems/a.statement") == report(folder, "some.theorems/a.cert"));
  CHECK(report(folder, "some.theorems/e.cert").starts_with("unreadable some.theorems: there is no theorem e\n"));
  CHECK(report(folder, "none.theorems").starts_with("unreadable none.theorems: there is no such file\n"));

  // The same as a folder of files.
  fs::create_directory(folder.path() / "files");
  for (const auto& [name, theorem] : split_theorems(text).theorems) {
    folder.write("files/" + name + ".statement", theorem.statement.text);
    if (theorem.certificate.line > 0) folder.write("files/" + name + ".cert", theorem.certificate.text);
  }
  const Report files = check_files({(folder.path() / "files").string()});
  const Report parts = check_files({(folder.path() / "some.theorems").string()});
  REQUIRE(files.results.size() == parts.results.size());
  for (std::size_t i = 0; i < files.results.size(); ++i) {
    CHECK(files.results[i].verdict == parts.results[i].verdict);
    CHECK(files.results[i].theorem == parts.results[i].theorem);
  }
  CHECK(files.summary == parts.summary);
}

TEST_CASE("what is wrong with a part has its line in the whole file") {
  const TemporaryFolder folder;
  std::string text = kClaims + proved("a") + proved("b");
  const auto at = text.rfind("term 1\n");
  text.replace(at, 7, "term 2 x\n");
  folder.write("t.theorems", text);
  CHECK(report(folder, "t.theorems").starts_with("accepted a\nrejected t.theorems:21: b: contradiction: "));
  folder.write("t.theorems", kClaims + proved("a") + "slipproof-statement 1\ntheorem b\nreal x\nshow x > y\n");
  CHECK(report(folder, "t.theorems").find("unreadable t.theorems:16: b: show: expected a number or a known name\n") !=
        std::string::npos);
  folder.write("t.theorems", proved("a") + "slipproof-statement 1\ntheorem b\nreal x\t\n");
  CHECK(report(folder, "t.theorems").find("unreadable t.theorems:13:7: b: text: a byte of value 9") !=
        std::string::npos);
}

TEST_CASE("what is no theorem file is refused whole, with the line") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& why) {
    CAPTURE(text);
    folder.write("t.theorems", text);
    const std::string found = report(folder, "t.theorems");
    CHECK(found.starts_with("unreadable t.theorems:" + why + "\ns UNREADABLE 0 accepted"));
    CHECK(report(folder, "") == found);  // it is not passed over
  };
  const std::string begin = "expected 'slipproof-claims 1' or 'slipproof-statement 1'";
  refused("", "1: parts: the file is empty");
  refused("# of mine\n" + proved("a"), "1: parts: " + begin);
  refused("\n" + proved("a"), "1: parts: " + begin);
  refused(std::string("\0", 1) + proved("a"), "1: parts: " + begin);
  refused("\xEF\xBB\xBF" + proved("a"), "1: parts: " + begin);
  refused(proved("a").substr(std::string(statement("a")).size()),
          "1: parts: a certificate without a statement before it");
  refused(kClaims + "slipproof-certificate 1\n", "3: parts: a certificate without a statement before it");
  refused(proved("a") + kClaims, "11: parts: the claims do not come first");
  refused(kClaims + kClaims, "3: parts: the claims do not come first");
  refused(proved("a") + proved("b") + proved("a"), "21: parts: a second statement of a");
  refused(undecided("a") + "slipproof-certificate 1\n", "8: parts: a second certificate of one statement");
  const std::string name = "expected 'theorem' and a name";
  for (const std::string line : {"theorem", "theorem ", "theorem ../a", "theorem a/b", "theorem a b", " theorem a"}) {
    refused(proved("b") + "slipproof-statement 1\n" + line + "\n", "11: parts: " + name);
  }
  refused("slipproof-statement 1", "1: parts: the file ends too early");
  refused("slipproof-statement 1\ntheorem a\rb\n", "1: parts: a byte of value 13, expected printable ASCII");
  fs::remove(folder.path() / "t.theorems");
  fs::create_directory(folder.path() / "t.theorems");  // an ordinary folder
  folder.write("t.theorems/a.statement", statement("a"));
  CHECK(report(folder, "t.theorems").starts_with("missing t.theorems/a.cert: there is no certificate\n"));
}

TEST_CASE("no byte of a theorem file can be another without being noticed, or meaning the same") {
  const TemporaryFolder folder;
  const std::string text = kClaims + proved("a") + proved("b");
  const std::string good =
      "accepted a\naccepted b\ns ACCEPTED 2 accepted, 0 rejected, 0 missing, 0 undecided, 0 unreadable\n";
  folder.write("t.theorems", text);
  REQUIRE(report(folder, "t.theorems") == good);
  const auto canonical = kClaims.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] = changed[i] == '#' ? '$' : '#';
    folder.write("t.theorems", changed);
    CAPTURE(changed);
    const bool in_claims = i >= std::string("slipproof-claims 1\n").size() && i + 1 < canonical;
    CHECK((report(folder, "t.theorems") == good) == in_claims);  // claims are not this program's
  }
}

TEST_CASE("a part is shown exactly, by both programs") {
  const TemporaryFolder folder;
  const std::string file = folder.write("t.theorems", kClaims + proved("a") + statement("b")).string();
  const std::string certificate = proved("a").substr(statement("a").size());
  for (const char* program : {"slipproof", "slipproof-check"}) {
    const auto show = [&](const std::string& name) {
      std::vector<std::string> arguments{"--show", name, file};
      if (std::string(program) == "slipproof") arguments.insert(arguments.begin(), "check");
      return run(arguments, program);
    };
    CHECK(show("a.statement").out == statement("a"));
    CHECK(show("a.cert").out == certificate);
    CHECK(show("a").out == proved("a"));
    CHECK(show("b").out == statement("b"));
    CHECK(show("claims.canonical").out == kClaims);
    for (const char* none : {"b.cert", "c", "", "a.cert.cert"}) {
      CAPTURE(none);
      const auto shown = show(none);
      CHECK(shown.exit_code != 0);
      CHECK(shown.out.empty());
      CHECK_FALSE(shown.err.empty());
    }
    CHECK(show("c").err == file + ": there is no c\n");
    CHECK(show("c").exit_code == 3);
  }
  folder.write("t.theorems", "junk\n");
  CHECK(run({"--show", "a", file}, "slipproof-check").err.starts_with(file + ":1: parts: expected"));
}
