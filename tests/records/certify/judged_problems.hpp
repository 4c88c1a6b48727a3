// What certify says of contact problems.
#pragma once

#include <doctest/doctest.h>

#include "support/certified.hpp"

namespace slipproof::test {

inline Certified problems(const std::string& text, CertifyOptions options = {}) {
  options.format = RecordFormat::json_lines;
  return certified(text, options);
}

inline nlohmann::json judged(const std::string& line, const CertifyOptions& options = {}) {
  const auto lines = problems(line + "\n", options).lines();
  REQUIRE(lines.size() == 1);
  return lines.front();
}

}  // namespace slipproof::test
