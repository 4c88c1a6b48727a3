// SHA-256, FIPS 180-4. The tests hold it to the examples of NIST and to another implementation.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace slipproof::check_contact {

/// The standard's constants: of each of the first primes the first 32 bits behind the point of a root.
template <std::size_t Count>
std::array<std::uint32_t, Count> bits_of_roots(unsigned long degree) {
  std::array<std::uint32_t, Count> result{};
  mpz_class prime = 2;
  for (std::uint32_t& bits : result) {
    mpz_class root = prime << (32 * degree);
    mpz_root(root.get_mpz_t(), root.get_mpz_t(), degree);
    bits = static_cast<std::uint32_t>(root.get_ui() & 0xffffffffU);
    mpz_nextprime(prime.get_mpz_t(), prime.get_mpz_t());
  }
  return result;
}

class Sha256 {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) {
      std::uint32_t& word = block_[size_ / 4 % 16];
      word = word << 8 | static_cast<unsigned char>(byte);
      if (++size_ % 64 == 0) mix();
    }
  }

  /// Of all that was added. Nothing can be added after it.
  std::string hexadecimal() {
    const std::uint64_t bits = 8 * size_;
    add("\x80");
    while (size_ % 64 != 56) add(std::string_view("\0", 1));
    for (int shift = 56; shift >= 0; shift -= 8) add(std::string(1, static_cast<char>(bits >> shift & 0xff)));
    std::string result;
    for (const std::uint32_t word : state_) {
      for (int shift = 28; shift >= 0; shift -= 4) result += "0123456789abcdef"[word >> shift & 0xf];
    }
    return result;
  }

 private:
  void mix() {
    static const auto k = bits_of_roots<64>(3);
    std::array<std::uint32_t, 64> w{};
    std::copy(block_.begin(), block_.end(), w.begin());
    for (std::size_t i = 16; i < 64; ++i) {
      const std::uint32_t x = w[i - 15], y = w[i - 2];
      w[i] = w[i - 16] + w[i - 7] + (std::rotr(x, 7) ^ std::rotr(x, 18) ^ x >> 3) +
             (std::rotr(y, 17) ^ std::rotr(y, 19) ^ y >> 10);
    }
    auto s = state_;  // a to h
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint32_t e = std::rotr(s[4], 6) ^ std::rotr(s[4], 11) ^ std::rotr(s[4], 25);
      const std::uint32_t a = std::rotr(s[0], 2) ^ std::rotr(s[0], 13) ^ std::rotr(s[0], 22);
      const std::uint32_t first = s[7] + e + ((s[4] & s[5]) ^ (~s[4] & s[6])) + k[i] + w[i];
      const std::uint32_t second = a + ((s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]));
      std::copy_backward(s.begin(), s.end() - 1, s.end());
      s[4] += first;
      s[0] = first + second;
    }
    for (std::size_t i = 0; i < 8; ++i) state_[i] += s[i];
  }

  std::array<std::uint32_t, 8> state_ = bits_of_roots<8>(2);
  std::array<std::uint32_t, 16> block_{};  ///< 64 bytes
  std::uint64_t size_ = 0;                 ///< in bytes, of all that was added
};

}  // namespace slipproof::check_contact
