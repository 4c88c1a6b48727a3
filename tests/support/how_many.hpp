// How much of a test is done: all that a minute allows, less where sanitizers make everything take ten times as long,
// or what a variable of the environment asks for.
#pragma once

#include <concepts>
#include <cstdlib>

namespace slipproof::test {

template <std::integral Count>
constexpr Count quick([[maybe_unused]] Count usual, [[maybe_unused]] Count sanitized) {
#if defined(__SANITIZE_ADDRESS__)
  return sanitized;
#else
  return usual;
#endif
}

/// The variable may say 1e4.
template <std::integral Count>
Count how_many(const char* variable, Count otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : static_cast<Count>(std::strtod(text, nullptr));
}

}  // namespace slipproof::test
