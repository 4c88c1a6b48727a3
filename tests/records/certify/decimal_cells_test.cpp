// Cells of lines, found and read in vector registers, against reading them one by one.
#include "records/reading/decimal_cells.hpp"

#include <doctest/doctest.h>
#include <fast_float/fast_float.h>

#include <bit>
#include <cstring>
#include <random>
#include <string>
#include <vector>

using namespace slipproof;

namespace {

/// A line between others, as in a chunk of a file.
struct Line {
  explicit Line(const std::vector<std::string>& cells, std::size_t before = 64, std::size_t behind = 64) {
    around.assign(before, '7');
    for (const auto& cell : cells) text += (&cell == &cells.front() ? "" : ",") + cell;
    around += text + std::string(behind, '8');
    line = std::string_view(around).substr(before, text.size());
  }
  std::string text, around;
  std::string_view line;
};

std::vector<std::uint32_t> ends_of(const std::vector<std::string>& cells) {
  std::vector<std::uint32_t> ends;
  std::size_t at = 0;
  for (const auto& cell : cells) {
    ends.push_back(static_cast<std::uint32_t>(at + cell.size()));
    at += cell.size() + 1;
  }
  return ends;
}

/// How many of the cells were read, each as fast_float reads it, which takes all of the cell then.
std::size_t read_rightly(const std::vector<std::string>& cells, std::size_t before = 64, std::size_t behind = 64) {
  const Line line(cells, before, behind);
  Decimals values{};
  const std::uint32_t unread = read_decimals(line.line, line.around, 0, ends_of(cells), values);
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if ((unread >> i & 1) != 0) continue;
    ++count;
    double expected = 0;
    const char* const end = cells[i].data() + cells[i].size();
    const auto [stop, error] = fast_float::from_chars(cells[i].data(), end, expected);
    CAPTURE(cells[i]);
    CHECK(error == std::errc());
    CHECK(stop == end);
    CHECK(std::bit_cast<std::uint64_t>(values[i]) == std::bit_cast<std::uint64_t>(expected));
  }
  return count;
}

/// Whether this machine reads any.
bool reads_in_vectors() {
  return read_rightly({"1"}) == 1;
}

class RandomCells {
 public:
  std::string decimal() {
    std::string digits;
    const auto count = below(26);
    const auto zeros = below(4) == 0 ? below(count + 1) : 0;
    for (std::size_t i = 0; i < count; ++i) digits += static_cast<char>(i < zeros ? '0' : '0' + below(10));
    if (below(8) != 0) digits.insert(below(count + 1), ".");
    return (below(2) == 0 ? "-" : "") + digits;
  }
  /// One byte changed, put in or taken away.
  std::string spoiled() {
    std::string cell = decimal();
    const std::string odd = ".-+eE /:9x\t";
    if (cell.empty() || below(3) == 0) return cell.insert(below(cell.size() + 1), 1, odd[below(odd.size())]);
    if (below(2) == 0) return cell.erase(below(cell.size()), 1);
    cell[below(cell.size())] = odd[below(odd.size())];
    return cell;
  }
  std::size_t below(std::size_t limit) { return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_); }

 private:
  std::mt19937_64 random_{20};
};

}  // namespace

TEST_CASE("Decimals are read to the nearest binary64, or not at all") {
  RandomCells random;
  std::size_t cells = 0, read = 0;
  for (int n = 0; n < 6000; ++n) {
    std::vector<std::string> line(1 + random.below(decimal_block));
    const bool spoil = n % 4 == 0;
    for (auto& cell : line) cell = spoil ? random.spoiled() : random.decimal();
    const std::size_t here = read_rightly(line);
    if (spoil) continue;
    cells += line.size();
    read += here;
  }
  if (reads_in_vectors()) CHECK(read > cells / 2);
}

TEST_CASE("What numbers of a solver look like is read at once") {
  if (!reads_in_vectors()) return;
  const std::vector<std::string> cells{"0",
                                       "-0",
                                       "1",
                                       "0.1",
                                       "0.3",
                                       "-9.81",
                                       "0.0073548926154482375",
                                       "9223372036854775807",
                                       "9999999999999999999",
                                       "-1668.0784756602593",
                                       ".5",
                                       "5.",
                                       "0.0000000000000000000001",
                                       "000000000000000000000012",
                                       "3.141592653589793"};
  CHECK(read_rightly(cells) == cells.size());
  for (const std::string cell :
       {"", "-", ".", "-.", "1e3", "+1", "1.2.3", "--1", " 1", "1 ", "nan", "inf", "1/2", "0x1", "1:2",
        "0.00000000000000000000001", "10000000000000000000", "1234567890123456789012345",
        "0000000000000000000000000000000000000000000000000000000000000000000000000000001"}) {
    CAPTURE(cell);
    CHECK(read_rightly({"1", cell, "2"}) == 2);
  }
}

TEST_CASE("The middle between two binary64, and what is next to it, is left to others or read rightly") {
  // 2^53 + 1, and the same with digits behind it; 2^52 + 1/2; 1 + 2^-53 is too long
  for (const std::string cell :
       {"9007199254740993", "9007199254740993.0", "4503599627370496.5", "4503599627370497.5", "0.50000000000000005"}) {
    read_rightly({cell});
  }
  if (!reads_in_vectors()) return;
  CHECK(read_rightly({"9007199254740993"}) == 0);
  CHECK(read_rightly({"4503599627370496.5"}) == 0);
  CHECK(read_rightly({"4503599627370496.501"}) == 1);
  CHECK(read_rightly({"4503599627370496.499"}) == 1);
}

TEST_CASE("What does not stand far enough from the ends of the text is not read") {
  for (std::size_t before = 0; before < 40; ++before) {
    for (const std::size_t behind : {0U, 1U, 40U}) {
      const bool able = before > 32 && behind > 0 && reads_in_vectors();
      CHECK(read_rightly({"1.5", "", "2"}, before, behind) == (able ? 2 : 0));
    }
  }
}

TEST_CASE("Ends of cells are found wherever a line stands") {
  RandomCells random;
  for (int n = 0; n < 1500; ++n) {
    std::vector<std::string> cells(1 + random.below(40));
    for (auto& cell : cells) cell = n % 3 == 0 ? std::string(random.below(90), 'x') : random.decimal();
    const Line line(cells, random.below(3), n % 2 == 0 ? 64 : random.below(64));
    std::vector<std::uint32_t> ends(cells.size());
    CHECK(find_cell_ends(line.line, line.around, ends));
    CHECK(ends == ends_of(cells));
    ends.push_back(0);
    CHECK_FALSE(find_cell_ends(line.line, line.around, ends));
    if (cells.size() == 1) continue;
    ends.resize(cells.size() - 1);
    CHECK_FALSE(find_cell_ends(line.line, line.around, ends));
  }
}
