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
