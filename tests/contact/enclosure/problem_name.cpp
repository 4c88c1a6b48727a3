// The name of a problem does not depend on how it is written, and the checker, which shares no code, finds the same.
#include "contact/judge/problem_name.hpp"

#include <doctest/doctest.h>

#include "contact/formats/read_files.hpp"
#include "contact/judge/certificate.hpp"
#include "proofs/check_contact/check_contact.hpp"
#include "support/run_program.hpp"

using namespace slipproof;

namespace {

const std::string kForm =
    "slipproof-contact-problem 1\n"
    "dimension 3 free 0 contacts 1\n"
    "mu 3/4\n"
    "matrix\n"
    "0 0 2\n"
    "0 1 1/2\n"
    "1 0 1/4\n"
    "1 1 1\n"
    "2 2 3602879701896397/36028797018963968\n"
    "constant -10 1/2 0\n";

std::string form(const ReadProblem& read) {
  return canonical_form(mixed_problem(read.problem));
}

}  // namespace

TEST_CASE("one problem has one canonical form, however it is written") {
  const test::TemporaryFolder folder;
  const auto in_file = [&](const std::string& name, const std::string& text) {
    return form(read_problem_file(folder.write(name, text)));
  };
  const std::string dense =
      R"({"dimension": 3, "W": [[2, 0.5, 0], [0.25, 1, -0.0], [0, 0, 0.1]], "q": [-10, 0.5, -0.0], "mu": 0.75})";
  const std::string sparse =
      R"({"mu": ["0x1.8p-1"], "dimension": 3, "title": "again", "q": ["-10", "1/2", 0.0], "W": {"rows": 3, "columns": 3,
          "entries": [[2, 2, 1e-1], [1, 1, 1], [0, 1, "1/2"], [0, 0, 2], [2, 0, 0], [1, 0, 0.25]]}, "r": [5, 0, 0]})";
  CHECK(in_file("dense.json", dense) == kForm);
  CHECK(in_file("sparse.json", sparse) == kForm);
  CHECK(form(read_problem_line(JsonProblem(dense, "lines.jsonl"))) == kForm);
  CHECK(in_file("siconos.dat", "3\n1\n0\n3\n3\n3 3\n2 0.25 0\n0.5 1 0\n0 0 0.1\n-10 0.5 0\n0.75\n") == kForm);
  folder.write("w_q.mtx", "%%MatrixMarket matrix array real general\n3 1\n-10\n0.5\n0\n");
  folder.write("w_mu.mtx", "%%MatrixMarket matrix array real general\n1 1\n0.75\n");
  CHECK(in_file("w.mtx", "%%MatrixMarket matrix array real general\n3 3\n2\n0.25\n0\n0.5\n1\n0\n0\n0\n0.1\n") == kForm);
  CHECK(in_file("w.mtx",
                "%%MatrixMarket matrix coordinate real general\n3 3 5\n3 3 0.1\n1 2 0.5\n1 1 2\n2 1 0.25\n2 2 1\n") ==
        kForm);
  CHECK(in_file("other.json", R"({"dimension": 3, "W": [[2, 0.25, 0], [0.5, 1, 0], [0, 0, 0.1]], "q": [-10, 0.5, 0],
      "mu": 0.75})") != kForm);
}

TEST_CASE("a certificate names its problem, and the checker finds that it is the one") {
  const ReadProblem read = read_problem_file(SLIPPROOF_SOURCE_DIR "/cases/contact-problems/pushed-block.json");
  const MixedProblem problem = mixed_problem(read.problem);
  const std::string certificate = contact_certificate(problem, judge_contacts(problem, read.answers.front().r, {}, {}));
  const std::string name = problem_name(problem);
  CHECK(certificate.starts_with("slipproof-contact 1\nproblem " + name + "\n"));
  const auto found = check_contact::check_contact_certificate(certificate, name);
  CHECK(found.kind == check_contact::ContactVerdict::Kind::accepted);
  CHECK(found.message.ends_with(", of the problem " + name));
  MixedProblem other = problem;
  other.mu[2] = 0.625;
  CHECK(check_contact::check_contact_certificate(certificate, problem_name(other)).message ==
        "it is about another problem, " + name);
}
