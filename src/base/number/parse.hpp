// Reading numbers exactly as they are written.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/number/rational.hpp"

namespace slipproof {

/// A text or a binary64 that is no finite number slipproof can hold. what() is "found ..., expected ...".
class NumberError : public std::runtime_error {
 public:
  NumberError(std::size_t position, std::string found, std::string expected);
  std::size_t position() const { return position_; }  ///< byte position of the mistake in the text, from 0
  const std::string& found() const { return found_; }
  const std::string& expected() const { return expected_; }

 private:
  std::size_t position_;
  std::string found_;
  std::string expected_;
};

/// Texts longer than this and exponents beyond these are refused before any of the work that they would cause.
/// Every binary64 and binary128 is inside.
inline constexpr std::size_t max_number_length = 10'000;
inline constexpr int max_decimal_exponent = 5'000;
inline constexpr int max_binary_exponent = 20'000;

/// The number that all of `text` denotes, exactly. After an optional sign, + or -, one of
/// - integers: 5, 007
/// - fractions: 3/4; of two integers, since 0.5/3 might be a slip of the pen
/// - decimals: 0.1, .5, 5., 1e-3, 2.5E+7
/// - hexadecimal: 0x1.8p-3, 0xFF; C's floating-point literals, with p before the exponent of 2
/// No spaces, no digit separators, no NaN, no infinity. Throws NumberError.
Rational parse_rational(std::string_view text);

}  // namespace slipproof
