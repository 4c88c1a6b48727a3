// What the prover and the checker say of a statement.
#pragma once

#include <string>

#include "base/input/diagnostic.hpp"
#include "proofs/check/theorem.hpp"
#include "proofs/statement/statement.hpp"

namespace slipproof::test {

/// The mistakes, a line each.
inline std::string mistakes(const std::string& text) {
  try {
    prove::Statement("s", text);
  } catch (const InputError& error) {
    std::string all;
    for (const Diagnostic& mistake : error.diagnostics()) all += to_string(mistake) + '\n';
    return all;
  }
  return "";
}

inline bool checker_reads(const std::string& text) {
  check::FormulaReader reader(text);
  try {
    check::Statement statement(reader);
    return true;
  } catch (const check::Rejection&) {
    return false;
  }
}

}  // namespace slipproof::test
