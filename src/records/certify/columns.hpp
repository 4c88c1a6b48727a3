// Certifying solver outputs that lie in memory as columns: arrays in, arrays out, no text between.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "records/certify/certify.hpp"
#include "records/certify/lane_judge.hpp"

namespace slipproof {

/// A value for each record, wherever it lies in memory that outlives it: not aligned, every so many bytes, also
/// backwards.
template <class T>
struct StridedColumn {
  const void* first = nullptr;        ///< of record 0; nullptr where the column is not there
  std::ptrdiff_t stride = sizeof(T);  ///< bytes from one record to the next; 0: the same for all

  StridedColumn() = default;
  StridedColumn(const void* of_first, std::ptrdiff_t bytes) : first(of_first), stride(bytes) {}
  StridedColumn(std::span<const T> values) : first(values.data()) {}  // NOLINT: a view, as span is one

  bool given() const { return first != nullptr; }
  const void* at(std::size_t record) const {
    return static_cast<const char*>(first) + static_cast<std::ptrdiff_t>(record) * stride;
  }
  T operator[](std::size_t record) const {
    T value;
    std::memcpy(&value, at(record), sizeof value);
    return value;
  }
};

using NumberColumn = StridedColumn<double>;
using CodeColumn = StridedColumn<std::uint8_t>;

/// Records as columns, in the forms that field.hpp lists. What is not given comes from the scene of the options.
///   RecordColumns columns{.records = n};
///   columns[Field::F] = {forces.data(), sizeof(double)};
struct RecordColumns {
  std::size_t records = 0;
  std::array<NumberColumn, field_count> numbers{};  ///< by Field; taken exactly, NaN and infinities are invalid answers
  CodeColumn modes{};  ///< ContactMode::index() of the mode that the solver claims, or no_mode
  CodeColumn kinds{};  ///< 0 for an internal force, 1 for an external one

  NumberColumn& operator[](Field f) { return numbers[index(f)]; }
  const NumberColumn& operator[](Field f) const { return numbers[index(f)]; }
};

struct ColumnsOptions {
  JudgeOptions judge{};
  std::optional<Scene> scene{};  ///< parameters that are the same for all records
  unsigned threads = 0;          ///< 0: as many as there are
};

/// Where the answers go: arrays of as many elements as there are records. Those that are empty are not wanted.
struct JudgementSpans {
  std::span<RecordVerdict> verdicts{};
  std::span<std::uint16_t> modes{};  ///< RecordJudgement::modes
  std::span<double> errors{};        ///< RecordJudgement::max_error
  std::span<Tier> tiers{};
};

/// Judges records of one set of columns. Made once, asked by many threads.
class ColumnsJudge {
 public:
  /// The columns' arrays must outlive it. Throws std::invalid_argument, which says what is missing from the columns, or
  /// given twice, or which code is none: "found ..., expected ...".
  ColumnsJudge(const RecordColumns& columns, const ColumnsOptions& options);

  /// Everything that is to be told of one record, which is judge() of it.
  RecordJudgement operator()(std::size_t record) const;

  /// Tells see(record, judgement) of the records from `begin` to before `end`, in order. Most of them are certified
  /// several at once in vector registers; the judgement is that of judge(), to the last bit.
  void each(std::size_t begin, std::size_t end,
            const std::function<void(std::size_t record, const RecordJudgement& judgement)>& see) const;

 private:
  Record record(std::size_t i) const;
  void fill_constants(LaneRecords& records) const;
  void fill(LaneRecords& records, std::size_t begin, std::size_t end) const;

  RecordColumns columns_;
  JudgeOptions options_;
  Record base_;                     ///< what the scene says
  std::uint32_t own_ = 0;           ///< bit(Field) of the columns
  std::optional<LaneJudge> lanes_;  ///< where it can decide anything
};

/// Judges every record on all threads. Throws what ColumnsJudge does, and std::invalid_argument for an answer's array
/// of another length. Progress is told from one thread at a time, of ever more records.
CertifySummary certify(const RecordColumns& columns, const ColumnsOptions& options, const JudgementSpans& answers,
                       const Progress& progress = {});

/// The answers in arrays of their own.
struct JudgedColumns {
  std::vector<RecordVerdict> verdicts;
  std::vector<std::uint16_t> modes;
  std::vector<double> errors;
  std::vector<Tier> tiers;
  CertifySummary summary;
};
JudgedColumns certify(const RecordColumns& columns, const ColumnsOptions& options = {});

}  // namespace slipproof
