// Finds and reads the cells of a CSV line, in groups, in vector registers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace slipproof {

/// Finds the ends of the cells of a line: its commas, and the end of the line. False if `ends` has not exactly as many
/// places as there are cells, and for lines of 4 GiB. `around` contains the line and may be read; this is faster if it
/// has more bytes after the line. Time: linear.
bool find_cell_ends(std::string_view line, std::string_view around, std::span<std::uint32_t> ends);

/// The largest number of cells that one call reads.
inline constexpr std::size_t decimal_block = 32;
using Decimals = std::array<double, decimal_block>;

/// Reads the cells of a line. The first cell begins at `begin`; each ends at an entry of `ends`, and the next begins
/// after its comma. A cell that can be read has at most 24 digits, 22 of them after the point; a point or none; a minus
/// or none; no exponent; and is not very near to the middle between two binary64. Bit k of the result is set if cell k
/// was not read. All bits are set on processors without AVX2 and FMA, and near the beginning of `around`, which is as
/// above. A number that was read is the binary64 nearest to the written number.
std::uint32_t read_decimals(std::string_view line, std::string_view around, std::size_t begin,
                            std::span<const std::uint32_t> ends, Decimals& values);

}  // namespace slipproof
