// Numbers of records as they are written, whatever they are of.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/number/rational.hpp"

namespace slipproof {

/// A line that cannot be read: its column (from 1; 0: no place) and what was found and expected.
struct BrokenRecord {
  std::size_t column;
  std::string message;
};

/// A value that is no finite number: where it stands in its line (byte, from 1; 0: no place), what was found, expected.
struct NotFinite {
  std::size_t column;
  std::string reason;
};

/// "line 3, column 25: ", or without a column if it is 0; empty for line 0, as records in columns stand in no lines.
std::string place_text(std::uint64_t line, std::size_t column);

/// Neither a fraction nor hexadecimal: what `--decimal` is about.
bool is_decimal(std::string_view text);

/// A cell without blanks and quotes around it.
std::string_view trimmed(std::string_view text);

struct CellNumber {
  double nearest = 0;             ///< perhaps NaN or infinite
  std::optional<Rational> exact;  ///< where a fraction, or a decimal that means itself, is written
};
/// Throws BrokenRecord; messages call the number by its name.
CellNumber read_number(std::string_view text, std::string_view name, std::size_t place, bool decimal_exact);

/// Of what stands in a record and is not asked for.
inline constexpr int ignored_column = -3;

/// Nothing if the value is finite.
std::optional<NotFinite> not_finite(std::string_view name, double value, std::size_t place);

}  // namespace slipproof
