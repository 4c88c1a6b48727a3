#include "records/certify/columns.hpp"

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "base/input/diagnostic.hpp"
#include "base/parallel/in_parallel.hpp"
#include "records/judging/block_judge.hpp"

namespace slipproof {

namespace {

/// Throws std::invalid_argument for the first code that is no mode.
void check_modes(const RecordColumns& columns) {
  if (!columns.modes.given()) return;
  const std::size_t modes = columns.fields->modes().size();
  const std::size_t count = columns.modes.stride == 0 ? std::min<std::size_t>(columns.records, 1) : columns.records;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint16_t code = columns.modes[i];
    if (code < modes || code == no_mode) continue;
    throw std::invalid_argument("record " + std::to_string(i + 1) + ": found the mode " + std::to_string(code) +
                                ", expected 0 to " + std::to_string(modes - 1) + ", or " + std::to_string(no_mode) +
                                " for none");
  }
}

std::uint64_t bits_of(const std::vector<std::uint16_t>& modes) {
  std::uint64_t bits = 0;
  for (const std::uint16_t mode : modes) bits |= mode < 64 ? std::uint64_t{1} << mode : 0;
  return bits;
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
  if (!answers.modes.empty()) answers.modes[i] = bits_of(judgement.modes);
  if (!answers.errors.empty()) answers.errors[i] = judgement.max_error;
  if (!answers.tiers.empty()) answers.tiers[i] = judgement.tier;
}

}  // namespace

NumberColumn& RecordColumns::number(std::string_view name) {
  const auto field = fields->find(name);
  if (!field) throw std::invalid_argument("found the column " + in_quotes(name) + ", expected a field");
  return numbers[*field];
}

ColumnsJudge::ColumnsJudge(const RecordColumns& columns, const RecordJudge& judge) : columns_(columns), judge_(judge) {
  for (const NumberColumn& column : columns.numbers) present_.push_back(column.given());
  if (const std::string reason = incomplete(present_, judge.fields(), judge.certified()); !reason.empty()) {
    throw std::invalid_argument(reason);
  }
  check_modes(columns);
}

Record ColumnsJudge::record(std::size_t i) const {
  Record record;
  record.clear(present_.size());
  for (std::size_t k = 0; k < present_.size(); ++k) {
    if (!present_[k]) continue;
    record.set(k, columns_.numbers[k][i]);
    if (!record.not_finite) record.not_finite = not_finite(judge_.fields().name(k), record.values[k], 0);
  }
  if (columns_.modes.given()) record.mode = columns_.modes[i];
  return record;
}

RecordJudgement ColumnsJudge::operator()(std::size_t i) const {
  return judge_(record(i));
}

void ColumnsJudge::fill(RecordBlock& block, std::size_t begin, std::size_t end) const {
  block.clear();
  for (std::size_t k = 0; k < present_.size(); ++k) {
    if (!present_[k]) continue;
    const NumberColumn column = columns_.numbers[k];
    double* const numbers = block.numbers(k);
    for (std::size_t i = begin; i < end; ++i) numbers[i - begin] = column[i];
  }
  for (std::size_t i = begin; i < end; ++i) {
    block.mode(i - begin) = columns_.modes.given() ? columns_.modes[i] : no_mode;
    block.add();
  }
}

void ColumnsJudge::each(std::size_t begin, std::size_t end,
                        const std::function<void(std::size_t, const RecordJudgement&)>& see) const {
  RecordBlock block(judge_.fields());
  block.begin(present_);
  BlockJudge lanes(judge_);
  ExactJudge exact = judge_.exact();
  RecordJudgement judgement;
  for (std::size_t first = begin; first < end; first += block_records) {
    fill(block, first, std::min(first + block_records, end));
    lanes.look_at(block);
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (!lanes.certified(i, judgement)) judgement = exact(record(first + i));
      see(first + i, judgement);
    }
  }
}

CertifySummary certify(const RecordColumns& columns, const RecordJudge& record_judge, const JudgementSpans& answers,
                       unsigned threads, const Progress& progress) {
  const ColumnsJudge judge(columns, record_judge);
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
  if (threads == 1) {
    for (std::size_t begin = 0; begin < columns.records; begin += piece) {
      judge_piece(begin, std::min(begin + piece, columns.records));
    }
    return total;
  }
  on_threads(threads, [&] { pieces_in_parallel(0, columns.records, piece, judge_piece); });
  return total;
}

JudgedColumns certify(const RecordColumns& columns, const RecordJudge& judge, unsigned threads) {
  JudgedColumns result;
  result.verdicts.resize(columns.records);
  result.modes.resize(columns.records);
  result.errors.resize(columns.records);
  result.tiers.resize(columns.records);
  result.summary = certify(columns, judge, {result.verdicts, result.modes, result.errors, result.tiers}, threads);
  return result;
}

}  // namespace slipproof
