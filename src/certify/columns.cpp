#include "certify/columns.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "parallel/thread_count.hpp"

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
  std::uint32_t given = 0;
  for (std::size_t i = 0; i < field_count; ++i) {
    if (columns.numbers[i].given()) given |= std::uint32_t{1} << i;
  }
  if (const std::string reason = incomplete(over_scene(base_, given)); !reason.empty()) {
    throw std::invalid_argument(reason);
  }
  check_codes(columns.modes, columns.records, 15, no_mode, "mode");
  check_codes(columns.kinds, columns.records, 1, 1, "kind");
}

Record ColumnsJudge::record(std::size_t i) const {
  Record record = fresh_record(base_);
  for (std::size_t k = 0; k < field_count; ++k) {
    if (columns_.numbers[k].given()) record.set(static_cast<Field>(k), columns_.numbers[k][i]);
  }
  if (columns_.modes.given() && columns_.modes[i] != no_mode) record.mode = all_modes()[columns_.modes[i]];
  if (columns_.kinds.given()) record.force_kind = columns_.kinds[i] == 0 ? ForceKind::internal : ForceKind::external;
  return record;
}

RecordJudgement ColumnsJudge::operator()(std::size_t i) const {
  return judge(record(i), options_);
}

void ColumnsJudge::each(std::size_t begin, std::size_t end,
                        const std::function<void(std::size_t, const RecordJudgement&)>& see) const {
  for (std::size_t i = begin; i < end; ++i) see(i, (*this)(i));
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
  tbb::task_arena arena(thread_count(options.threads));
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, columns.records, piece),
                      [&](const tbb::blocked_range<std::size_t>& r) { judge_piece(r.begin(), r.end()); });
  });
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
