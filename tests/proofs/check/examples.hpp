// Two small theorems with proofs that use every rule, and what the tests do with statements and certificates.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "proofs/check/judge.hpp"
#include "proofs/check/record.hpp"
#include "proofs/check/theorem.hpp"
#include "support/replaced.hpp"

namespace slipproof::check {

inline std::string header(const std::string& statement) {
  FormulaReader reader(statement);
  const Statement read(reader);
  return "slipproof-certificate 1\ntheorem " + read.theorem + " " + read.fingerprint + "\n";
}

/// "" if accepted, otherwise `S:` or `C:`, of statement or certificate, and `LINE: RULE: message`.
inline std::string verdict(const std::string& statement, const std::string& certificate) {
  const Judgement judgement = judge(statement, certificate);
  const auto says = [&](const char* what) { return judgement.message.find(what) != std::string::npos; };
  const bool own_limit = says("too many polynomials and terms") || says("takes too much work");  // another has others
  if (!own_limit) record(statement, certificate, judgement.verdict);
  if (judgement.verdict == Verdict::accepted) return "";
  return (judgement.about_certificate ? "C:" : "S:") + judgement.message;
}

using test::replaced;

// A small theorem whose proof uses every rule but `witness`.
inline const std::string kSplitStatement =
    "slipproof-statement 1\n"
    "theorem split-example\n"
    "real x y t\n"
    "assume e: t = x\n"
    "assume d: x > 0 or y > 0\n"
    "assume s: x >= 0 and y >= 0\n"
    "show t + y > 0 and (x - y)^2 >= 0\n";

inline const std::string kSplitProof =
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
    "term 3 d.1\n"
    "term 3 s.2\n"
    "term 3 goal.1\n"
    "equation k: 3\n"
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
inline const std::string kWitnessStatement =
    "slipproof-statement 1\n"
    "theorem witness-example\n"
    "real x y\n"
    "assume a: x > 0 and y > 0\n"
    "exists u\n"
    "show u*y = x and u > 0\n";

inline const std::string kWitnessProof =
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

}  // namespace slipproof::check
