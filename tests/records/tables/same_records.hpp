// The same records in CSV and in every binary form, and what certify says of a table.
#pragma once

#include "records/certify/columns.hpp"
#include "records/certify/table_records.hpp"
#include "records/record/bicycle_records.hpp"
#include "support/certified.hpp"
#include "support/files/npy_file.hpp"
#include "support/files/small_files.hpp"
#include "support/scenes/solver_records.hpp"

namespace slipproof::test {

/// Records with J, some of them wrong: CSV and every binary form of the same numbers.
class SameRecords {
 public:
  explicit SameRecords(std::size_t count, std::uint64_t seed = 71) {
    SolverRecords records(seed);
    while (cells_.size() < count) {
      Cells cells = records.next();
      if (cells[j_cell].empty()) continue;
      const std::size_t k = cells_.size();
      if (k % 7 == 3) cells[answer_cell + 7] = "12.5";
      if (k % 11 == 5) cells[mode_cell] = "lift/lift";
      if (k % 13 == 6) cells[mode_cell] = "";
      if (k % 50 == 8) cells[0] = "-1";
      cells_.push_back(std::move(cells));
    }
  }

  std::size_t size() const { return cells_.size(); }
  std::string csv() const {
    std::string text = test::header();
    for (const Cells& cells : cells_) text += joined(cells);
    return text;
  }
  std::string rows() const {
    std::string text;
    for (const Cells& cells : cells_) text += npy_row(cells);
    return text;
  }
  double number(std::size_t row, std::size_t column) const { return std::strtod(cells_[row][column].c_str(), nullptr); }
  const Cells& cells(std::size_t row) const { return cells_[row]; }

 private:
  std::vector<Cells> cells_;
};

inline Certified certified_table(const std::string& path, const CertifyOptions& given = {},
                                 const std::vector<std::string>& names = {}) {
  CertifyOptions options = given;
  options.file = path;
  Certified result;
  result.summary = certify(
      open_table(path, names), [&result](std::string_view out) { result.text += out; }, options);
  return result;
}

/// CSV refers to what scenes without J say; the lines are the same.
inline void check_same(const Certified& found, const Certified& expected) {
  CHECK(found.text == expected.text);
  CHECK(to_json(found.summary) == to_json(expected.summary));
}

inline std::string table_refusal(const std::string& path) {
  return refusal([&] { certified_table(path); }, path);
}

}  // namespace slipproof::test
