// The results for a piece of the records, and writing pieces in their order.
#pragma once

#include <tbb/parallel_pipeline.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel/in_parallel.hpp"
#include "records/certify/certify.hpp"
#include "records/record/cells.hpp"
#include "records/record/record_block.hpp"

namespace slipproof {

struct Judged {
  std::string lines;
  std::vector<std::pair<std::uint64_t, RecordJudgement>> judgements;  ///< filled if options.judged is set
  CertifySummary summary;
  std::optional<Diagnostic> broken;  ///< the first one, with stop_at_broken

  /// Counts a judgement and writes its line.
  void add(std::uint64_t record, const RecordJudgement& judgement, bool is_broken, const CertifyOptions& options) {
    if (is_broken) ++summary.broken;
    summary.add(judgement);
    append_line(lines, record, judgement);
    if (options.judged) judgements.emplace_back(record, judgement);
  }

  /// Makes the judgement of a record that cannot be read; false if the run stops there. `line` is 0 if there are no
  /// lines.
  bool take(const BrokenRecord& found, std::uint64_t line, std::uint64_t record, RecordJudgement& judgement,
            const CertifyOptions& options) {
    if (!options.stop_at_broken) {
      judgement = invalid_judgement(place_text(line, found.column) + found.message);
      return true;
    }
    const std::string where = line == 0 ? "record " + std::to_string(record) + ": " : "";
    broken = {options.file, static_cast<std::size_t>(line), found.column, where + found.message};
    return false;
  }
};

/// The records of a piece. Judges them in groups and writes them in order.
class JudgedRecords {
 public:
  /// `bytes`: the expected length of the output, at least.
  explicit JudgedRecords(const CertifyOptions& options, std::size_t bytes = 0) : options_(options) {
    result_.lines.reserve(bytes);
  }

  /// judge(judgement) judges a record, at the latest in finish(), or throws BrokenRecord. If it fails otherwise, this
  /// record is undecided. False if the run stops there.
  /// `line` is 0 if there are no lines.
  template <class Judge, class Finish>
  bool add(std::uint64_t record, std::uint64_t line, const Judge& judge, const Finish& finish) {
    Entry& entry = entries_[count_];
    entry.record = record;
    try {
      entry.broken = false;
      const std::string failure = failure_of([&] { judge(entry.judgement); });
      if (!failure.empty()) entry.judgement = undecided_judgement(failure);
    } catch (const BrokenRecord& found) {
      entry.broken = true;
      if (!result_.take(found, line, record, entry.judgement, options_)) return false;
    }
    if (++count_ == entries_.size()) write(finish);
    return true;
  }

  /// The results for all records; none is left waiting.
  template <class Finish>
  Judged result(const Finish& finish) {
    write(finish);
    return std::move(result_);
  }

 private:
  struct Entry {
    std::uint64_t record = 0;
    RecordJudgement judgement;
    bool broken = false;
  };

  template <class Finish>
  void write(const Finish& finish) {
    stop_if_asked();
    finish();
    for (std::size_t i = 0; i < count_; ++i) {
      result_.add(entries_[i].record, entries_[i].judgement, entries_[i].broken, options_);
    }
    count_ = 0;
  }

  const CertifyOptions& options_;
  Judged result_;
  std::array<Entry, block_records> entries_;
  std::size_t count_ = 0;
};

/// Writes the next results in order: their lines to the output, their counts to the summary. Throws InputError if they
/// contain a broken record.
inline void write_judged(const Judged& judged, CertifySummary& summary, const CertifyOptions& options,
                         const LineSink& output, const Progress& progress) {
  if (!judged.lines.empty()) output(judged.lines);
  for (const auto& [record, judgement] : judged.judgements) options.judged(record, judgement);
  summary.add(judged.summary);
  if (judged.broken) throw InputError({*judged.broken});
  if (progress) progress(summary.records);
}

/// Judges pieces in parallel. next(piece) reads a piece and returns false at the end. judge(piece) returns its results;
/// it is called in any order and by several threads. Writes the results in the order of the pieces.
template <class Piece, class Next, class Judge>
CertifySummary judge_in_order(const CertifyOptions& options, const LineSink& output, const Progress& progress,
                              const Next& next, const Judge& judge) {
  CertifySummary summary;
  const auto write = [&](const Judged& judged) { write_judged(judged, summary, options, output, progress); };
  if (options.threads == 1) {
    Piece piece;
    while (next(piece)) write(judge(piece));
    return summary;
  }
  // Pieces are kept in places that are used again as results are written in order. The pipeline cannot keep them: when
  // an exception ends it, it loses what it holds.
  struct Place {
    Piece piece;
    Judged judged;
  };
  std::vector<Place> places(3 * static_cast<std::size_t>(thread_count(options.threads)));
  std::size_t count = 0;
  on_threads(options.threads, [&, token = StopScope::token()] {
    tbb::parallel_pipeline(
        places.size(),
        tbb::make_filter<void, Place*>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& control) {
          Place* place = &places[count++ % places.size()];
          if (!next(place->piece)) control.stop();
          return place;
        }) & tbb::make_filter<Place*, Place*>(tbb::filter_mode::parallel, [&](Place* place) {
          const StopScope scope(token);
          place->judged = judge(place->piece);
          return place;
        }) & tbb::make_filter<Place*, void>(tbb::filter_mode::serial_in_order, [&](Place* place) {
          write(place->judged);
        }));
  });
  return summary;
}

}  // namespace slipproof
