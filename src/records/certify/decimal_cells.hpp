// The cells of a line of CSV, found and read several at once in vector registers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace slipproof {

/// Where the cells of a line end: at its commas, and the last one at its own end. False unless there are as many as
/// there is room for, and for lines of 4 GiB. `around` holds the line, and may be read; the more of it lies behind the
/// line, the better. Time: linear.
bool find_cell_ends(std::string_view line, std::string_view around, std::span<std::uint32_t> ends);

/// As many cells are read by one call at most.
inline constexpr std::size_t decimal_block = 32;
using Decimals = std::array<double, decimal_block>;

/// Reads the cells of a line that begin at `begin` and end at `ends`, each behind the comma that ends the one before:
/// those of up to 24 digits, 22 of them behind the point, a point or none, a minus or none, and no exponent, unless
/// they are very near to the middle between two binary64. Bit k of the answer is set for a cell that was not read; all
/// are on processors without AVX2 and FMA, and at the beginning of `around`, which is as above. A number that was read
/// is the binary64 nearest to what is written.
std::uint32_t read_decimals(std::string_view line, std::string_view around, std::size_t begin,
                            std::span<const std::uint32_t> ends, Decimals& values);

}  // namespace slipproof
