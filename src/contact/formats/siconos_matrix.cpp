#include "contact/formats/siconos_matrix.hpp"

#include <charconv>

#include "contact/formats/entries.hpp"

namespace slipproof {

namespace {

/// Recognises numbers printed with printf's %e without a precision: 7 digits, whatever the number was.
class ShortPrints {
 public:
  void see(std::string_view word) {
    const std::size_t point = word.find('.'), exponent = word.find('e');
    const bool is_short = point != std::string_view::npos && exponent == point + 7;
    all_ = all_ && is_short;
    rounded_ = rounded_ || (is_short && word[exponent - 1] != '0');
  }
  bool any() const { return all_ && rounded_; }

 private:
  bool all_ = true, rounded_ = false;
};

class SiconosMatrix {
 public:
  SiconosMatrix(WordReader& words, const std::string& name, std::vector<std::string>& remarks)
      : words_(words), name_(name), entry_("an entry of " + name), remarks_(remarks) {}

  SparseMatrix read(const std::optional<MatrixSize>& size) {
    const std::size_t start = words_.position();
    const std::string storages = "the storage of " + name_ + ": 0 (dense), 1 (sparse blocks) or 2 (sparse)";
    if (words_.peek() != "0" && words_.peek() != "1" && words_.peek() != "2") words_.stop(storages);
    const std::size_t storage = words_.count(storages);
    rows_ = size ? same(size->rows, "the number of rows of " + name_) : count("the number of rows of");
    columns_ = same(size ? size->columns : rows_, "the number of columns of " + name_);
    if (storage == 0) read_dense();
    if (storage == 1) read_blocks();
    if (storage == 2) read_sparse();
    return matrix_of(rows_, columns_, std::move(entries_), [&](const std::string& twice) {
      throw FormatStop{start, name_ + ": " + twice};
    });
  }

 private:
  std::size_t count(const std::string& what) { return words_.count(what + " " + name_); }
  double entry() { return words_.finite_number(entry_); }
  /// This very number.
  std::size_t same(std::size_t expected, const std::string& what) {
    if (words_.peek() != std::to_string(expected)) words_.stop(std::to_string(expected) + ", " + what);
    words_.next();
    return expected;
  }

  /// What Siconos reads fills a buffer column by column, however the lines of the file look.
  void read_dense() {
    same(rows_, "the number of rows of " + name_ + " again");
    same(columns_, "the number of columns of " + name_ + " again");
    for (std::size_t j = 0; j < columns_; ++j) {
      for (std::size_t i = 0; i < rows_; ++i) put_entry(entries_, i, j, entry());
    }
  }

  /// The end of each block: the ends increase, and the last one is the number of rows or columns.
  std::vector<std::size_t> ends(std::size_t number, std::size_t last, const std::string& what) {
    std::vector<std::size_t> result = {0};
    const std::string expected = "the end of a block of " + what + " of " + name_;
    for (std::size_t k = 0; k < number; ++k) {
      const std::size_t end = words_.position();
      result.push_back(words_.count(expected));
      const bool fits = k + 1 == number ? result[k + 1] == last : result[k + 1] < last;
      if (result[k + 1] <= result[k] || !fits) {
        throw FormatStop{end, "found " + std::to_string(result[k + 1]) + ", expected " + expected +
                                  ", which increase to " + std::to_string(last)};
      }
    }
    return result;
  }

  void read_blocks() {
    const std::size_t blocks = count("the number of blocks of");
    if (blocks == 0) return;
    const std::size_t down = count("the number of rows of blocks of");
    const std::size_t across = count("the number of columns of blocks of");
    const std::vector<std::size_t> row_ends = ends(down, rows_, "rows");
    const std::vector<std::size_t> column_ends = ends(across, columns_, "columns");
    const std::size_t filled_at = words_.position();
    const std::size_t filled = count("the number of starts of rows of blocks of");
    if (filled == 0 || filled > down + 1) {
      throw FormatStop{filled_at, "found " + std::to_string(filled) + ", expected at most " + std::to_string(down + 1) +
                                      " starts of rows of blocks of " + name_};
    }
    same(blocks, "the number of blocks of " + name_ + " again");
    const std::vector<std::size_t> starts = block_starts(filled, blocks);
    std::vector<std::size_t> column;
    for (std::size_t k = 0; k < blocks; ++k) {
      const std::size_t at = words_.position();
      column.push_back(count("the column of a block of"));
      if (column.back() >= across) {
        throw FormatStop{at, "found " + std::to_string(column.back()) + ", expected the column of a block of " + name_ +
                                 ", below " + std::to_string(across)};
      }
    }
    ShortPrints prints;
    for (std::size_t i = 0; i + 1 < filled; ++i) {
      for (std::size_t k = starts[i]; k < starts[i + 1]; ++k) {
        same(k, "the index before a block of " + name_);
        read_block(row_ends[i], row_ends[i + 1], column_ends[column[k]], column_ends[column[k] + 1], prints);
      }
    }
    if (prints.any()) remark_digits("seven");
  }

  std::vector<std::size_t> block_starts(std::size_t number, std::size_t blocks) {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < number; ++k) {
      const std::size_t at = words_.position(), before = k == 0 ? 0 : result.back();
      result.push_back(count("the start of a row of blocks of"));
      const bool fits = k == 0 ? result[k] == 0 : k + 1 == number ? result[k] == blocks : result[k] <= blocks;
      if (result[k] < before || !fits) {
        throw FormatStop{at, "found " + std::to_string(result[k]) + ", expected the start of a row of blocks of " +
                                 name_ + ", from 0 up to " + std::to_string(blocks)};
      }
    }
    return result;
  }

  void read_block(std::size_t row, std::size_t row_end, std::size_t column, std::size_t column_end,
                  ShortPrints& prints) {
    for (std::size_t j = column; j < column_end; ++j) {
      for (std::size_t i = row; i < row_end; ++i) {
        prints.see(words_.peek());
        put_entry(entries_, i, j, entry());
      }
    }
  }

  /// What CSparse prints for people to look at.
  void read_sparse() {
    const std::string origins = "the origin of " + name_ + ": 1 (triplets), 2 (columns) or 3 (rows)";
    if (words_.peek() == "4") words_.stop(origins + "; half of a symmetric matrix is not the matrix");
    const std::size_t origin = words_.count(origins);
    words_.word("CSparse");
    words_.rest_of_line();
    const bool triplets = words_.peek() == "triplet:", by_rows = words_.peek() == "csr:";
    const std::size_t kind = triplets ? 1 : by_rows ? 3 : 2;
    if (origin != kind) words_.stop("a matrix of the origin " + std::to_string(origin) + " for " + name_);
    if (kind != 2) words_.next();
    words_.word(std::to_string(rows_) + "-by-" + std::to_string(columns_) + ",");
    words_.word("nzmax:");
    words_.next();
    words_.word("nnz:");
    const std::size_t entries = count_before_comma(!triplets);
    if (!triplets) words_.rest_of_line();
    triplets ? read_triplets(entries) : read_lists(by_rows, entries);
    if (entries != 0) remark_digits("six");
  }

  std::size_t count_before_comma(bool comma) {
    const std::size_t at = words_.position();
    const std::string_view word = words_.next();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const std::string_view left(end, static_cast<std::size_t>(word.data() + word.size() - end));
    if (error == std::errc() && left == (comma ? "," : "")) return value;
    throw FormatStop{at, "found " + in_quotes(word) + ", expected the number of entries of " + name_};
  }

  std::size_t index(std::size_t bound, const char* what) {
    const std::size_t at = words_.position();
    const std::size_t found = words_.count(what);
    if (found < bound) return found;
    throw FormatStop{at, "found " + std::to_string(found) + ", expected " + what + " of " + name_ + ", below " +
                             std::to_string(bound)};
  }

  void read_triplets(std::size_t number) {
    for (std::size_t k = 0; k < number; ++k) {
      const std::size_t i = index(rows_, "the row of an entry"), j = index(columns_, "the column of an entry");
      words_.word(":");
      entries_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), entry()});
    }
  }

  void read_lists(bool by_rows, std::size_t number) {
    const std::size_t lists = by_rows ? rows_ : columns_, bound = by_rows ? columns_ : rows_;
    for (std::size_t j = 0; j < lists; ++j) {
      words_.word(by_rows ? "row" : "col");
      same(j, by_rows ? "the next row" : "the next column");
      words_.word(":");
      words_.word("locations");
      same(entries_.size(), "the number of entries before");
      words_.word("to");
      const std::size_t end = list_end(number);
      while (entries_.size() < end) {
        const std::size_t i = index(bound, by_rows ? "the column of an entry" : "the row of an entry");
        words_.word(":");
        const double x = entry();
        const auto list = static_cast<std::uint32_t>(j), other = static_cast<std::uint32_t>(i);
        entries_.push_back(by_rows ? MatrixEntry{list, other, x} : MatrixEntry{other, list, x});
      }
    }
    if (entries_.size() != number) words_.stop(std::to_string(number) + " entries of " + name_ + " altogether");
  }

  /// The last location counts from 0: -1 is the end of nothing.
  std::size_t list_end(std::size_t number) {
    const std::size_t at = words_.position();
    std::size_t end = 0;
    if (words_.peek() == "-1") {
      words_.next();
    } else {
      end = count("the last location of a list of") + 1;
    }
    if (end >= entries_.size() && end <= number) return end;
    throw FormatStop{at, "found the location " + std::to_string(end) + " - 1, expected one from " +
                             std::to_string(entries_.size()) + " - 1 to " + std::to_string(number) + " - 1"};
  }

  void remark_digits(const std::string& digits) {
    remarks_.push_back(name_ + " is printed with " + digits + " digits, which are taken as printed");
  }

  WordReader& words_;
  const std::string& name_;
  const std::string entry_;  ///< how messages call one
  std::vector<std::string>& remarks_;
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<MatrixEntry> entries_;
};

}  // namespace

SparseMatrix read_siconos_matrix(WordReader& words, const std::string& name, const std::optional<MatrixSize>& size,
                                 std::vector<std::string>& remarks) {
  return SiconosMatrix(words, name, remarks).read(size);
}

}  // namespace slipproof
