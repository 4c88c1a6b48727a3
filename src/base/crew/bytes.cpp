#include "base/crew/bytes.hpp"

#include <bit>

namespace slipproof {

ByteWriter& ByteWriter::number(std::uint64_t value) {
  for (int i = 0; i < 8; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xFFU);
  return *this;
}

ByteWriter& ByteWriter::real(double value) {
  return number(std::bit_cast<std::uint64_t>(value));
}

ByteWriter& ByteWriter::text(std::string_view value) {
  number(value.size());
  bytes_ += value;
  return *this;
}

ByteWriter& ByteWriter::rationals(const std::vector<Rational>& values) {
  number(values.size());
  for (const Rational& value : values) text(value.str());
  return *this;
}

std::string_view ByteReader::next(std::uint64_t size) {
  if (size > rest_.size()) throw BrokenBytes();
  const std::string_view found = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return found;
}

std::uint64_t ByteReader::number() {
  const std::string_view bytes = next(8);
  std::uint64_t value = 0;
  for (std::size_t i = 8; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

double ByteReader::real() {
  return std::bit_cast<double>(number());
}

std::string_view ByteReader::text() {
  return next(number());
}

std::vector<Rational> ByteReader::rationals() {
  std::vector<Rational> values;
  for (std::uint64_t left = number(); left > 0; --left) values.emplace_back(std::string(text()));
  return values;
}

void ByteReader::end() const {
  if (!rest_.empty()) throw BrokenBytes();
}

}  // namespace slipproof
