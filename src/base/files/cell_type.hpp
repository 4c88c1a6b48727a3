// How a number or a text lies in the bytes of a binary file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace slipproof {

struct CellType {
  enum class Kind : std::uint8_t {
    real,     ///< binary64 or binary32
    integer,  ///< 1, 2, 4 or 8 bytes, two's complement
    natural,  ///< unsigned, 1, 2, 4 or 8 bytes
    bytes,    ///< text, one byte a character, zero bytes after its end
    utf32,    ///< text, four bytes a character
    other     ///< a type that is not supported
  };
  Kind kind = Kind::other;
  std::size_t size = 0;  ///< bytes
  bool big_endian = false;
  std::string name;  ///< the name of the type in the file

  bool is_number() const { return kind <= Kind::natural; }
  bool is_integer() const { return kind == Kind::integer || kind == Kind::natural; }
  bool is_text() const { return kind == Kind::bytes || kind == Kind::utf32; }
  /// True if the cells have the format of a double of this machine.
  bool is_native() const;
};

/// A number of the type; an integer that binary64 cannot hold is rounded to the nearest.
double number_at(const CellType& type, const char* cell);
/// Reads an integer; returns the largest int64 if the value is above it. The type must be an integer type.
std::int64_t integer_at(const CellType& type, const char* cell);
/// A cell of a text type, as UTF-8 without the trailing zeros.
std::string text_at(const CellType& type, const char* cell);

/// The numbers of `count` cells that are `stride` bytes apart.
void read_numbers(const CellType& type, const char* first, std::size_t stride, std::size_t count, double* to);

}  // namespace slipproof
