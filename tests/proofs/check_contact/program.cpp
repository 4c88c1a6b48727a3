// The program slipproof-check-contact, and the files that it takes.
#include <algorithm>

#include "proofs/check_contact/examples.hpp"
#include "proofs/check_contact/files.hpp"
#include "support/run_program.hpp"

using namespace slipproof::check_contact;

namespace {

slipproof::test::ProgramEnd program(const std::vector<std::string>& arguments, const std::string& input = "") {
  return slipproof::test::run(arguments, "slipproof-check-contact", input);
}

std::string summary(const std::string& word, int accepted, int rejected, int missing, int unreadable) {
  return "s " + word + " " + std::to_string(accepted) + " accepted, " + std::to_string(rejected) + " rejected, " +
         std::to_string(missing) + " missing, 0 undecided, " + std::to_string(unreadable) + " unreadable\n";
}

}  // namespace

TEST_CASE("the program's words and exit codes") {
  const slipproof::test::TemporaryFolder folder;
  const std::string good = folder.write("good", kRod),
                    bad = folder.write("bad", replaced(kRod, "answer 0", "answer 5")),
                    broken = folder.write("broken", replaced(kRod, "end", "fin"));
  CHECK(program({good}).exit_code == 0);
  CHECK(program({good}).out ==
        "accepted\na solution within 5.0e-1 of the answer, 2 contacts in dimension 1 and 1 free unknowns, names no "
        "problem, has the "
        "numbers of e4f36668ce6bdd81ac3ead88aa01721ba63f32acf45b3293d5e92275aa1e6f05\n" +
            summary("ACCEPTED", 1, 0, 0, 0));
  CHECK(program({bad}).exit_code == 5);
  CHECK(program({bad}).out == "rejected: component 0: the solution may be farther than RHO from the answer\n" +
                                  summary("REJECTED", 0, 1, 0, 0));
  CHECK(program({broken}).exit_code == 3);
  CHECK(program({broken}).out ==
        "unreadable: line 16, column 1: found 'fin', expected a claim or 'end'\n" + summary("UNREADABLE", 0, 0, 0, 1));
  CHECK(program({"-"}, kRod).exit_code == 0);
  CHECK(program({"-"}, "").exit_code == 3);
  CHECK(program({"-"}, "").out ==
        "unreadable: line 1, column 1: found the end of the file, expected 'slipproof-contact'\n" +
            summary("UNREADABLE", 0, 0, 0, 1));
  CHECK(program({good, broken}).exit_code == 3);
  CHECK(program({bad, broken}).exit_code == 5);
  CHECK(program({good, good}).out.starts_with(good + ": accepted\n" + good + ": a solution within"));
  CHECK(program({}).exit_code == 2);
  CHECK(program({"--unknown"}).exit_code == 2);
  CHECK(program({"--help"}).exit_code == 0);
  CHECK(program({"--version"}).out.starts_with("slipproof-check-contact "));
}

TEST_CASE("a file may have several certificates, and each has a verdict with its line") {
  const slipproof::test::TemporaryFolder folder;
  const std::string bad = replaced(kRod, "answer 0", "answer 5"), broken = replaced(kRod, "end", "fin");
  const auto lines = std::to_string(std::count(kRod.begin(), kRod.end(), '\n') + 1);
  const auto last = std::to_string(2 * std::count(kRod.begin(), kRod.end(), '\n') + 1);
  const std::string file = folder.write("three", kRod + bad + broken);
  const auto outcome = program({file});
  CHECK(outcome.exit_code == 5);
  CHECK(outcome.out.starts_with(file + ":1: accepted\n" + file + ":1: a solution within"));
  CHECK(outcome.out.find("\n" + file + ":" + lines + ": rejected: component 0") != std::string::npos);
  CHECK(outcome.out.find("\n" + file + ":" + last + ": unreadable: line 16, column 1: found 'fin'") !=
        std::string::npos);
  CHECK(outcome.out.ends_with("\n" + summary("REJECTED", 1, 1, 0, 1)));
  CHECK(program({"-"}, kRod + kRod).out.ends_with(summary("ACCEPTED", 2, 0, 0, 0)));
  CHECK(program({folder.write("before", "junk\n" + kRod)}).exit_code == 3);
  CHECK(program({folder.write("after", kRod + "junk\n")}).exit_code == 3);
}

TEST_CASE("what is no file has a message, and a name cannot pass for another line") {
  const slipproof::test::TemporaryFolder folder;
  CHECK(program({folder.path() / "none"}).exit_code == 3);
  CHECK(program({folder.path() / "none"}).out == "missing: there is no such file\n" + summary("MISSING", 0, 0, 1, 0));
  const std::string no_file = "unreadable: it is not a regular file\n" + summary("UNREADABLE", 0, 0, 0, 1);
  CHECK(program({folder.path()}).out == no_file);
  CHECK(program({"/dev/zero"}).out == no_file);
  CHECK(check_contact_files({"a\naccepted\x1B", "b"}).text ==
        "a\\x0aaccepted\\x1b: missing: there is no such file\nb: missing: there is no such file\n");
}

TEST_CASE("what cannot be written is 6 with a message") {
  const slipproof::test::TemporaryFolder folder;
  const std::string command = slipproof::test::quoted(std::string(SLIPPROOF_BINARY_DIR) + "/slipproof-check-contact") +
                              " " + slipproof::test::quoted(folder.write("good", kRod).string());
  for (const char* out : {">/dev/full", ">&-"}) {
    const std::filesystem::path err = folder.path() / "err";
    const int status = std::system((command + " " + out + " 2>" + err.string()).c_str());
    CHECK(WEXITSTATUS(status) == 6);
    CHECK(slipproof::test::read_file(err) == "slipproof-check-contact: standard output cannot be written\n");
  }
}
