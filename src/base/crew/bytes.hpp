// Serialization for messages between ranks and for journals: numbers and texts one after the other.
#pragma once

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
  ByteWriter& number(std::uint64_t value);
  ByteWriter& real(double value);  ///< its bits
  ByteWriter& text(std::string_view value);
  ByteWriter& rationals(const std::vector<Rational>& values);  ///< their number, then each as text
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads values in the order in which they were written; the bytes must outlive it. Throws BrokenBytes.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}
  std::uint64_t number();
  double real();
  std::string_view text();
  std::vector<Rational> rationals();
  std::string_view rest() const { return rest_; }
  void end() const;  ///< throws if bytes remain

 private:
  std::string_view next(std::uint64_t size);
  std::string_view rest_;
};

}  // namespace slipproof
