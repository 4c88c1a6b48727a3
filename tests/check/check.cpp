// The checker accepts a proof and rejects every forgery: for each side condition of proofs/FORMAT.md a certificate that
// differs from a valid one only there.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "check/certificate.hpp"
#include "check/files.hpp"

namespace {

using namespace slipproof::check;

std::string fingerprint(const Statement& statement) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(statement.fingerprint()));
  return text;
}

Statement read_statement(const std::string& text) {
  std::istringstream input(text);
  return Statement(input);
}

std::string header(const std::string& statement) {
  const Statement read = read_statement(statement);
  return "slipproof-certificate 1\ntheorem " + read.theorem() + " " + fingerprint(read) + "\n";
}

/// "" if accepted, otherwise `rule: message`.
std::string verdict(const std::string& statement, const std::string& certificate) {
  try {
    const Statement read = read_statement(statement);
    std::istringstream input(certificate);
    check_certificate(read, input);
    return "";
  } catch (const Failure& failure) {
    CHECK(failure.line > 0);
    return failure.rule + ": " + failure.what();
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  REQUIRE_MESSAGE(place != std::string::npos, "no '" << from << "'");
  return text.replace(place, from.size(), to);
}

struct Forgery {
  std::string from, to, expected;
};

// A small theorem whose proof uses every rule but `witness`.
const std::string kSplitStatement =
    "slipproof-statement 1\n"
    "theorem split-example\n"
    "real x y t\n"
    "assume e: t = x\n"
    "assume d: x > 0 or y > 0\n"
    "assume s: x >= 0 and y >= 0\n"
    "show t + y > 0 and (x - y)^2 >= 0\n";

const std::string kSplitProof =
    "have k: t - x = 0\n"
    "term 1 k\n"
    "equation e: -1\n"
    "qed\n"
    "term 1 k\n"
    "equation e: 1\n"
    "qed\n"
    "cases goal\n"
    "branch 1\n"
    "cases d\n"
    "branch 1\n"
    "contradiction\n"
    "term 3/4 d.1\n"
    "term 3/4 s.2\n"
    "term 3/4 goal.1\n"
    "equation k: 3/4\n"
    "qed\n"
    "branch 2\n"
    "contradiction\n"
    "term 1 d.2\n"
    "term 1 s.1\n"
    "term 1 goal.1\n"
    "equation k: 1\n"
    "qed\n"
    "end\n"
    "branch 2\n"
    "split r: x - y\n"
    "branch negative\n"
    "contradiction\n"
    "term 1 r^2\n"
    "term 1 goal.2\n"
    "qed\n"
    "branch zero\n"
    "contradiction\n"
    "term 1 goal.2\n"
    "equation r: x - y\n"
    "qed\n"
    "branch positive\n"
    "contradiction\n"
    "term 1 r^2\n"
    "term 1 goal.2\n"
    "qed\n"
    "end\n"
    "end\n";

// u = x/y solves u y = x, u > 0, where x > 0 and y > 0.
const std::string kWitnessStatement =
    "slipproof-statement 1\n"
    "theorem witness-example\n"
    "real x y\n"
    "assume a: x > 0 and y > 0\n"
    "exists u\n"
    "show u*y = x and u > 0\n";

const std::string kWitnessProof =
    "witness w\n"
    "set u = x/y\n"
    "cases w\n"
    "branch 1\n"
    "contradiction\n"
    "term 1 a.2\n"
    "equation w.1: -1\n"
    "qed\n"
    "branch 2\n"
    "cases w.2\n"
    "branch 1\n"
    "cases w.2.1\n"
    "branch 1\n"
    "contradiction\n"
    "term 1 a.2\n"
    "term 1 w.2.1.1.1\n"
    "qed\n"
    "branch 2\n"
    "cases w.2.1.2\n"
    "branch 1\n"
    "contradiction\n"
    "term 1 w.2.1.2.1\n"
    "qed\n"
    "branch 2\n"
    "contradiction\n"
    "term 1 w.2.1.2.2\n"
    "qed\n"
    "end\n"
    "end\n"
    "branch 2\n"
    "cases w.2.2\n"
    "branch 1\n"
    "contradiction\n"
    "term 1 a.2\n"
    "term 1 w.2.2.1.1\n"
    "qed\n"
    "branch 2\n"
    "contradiction\n"
    "term 1 a.1 a.2\n"
    "term 1 w.2.2.2\n"
    "qed\n"
    "end\n"
    "end\n"
    "end\n";

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
      {{"term 3/4 d.1", "term -3/4 d.1", "contradiction: expected a number"},
       {"term 3/4 d.1", "term 0 d.1", "contradiction: a coefficient is not positive"},
       {"term 3/4 d.1", "term 0/4 d.1", "contradiction: a coefficient is not positive"},
       {"term 3/4 d.1", "term 3/0 d.1", "contradiction: a coefficient is not positive"},
       {"term 3/4 d.1", "term 1/2 d.1", "contradiction: the terms do not add up to zero"},
       {"term 3/4 d.1\n", "", "contradiction: the terms do not add up to zero"},
       {"equation k: 3/4", "equation k: 3/4*x", "contradiction: the terms do not add up to zero"},
       {"equation k: 3/4", "equation k: 3/(4*x)", "contradiction: expected a polynomial, found a division"},
       {"equation k: 3/4", "equation k: 3/0", "contradiction: division by zero"},
       {"equation k: 3/4", "equation s.1: 3/4", "contradiction: not an equation"},
       {"equation k: 3/4", "equation nowhere: 3/4", "contradiction: there is no hypothesis 'nowhere' here"},
       {"equation k: 3/4", "equation k: 3/4*v", "contradiction: unknown name 'v'"},
       {"term 3/4 d.1", "term 3/4 e", "contradiction: not an inequality"},
       {"term 3/4 d.1", "term 3/4 d", "contradiction: not an inequality"},
       {"term 3/4 d.1", "term 3/4 d.3", "contradiction: there is no hypothesis 'd.3' here"},
       {"term 1 d.2", "term 1 d.1", "contradiction: there is no hypothesis 'd.1' here"},
       {"term 1 r^2", "term 1 r^0", "contradiction: an exponent is out of range"},
       {"term 1 r^2", "term 1 r^65", "contradiction: an exponent is out of range"},
       {"term 1 r^2", "term 1 r^99999999999999999999", "contradiction: an exponent is out of range"},
       {"term 1 r^2\nterm 1 goal.2\n", "equation e: 0\n", "contradiction: no term of the identity is strict"},
       {"have k: t - x = 0", "have k: t + x = 0", "have: the terms do not add up to zero"},
       {"have k: t - x = 0", "have k: t - x > 0", "have: the terms do not add up to zero"},
       {"have k: t - x = 0", "have k: t - x = 1", "have: expected 0 on the right"},
       {"have k: t - x = 0", "have e: t - x = 0", "have: the name 'e' is given twice"},
       {"qed\nterm 1 k\nequation e: 1\nqed\n", "qed\n", "have: expected 'term', 'equation' or 'qed'"},
       {"split r: x - y", "split r: x + y", "contradiction: the terms do not add up to zero"},
       {"split r: x - y", "split k: x - y", "split: the name 'k' is given twice"},
       {"split r: x - y", "split r: x/y", "split: expected a polynomial, found a division"},
       {"branch zero\ncontradiction\nterm 1 goal.2\nequation r: x - y\nqed\n", "", "split: expected 'branch zero'"},
       {"branch positive\n", "branch negative\n", "split: expected 'branch positive'"},
       {"branch positive\ncontradiction\nterm 1 r^2\nterm 1 goal.2\nqed\n", "", "split: expected 'branch positive'"},
       {"cases d\n", "cases s.1\n", "cases: 's.1' is not a disjunction"},
       {"cases d\n", "cases x\n", "cases: there is no hypothesis 'x' here"},
       {"branch 2\ncontradiction\nterm 1 d.2\nterm 1 s.1\nterm 1 goal.1\nequation k: 1\nqed\n", "",
        "cases: expected 'branch 2'"},
       {"qed\nend\nbranch 2\nsplit", "qed\nbranch 3\nend\nbranch 2\nsplit", "cases: expected 'end'"},
       {"cases goal\n", "assume more: x > 1\ncases goal\n", "unknown rule 'assume'"},
       {"cases goal\n", "witness w\ncases goal\n", "witness: the statement has no unknowns"},
       {"slipproof-certificate 1", "slipproof-certificate 2", "header: expected 'slipproof-certificate 1'"},
       {"theorem split-example", "theorem other-example", "theorem: the certificate is for another theorem"},
       {"theorem split-example ", "theorem split-example 0", "theorem: the certificate is for another statement"}});
}

TEST_CASE("every side condition of witnesses has a forgery that it rejects") {
  reject_all(kWitnessStatement, kWitnessProof,
             {{"set u = x/y\n", "", "witness: expected 'set u = ...'"},
              {"set u = x/y", "set v = x/y", "witness: expected 'set u = ...'"},
              {"set u = x/y", "set u = u", "witness: unknown name 'u'"},
              {"set u = x/y", "set u = x/(y - y)", "witness: division by zero"},
              {"set u = x/y", "set u = x/(y - 1)", "contradiction: the terms do not add up to zero"},
              {"set u = x/y", "set u = 2*x/y", "contradiction: the terms do not add up to zero"},
              {"branch 1\ncontradiction\nterm 1 a.2\nequation w.1: -1\nqed\n", "", "cases: expected 'branch 1'"}});
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
  CHECK(verdict(weaker, header(kSplitStatement) + kSplitProof).find("another statement") != std::string::npos);
  CHECK(verdict(weaker, header(weaker) + kSplitProof).find("the terms do not add up") != std::string::npos);
  const std::string no_assumption = replaced(kSplitStatement, "assume e: t = x\n", "");
  CHECK(verdict(no_assumption, header(no_assumption) + kSplitProof).find("no hypothesis 'e'") != std::string::npos);
}

TEST_CASE("malformed statements are refused with rule and line") {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"", "statement: the statement ends without `show`"},
      {"slipproof-statement 2\n", "header: expected 'slipproof-statement 1'"},
      {"slipproof-statement 1\nshow false\n", "expected 'theorem NAME'"},
      {"slipproof-statement 1\ntheorem t\nreal x x\nshow false\n", "real: the name 'x' is given twice"},
      {"slipproof-statement 1\ntheorem t\nreal x\nlet x = 1\nshow false\n", "let: the name 'x' is given twice"},
      {"slipproof-statement 1\ntheorem t\nreal or\nshow false\n", "real: 'or' is a reserved word"},
      {"slipproof-statement 1\ntheorem t\nassume a: 1 > 0\nassume a: 2 > 0\nshow false\n",
       "assume: the assumption 'a' is given twice"},
      {"slipproof-statement 1\ntheorem t\nassume a: y > 0\nshow false\n", "assume: unknown name 'y'"},
      {"slipproof-statement 1\ntheorem t\nreal x\nassume a: x\nshow false\n", "assume: expected a comparison"},
      {"slipproof-statement 1\ntheorem t\nreal x\nassume a: x > 1/0\nshow false\n", "assume: division by zero"},
      {"slipproof-statement 1\ntheorem t\nexists u\nassume a: u > 0\nshow false\n",
       "assume: unknown directive 'assume'"},
      {"slipproof-statement 1\ntheorem t\nexists u\nexists v\nshow false\n", "exists: `exists` is given twice"},
      {"slipproof-statement 1\ntheorem t\nexists u\nlet u = 1\nshow false\n", "let: the name 'u' is given twice"},
      {"slipproof-statement 1\ntheorem t\nshow false\nshow false\n", "show: nothing may follow `show`"},
      {"slipproof-statement 1\ntheorem t\nreal x\nshow x^65 > 0\n", "show: an exponent is too large"},
      {"slipproof-statement 1\ntheorem t\nreal x\nshow ((x^64)^64) > 0\n", "show: a degree is too large"},
      {"slipproof-statement 1\ntheorem t\nshow (2^64)^64*(2^64)^64*(2^64)^64 > 0\n",
       "show: a coefficient has too many digits"},
      {"slipproof-statement 1\ntheorem t\nshow " + std::string(200, '(') + "1" + std::string(200, ')') + " > 0\n",
       "nested too deeply"},
      {"slipproof-statement 1\ntheorem t\nshow " + std::string(100'000, '{') + "\n", "nested too deeply"},
      {"slipproof-statement 1\ntheorem t\nshow " + std::string(2'000, '9') + " > 0\n", "a number has too many digits"},
      {"slipproof-statement 1\ntheorem t\nreal a b c d e f g h\nshow (a+b+c+d+e+f+g+h)^40 > 0\n", "too many terms"},
      {"slipproof-statement 1\ntheorem t\n#" + std::string(2 << 20, 'x') + "\nshow false\n", "the line is too long"}};
  for (const auto& [text, expected] : table) {
    const std::string found = verdict(text, "");
    INFO("'", text.substr(0, 200), "' gave '", found, "'");
    CHECK(found.find(expected) != std::string::npos);
  }
}

TEST_CASE("more than 64 variables and deep nesting of branches are refused") {
  std::string variables = "slipproof-statement 1\ntheorem t\nreal";
  for (int i = 0; i < 65; ++i) variables += " x" + std::to_string(i);
  CHECK(verdict(variables + "\nshow false\n", "").find("too many variables") != std::string::npos);
  std::string deep = header(kSplitStatement);
  for (int i = 0; i < 1'100; ++i) deep += "split n" + std::to_string(i) + ": x\nbranch negative\n";
  CHECK(verdict(kSplitStatement, deep).find("nested too deeply") != std::string::npos);
}

namespace {

std::vector<std::filesystem::path> shipped() {
  return certificates_in(std::filesystem::path(SLIPPROOF_SOURCE_DIR) / "proofs");
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A certificate as its proof's lines, where `term` factors may stand in any order.
std::vector<std::string> meaning(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::string squeezed;
    for (const char c : line) {
      if (c != ' ' && c != '\t') squeezed += c;
    }
    if (!squeezed.empty() && squeezed.front() != '#') result.push_back(squeezed);
  }
  return result;
}

}  // namespace

TEST_CASE("all shipped certificates are accepted") {
  REQUIRE(shipped().size() > 40);
  for (const auto& certificate : shipped()) {
    const FileResult result = check_file(certificate);
    INFO(result.message);
    CHECK(result.verdict == Verdict::accepted);
  }
}

// The sanitizers slow this down by an order of magnitude; they see the same code with fewer mutants.
#if defined(__SANITIZE_ADDRESS__)
constexpr int mutant_count = 1'000;
#else
constexpr int mutant_count = 10'000;
#endif

TEST_CASE("mutants of the shipped certificates: rejected, or a proof all the same") {
  // A mutant may be a valid certificate too (a derived fact that is not needed in this place, a stronger strictness, a
  // name that nobody uses). Those that are accepted are few, and the statement is untouched: count and bound them.
  std::mt19937_64 random(20240607);
  const auto certificates = shipped();
  const std::string symbols = "0123456789+-*/^=> .:abxyR";
  int mutants = 0;
  int accepted = 0;
  int identical = 0;
  for (std::size_t round = 0; mutants < mutant_count; ++round) {
    const auto& path = certificates[round % certificates.size()];
    const std::string valid = content(path);
    if (valid.size() > 20'000) continue;
    std::filesystem::path statement_path = path;
    const std::string statement = content(statement_path.replace_extension(".statement"));
    std::vector<std::string> lines;
    std::istringstream input(valid);
    for (std::string line; std::getline(input, line);) lines.push_back(line);
    for (int i = 0; i < 20; ++i, ++mutants) {
      std::vector<std::string> mutant = lines;
      const std::size_t at = random() % lines.size();
      const std::size_t other = random() % lines.size();
      switch (random() % 6) {
        case 0:
          mutant.erase(mutant.begin() + static_cast<std::ptrdiff_t>(at));
          break;
        case 1:
          mutant.insert(mutant.begin() + static_cast<std::ptrdiff_t>(at), lines[other]);
          break;
        case 2:
          std::swap(mutant[at], mutant[other]);
          break;
        case 3:
          mutant[at] = lines[other];
          break;
        case 4:
          mutant.resize(at);
          break;
        default:
          mutant[at][random() % mutant[at].size()] = symbols[random() % symbols.size()];
      }
      std::string text;
      for (const std::string& line : mutant) text += line + '\n';
      if (verdict(statement, text) != "") continue;
      if (meaning(text) == meaning(valid)) {
        ++identical;
        continue;
      }
      // Accepted and different: it must be a reordering within an identity, or a fact or name that the proof does not
      // need.
      std::vector<std::string> before = meaning(valid);
      std::vector<std::string> after = meaning(text);
      std::sort(before.begin(), before.end());
      std::sort(after.begin(), after.end());
      if (before != after) {
        for (std::size_t k = 0; k < mutant.size() && k < lines.size(); ++k) {
          if (mutant[k] != lines[k]) {
            MESSAGE(path.filename().string(), ":", k + 1, ": ", lines[k], " -> ", mutant[k]);
            break;
          }
        }
      }
      accepted += before == after ? 0 : 1;
      identical += before == after ? 1 : 0;
    }
  }
  MESSAGE(mutants << " mutants, " << identical << " the same proof, " << accepted << " other proofs accepted");
  CHECK(accepted * 200 < mutants);
}
