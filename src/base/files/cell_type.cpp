#include "base/files/cell_type.hpp"

#include <bit>
#include <cstring>
#include <limits>

#include "base/input/utf8.hpp"

namespace slipproof {

namespace {

/// The bytes of an unsigned integer in the order of this machine.
std::uint64_t bits_at(const CellType& type, const char* cell) {
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < type.size; ++k) {
    const auto byte = static_cast<unsigned char>(cell[type.big_endian ? k : type.size - 1 - k]);
    bits = bits << 8U | byte;
  }
  return bits;
}

std::int64_t signed_value(std::uint64_t bits, std::size_t size) {
  const auto unused = static_cast<unsigned>(64 - 8 * size);
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

}  // namespace

bool CellType::is_native() const {
  return kind == Kind::real && size == sizeof(double) && big_endian == (std::endian::native == std::endian::big);
}

double number_at(const CellType& type, const char* cell) {
  const std::uint64_t bits = bits_at(type, cell);
  switch (type.kind) {
    case CellType::Kind::real:
      if (type.size == 8) return std::bit_cast<double>(bits);
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case CellType::Kind::natural:
      return static_cast<double>(bits);
    default:
      return static_cast<double>(signed_value(bits, type.size));
  }
}

std::int64_t integer_at(const CellType& type, const char* cell) {
  const std::uint64_t bits = bits_at(type, cell);
  if (type.kind == CellType::Kind::integer) return signed_value(bits, type.size);
  constexpr auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  return static_cast<std::int64_t>(bits < largest ? bits : largest);
}

std::string text_at(const CellType& type, const char* cell) {
  std::string text;
  if (type.kind == CellType::Kind::bytes) {
    text.assign(cell, type.size);
    while (!text.empty() && text.back() == '\0') text.pop_back();
    return text;
  }
  const CellType letter{CellType::Kind::natural, 4, type.big_endian, {}};
  std::size_t length = type.size / 4;
  while (length > 0 && bits_at(letter, cell + 4 * (length - 1)) == 0) --length;
  for (std::size_t k = 0; k < length; ++k) append_utf8(text, static_cast<std::uint32_t>(bits_at(letter, cell + 4 * k)));
  return text;
}

void read_numbers(const CellType& type, const char* first, std::size_t stride, std::size_t count, double* to) {
  if (type.is_native()) {
    for (std::size_t i = 0; i < count; ++i) std::memcpy(to + i, first + i * stride, sizeof(double));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) to[i] = number_at(type, first + i * stride);
}

}  // namespace slipproof
