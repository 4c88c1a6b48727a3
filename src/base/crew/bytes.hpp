// Serialization for results of ranks and for journals: numbers and texts one after the other.
#pragma once

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof {

/// Thrown if bytes do not contain the expected values.
class BrokenBytes : public std::runtime_error {
 public:
  BrokenBytes() : std::runtime_error("found bytes that end too early, or go on too long") {}
};

/// Writes numbers as eight bytes, lowest first, on every machine, and texts preceded by their length.
class ByteWriter {
 public:
  ByteWriter& number(std::uint64_t value) {
    for (int i = 0; i < 64; i += 8) bytes_ += static_cast<char>(value >> i & 0xFFU);
    return *this;
  }
  /// Writes its bits.
  ByteWriter& real(double value) { return number(std::bit_cast<std::uint64_t>(value)); }
  ByteWriter& text(std::string_view value) {
    number(value.size());
    bytes_ += value;
    return *this;
  }
  /// Writes their number, then each as text.
  ByteWriter& rationals(const std::vector<Rational>& values) {
    number(values.size());
    for (const Rational& value : values) text(value.str());
    return *this;
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads values in the order in which they were written; the bytes must outlive it. Throws BrokenBytes.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    const std::string_view bytes = next(8);
    for (std::size_t i = 8; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[i]);
    return value;
  }
  double real() { return std::bit_cast<double>(number()); }
  std::string_view text() { return next(number()); }
  std::vector<Rational> rationals() {
    std::vector<Rational> values;
    for (std::uint64_t left = number(); left > 0; --left) values.emplace_back(std::string(text()));
    return values;
  }
  std::string_view rest() const { return rest_; }
  /// Throws if bytes remain.
  void end() const {
    if (!rest_.empty()) throw BrokenBytes();
  }

 private:
  std::string_view next(std::uint64_t size) {
    if (size > rest_.size()) throw BrokenBytes();
    const std::string_view found = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return found;
  }

  std::string_view rest_;
};

}  // namespace slipproof
