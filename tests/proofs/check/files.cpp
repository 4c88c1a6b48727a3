// What stands in files and folders: five verdicts, links, what is no file, and the program's exit codes.
#include "proofs/check/files.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

#include "proofs/check/examples.hpp"
#include "support/run_program.hpp"

using namespace slipproof::check;
using slipproof::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

const std::string kStatement = "slipproof-statement 1\ntheorem t\nreal x\nshow x^2 >= 0\n";
const std::string kProof =
    "split s: x\nbranch negative\ncontradiction\nterm 1 s^2\nterm 1 goal\nqed\nbranch zero\ncontradiction\nterm 1 "
    "goal\nequation s: x\nqed\nbranch positive\ncontradiction\nterm 1 s^2\nterm 1 goal\nqed\nend\n";
const std::string kUndecided = "slipproof-undecided 1\ntheorem t\n";

std::string proof_of(const std::string& statement) {
  return header(statement) + kProof;
}

/// A folder with a proved theorem, and the path of its certificate.
struct Proved : TemporaryFolder {
  Proved() {
    write("t.statement", kStatement);
    certificate = write("t.cert", proof_of(kStatement));
  }
  fs::path certificate;
};

/// `VERDICT MESSAGE` of each line, without the folder; and the summary.
std::string report(const fs::path& argument, const fs::path& folder) {
  const Report found = check_files({argument.string()});
  std::string text = found.text + found.summary;
  const std::string prefix = folder.string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}

std::string report(const TemporaryFolder& folder) {
  return report(folder.path(), folder.path());
}

std::string summary(const char* word, int accepted, int rejected, int missing, int undecided, int unreadable) {
  return std::string("s ") + word + " " + std::to_string(accepted) + " accepted, " + std::to_string(rejected) +
         " rejected, " + std::to_string(missing) + " missing, " + std::to_string(undecided) + " undecided, " +
         std::to_string(unreadable) + " unreadable\n";
}

}  // namespace

TEST_CASE("a certificate is accepted, rejected, missing, undecided or unreadable") {
  const Proved folder;
  const auto is = [&](Verdict verdict, const std::string& message, int exit_code) {
    const FileResult result = check_file(folder.certificate);
    CHECK(result.verdict == verdict);
    CHECK(result.message == (message.empty() ? "" : folder.path().string() + "/" + message));
    const bool readable = verdict != Verdict::unreadable;
    if (readable) CHECK(result.theorem == "t");
    CHECK(check_files({folder.certificate.string()}).exit_code == exit_code);
  };
  is(Verdict::accepted, "", 0);
  folder.write("t.cert", "");
  is(Verdict::rejected, "t.cert:1: header: the file ends too early", 5);
  folder.write("t.cert", kUndecided);
  is(Verdict::undecided, "t.cert: the search ended without a certificate", 4);
  folder.write("t.cert", kUndecided + "because the budget of 10 steps is spent\n\n# two\nbecause x > 0 is left\n");
  is(Verdict::undecided,
     "t.cert: the search ended without a certificate: the budget of 10 steps is spent; x > 0 is left", 4);
  fs::remove(folder.certificate);
  is(Verdict::missing, "t.cert: there is no certificate", 3);
  fs::create_directory(folder.certificate);
  is(Verdict::unreadable, "t.cert: not a regular file", 3);
  folder.write("t.statement", "slipproof-statement 1\ntheorem t\nshow x > 0\n");
  is(Verdict::unreadable, "t.statement:3: show: expected a number or a known name", 3);
  fs::remove(folder.path() / "t.statement");
  is(Verdict::unreadable, "t.statement: there is no such file", 3);
}

TEST_CASE("what only looks like a record of an undecided search is rejected") {
  const Proved folder;
  for (const std::string& text :
       {std::string("slipproof-undecided 1\n"), std::string("slipproof-undecided 2\ntheorem t\n"),
        std::string("slipproof-undecided 1\ntheorem u\n"), kUndecided + "because\n", kUndecided + "since x > 0\n",
        kUndecided + proof_of(kStatement), kUndecided + "because \x1B[1A\n", proof_of(kStatement) + kUndecided,
        "slipproof-undecided 1\ntheorem t " + std::string(16, '0') + "\n"}) {
    folder.write("t.cert", text);
    CAPTURE(text);
    CHECK(check_file(folder.certificate).verdict == Verdict::rejected);
    CHECK(verdict(kStatement, text).starts_with("C:"));  // a second checker is asked the same
  }
  const std::string reasons =
      "\n# why\n" + kUndecided + " because $10 are spent\nbecause=x\n#because\nbecause x >= 0 is left\n";
  for (std::size_t size = 0; size <= reasons.size(); ++size) {
    CHECK(verdict(kStatement, reasons.substr(0, size)).starts_with("C:"));
    CHECK(verdict(kStatement, reasons.substr(size)).starts_with("C:"));
  }
}

TEST_CASE("a folder tells all five, with their counts") {
  const Proved folder;
  for (const char* name : {"below", "below/deeper"}) fs::create_directory(folder.path() / name);
  for (const char* name : {"below/missing", "below/deeper/undecided", "rejected"}) {
    folder.write(std::string(name) + ".statement", kStatement);
  }
  folder.write("below/deeper/undecided.cert", kUndecided);
  folder.write("rejected.cert", kProof);
  folder.write("lonely.cert", proof_of(kStatement));
  folder.write("README.md", "no statement");
  CHECK(report(folder) ==
        "undecided below/deeper/undecided.cert: the search ended without a certificate\n"
        "missing below/missing.cert: there is no certificate\n"
        "unreadable lonely.statement: there is no such file\n"
        "rejected rejected.cert:1: header: expected 'slipproof-certificate 1'\n"
        "accepted t\n" +
            summary("REJECTED", 1, 1, 1, 1, 1));
  fs::remove(folder.path() / "rejected.statement");
  fs::remove(folder.path() / "rejected.cert");
  CHECK(report(folder).ends_with(summary("UNREADABLE", 1, 0, 1, 1, 1)));
  fs::remove(folder.path() / "lonely.cert");
  CHECK(report(folder).ends_with(summary("MISSING", 1, 0, 1, 1, 0)));
  fs::remove(folder.path() / "below/missing.statement");
  CHECK(report(folder).ends_with(summary("UNDECIDED", 1, 0, 0, 1, 0)));
  CHECK(check_files({folder.path().string()}).exit_code == 4);
  fs::remove_all(folder.path() / "below");
  CHECK(report(folder) == "accepted t\n" + summary("ACCEPTED", 1, 0, 0, 0, 0));
}

TEST_CASE("an argument may be a certificate, its statement, or a folder, and nothing else") {
  const Proved folder;
  const fs::path in = folder.path();
  CHECK(report(in / "t.statement", in) == "accepted t\n" + summary("ACCEPTED", 1, 0, 0, 0, 0));
  CHECK(report(in / "t", in) == "unreadable t: expected NAME.cert, NAME.statement, NAME.theorems or a folder\n" +
                                    summary("UNREADABLE", 0, 0, 0, 0, 1));
  fs::create_directory(in / "empty");
  CHECK(report(in / "empty", in) == "unreadable empty: no statements here\n" + summary("UNREADABLE", 0, 0, 0, 0, 1));
  CHECK(report(in / "nothing.cert", in) ==
        "unreadable nothing.statement: there is no such file\n" + summary("UNREADABLE", 0, 0, 0, 0, 1));
  const Report both = check_files({(in / "t.cert").string(), (in / "nothing.cert").string()});
  CHECK(both.exit_code == 3);
  CHECK(both.results.size() == 2);
}

TEST_CASE("links to files are followed, those to folders elsewhere are named") {
  const Proved folder, elsewhere;
  const fs::path in = folder.path();
  fs::create_symlink(in / "t.statement", in / "linked.statement");
  fs::create_symlink("t.cert", in / "linked.cert");
  fs::create_directory(in / "below");
  fs::create_directory_symlink(in, in / "below" / "round");
  fs::create_directory_symlink("below", in / "inside");
  CHECK(report(folder) == "accepted t in linked.cert\naccepted t\n" + summary("ACCEPTED", 2, 0, 0, 0, 0));
  fs::create_symlink("nowhere", in / "dangling.cert");
  fs::create_symlink("nowhere", in / "other.statement");
  fs::create_symlink("t.statement", in / "dangling.statement");
  fs::create_symlink("endless.cert", in / "endless.cert");
  fs::create_symlink("nowhere", in / "harmless");
  fs::create_directory_symlink(elsewhere.path(), in / "outside");
  CHECK(report(folder) ==
        "unreadable dangling.cert: a link to nothing\n"
        "unreadable endless.statement: there is no such file\n"
        "accepted t in linked.cert\n"
        "unreadable other.statement: a link to nothing\n"
        "unreadable outside: a link to a folder elsewhere, which is not followed\n"
        "accepted t\n" +
            summary("UNREADABLE", 2, 0, 0, 0, 4));
  CHECK(report(in / "outside", in) == "accepted t\n" + summary("ACCEPTED", 1, 0, 0, 0, 0));
}

TEST_CASE("what is no regular file is told and not opened") {
  const Proved folder;
  const fs::path in = folder.path();
  REQUIRE(mkfifo((in / "pipe.cert").c_str(), 0600) == 0);
  folder.write("pipe.statement", kStatement);
  REQUIRE(mkfifo((in / "way.statement").c_str(), 0600) == 0);
  REQUIRE(mkfifo((in / "other").c_str(), 0600) == 0);
  fs::create_symlink("/dev/zero", in / "zero.cert");
  folder.write("zero.statement", kStatement);
  const std::string expected =
      "unreadable pipe.cert: not a regular file\n"
      "accepted t\n"
      "unreadable way.statement: not a regular file\n"
      "unreadable zero.cert: not a regular file\n";
  CHECK(report(folder) == expected + summary("UNREADABLE", 1, 0, 0, 0, 3));
  CHECK(report(in / "pipe.cert", in).starts_with("unreadable pipe.cert: not a regular file\n"));
  CHECK(report(in / "other", in).starts_with("unreadable other: expected NAME.cert"));
}

TEST_CASE("the name of a file cannot pass for another line") {
  const Proved folder;
  folder.write("a\naccepted A2.1\x1B[2K\xC2\x9B\xE2\x80\xAE\xC3\xA9.cert", "");
  CHECK(report(folder).starts_with(
      "unreadable a\\x0aaccepted A2.1\\x1b[2K\\xc2\\x9b\\xe2\\x80\\xae\xC3\xA9.statement: there is no such file\n"));
}

TEST_CASE("a theorem that is called otherwise than its file is accepted with the file") {
  const Proved folder;
  folder.write("u.statement", kStatement);
  folder.write("u.cert", proof_of(kStatement));
  CHECK(report(folder) == "accepted t\naccepted t in u.cert\n" + summary("ACCEPTED", 2, 0, 0, 0, 0));
}

TEST_CASE("the program's exit codes; what cannot be written is 6 with a message") {
  const Proved folder;
  const auto program = [&](const std::vector<std::string>& arguments) {
    return slipproof::test::run(arguments, "slipproof-check");
  };
  const auto good = program({folder.path()});
  CHECK(good.exit_code == 0);
  CHECK(good.out == "accepted t\n" + summary("ACCEPTED", 1, 0, 0, 0, 0));
  CHECK(program({}).exit_code == 2);
  CHECK(program({"--unknown"}).exit_code == 2);
  CHECK(program({"--help"}).exit_code == 0);
  CHECK(program({"--version"}).out.starts_with("slipproof-check "));
  const std::string command = slipproof::test::quoted(std::string(SLIPPROOF_BINARY_DIR) + "/slipproof-check") + " " +
                              slipproof::test::quoted(folder.path().string());
  for (const char* out : {">/dev/full", ">&-"}) {
    const fs::path err = folder.path() / "err";
    const int status = std::system((command + " " + out + " 2>" + err.string()).c_str());
    CHECK(WEXITSTATUS(status) == 6);
    CHECK(slipproof::test::read_file(err) == "slipproof-check: standard output cannot be written\n");
  }
}
