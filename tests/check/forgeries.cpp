// The checker accepts a proof and rejects every forgery: for each side condition of proofs/FORMAT.md a certificate that
// differs from a valid one only there.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "check/examples.hpp"

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
