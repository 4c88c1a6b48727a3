// Certifies solver outputs in memory: arrays in, arrays out, without text in between.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "records/certify/certify.hpp"
#include "records/judging/record_judge.hpp"
#include "records/record/record_block.hpp"

namespace slipproof {

/// A column: a value for each record, in memory that must outlive it. Values need no alignment; the stride may be any
/// number of bytes, also negative.
template <class T>
struct StridedColumn {
  const void* first = nullptr;        ///< the value of record 0; nullptr if there is no column
  std::ptrdiff_t stride = sizeof(T);  ///< bytes from one record to the next; 0: one value for all

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
using CodeColumn = StridedColumn<std::uint16_t>;

/// Records as columns. A number without a column is the same for all records, or missing.
/// RecordColumns columns(judge.fields(), n);
/// columns.number("F") = {forces.data(), sizeof(double)};
struct RecordColumns {
  RecordColumns(const RecordFields& of, std::size_t count) : fields(&of), records(count), numbers(of.size()) {}

  const RecordFields* fields;
  std::size_t records;
  std::vector<NumberColumn> numbers;  ///< by field; used exactly; NaN and infinities make an answer invalid
  CodeColumn modes{};  ///< the modes that the solver claims, as numbers among the fields' modes, or no_mode

  /// Throws std::invalid_argument for a name that is not a field.
  NumberColumn& number(std::string_view name);
};

/// Arrays that receive the answers, each with one element for each record. An empty array is not filled.
struct JudgementSpans {
  std::span<RecordVerdict> verdicts{};
  std::span<std::uint64_t> modes{};  ///< RecordJudgement::modes, bit i for mode i of the first 64
  std::span<double> errors{};        ///< RecordJudgement::max_error
  std::span<Tier> tiers{};
};

/// Judges the records of one set of columns. Made once, used by many threads.
class ColumnsJudge {
 public:
  /// `columns`, its arrays and `judge` must outlive it. Throws std::invalid_argument if a column is missing or given
  /// twice, or if a code is not a mode: "found ..., expected ...".
  ColumnsJudge(const RecordColumns& columns, const RecordJudge& judge);

  /// The complete judgement of one record.
  RecordJudgement operator()(std::size_t record) const;

  /// Calls see(record, judgement) for the records from `begin` to `end` - 1, in order. Most records are certified in
  /// groups, in vector registers.
  void each(std::size_t begin, std::size_t end,
            const std::function<void(std::size_t record, const RecordJudgement& judgement)>& see) const;

 private:
  Record record(std::size_t i) const;
  void fill(RecordBlock& block, std::size_t begin, std::size_t end) const;

  const RecordColumns& columns_;
  const RecordJudge& judge_;
  std::vector<bool> present_;
};

/// Judges every record on all threads. Throws what ColumnsJudge throws, and std::invalid_argument for an answer array
/// of the wrong length. Calls `progress` from one thread at a time, with ascending numbers of records.
CertifySummary certify(const RecordColumns& columns, const RecordJudge& judge, const JudgementSpans& answers,
                       unsigned threads = 0, const Progress& progress = {});

/// The answers, in arrays of their own.
struct JudgedColumns {
  std::vector<RecordVerdict> verdicts;
  std::vector<std::uint64_t> modes;
  std::vector<double> errors;
  std::vector<Tier> tiers;
  CertifySummary summary;
};
JudgedColumns certify(const RecordColumns& columns, const RecordJudge& judge, unsigned threads = 0);

}  // namespace slipproof
