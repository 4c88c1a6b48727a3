// Statements of a few lines, for tests.
#pragma once

#include <string>

namespace slipproof::test {

inline std::string statement(const std::string& lines) {
  return "slipproof-statement 1\ntheorem small\n" + lines;
}

}  // namespace slipproof::test
