#include "records/certify/columns.hpp"

#include <algorithm>
#include <bit>
#include <mutex>
#include <stdexcept>

#include "base/parallel/in_parallel.hpp"

namespace slipproof {

namespace {

/// Throws std::invalid_argument for the first code above `largest` that is not `other`.
void check_codes(const CodeColumn& codes, std::size_t records, unsigned largest, unsigned other, const char* name) {
  if (!codes.given()) return;
  const std::size_t count = codes.stride == 0 ? std::min<std::size_t>(records, 1) : records;
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned code = codes[i];
    if (code <= largest || code == other) continue;
    throw std::invalid_argument("record " + std::to_string(i + 1) + ": found the " + name + " " + std::to_string(code) +
                                ", expected 0 to " + std::to_string(largest) +
                                (other > largest && other == no_mode ? ", or 255 for none" : ""));
  }
}

ForceKind kind_of_code(std::uint8_t code) {
  return code == 0 ? ForceKind::internal : ForceKind::external;
}

template <class T>
void check_length(std::span<T> answers, std::size_t records) {
  if (answers.empty() || answers.size() == records) return;
  throw std::invalid_argument("found an array for " + std::to_string(answers.size()) + " answers, expected " +
                              std::to_string(records) + ", as there are records");
}

/// One record's part of the answers.
void put(const JudgementSpans& answers, std::size_t i, const RecordJudgement& judgement) {
  if (!answers.verdicts.empty()) answers.verdicts[i] = judgement.verdict;
  if (!answers.modes.empty()) answers.modes[i] = judgement.modes;
  if (!answers.errors.empty()) answers.errors[i] = judgement.max_error;
  if (!answers.tiers.empty()) answers.tiers[i] = judgement.tier;
}

}  // namespace

ColumnsJudge::ColumnsJudge(const RecordColumns& columns, const ColumnsOptions& options)
    : columns_(columns), options_(options.judge) {
  if (options.scene) base_ = to_record(*options.scene);
  for (std::size_t i = 0; i < field_count; ++i) {
    if (columns.numbers[i].given()) own_ |= std::uint32_t{1} << i;
  }
  const std::uint32_t complete = over_scene(base_, own_);
  if (const std::string reason = incomplete(complete); !reason.empty()) throw std::invalid_argument(reason);
  check_codes(columns.modes, columns.records, 15, no_mode, "mode");
  check_codes(columns.kinds, columns.records, 1, 1, "kind");
  if (LaneJudge lanes(complete, own_, base_); lanes.able()) lanes_ = lanes;
}

Record ColumnsJudge::record(std::size_t i) const {
  Record record = fresh_record(base_);
  for (std::size_t k = 0; k < field_count; ++k) {
    if (columns_.numbers[k].given()) record.set(static_cast<Field>(k), columns_.numbers[k][i]);
  }
  if (columns_.modes.given() && columns_.modes[i] != no_mode) record.mode = all_modes()[columns_.modes[i]];
  if (columns_.kinds.given()) record.force_kind = kind_of_code(columns_.kinds[i]);
  return record;
}

RecordJudgement ColumnsJudge::operator()(std::size_t i) const {
  return judge(record(i), options_);
}

/// What is the same for all records.
void ColumnsJudge::fill_constants(LaneRecords& records) const {
  for (std::size_t k = 0; k < field_count; ++k) {
    const NumberColumn& column = columns_.numbers[k];
    if (column.given() && column.stride != 0) continue;
    records.numbers[k].fill(column.given() && columns_.records > 0 ? column[0] : base_.values[k]);
  }
  records.modes.fill(no_mode);
  records.kinds.fill(base_.force_kind);
}

void ColumnsJudge::fill(LaneRecords& records, std::size_t begin, std::size_t end) const {
  records.count = end - begin;
  for (auto rest = own_; rest != 0; rest &= rest - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(rest));
    const NumberColumn column = columns_.numbers[k];
    if (column.stride == 0) continue;
    for (std::size_t i = begin; i < end; ++i) records.numbers[k][i - begin] = column[i];
  }
  for (std::size_t i = begin; i < end && columns_.modes.given(); ++i) records.modes[i - begin] = columns_.modes[i];
  for (std::size_t i = begin; i < end && columns_.kinds.given(); ++i) {
    records.kinds[i - begin] = kind_of_code(columns_.kinds[i]);
  }
}

void ColumnsJudge::each(std::size_t begin, std::size_t end,
                        const std::function<void(std::size_t, const RecordJudgement&)>& see) const {
  if (!lanes_) {
    for (std::size_t i = begin; i < end; ++i) see(i, (*this)(i));
    return;
  }
  LaneRecords records;
  CertifiedLanes answers;
  RecordJudgement certified;
  fill_constants(records);
  for (std::size_t first = begin; first < end; first += lane_records) {
    fill(records, first, std::min(first + lane_records, end));
    lanes_->answers(records, answers);
    for (std::size_t i = 0; i < records.count; ++i) {
      if (answers.certified(i, options_.tolerance, certified)) {
        see(first + i, certified);
      } else {
        see(first + i, (*this)(first + i));
      }
    }
  }
}

CertifySummary certify(const RecordColumns& columns, const ColumnsOptions& options, const JudgementSpans& answers,
                       const Progress& progress) {
  const ColumnsJudge judge(columns, options);
  check_length(answers.verdicts, columns.records);
  check_length(answers.modes, columns.records);
  check_length(answers.errors, columns.records);
  check_length(answers.tiers, columns.records);
  CertifySummary total;
  std::mutex mutex;
  const auto judge_piece = [&](std::size_t begin, std::size_t end) {
    CertifySummary summary;
    judge.each(begin, end, [&](std::size_t i, const RecordJudgement& judgement) {
      stop_if_asked();
      put(answers, i, judgement);
      summary.add(judgement);
    });
    const std::lock_guard lock(mutex);
    total.add(summary);
    if (progress) progress(total.records);
  };
  constexpr std::size_t piece = 4096;
  if (options.threads == 1) {
    for (std::size_t begin = 0; begin < columns.records; begin += piece) {
      judge_piece(begin, std::min(begin + piece, columns.records));
    }
    return total;
  }
  on_threads(options.threads, [&] { pieces_in_parallel(0, columns.records, piece, judge_piece); });
  return total;
}

JudgedColumns certify(const RecordColumns& columns, const ColumnsOptions& options) {
  JudgedColumns result;
  result.verdicts.resize(columns.records);
  result.modes.resize(columns.records);
  result.errors.resize(columns.records);
  result.tiers.resize(columns.records);
  result.summary = certify(columns, options, {result.verdicts, result.modes, result.errors, result.tiers});
  return result;
}

}  // namespace slipproof
