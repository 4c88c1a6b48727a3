// Numbers in records as written, for all kinds of records.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/number/rational.hpp"

namespace slipproof {

/// Thrown for a line that cannot be read: column (from 1; 0: unknown), what was found, what was expected.
struct BrokenRecord {
  std::size_t column;
  std::string message;
};

/// A value that is not a finite number: its place in the line (byte, from 1; 0: unknown), what was found, what was
/// expected.
struct NotFinite {
  std::size_t column;
  std::string reason;
};

/// "line 3, column 25: "; without the column if it is 0; empty for line 0, since records in columns have no lines.
std::string place_text(std::uint64_t line, std::size_t column);

/// True for a number that is neither a fraction nor hexadecimal; `--decimal` concerns these.
bool is_decimal(std::string_view text);

/// The cell without surrounding blanks and quotes.
std::string_view trimmed(std::string_view text);

struct CellNumber {
  double nearest = 0;             ///< may be NaN or infinite
  std::optional<Rational> exact;  ///< set if the text is a fraction, or a decimal that counts exactly
};
/// Throws BrokenRecord. `name` is the number's name in messages.
CellNumber read_number(std::string_view text, std::string_view name, std::size_t place, bool decimal_exact);

/// The column number of cells that are not used.
inline constexpr int ignored_column = -3;

/// Describes NaN and infinities; nothing if the value is finite.
std::optional<NotFinite> not_finite(std::string_view name, double value, std::size_t place);

}  // namespace slipproof
