// A text with a small change.
#pragma once

#include <doctest/doctest.h>

#include <string>

namespace slipproof::test {

/// The first `from`, which must be there, becomes `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  REQUIRE_MESSAGE(place != std::string::npos, "no '" << from << "'");
  return text.replace(place, from.size(), to);
}

}  // namespace slipproof::test
