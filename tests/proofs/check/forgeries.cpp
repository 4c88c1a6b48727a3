// The checker accepts a proof and rejects every forgery: for each side condition of proofs/FORMAT.md a certificate that
// differs from a valid one only there.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "proofs/check/examples.hpp"

namespace {

using namespace slipproof::check;

struct Forgery {
  std::string from, to, expected;
};

void reject_all(const std::string& statement, const std::string& proof, const std::vector<Forgery>& forgeries) {
  const std::string certificate = header(statement) + proof;
  REQUIRE(verdict(statement, certificate) == "");
  for (const Forgery& forgery : forgeries) {
    const std::string found = verdict(statement, replaced(certificate, forgery.from, forgery.to));
    INFO("'", forgery.from, "' -> '", forgery.to, "' gave '", found, "'");
    CHECK(found.find(forgery.expected) != std::string::npos);
    CHECK(found != "");
  }
}

}  // namespace

TEST_CASE("every side condition of identities, haves and splits has a forgery that it rejects") {
  reject_all(
      kSplitStatement, kSplitProof,
      {{"term 3 d.1", "term -3 d.1", "contradiction: expected a number"},
       {"term 3 d.1", "term 0 d.1", "contradiction: the coefficient is zero"},
       {"term 3 d.1", "term 03 d.1", "contradiction: a number begins with zero"},
       {"term 3 d.1", "term 3/4 d.1", "contradiction: expected a name"},
       {"term 3 d.1", "term 2 d.1", "contradiction: the lines do not add up to zero"},
       {"term 3 d.1\n", "", "contradiction: the lines do not add up to zero"},
       {"equation k: 3", "equation k: 3*x", "contradiction: the lines do not add up to zero"},
       {"equation k: 3", "equation k: 3/(4*x)", "contradiction: expected a polynomial with integer coefficients"},
       {"equation k: 3", "equation k: 6/2", "contradiction: expected a polynomial with integer coefficients"},
       {"equation k: 3", "equation k: 3/0", "contradiction: division by zero"},
       {"equation k: 3", "equation k: (3)/1", "contradiction: expected a polynomial with integer coefficients"},
       {"equation k: 3", "equation k: 1/(1/3)", "contradiction: expected a polynomial with integer coefficients"},
       {"equation k: 3", "equation k: 3 + (x - x)/1", "contradiction: expected a polynomial with integer coefficients"},
       {"equation k: 3", "equation k: 3*x/x", "contradiction: expected a polynomial with integer coefficients"},
       {"have k: t - x = 0", "have k: (t - x)/1 = 0", "have: expected a polynomial with integer coefficients"},
       {"split r: x - y", "split r: 1/(1/(x - y))", "split: expected a polynomial with integer coefficients"},
       {"have k: t - x = 0", "have and: t - x = 0", "have: expected a name, found a reserved word"},
       {"split r: x - y", "split or: x - y", "split: expected a name, found a reserved word"},
       {"split r: x - y", "split false: x - y", "split: expected a name, found a reserved word"},
       {"have k: t - x = 0", "have k : t - x = 0 0", "have: expected the end of the line"},
       {"branch zero\n", "branch  zero\n", "expected 'branch zero'"},
       {"branch zero\n", "branch zero \n", "expected 'branch zero'"},
       {"qed\nend\n", "qed\n end\n", "expected 'end'"},
       {"equation k: 3", "equation s.1: 3", "contradiction: not an equation"},
       {"equation k: 3", "equation nowhere: 3", "contradiction: there is no such hypothesis here"},
       {"equation k: 3", "equation k: 3*v", "contradiction: expected a number or a known name"},
       {"equation k: 3\n", "equation k: 3\nequation k: 0\n", "contradiction: a line is zero, and not the only one"},
       {"term 3 d.1", "term 3 e", "contradiction: not an inequality"},
       {"term 3 d.1", "term 3 d", "contradiction: not an inequality"},
       {"term 3 d.1", "term 3 d.3", "contradiction: there is no such hypothesis here"},
       {"term 1 d.2", "term 1 d.1", "contradiction: there is no such hypothesis here"},
       {"term 1 r^2", "term 1 r^0", "contradiction: an exponent is out of range"},
       {"term 1 r^2", "term 1 r^65", "contradiction: an exponent is out of range"},
       {"term 1 r^2", "term 1 r^99999999999999999999", "contradiction: an exponent is out of range"},
       {"term 1 r^2\nterm 1 goal.2\n", "equation e: 0\n", "contradiction: no term is strict"},
       {"term 1 r^2\nterm 1 goal.2\n", "", "contradiction: no term is strict"},
       {"have k: t - x = 0", "have k: t + x = 0", "have: the lines do not add up to zero"},
       {"have k: t - x = 0", "have k: t - x > 0", "have: the lines do not add up to zero"},
       {"have k: t - x = 0", "have k: t - x = 1", "have: expected '0'"},
       {"have k: t - x = 0", "have k: t - x 0", "have: expected '='"},
       {"cases goal\n", "have j: 1 = 0\nterm 1\nqed\nterm 1\nqed\ncases goal\n",
        "have: the lines do not add up to zero"},
       {"contradiction\nterm 3 d.1\n", "have j: 0 > 0\nterm 3 d.1\n", "have: the negation is not used"},
       {"contradiction\nterm 3 d.1\n",
        "have j: 0 > 0\nterm 3 d.1\nterm 3 s.2\nterm 3 goal.1\nequation k: 3\nqed\ncontradiction\nterm 3 d.1\n",
        "have: the negation is not used"},
       {"have k: t - x = 0", "have e: t - x = 0", "have: the name of a hypothesis is given twice"},
       {"qed\nterm 1 k\nequation e: 1\nqed\n", "qed\n", "have: expected 'term'"},
       {"split r: x - y", "split r: x + y", "contradiction: the lines do not add up to zero"},
       {"split r: x - y", "split k: x - y", "the name of a hypothesis is given twice"},
       {"split r: x - y", "split r: x/y", "split: expected a polynomial with integer coefficients"},
       {"branch zero\ncontradiction\nterm 1 goal.2\nequation r: x - y\nqed\n", "", "expected 'branch zero'"},
       {"branch positive\n", "branch negative\n", "expected 'branch positive'"},
       {"branch positive\ncontradiction\nterm 1 r^2\nterm 1 goal.2\nqed\n", "", "expected 'branch positive'"},
       {"cases d\n", "cases s.1\n", "cases: the hypothesis is not a disjunction"},
       {"cases d\n", "cases x\n", "cases: there is no such hypothesis here"},
       {"branch 2\ncontradiction\nterm 1 d.2\nterm 1 s.1\nterm 1 goal.1\nequation k: 1\nqed\n", "",
        "expected 'branch 2'"},
       {"qed\nend\nbranch 2\nsplit", "qed\nbranch 3\nend\nbranch 2\nsplit", "expected 'end'"},
       {"cases goal\n", "assume more: x > 1\ncases goal\n", "assume: unknown rule"},
       {"slipproof-certificate 1", "slipproof-certificate 2", "header: expected 'slipproof-certificate 1'"},
       {"theorem split-example", "theorem other-example", "header: expected 'theorem split-example "},
       {"theorem split-example ", "theorem split-example 0", "header: expected 'theorem split-example "}});
}

TEST_CASE("every side condition of witnesses has a forgery that it rejects") {
  reject_all(kWitnessStatement, kWitnessProof,
             {{"set u = x/y\n", "", "witness: expected 'set'"},
              {"set u = x/y", "set v = x/y", "witness: expected 'u'"},
              {"set u = x/y", "set u = u", "witness: expected a number or a known name"},
              {"set u = x/y", "set u = x/(y - y)", "witness: division by zero"},
              {"witness w", "witness and", "witness: expected a name, found a reserved word"},
              {"set u = x/y", "set u = x/0", "witness: division by zero"},
              {"set u = x/y", "set u = x/(y - 1)", "contradiction: the lines do not add up to zero"},
              {"set u = x/y", "set u = 2*x/y", "contradiction: the lines do not add up to zero"},
              {"branch 1\ncontradiction\nterm 1 a.2\nequation w.1: -1\nqed\n", "", "expected 'branch 1'"}});
}

// Statements that are false, and what would prove them if the checker left out one condition.
TEST_CASE("false statements have no certificate") {
  struct False {
    std::string statement, proof, expected;
  };
  const std::string positive = "real x\nassume a: x > 0\nshow false\n";
  const std::string bounds = "real x z\nassume a: x >= 0\nassume b: -x >= 0\nassume c: z > 0\nshow false\n";
  const std::vector<False> table = {
      {positive, "contradiction\nterm 0 a\nqed\n", "the coefficient is zero"},
      {positive, "contradiction\nterm 1 a\nterm -1 a\nqed\n", "expected a number"},
      {positive, "contradiction\nterm 1 a\nqed\n", "the lines do not add up to zero"},
      {positive, "contradiction\nterm 1 a\nequation a: -1\nqed\n", "not an equation"},
      {positive, "contradiction\nqed\n", "no term is strict"},
      {positive, "cases a\nend\n", "the hypothesis is not a disjunction"},
      {positive, "cases goal\nend\n", "there is no such hypothesis here"},
      {positive, "witness w\ncases w\nend\n", "the statement has no `exists`"},
      {bounds, "contradiction\nterm 1 a\nterm 1 b\nqed\n", "no term is strict"},
      {bounds, "contradiction\nterm 1 a c\nterm 1 b c\nqed\n", "no term is strict"},
      {bounds, "have k: x > 0\nterm 1 a\nterm 1 k\nqed\ncontradiction\nterm 1 k\nterm 1 b\nqed\n",
       "have: no term is strict"},
      {"real x\nassume b: -x >= 0\nshow x = 0\n",
       "have k: x = 0\nterm 1 b\nterm 1 k\nqed\nterm 1 b\nterm 1 k\nqed\ncases goal\nbranch 1\ncontradiction\n"
       "term 1 goal.1\nequation k: -1\nqed\nbranch 2\ncontradiction\nterm 1 goal.2\nequation k: 1\nqed\nend\n",
       "have: the lines do not add up to zero"},
      {"real x\nassume a: x >= 0\nshow x > 0\n", "contradiction\nterm 1 a\nterm 1 goal\nqed\n", "no term is strict"},
      {"real x\nshow x*x > 0\n",
       "split s: x\nbranch negative\ncontradiction\nterm 1 s^2\nterm 1 goal\nqed\nbranch positive\ncontradiction\n"
       "term 1 s^2\nterm 1 goal\nqed\nend\n",
       "expected 'branch zero'"},
      {"real x y\nassume a: x > 0 or y > 0\nshow x > 0\n",
       "cases a\nbranch 1\ncontradiction\nterm 1 a.1\nterm 1 goal\nqed\nend\n", "expected 'branch 2'"},
      {"real x y\nassume a: x > 0 or y > 0\nshow x > 0\n",
       "cases a\nbranch 1\ncontradiction\nterm 1 a.1\nterm 1 goal\nqed\nbranch 2\ncontradiction\nterm 1 a.1\n"
       "term 1 goal\nqed\nend\n",
       "there is no such hypothesis here"},
      {"real x\nshow x > 0\n", "split s: x\nbranch negative\ncontradiction\nterm 1 s\nterm 1 goal\nqed\n",
       "the lines do not add up to zero"},
      {"real x\nshow x <= 0\n",
       "split s: x\nbranch negative\ncontradiction\nterm 1 s\nterm 1 goal\nqed\nbranch zero\ncontradiction\nterm 1 "
       "goal\n"
       "equation s: -1\nqed\nbranch positive\ncontradiction\nterm 1 s\nterm 1 goal\nqed\n",
       "the lines do not add up to zero"},
      {bounds, "have k: x >= 0\nterm 1 a\nterm 1 k\nqed\ncontradiction\nterm 1 k\nterm 1 b\nqed\n",
       "no term is strict"},
      // The relations mean what they say.
      {"real x\nassume a: x <= 0\nassume b: x >= 0\nshow false\n", "contradiction\nterm 1 a\nterm 1 b\nqed\n",
       "no term is strict"},
      {"real x\nassume a: x != 0\nassume b: x > 0\nshow false\n", "contradiction\nterm 1 b\nequation a: -1\nqed\n",
       "not an equation"},
      {"real x\nassume a: 1/x < 0\nshow false\n", "contradiction\nterm 1 a.2\nterm 1\nqed\n",
       "the lines do not add up to zero"},
      {"real x\nexists u\nshow u > x\n", "contradiction\nterm 1 goal\nqed\n", "there is no such hypothesis here"},
      // Divisors count: x/x = 1 is false at 0, and so is a value that is not defined there.
      {"real x\nshow x/x = 1\n", "cases goal\nbranch 1\ncontradiction\nterm 1 goal.1.1\nterm 1 goal.1.2\nqed\n",
       "no term is strict"},
      {"real x\nexists u\nshow x*u = 1\n",
       "witness w\nset u = 1/x\ncases w\nbranch 2\ncontradiction\nterm 1 w.2\nqed\nend\n", "expected 'branch 1'"},
      {"real x\nexists u\nshow x*u = 1\n", "witness w\nset u = u\n", "expected a number or a known name"},
      {"real x\nexists u\nlet v = 1 - x*u\nshow x*u = 1\n", "witness w\nset u = v\n",
       "expected a number or a known name"},
      {"real x\nexists u\nshow u > 0 and u < 0\n", "contradiction\nterm 1 goal.1\nqed\n",
       "there is no such hypothesis here"}};
  for (const False& forged : table) {
    const std::string statement = "slipproof-statement 1\ntheorem t\n" + forged.statement;
    const std::string found = verdict(statement, header(statement) + forged.proof);
    INFO(forged.statement, forged.proof, "gave '", found, "'");
    CHECK(found.find(forged.expected) != std::string::npos);
  }
}

// What names abbreviate is a polynomial for a certificate only if nothing in it is divided, even by 1.
TEST_CASE("a name that stands for a fraction is none of a polynomial") {
  const std::string statement =
      "slipproof-statement 1\ntheorem t\nreal x\nlet p = 2*x\nlet q = 4*x/2\nlet r = 2*x/1\nlet s = 1/(1/(2*x))\nlet i "
      "= q + "
      "0\nassume e: x = 0\nassume a: x > 0\nshow false\n";
  const auto with = [&](const std::string& factor) {
    return verdict(statement, header(statement) + "have k: x^2 + 1 > 0\nterm 1 k\nequation e: x\nterm 1\nqed\n" +
                                  "contradiction\nterm 2 a a\nequation e: -" + factor + "\nqed\n");
  };
  CHECK(with("2*x") == "");
  CHECK(with("p") == "");
  for (const char* name : {"q", "r", "s", "i", "0*q - 2*x"}) {
    CAPTURE(name);
    CHECK(with(name) == "C:10: contradiction: expected a polynomial with integer coefficients");
  }
}

// What a witness gives: the divisors of its values, those of each value anew, then the negated conclusion.
TEST_CASE("a witness lists divisors value by value, and the negated conclusion last, as it is") {
  const std::string statement =
      "slipproof-statement 1\ntheorem t\nreal x y\nassume a: x > 0 and y > 0\nexists u v\nshow u = v\n";
  const auto zero = [](const char* branch, const char* positive) {
    return std::string("branch ") + branch + "\ncontradiction\nterm 1 a." + positive + "\nequation w." + branch +
           ": -1\nqed\n";
  };
  const std::string proof = "witness w\nset u = 1/x + 1/y\nset v = 1/y + 1/x\ncases w\n" + zero("1", "1") +
                            zero("2", "2") + zero("3", "2") + zero("4", "1") +
                            "branch 5\ncases w.5\nbranch 1\ncontradiction\nterm 1 a.1\nterm 1 w.5.1.1\nqed\n"
                            "branch 2\ncontradiction\nterm 1 a.2\nterm 1 w.5.2.1\nqed\n"
                            "branch 3\ncases w.5.3\nbranch 1\ncontradiction\nterm 1 w.5.3.1\nqed\n"
                            "branch 2\ncontradiction\nterm 1 w.5.3.2\nqed\nend\nend\nend\n";
  reject_all(statement, proof,
             {{zero("3", "2"), zero("3", "1"), "the lines do not add up to zero"},
              {zero("4", "1"), "", "expected 'branch 4'"},
              {"cases w.5\nbranch 1\ncontradiction\n", "contradiction\n", "there is no such hypothesis here"},
              {"set v = 1/y + 1/x", "set v = 1/x + 1/y", "the lines do not add up to zero"}});
  // Without divisors it is the negated conclusion alone.
  const std::string either = replaced(statement, "u = v", "u = x or v = 0");
  const std::string alone =
      "witness w\nset u = x\nset v = 1\ncases w.1\nbranch 1\ncontradiction\nterm 1 w.1.1\nqed\n"
      "branch 2\ncontradiction\nterm 1 w.1.2\nqed\nend\n";
  CHECK(verdict(either, header(either) + alone) == "");
  // Each unknown has its own value.
  reject_all(replaced(statement, "u = v", "u < v"),
             "witness w\nset u = 0\nset v = 1\ncontradiction\nterm 1 w\nterm 1\nqed\n",
             {{"set u = 0\nset v = 1", "set u = 1\nset v = 0", "the lines do not add up to zero"},
              {"set v = 1", "set v = 0", "the lines do not add up to zero"}});
}

// The normal form of proofs/FORMAT.md: which hypothesis stands for which polynomial.
TEST_CASE("hypotheses have the names and the polynomials that the format says") {
  struct Row {
    std::string formula, before, line, polynomial;
  };
  const std::vector<Row> table = {
      {"-x^2 < 1", "", "term 1 h", "1 + x^2"},
      {"- -x^2 < 1", "", "term 1 h", "1 - x^2"},
      {"2^3*x - y^2 > -2^2", "", "term 1 h", "8*x - y^2 + 4"},
      {"x - y - z >= 0", "", "term 1 h", "x - y - z"},
      {"x/2 >= y", "", "term 1 h", "2*x - 4*y"},
      {"x/-2 >= y", "", "term 1 h", "-2*x - 4*y"},
      {"6/2/3*x = y", "", "equation h: 1", "6*x - 6*y"},
      {"x < y <= z", "", "term 1 h.1", "y - x"},
      {"x < y <= z", "", "term 1 h.2", "z - y"},
      {"x < y <= z and z = 1", "", "term 1 h.1.2", "z - y"},
      {"x < y <= z and z = 1", "", "equation h.2: 1", "z - 1"},
      {"{x > 0 and y > 0} and z > 0", "", "term 1 h.1.2", "y"},
      {"x != 0", "cases h\nbranch 1\n", "term 1 h.1", "x"},
      {"x > 0 and y > 0 and z > 0", "", "term 1 h.2", "y"},
      {"{{x > 0}}", "", "term 1 h", "x"},
      {"x/y > 0", "", "term 1 h.2", "x*y"},
      {"x/y/z = 1", "cases h.1\nbranch 1\n", "term 1 h.1.1", "y"},
      {"x/y/z = 1", "cases h.2\nbranch 1\n", "term 1 h.2.1", "z"},
      {"x/y/z = 1", "", "equation h.3: 1", "x - y*z"},
      {"1/(x/y) = 1", "cases h.1\nbranch 1\n", "term 1 h.1.1", "y"},
      {"1/(x/y) = 1", "cases h.2\nbranch 1\n", "term 1 h.2.1", "x"},
      {"1/(x/y) = 1", "", "equation h.3: 1", "y - x"},
      {"1/x + 1/(-x) = z", "cases h.2\nbranch 1\n", "term 1 h.2.1", "-x"},
      {"1/x + 1/x = z", "", "equation h.2: 1", "2 - x*z"},
      {"1/x + 1/y >= z", "", "term 1 h.3", "(x + y - x*y*z)*x*y"},
      {"y/(2*x) = z/(2*x)", "", "equation h.2: 1", "y - z"},
      {"y/(2*x) = z/(4*x)", "", "equation h.3: 1", "4*x*y - 2*x*z"},
      {"1/(1/x) = 0", "", "equation h.2: 1", "x"},
      {"x^2/x > 0", "", "term 1 h.2", "x^3"},
      {"(x/y)^2 = z", "", "equation h.2: 1", "x^2 - y^2*z"},
  };
  for (const Row& row : table) {
    const std::string statement =
        "slipproof-statement 1\ntheorem t\nreal x y z\nassume h: " + row.formula + "\nshow false\n";
    const std::string found = verdict(statement, header(statement) + row.before + "have k: " + row.polynomial +
                                                     " >= 0\nterm 1 k\n" + row.line + "\nqed\n");
    CAPTURE(row.formula);
    CAPTURE(row.line);
    CHECK(found.find("have: the file ends too early") != std::string::npos);  // the identity was right
  }
}

TEST_CASE("negations have the shapes that the format says") {
  const auto proves = [](const std::string& lines, const std::string& proof) {
    const std::string statement = "slipproof-statement 1\ntheorem t\nreal x y\n" + lines;
    return verdict(statement, header(statement) + proof);
  };
  const std::string two = "contradiction\nterm 1 a\nterm 1 goal";
  CHECK(proves("assume a: x > 0\nshow x != 0\n", two + ".1\nqed\n") == "");  // not x = 0, but -x >= 0 and x >= 0
  CHECK(proves("assume a: -x > 0\nshow x != 0\n", two + ".2\nqed\n") == "");
  CHECK(proves("assume a: x >= 0\nshow x >= 0 and 0 = 0\n",
               "cases goal\nbranch 1\n" + two +
                   ".1\nqed\nbranch 2\ncases goal.2\nbranch 1\ncontradiction\nterm 1 "
                   "goal.2.1\nqed\nbranch 2\ncontradiction\nterm 1 goal.2.2\nqed\nend\nend\n") == "");
  CHECK(proves("assume a: x > 0\nshow x > 0 or false\n", two + ".1\nqed\n") == "");
  CHECK(proves("assume a: false\nshow x > 0\n", "cases a\nend\n") == "");
  CHECK(proves("assume a: x > 0 and -x > 0\nshow false\n", "contradiction\nterm 1 a.1\nterm 1 a.2\nqed\n") == "");
  CHECK(proves("show false\n", two + "\nqed\n").find("there is no such hypothesis") != std::string::npos);
  CHECK(proves("assume a: x > 0\nshow x^3 > 0\n", "contradiction\nterm 1 a a a\nterm 1 goal\nqed\n") == "");
  CHECK(proves("assume a: x > 0\nshow x^3 > 0\n", "contradiction\nterm 1 a a^2\nterm 1 goal\nqed\n") == "");
  CHECK(proves("show 1 > 0\n", "contradiction\nterm 1\nterm 1 goal\nqed\n") == "");  // the empty product is 1, strict
}

TEST_CASE("truncated anywhere, a certificate is rejected; so is one that goes on") {
  for (const auto& [statement, proof] :
       {std::pair(kSplitStatement, kSplitProof), std::pair(kWitnessStatement, kWitnessProof)}) {
    const std::string certificate = header(statement) + proof;
    for (std::size_t length = 0; length + 1 < certificate.size(); ++length) {
      CHECK(verdict(statement, certificate.substr(0, length)) != "");
    }
    CHECK(verdict(statement, certificate + "contradiction\nterm 1\nqed\n").find("goes on") != std::string::npos);
  }
}

TEST_CASE("a certificate of a changed statement is rejected, even with its fingerprint") {
  const std::string weaker = replaced(kSplitStatement, "x > 0 or y > 0", "x > 0 or y > -1");
  CHECK(verdict(weaker, header(kSplitStatement) + kSplitProof).find("expected 'theorem split-example") !=
        std::string::npos);
  CHECK(verdict(weaker, header(weaker) + kSplitProof).find("the lines do not add up") != std::string::npos);
  const std::string no_assumption = replaced(kSplitStatement, "assume e: t = x\n", "");
  CHECK(verdict(no_assumption, header(no_assumption) + kSplitProof).find("no such hypothesis") != std::string::npos);
}
