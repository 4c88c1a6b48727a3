#include "records/reading/decimal_cells.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "base/os/registers.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define SLIPPROOF_READS_DECIMALS_IN_VECTORS
#include <immintrin.h>
#endif

namespace slipproof {

namespace {

bool find_ends_one_by_one(std::string_view line, std::span<std::uint32_t> ends) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::size_t comma = line.find(',', at);
    if ((comma == std::string_view::npos) != (i + 1 == ends.size())) return false;
    ends[i] = static_cast<std::uint32_t>(std::min(comma, line.size()));
    at = comma + 1;
  }
  return true;
}

#if defined(SLIPPROOF_READS_DECIMALS_IN_VECTORS)

#define SLIPPROOF_AVX2 gnu::target("avx2,fma,lzcnt,popcnt,bmi")

bool has_avx2() {
  return machine_registers() >= Registers::four;
}

constexpr std::size_t register_size = 32;  // in bytes

[[SLIPPROOF_AVX2]] inline __m256i load_bytes(const void* at) {
  return _mm256_loadu_si256(static_cast<const __m256i*>(at));
}
[[SLIPPROOF_AVX2]] inline std::uint32_t places_where(__m256i truth) {
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(truth));
}

/// Up to 63 bytes after the end of the line may be read.
[[SLIPPROOF_AVX2]] bool find_ends(std::string_view line, std::span<std::uint32_t> ends) {
  const __m256i comma = _mm256_set1_epi8(',');
  std::size_t count = 0;
  for (std::size_t at = 0; at < line.size(); at += 2 * register_size) {
    const char* const here = line.data() + at;
    std::uint64_t commas = places_where(_mm256_cmpeq_epi8(load_bytes(here), comma)) |
                           std::uint64_t(places_where(_mm256_cmpeq_epi8(load_bytes(here + register_size), comma)))
                               << register_size;
    if (line.size() - at < 2 * register_size) commas &= (std::uint64_t(1) << (line.size() - at)) - 1;
    if (count + static_cast<std::size_t>(std::popcount(commas)) >= ends.size()) return false;
    for (; commas != 0; commas &= commas - 1) {
      ends[count++] = static_cast<std::uint32_t>(at + static_cast<std::size_t>(std::countr_zero(commas)));
    }
  }
  ends[count++] = static_cast<std::uint32_t>(line.size());
  return count == ends.size();
}

/// The 32 bytes from byte 32 - n on end in n bytes of ones, after zeros.
alignas(64) constexpr auto ones_behind_zeros = [] {
  std::array<std::uint8_t, 2 * register_size> window{};
  for (std::size_t i = register_size; i < 2 * register_size; ++i) window[i] = 0xff;
  return window;
}();
[[SLIPPROOF_AVX2]] inline __m256i last_ones(std::size_t count) {
  return load_bytes(ones_behind_zeros.data() + count);
}

/// Powers of ten that are binary64 numbers; NaN for larger exponents.
struct Powers {
  std::array<double, register_size + 1> power{}, inverse{};
};
constexpr Powers powers = [] {
  Powers result;
  double power = 1;
  for (std::size_t i = 0; i <= register_size; ++i, power *= 10) {
    result.power[i] = i <= 22 ? power : std::numeric_limits<double>::quiet_NaN();
    result.inverse[i] = 1 / result.power[i];
  }
  return result;
}();

/// The digits of cells. The last group of four is filled up with zeros.
struct DigitBlock {
  /// Each holds two numbers of 8 digits: `low` the last 16 digits of the cell, `high` the 16 before them.
  alignas(register_size) std::array<std::uint64_t, decimal_block> low, high;
  /// 10^n for n digits after the point, and 10^-n.
  alignas(register_size) std::array<double, decimal_block> power, inverse;
  alignas(register_size) std::array<char, decimal_block> first;
  alignas(register_size) std::array<std::uint8_t, decimal_block> digits;  ///< number of digits; 32 stands for more
  /// Not all zeros if the cell contains other characters than digits.
  alignas(register_size) std::array<std::array<std::uint8_t, register_size>, decimal_block> wrong;
};

/// Takes the 32 bytes up to the end of a cell, removes the point, converts the digits, and sets bytes before the cell
/// to zero. Then adds neighbours to numbers of two, four and eight digits. Returns a mask of the cells that contain
/// other characters than digits.
[[SLIPPROOF_AVX2]] std::uint32_t read_digits(const char* line, std::size_t begin, std::span<const std::uint32_t> ends,
                                             DigitBlock& block) {
  const __m256i point = _mm256_set1_epi8('.'), zero = _mm256_set1_epi8('0'), nine = _mm256_set1_epi8(9);
  const __m256i by_1 = _mm256_set1_epi16(0x010a), by_2 = _mm256_set1_epi32(0x00010064),
                by_4 = _mm256_set1_epi32(0x00012710);
  __m256i anything = _mm256_setzero_si256();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::size_t size = ends[i] - begin;
    const char* const end = line + ends[i];
    __m256i text = load_bytes(end - register_size);
    std::size_t places = _lzcnt_u32(places_where(_mm256_cmpeq_epi8(text, point)));
    const char first = line[begin];
    std::size_t digits = std::min(size - static_cast<std::size_t>(first == '-'), register_size);
    if (places < size) [[likely]] {
      text = _mm256_blendv_epi8(load_bytes(end - register_size - 1), text, last_ones(places));
      --digits;
    } else {
      places = 0;
    }
    const __m256i numbers = _mm256_and_si256(_mm256_sub_epi8(text, zero), last_ones(digits));
    const __m256i wrong = _mm256_subs_epu8(numbers, nine);
    const __m256i fours = _mm256_madd_epi16(_mm256_maddubs_epi16(numbers, by_1), by_2);
    const __m256i eights = _mm256_madd_epi16(_mm256_packus_epi32(fours, fours), by_4);
    _mm_storel_epi64(reinterpret_cast<__m128i*>(&block.high[i]), _mm256_castsi256_si128(eights));
    _mm_storel_epi64(reinterpret_cast<__m128i*>(&block.low[i]), _mm256_extracti128_si256(eights, 1));
    _mm256_store_si256(reinterpret_cast<__m256i*>(&block.wrong[i]), wrong);
    anything = _mm256_or_si256(anything, wrong);
    block.digits[i] = static_cast<std::uint8_t>(digits);
    block.first[i] = first;
    block.power[i] = powers.power[places];
    block.inverse[i] = powers.inverse[places];
    begin = ends[i] + 1;
  }
  for (std::size_t i = ends.size(); i % 4 != 0; ++i) {
    block.low[i] = block.high[i] = 0;
    block.power[i] = block.inverse[i] = 0;
    block.first[i] = 0;
  }
  std::uint32_t unclean = 0;
  if (_mm256_testz_si256(anything, anything) != 0) return unclean;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const __m256i wrong = load_bytes(&block.wrong[i]);
    unclean |= static_cast<std::uint32_t>(_mm256_testz_si256(wrong, wrong) == 0) << i;
  }
  return unclean;
}

[[SLIPPROOF_AVX2]] inline __m256i all(std::uint64_t x) {
  return _mm256_set1_epi64x(static_cast<std::int64_t>(x));
}
[[SLIPPROOF_AVX2]] inline __m256d number(__m256i below_2_32) {
  const __m256d bias = _mm256_set1_pd(0x1p52);
  return _mm256_sub_pd(_mm256_castsi256_pd(_mm256_or_si256(below_2_32, _mm256_castpd_si256(bias))), bias);
}

/// The binary64 nearest to w / 10^n, where w is an integer below 10^19 and 10^n is a binary64. w is the sum of two
/// binary64: `sum`, and `lost`, the error of rounding w, below 2^-52 w. A first quotient q, computed with a rounded
/// inverse, is wrong by less than 2^-51 w / 10^n. Therefore the remainder, computed by a fused operation, is small and
/// known up to 2^-100 w; it gives a correction e. So the quotient lies between q + e - 2^-75 q and q + e + 2^-75 q. If
/// both bounds round to the same number, the quotient rounds to it, too. The function marks cells for which they do
/// not, and cells with more than 19 significant digits.
[[SLIPPROOF_AVX2]] std::uint32_t divide(const DigitBlock& block, std::size_t count, Decimals& values) {
  constexpr std::uint64_t e8 = 100'000'000, e16 = e8 * e8, lower = 0xffffffff;
  std::uint32_t unsure = 0;
  for (std::size_t i = 0; i < count; i += 4) {
    const __m256i low = load_bytes(&block.low[i]), high = _mm256_srli_epi64(load_bytes(&block.high[i]), 32);
    const __m256i w_high = _mm256_add_epi64(_mm256_mul_epu32(high, all(e16 & lower)),
                                            _mm256_slli_epi64(_mm256_mul_epu32(high, all(e16 >> 32)), 32));
    const __m256i w_low = _mm256_add_epi64(_mm256_mul_epu32(low, all(e8)), _mm256_srli_epi64(low, 32));
    const __m256i w = _mm256_add_epi64(w_high, w_low);
    const __m256d a = _mm256_mul_pd(number(_mm256_srli_epi64(w, 32)), _mm256_set1_pd(0x1p32)),
                  b = number(_mm256_and_si256(w, all(lower)));
    const __m256d sum = _mm256_add_pd(a, b), lost = _mm256_sub_pd(b, _mm256_sub_pd(sum, a));
    const __m256d inverse = _mm256_load_pd(&block.inverse[i]), q = _mm256_mul_pd(sum, inverse);
    const __m256d remainder = _mm256_add_pd(_mm256_fnmadd_pd(q, _mm256_load_pd(&block.power[i]), sum), lost);
    const __m256d e = _mm256_mul_pd(remainder, inverse), margin = _mm256_mul_pd(q, _mm256_set1_pd(0x1p-75));
    const __m256d from = _mm256_add_pd(q, _mm256_sub_pd(e, margin)), to = _mm256_add_pd(q, _mm256_add_pd(e, margin));
    const __m256i large = _mm256_cmpgt_epi64(high, all(999));
    const __m256d differ = _mm256_cmp_pd(from, to, _CMP_NEQ_UQ);
    unsure |= static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_or_pd(differ, _mm256_castsi256_pd(large)))) << i;
    std::int32_t first = 0;
    std::memcpy(&first, &block.first[i], sizeof first);
    const __m256i minus = _mm256_cmpeq_epi64(_mm256_cvtepu8_epi64(_mm_cvtsi32_si128(first)), all('-'));
    _mm256_storeu_pd(&values[i], _mm256_xor_pd(from, _mm256_castsi256_pd(_mm256_slli_epi64(minus, 63))));
  }
  return unsure;
}

[[SLIPPROOF_AVX2]] std::uint32_t read_in_vectors(const char* line, std::size_t begin,
                                                 std::span<const std::uint32_t> ends, Decimals& values) {
  DigitBlock block;
  block.digits.fill(0);
  const std::uint32_t unclean = read_digits(line, begin, ends, block);
  // There are 1 to 24 digits, so the first eight of 32 bytes have none.
  const __m256i digits = _mm256_sub_epi8(load_bytes(block.digits.data()), _mm256_set1_epi8(1));
  const __m256i few = _mm256_cmpeq_epi8(_mm256_subs_epu8(digits, _mm256_set1_epi8(23)), _mm256_setzero_si256());
  return unclean | ~places_where(few) | divide(block, ends.size(), values);
}

#endif

}  // namespace

bool find_cell_ends(std::string_view line, [[maybe_unused]] std::string_view around, std::span<std::uint32_t> ends) {
  if (line.size() > std::numeric_limits<std::uint32_t>::max()) return false;
#if defined(SLIPPROOF_READS_DECIMALS_IN_VECTORS)
  const auto behind = static_cast<std::size_t>(around.data() + around.size() - (line.data() + line.size()));
  if (behind >= 2 * register_size && has_avx2()) return find_ends(line, ends);
#endif
  return find_ends_one_by_one(line, ends);
}

std::uint32_t read_decimals([[maybe_unused]] std::string_view line, [[maybe_unused]] std::string_view around,
                            [[maybe_unused]] std::size_t begin, std::span<const std::uint32_t> ends,
                            [[maybe_unused]] Decimals& values) {
  const auto cells = static_cast<std::uint32_t>((std::uint64_t(1) << ends.size()) - 1);
#if defined(SLIPPROOF_READS_DECIMALS_IN_VECTORS)
  // The first cell may be empty and reaches back furthest; the last cell may be empty, too, and its first byte is also
  // read.
  const auto before = static_cast<std::size_t>(line.data() + begin - around.data());
  const bool ends_before = line.data() + line.size() < around.data() + around.size();
  if (before > register_size && ends_before && has_avx2())
    return cells & read_in_vectors(line.data(), begin, ends, values);
#endif
  return cells;
}

}  // namespace slipproof
