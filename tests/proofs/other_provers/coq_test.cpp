// Certificates read back and written for Coq. Whether Coq accepts them is for tests/program/external to see.
#include "proofs/other_provers/coq.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "base/input/diagnostic.hpp"
#include "proofs/check/files.hpp"
#include "proofs/other_provers/certificate_reader.hpp"
#include "proofs/search/prove_files.hpp"
#include "support/papers/shipped.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using test::read_file;
using test::shipped_folder;

namespace {

const std::string kStatement =
    "slipproof-statement 1\ntheorem small.one\nreal x end\nassume domain: end > 0\nlet q = x/end\nassume large: q > 1\n"
    "show x > end or false\n";

/// A certificate of it; the fingerprint is that of the statement.
std::string certificate(const std::string& proof) {
  return "slipproof-certificate 1\ntheorem small.one " + prove::Statement("small", kStatement).fingerprint() + '\n' +
         proof;
}

const std::string kProof =
    "have above: x - end > 0\nterm 1 large.2\nterm 1 domain above\nqed\n"
    "contradiction\nterm 1 above\nterm 1 goal.1\nqed\n";

std::string theorem_in(const std::string& text) {
  const auto theorem = text.find("Theorem ");
  return text.substr(theorem, text.find("Proof.\n", theorem) - theorem);
}

std::string message(const std::string& text) {
  try {
    coq_text("small.statement", kStatement, "small.cert", text);
  } catch (const InputError& error) {
    return to_string(error.diagnostics().front());
  }
  return "";
}

}  // namespace

TEST_CASE("shipped certificates read back as they were written") {
  std::size_t count = 0;
  for (const std::filesystem::path& file : statements_in(shipped_folder)) {
    std::filesystem::path path = file;
    const std::string text = read_file(path.replace_extension(".cert"));
    if (text.empty() || text.size() > 300'000) continue;
    const prove::Statement statement(file.string(), read_file(file));
    CAPTURE(path);
    CHECK(certificate_text(statement, read_certificate(statement, path.string(), text)) == text);
    ++count;
  }
  CHECK(count > 50);
}

TEST_CASE("the theorem says what the statement says, and the proof takes the certificate's steps") {
  const test::TemporaryFolder folder;
  folder.write("small.statement", kStatement);
  CHECK(check::check_file(folder.write("small.cert", certificate(kProof))).verdict == check::Verdict::accepted);
  const std::string text = coq_text("small.statement", kStatement, "small.cert", certificate(kProof));
  CHECK(theorem_in(text) ==
        "Theorem small_one :\n"
        "  forall x end'0 : real,\n"
        "  (* domain *) end'0 > 0 ->\n"
        "  let q := x / end'0 in\n"
        "  (* large *) (end'0 <> 0 /\\ q > 1) ->\n"
        "  x > end'0 \\/ False.\n");
  CHECK(text.substr(text.find("assert (_above")) ==
        "assert (_above : 0 < x - end'0). {\n"
        "destruct (Steps.positive_or (x - end'0)) as [_above | _above]; [exact _above | exfalso].\n"
        "refine (Steps.absurd _ (Steps.add (_large'_2) (Steps.mul0 (_above) (Steps.weak (_domain)))) _). ring.\n"
        "}\n"
        "refine (Steps.absurd _ (Steps.add (_above) (_goal'_1)) _). ring.\n"
        "Qed.\n");
}

TEST_CASE("a divisor that values make constant, or equal to another, is shown not to vanish as the theorem says") {
  const std::string statement =
      "slipproof-statement 1\ntheorem small.two\nreal z\nassume domain: z > 0\nexists x y\n"
      "show 1/x > 0 and 1/z = 1/y\n";
  const std::string proof = "slipproof-certificate 1\ntheorem small.two " +
                            prove::Statement("small", statement).fingerprint() +
                            "\nwitness goal\nset x = 2\nset y = z\ncases goal\nbranch 1\n"
                            "contradiction\nterm 1 goal.1\nterm 2\nqed\n"
                            "branch 2\ncases goal.2\nbranch 1\n"
                            "contradiction\nterm 1 domain\nterm 1 goal.2.1.1\nqed\n"
                            "branch 2\ncases goal.2.2\nbranch 1\ncontradiction\nterm 1 goal.2.2.1\nqed\n"
                            "branch 2\ncontradiction\nterm 1 goal.2.2.2\nqed\nend\nend\nend\n";
  const test::TemporaryFolder folder;
  folder.write("small.statement", statement);
  CHECK(check::check_file(folder.write("small.cert", proof)).verdict == check::Verdict::accepted);
  const std::string text = coq_text("small.statement", statement, "small.cert", proof);
  CHECK(text.find("(x <> 0 /\\ 1 / x > 0) /\\ (z <> 0 /\\ y <> 0 /\\ 1 / z = 1 / y)") != std::string::npos);
  const auto shown = [&](const std::string& p, const std::string& non_zero) {
    return text.find("refine (iff_trans (Steps.guard _ (" + p + ") (1) _ (fun _ => _)) (iff_sym (Steps.known (" + p +
                     ") " + non_zero + " (iff_refl _)))).");
  };
  const std::size_t x = shown("2", "ltac:(lra)"), z = text.find("apply (Steps.guard _ (z) (1)). "),
                    y = shown("z", "_z1");
  CHECK(x < z);
  CHECK(z < y);
  CHECK(y != std::string::npos);
}

TEST_CASE("what is no certificate of the statement is an input error with its line") {
  CHECK(message(certificate(kProof)).empty());
  CHECK(message("") == "small.cert: the certificate ends before its proof does");
  CHECK(message("slipproof-certificate 1\ntheorem small.one 0123456789abcdef\n") ==
        "small.cert:2: the certificate is of another statement");
  CHECK(message(certificate("# a comment\n\nguess\n")) == "small.cert:5: unknown rule `guess`");
  CHECK(message(certificate("contradiction\nterm -1 domain\nqed\n")).starts_with("small.cert:4: found `-1`"));
  CHECK(message(certificate("contradiction\nterm 1 domain^65\nqed\n")).starts_with("small.cert:4: "));
  CHECK(message(certificate("contradiction\nequation domain: x +* y\nqed\n")).starts_with("small.cert:4: "));
  CHECK(message(certificate("contradiction\nterm 1 elsewhere\nqed\n")) ==
        "small.cert: there is no hypothesis 'elsewhere' here");
  CHECK(message(certificate("contradiction\nterm 1 goal.1\nqed\n")) == "small.cert: no term of the identity is strict");
  CHECK(message(certificate("split s: x\nbranch positive\n")).starts_with("small.cert:4: expected `branch negative`"));
  CHECK(message(certificate("cases domain\nend\n")) == "small.cert: 'domain' has other alternatives");
}

TEST_CASE("names that Coq does not have become others, all at once") {
  const std::string statement =
      "slipproof-statement 1\ntheorem odd-names\nreal x x' x'' y.1 if\nassume h: x > 0\nlet a.b = x' - x''\n"
      "define d.: x > 0 or a.b = if\nshow d. or y.1 = 0\n";
  const prove::Statement read("s", statement);
  const std::string text = coq_text("s", statement, "c",
                                    "slipproof-certificate 1\ntheorem odd-names " + read.fingerprint() +
                                        "\ncontradiction\nterm 1 goal.1.1\nterm 1 h\nqed\n");
  CHECK(theorem_in(text) ==
        "Theorem odd_names :\n"
        "  forall x x'' x'''' y'_1 if'0 : real,\n"
        "  (* h *) x > 0 ->\n"
        "  let a'_b := x'' - x'''' in\n"
        "  let d'_ := x > 0 \\/ a'_b = if'0 in\n"
        "  d'_ \\/ y'_1 = 0.\n");
}

TEST_CASE("parts of hypotheses with like names stay apart") {
  const std::string statement =
      "slipproof-statement 1\ntheorem alike\nreal x y\nassume h: y > 0 and x > 0\nassume h_2: y > 1 and x > 1\nshow x "
      "> 0\n";
  const prove::Statement read("s", statement);
  const std::string text = coq_text("s", statement, "c",
                                    "slipproof-certificate 1\ntheorem alike " + read.fingerprint() +
                                        "\ncontradiction\nterm 1 goal\nterm 1 h.2\nqed\n");
  CHECK(text.find("_h'_2") != text.npos);
  CHECK(text.find("_h_2'_1") != text.npos);
}

TEST_CASE("the values of a witness may use what the statement abbreviates") {
  const std::string statement =
      "slipproof-statement 1\ntheorem half\nreal x\nassume h: x > 0\nlet m = x/2\nexists z\nshow z < x and z = m\n";
  const std::string proof = "slipproof-certificate 1\ntheorem half " + prove::Statement("s", statement).fingerprint() +
                            "\nwitness w\nset z = m\ncases w\nbranch 1\ncontradiction\nterm 1 w.1\nterm 2 h\nqed\n"
                            "branch 2\ncases w.2\nbranch 1\ncontradiction\nterm 1 w.2.1\nqed\nbranch 2\n"
                            "contradiction\nterm 1 w.2.2\nqed\nend\nend\n";
  const test::TemporaryFolder folder;
  folder.write("half.statement", statement);
  const auto checked = check::check_file(folder.write("half.cert", proof));
  CHECK(checked.message == "");
  const std::string text = coq_text("s", statement, "c", proof);
  CHECK(text.find("pose (z := m).") != std::string::npos);
}
