// What is false is refuted, by numbers at which it is; what holds of nothing is told.
#include <doctest/doctest.h>

#include <random>
#include <string>

#include "proofs/check/files.hpp"
#include "proofs/search/instance.hpp"
#include "proofs/search/prove.hpp"
#include "proofs/search/small_statement.hpp"
#include "support/run_program.hpp"

namespace {

using namespace slipproof;
using test::statement;
using Verdict = ProofOutcome::Verdict;

ProofOutcome outcome(const std::string& lines) {
  return prove_statement("small", statement(lines));
}

/// Whether the checker accepts that the statement is false at the numbers.
bool is_false_at(const std::string& lines, const NamedValues& values) {
  const test::TemporaryFolder folder;
  for (const NamedStatement& part : refutation_at({"small", statement(lines)}, values)) {
    const ProofOutcome proof = prove_statement(part.name, part.text);
    if (!proof.proved()) return false;
    folder.write(part.name + ".statement", part.text);
    if (check::check_file(folder.write(part.name + ".cert", proof.certificate)).verdict != check::Verdict::accepted)
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a false statement is refuted by numbers that meet its assumptions and break its conclusion") {
  for (const std::string& lines :
       {std::string("real x\nshow x > 0\n"), std::string("real x y\nassume a: x > y\nshow x^2 > y^2\n"),
        std::string("real x y\nassume a: x >= 0 and y >= 0 and x^2 + y^2 = 25\nshow x + y > 6 or x > 100\n"),
        std::string("real x y\nassume a: x^3 - 2*y = 1\nassume b: y^2 < 1/100\nshow x*y > 1\n"),
        std::string("real x y z\nassume goal': x != 0\ndefine d: y/x > 1\nassume e: d or z = 3\nshow y > x\n"),
        // No value of the unknown is between these bounds.
        std::string("real x y\nassume a: x > 0\nexists z\nshow x < z and z < y\n"),
        std::string("real x\nexists u v\nshow u + v = 1 and u - v = x and u > 0 and v > 0\n")}) {
    CAPTURE(lines);
    const ProofOutcome found = outcome(lines);
    CHECK(found.verdict == Verdict::refuted);
    CHECK(is_false_at(lines, found.counterexample));
  }
}

TEST_CASE("numbers at which a statement is true refute nothing") {
  const std::string lines = "real x y\nassume a: x > y\nshow x^2 > y^2\n";
  CHECK(is_false_at(lines, {{"x", 1}, {"y", -1}}));
  CHECK(!is_false_at(lines, {{"x", 2}, {"y", 1}}));
  CHECK(!is_false_at(lines, {{"x", 1}, {"y", 2}}));  // the assumption is not met
  const std::string exists = "real x\nexists z\nshow z > x and z < 1\n";
  CHECK(is_false_at(exists, {{"x", Rational(3, 2)}}));
  CHECK(!is_false_at(exists, {{"x", 0}}));
}

TEST_CASE("the values of a refutation are read back from its text") {
  const NamedStatement small{"small", statement("real x y\nassume a: x > y\nshow x^2 > y^2\n")};
  const NamedValues values{{"x", Rational(1, 3)}, {"y", Rational(-7, 2)}};
  const auto refutation = refutation_at(small, values);
  CHECK(refutation[0].name == "small.refuted.met");
  CHECK(refutation[1].name == "small.refuted.fails");
  CHECK(refuting_values(small, refutation[0].text) == values);
  CHECK(!refuting_values(small, "let x = 1\n"));
  CHECK(!refuting_values(small, "let x = 1\nlet y = one\n"));
}

TEST_CASE("assumptions that contradict each other are told, and the certificate needs nothing else") {
  for (const char* lines :
       {"real x y\nassume a: x > y and y > x\nshow x = 0\n", "real x\nassume a: x^2 < 0\nexists z\nshow z > x\n",
        "real x y\nassume a: x > 1\nassume b: y > 1\nassume c: x*y < 1\nshow x > 0 and y > 2\n"}) {
    CAPTURE(lines);
    const ProofOutcome found = outcome(lines);
    CHECK(found.verdict == Verdict::proved);
    CHECK(found.vacuous);
    CHECK(uses_assumptions_only(found.certificate));
    const test::TemporaryFolder folder;
    folder.write("small.statement", statement(lines));
    CHECK(check::check_file(folder.write("small.cert", found.certificate)).verdict == check::Verdict::accepted);
  }
  CHECK(!outcome("real x\nassume a: x > 1\nshow x > 0\n").vacuous);
  CHECK(!outcome("real x\nassume a: x > 1\nassume b: x < 1\nshow false\n").vacuous);  // that is what it says
}

TEST_CASE("a certificate that uses the conclusion is told from one that does not") {
  CHECK(uses_assumptions_only("contradiction\nterm 1 a b^2\nequation goal'.1: x\nqed\n"));
  CHECK(!uses_assumptions_only("contradiction\nterm 1 a goal^2\nqed\n"));
  CHECK(!uses_assumptions_only("contradiction\nterm 1 a\nequation goal.1: x\nqed\n"));
  CHECK(!uses_assumptions_only("cases goal\n"));
  CHECK(!uses_assumptions_only("witness w\nset z = 1\n"));
}

TEST_CASE("most random false implications in two variables are refuted") {
  std::mt19937_64 random(5);
  const auto below = [&](std::uint64_t n) { return static_cast<int>(random() % n); };
  const auto polynomial = [&] {
    std::string text = std::to_string(below(19) - 9);
    for (const char* monomial : {"x", "y", "x^2", "x*y", "y^2", "x^2*y"}) {
      if (below(2) == 0) text += " + " + std::to_string(below(9) - 4) + "*" + monomial;
    }
    return text.front() == '-' ? "0 " + text : text;
  };
  int refuted = 0;
  for (int i = 0; i < 100; ++i) {
    std::string lines = "real x y\n";
    for (int k = 0; k < 3; ++k) {
      lines += "assume a" + std::to_string(k) + ": " + polynomial() + (below(4) == 0 ? " >= 0\n" : " > 0\n");
    }
    prove::Limits limits;
    limits.steps = 200'000;
    const ProofOutcome found = prove_statement("small", statement(lines + "show " + polynomial() + " > 0\n"), limits);
    if (found.verdict == Verdict::refuted) ++refuted;
  }
  CHECK(refuted >= 55);
}

TEST_CASE("an effort ends what would take for ever") {
  std::string many = "real x";
  for (int i = 0; i < 60; ++i) many += " v" + std::to_string(i);
  many += '\n';
  for (int i = 0; i < 1000; ++i) {
    many += "assume a" + std::to_string(i) + ": v" + std::to_string(i % 60) + " < " + std::to_string(i + 1) + "*x^2\n";
  }
  prove::Limits limits;
  limits.steps = 300'000;
  limits.quick_samples = limits.samples = 0;
  for (const std::string& lines : {std::string("real a b c d e f\nshow (a + b + c + d + e + f)^10 + 1 > 0\n"),
                                   many + "show x^4 - 2*x^2 + 1 > v0 - x^2\n"}) {
    const ProofOutcome found = prove_statement("small", statement(lines), limits);
    CHECK(found.verdict == Verdict::undecided);
    CHECK(found.exhausted);
  }
}

TEST_CASE("angles are found as rational points on circles") {
  for (const char* shown :
       {"c > 2*s and s > 1/10", "s > c and c > 1/4", "s < 0 and c < 0", "c*d - s*t > 1/2 and t > s and s > 0"}) {
    CAPTURE(shown);
    const std::string lines = std::string("exists c s d t\nshow c^2 + s^2 = 1 and d^2 + t^2 = 1 and ") + shown + "\n";
    CHECK(prove_statement("small", statement(lines)).proved());
  }
  CHECK(!prove_statement("small", statement("exists c s\nshow c^2 + s^2 = 1 and c > 1\n")).proved());
}
