#include "contact/formats/matrix_market.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/files/words.hpp"
#include "base/input/text_file.hpp"
#include "contact/formats/entries.hpp"
#include "contact/formats/problem_check.hpp"

namespace slipproof {

namespace {

std::string lower_case(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

class MarketText {
 public:
  explicit MarketText(std::string_view text) : words_(text) {
    words_.word(matrix_market_banner);
    one_of({"matrix"});
    is_array_ = one_of({"coordinate", "array"}) == "array";
    is_integer_ = one_of({"real", "integer", "double"}) == "integer";
    symmetry_ = one_of({"general", "symmetric", "skew-symmetric"});
    words_.rest_of_line();
    while (words_.peek().starts_with('%')) words_.rest_of_line();
    start_ = words_.position();
    rows_ = words_.count("the number of rows");
    columns_ = words_.count("the number of columns");
  }

  std::vector<double> vector(std::optional<std::size_t> most) {
    if (!is_array_ || symmetry_ != "general" || (rows_ != 1 && columns_ != 1)) {
      throw FormatStop{start_, "found a matrix, expected a vector: a general array of one column"};
    }
    if (most && rows_ * columns_ > *most) {
      throw FormatStop{start_,
                       "found " + std::to_string(rows_ * columns_) + " numbers, expected " + std::to_string(*most)};
    }
    std::vector<double> result;
    for (std::size_t k = 0; k < rows_ * columns_; ++k) result.push_back(entry("a component of the vector", true));
    end();
    return result;
  }

  SparseMatrix matrix(std::size_t rows, std::size_t columns) {
    const auto shape = [](std::size_t r, std::size_t c) {
      return std::to_string(r) + " rows and " + std::to_string(c) + " columns";
    };
    if (rows_ != rows || columns_ != columns) {
      throw FormatStop{start_, "found " + shape(rows_, columns_) + ", expected " + shape(rows, columns) +
                                   ", the length of the vector"};
    }
    if (symmetry_ != "general" && rows_ != columns_) {
      throw FormatStop{start_, "found " + shape(rows_, columns_) + ", expected a square matrix that is " + symmetry_};
    }
    is_array_ ? read_array() : read_coordinates();
    end();
    return matrix_of(rows_, columns_, std::move(entries_), [&](const std::string& twice) {
      throw FormatStop{start_, twice};
    });
  }

 private:
  std::string one_of(std::initializer_list<std::string_view> known) {
    const std::string word = lower_case(words_.peek());
    if (std::ranges::find(known, word) == known.end()) {
      std::string expected;
      for (const std::string_view name : known) expected += (expected.empty() ? "" : " or ") + std::string(name);
      words_.stop(expected);
    }
    words_.next();
    return word;
  }

  void end() {
    if (!words_.peek().empty()) words_.stop("the end of the file");
  }

  double entry(const char* what, bool any) {
    const std::string_view word = words_.peek();
    if (is_integer_ && word.find_first_not_of("+-0123456789") != std::string_view::npos) {
      words_.stop(std::string(what) + ", a whole number, as the first line says integer");
    }
    return any ? words_.number(what) : words_.finite_number(what);
  }

  bool general() const { return symmetry_ == "general"; }
  bool skew() const { return symmetry_ == "skew-symmetric"; }

  void put(std::size_t i, std::size_t j, double x) {
    entries_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), x});
    if (general() || i == j) return;
    entries_.push_back({static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(i), skew() ? -x : x});
  }

  /// Column by column; of symmetric ones what is on and below the diagonal.
  void read_array() {
    for (std::size_t j = 0; j < columns_; ++j) {
      for (std::size_t i = general() ? 0 : j + (skew() ? 1 : 0); i < rows_; ++i) {
        if (const double x = entry("an entry of the matrix", false); x != 0) put(i, j, x);
      }
    }
  }

  std::size_t index(std::size_t bound, const char* what) {
    const std::size_t at = words_.position(), found = words_.count(what);
    if (found >= 1 && found <= bound) return found - 1;
    throw FormatStop{at,
                     "found " + std::to_string(found) + ", expected " + what + ", from 1 to " + std::to_string(bound)};
  }

  void read_coordinates() {
    const std::size_t number = words_.count("the number of entries");
    for (std::size_t k = 0; k < number; ++k) {
      const std::size_t at = words_.position();
      const std::size_t i = index(rows_, "the row of an entry"), j = index(columns_, "the column of an entry");
      if (!general() && (i < j || (skew() && i == j))) {
        throw FormatStop{at, "found the row " + std::to_string(i + 1) + " and the column " + std::to_string(j + 1) +
                                 ", expected what is below the diagonal of a matrix that is " + symmetry_};
      }
      put(i, j, entry("an entry of the matrix", false));
    }
  }

  WordReader words_;
  bool is_array_ = false, is_integer_ = false;
  std::string symmetry_;
  std::size_t start_ = 0, rows_ = 0, columns_ = 0;
  std::vector<MatrixEntry> entries_;
};

/// The vector of a matrix, from the same folder; nothing if there is no such file.
std::optional<std::vector<double>> vector_beside(const std::string& stem, const std::string& part,
                                                 std::optional<std::size_t> most = {}) {
  const std::string file = stem + "_" + part + ".mtx";
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::nullopt;
  return read_market_vector(read_text_file(file, max_problem_file_size), file, most);
}

}  // namespace

std::vector<double> read_market_vector(std::string_view text, const std::string& file,
                                       std::optional<std::size_t> most) {
  try {
    return MarketText(text).vector(most);
  } catch (const FormatStop& stop) {
    refuse(file, text, stop);
  }
}

SparseMatrix read_market_matrix(std::string_view text, const std::string& file, std::size_t rows, std::size_t columns) {
  try {
    return MarketText(text).matrix(rows, columns);
  } catch (const FormatStop& stop) {
    refuse(file, text, stop);
  }
}

ReadProblem read_matrix_market(std::string_view text, const std::string& file) {
  constexpr std::string_view ending = ".mtx";
  if (!file.ends_with(ending))
    refuse(file, "found a matrix, expected a name that ends in .mtx, with q in the same folder");
  const std::string stem = file.substr(0, file.size() - ending.size());
  ReadProblem result;
  ProblemFile& problem = result.problem;
  const auto q = vector_beside(stem, "q");
  if (!q) refuse(file, "found no " + stem + "_q.mtx in the same folder, expected the vector q there");
  problem.q = *q;
  problem.W = read_market_matrix(text, file, q->size(), q->size());
  problem.mu = vector_beside(stem, "mu", q->size()).value_or(std::vector<double>());
  problem.form = problem.mu.empty() ? ProblemForm::complementarity : ProblemForm::local;
  problem.dimension = 1;
  if (!problem.mu.empty()) {
    const DimensionBySizes found = dimension_by_sizes(q->size(), problem.mu.size());
    if (!found.mistake.empty()) refuse(file, found.key + ": " + found.mistake);
    problem.dimension = found.dimension;
  }
  const auto r = vector_beside(stem, "r", q->size()), u = vector_beside(stem, "u", q->size());
  if (r || u) {
    result.answers.push_back({stem + "_" + (r ? "r" : "u") + ".mtx",
                              r.value_or(std::vector<double>()),
                              u.value_or(std::vector<double>()),
                              {},
                              {}});
  }
  return result;
}

}  // namespace slipproof
