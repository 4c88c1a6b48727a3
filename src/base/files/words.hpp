// Reads a text word by word, and words as numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/input/diagnostic.hpp"

namespace slipproof {

/// Longest accepted file with a contact problem, in bytes; real problems are shorter.
inline constexpr std::size_t max_problem_file_size = std::size_t{1} << 29U;

/// The place and message of the first mistake in a text. Thrown by readers, caught by the code that knows the file.
struct FormatStop {
  std::size_t position = 0;  ///< a byte of the text
  std::string message;       ///< found ..., expected ...
};

/// The binary64 nearest to a decimal, an infinity beyond its range; nan, inf and infinity in any case. Nothing for any
/// other text.
std::optional<double> read_binary64(std::string_view word);

/// Line and column of a byte.
Place place_in(std::string_view text, std::size_t position);

/// Throws InputError with the place of `stop`.
[[noreturn]] void refuse(const std::string& file, std::string_view text, const FormatStop& stop);
/// The same without a place in the text.
[[noreturn]] void refuse(const std::string& file, const std::string& message);

/// Throws InputError if there are more numbers than expected, before memory is allocated for them.
void refuse_more(const std::string& file, const std::string& where, std::uint64_t found,
                 std::optional<std::size_t> expected);

/// Splits a text into words at blanks and line ends. Throws FormatStop for an unexpected word; `expected` describes the
/// expected one.
class WordReader {
 public:
  explicit WordReader(std::string_view text, std::size_t position = 0) : text_(text), position_(position) {}

  /// The next word; empty at the end of the text.
  std::string_view peek();
  std::string_view next();
  /// The position of the next word.
  std::size_t position();
  /// The rest of the line. Consumes the line end, too.
  std::string_view rest_of_line();
  std::string_view rest() { return text_.substr(position()); }

  /// Reads a count: digits only. Each counted thing takes at least a byte of the file, so larger numbers are refused.
  std::size_t count(std::string_view expected);
  double finite_number(std::string_view expected);
  double number(std::string_view expected);
  /// Reads exactly this word.
  void word(std::string_view expected);

  /// Throws FormatStop at the next word.
  [[noreturn]] void stop(const std::string& expected);

 private:
  std::string_view text_;
  std::size_t position_;
};

}  // namespace slipproof
