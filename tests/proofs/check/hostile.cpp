// Hostile folders (support/files/hostile_files.hpp), by the program slipproof-check or by another of the same format,
// which SLIPPROOF_CHECKER names. And their names in a file of Coq.
#include "proofs/check/examples.hpp"
#include "support/files/hostile_files.hpp"

using namespace slipproof::test;

namespace {

const std::string kPositive = "slipproof-statement 1\ntheorem t\nreal x\nassume a: x > 0\nshow x > 0\n";

GoodTexts good_texts() {
  return {kPositive, slipproof::check::header(kPositive) + "contradiction\nterm 1 a\nterm 1 goal\nqed\n"};
}

std::string checker() {
  const char* other = std::getenv("SLIPPROOF_CHECKER");
  return other != nullptr ? other : SLIPPROOF_BINARY_DIR "/slipproof-check";
}

}  // namespace

TEST_CASE("hostile folders: one verdict for each certificate, their counts, and an end") {
  for (const HostileCase& hostile : hostile_cases()) {
    CAPTURE(hostile.what);
    const HostileFolder folder(good_texts());
    hostile.make(folder);
    std::vector<std::string> expected, found;
    for (const Hostile& one : hostile.found) expected.push_back(one.beside_statement);
    const ProgramEnd outcome = run_checker(checker(), {folder.path().string()});
    CAPTURE(outcome.out);
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line) && !line.starts_with("s ");)
      found.push_back(line.substr(0, line.find(' ')));
    CHECK(found == expected);
    const ProgramEnd end = expected_end(expected);
    CHECK(outcome.exit_code == end.exit_code);
    CHECK(outcome.out.ends_with("\n" + end.out));
    check_lines(outcome.out, expected.size() + 1);
  }
}

TEST_CASE("hostile theorem files: one verdict for each certificate, and for a file that is none") {
  const GoodTexts good = good_texts();
  const std::string one = good.statement + good.certificate, claims = "slipproof-claims 1\n";
  const auto called = [](const std::string& name) {
    return "slipproof-statement 1\ntheorem " + name + "\nreal x\nshow x = x\n";
  };
  const auto text = [](const std::string& what) {
    return [what](const HostileFolder& folder) { folder.write("f.theorems", what); };
  };
  using F = const HostileFolder&;
  const std::vector<std::string> unreadable{"unreadable"};
  struct Case {
    std::string what;
    std::function<void(F)> make;
    std::vector<std::string> verdicts;
  };
  for (const auto& [what, make, verdicts] : std::vector<Case>{
           {"a good one", text(claims + one + called("u")), {"accepted", "missing"}},
           {"without the last line feed", text(one.substr(0, one.size() - 1)), {"accepted"}},
           {"one beside files of its own",
            [&](F f) { f.both("t"), f.write("t.theorems", one); },
            {"accepted", "accepted"}},
           {"undecided", text(called("t") + "slipproof-undecided 1\ntheorem t\n"), {"undecided"}},
           {"a certificate of another", text(called("t") + good.certificate), {"rejected"}},
           {"two of one name", text(one + one), unreadable},
           {"two certificates", text(one + good.certificate), unreadable},
           {"a certificate first", text(good.certificate), unreadable},
           {"a certificate after the claims", text(claims + good.certificate), unreadable},
           {"late claims", text(one + claims), unreadable},
           {"two claims", text(claims + claims + one), unreadable},
           {"nothing", text(""), unreadable},
           {"other text", text("slipproof-statement 2\n" + one), unreadable},
           {"a comment first", text("# of mine\n" + one), unreadable},
           {"no name", text(one + "slipproof-statement 1"), unreadable},
           {"a name of another folder", text(one + called("../u")), unreadable},
           {"a name that hides itself", text(one + called("\xE2\x80\xAEu")), unreadable},
           {"a name that is two", text(one + called("u v")), unreadable},
           {"a long name", text(one + called(std::string(101, 'n'))), unreadable},
           {"a name of the longest", text(one + called(std::string(100, 'n'))), {"missing", "accepted"}},
           {"ends of lines of another system", text("slipproof-statement 1\r\n" + one), unreadable},
           {"zeros", text(std::string(65'536, '\0')), unreadable},
           {"a pipe", [](F f) { f.pipe("f.theorems"); }, unreadable},
           {"an endless one", [](F f) { f.link("f.theorems", "/dev/zero"); }, unreadable},
           {"a tebibyte", [](F f) { f.huge("f.theorems"); }, unreadable},
           {"a link to nothing", [](F f) { f.link("f.theorems", "nothing"); }, unreadable},
           {"a link to one",
            [&](F f) { f.write("f.theorems", one), f.link("g.theorems", "f.theorems"); },
            {"accepted", "accepted"}},
           {"a folder of that name", [](F f) { f.folder("f.theorems"), f.both("f.theorems/t"); }, {"accepted"}},
           {"one without a name", [&](F f) { f.both("t"), f.write(".theorems", one); }, {"accepted"}}}) {
    CAPTURE(what);
    const HostileFolder folder(good);
    make(folder);
    const ProgramEnd outcome = run_checker(checker(), {folder.path().string()});
    CAPTURE(outcome.out);
    std::vector<std::string> found;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line) && !line.starts_with("s ");)
      found.push_back(line.substr(0, line.find(' ')));
    CHECK(found == verdicts);
    CHECK(outcome.exit_code == expected_end(verdicts).exit_code);
    check_lines(outcome.out, verdicts.size() + 1);
  }
}

TEST_CASE("arguments that are no certificates, and output that cannot be written") {
  const HostileFolder folder(good_texts());
  folder.both("t");
  const auto verdict = [&](const std::string& name) {
    const std::string out = run_checker(checker(), {folder.at(name).string()}).out;
    return out.substr(0, out.find(' '));
  };
  CHECK(verdict("t.cert") == "accepted");
  CHECK(verdict("t.statement") == "accepted");
  CHECK(verdict("t") == "unreadable");
  CHECK(verdict("nothing.cert") == "unreadable");
  CHECK(verdict("nothing") == "unreadable");
  CHECK(run_checker(checker(), {}).exit_code == 2);
  CHECK(run_checker(checker(), {"--unknown"}).exit_code == 2);
  for (const char* out : {">/dev/full", ">&-"}) {
    const int status =
        std::system((quoted(checker()) + " " + quoted(folder.at("t.cert").string()) + " 2>/dev/null " + out).c_str());
    CHECK(WEXITSTATUS(status) == 6);
  }
}

TEST_CASE("the name of a file adds nothing to a file of Coq but a comment") {
  const HostileFolder folder(good_texts());
  const auto theorem = [&](const std::string& name) {
    folder.both(name);
    return run_checker("sh", {SLIPPROOF_SOURCE_DIR "/proofs/coq/theorems.sh", folder.at(name + ".cert").string()});
  };
  const std::string plain = theorem("plain").out;
  CHECK(plain.find("(* plain.cert *)\nDefinition statement1 := text \"slipproof-statement 1\n") != std::string::npos);
  for (const std::string name : {"a*) Axiom false : False. (*", "a\n*)\nAxiom false : False.\n(*",
                                 "a\" *) Axiom b : False. (* \"", "-n", "\\c", "(*", "\xC3\x28"}) {
    CAPTURE(name);
    std::string shown = name;
    std::replace_if(
        shown.begin(), shown.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '.'; }, '?');
    CHECK(theorem(name).out == slipproof::check::replaced(plain, "plain.cert", shown + ".cert"));
  }
  folder.statement("pipe"), folder.pipe("pipe.cert");
  for (const char* bad : {"pipe.cert", "nothing.cert"}) {
    CHECK(run_checker("sh", {SLIPPROOF_SOURCE_DIR "/proofs/coq/theorems.sh", folder.at(bad).string()}).exit_code == 3);
  }
}
