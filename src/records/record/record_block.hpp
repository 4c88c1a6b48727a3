// Records side by side, number by number.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "records/record/record.hpp"

namespace slipproof {

/// The number of records that are held side by side.
inline constexpr std::size_t block_records = 256;

/// Records that all give the same fields.
class RecordBlock {
 public:
  explicit RecordBlock(const RecordFields& fields)
      : numbers_(fields.size() * stride), present_(fields.size()), rounded_(fields.size()) {}

  /// Begins a block of records with these fields; removes the records that it has.
  void begin(const std::vector<bool>& present) {
    present_ = present;
    clear();
  }
  void clear() {
    rounded_.assign(rounded_.size(), false);
    count_ = 0;
  }

  std::size_t size() const { return count_; }
  bool full() const { return count_ == block_records; }
  const std::vector<bool>& present() const { return present_; }
  /// The numbers of all records in a field; places after the last record may be written.
  double* numbers(std::size_t field) { return &numbers_[field * stride]; }
  std::span<const double> numbers(std::size_t field) const { return {&numbers_[field * stride], count_}; }
  /// True if the number of some record is a rounded value.
  bool rounded(std::size_t field) const { return rounded_[field]; }
  /// The mode that the solver claims, or no_mode.
  std::uint16_t& mode(std::size_t row) { return modes_[row]; }
  std::uint16_t mode(std::size_t row) const { return modes_[row]; }

  /// Adds the next record, whose numbers have been written.
  void add() { ++count_; }
  void add(const Record& record) {
    for (std::size_t i = 0; i < present_.size(); ++i) {
      if (present_[i]) numbers(i)[count_] = record.values[i];
    }
    for (const auto& [field, value] : record.exact) rounded_[field] = true;
    modes_[count_] = record.mode;
    add();
  }

  /// Takes some rows of another block.
  void take(const RecordBlock& from, std::span<const std::uint16_t> rows) {
    begin(from.present_);
    rounded_ = from.rounded_;
    for (std::size_t i = 0; i < present_.size(); ++i) {
      if (!present_[i]) continue;
      const std::span<const double> theirs = from.numbers(i);
      for (std::size_t k = 0; k < rows.size(); ++k) numbers(i)[k] = theirs[rows[k]];
    }
    for (const std::uint16_t row : rows) modes_[count_++] = from.modes_[row];
  }

 private:
  /// Places rows of different fields in different cache lines.
  static constexpr std::size_t stride = block_records + 8;

  std::vector<double> numbers_;
  std::vector<bool> present_, rounded_;
  std::array<std::uint16_t, block_records> modes_{};
  std::size_t count_ = 0;
};

}  // namespace slipproof
