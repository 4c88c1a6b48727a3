// Certifies solver outputs in bulk: reads a stream of records, writes a line of JSON for each.
#pragma once

#include <functional>
#include <istream>
#include <string>
#include <string_view>

#include "base/input/byte_source.hpp"
#include "records/reading/options.hpp"

namespace slipproof {

/// Counts over the records that were judged.
struct CertifySummary {
  std::uint64_t records = 0;
  std::array<std::uint64_t, record_verdict_count> verdicts{};
  TierCounts tiers{};
  std::uint64_t broken = 0;           ///< invalid records that could not be read
  double worst_certified_error = 0;   ///< largest relative error of a component among certified records
  double worst_error = 0;             ///< the same among records that are the right motion, certified or not
  std::uint64_t with_rho = 0;         ///< contact problems whose certified answers have a rho instead of an error
  double worst_rho = 0;               ///< the largest of these rho
  std::uint64_t eps_solutions = 0;    ///< of those that are inaccurate
  std::uint64_t others_possible = 0;  ///< certified records that are not proved to be the only solution

  std::uint64_t count(RecordVerdict v) const { return verdicts[static_cast<std::size_t>(v)]; }
  void add(const CertifySummary& other);
  void add(const RecordJudgement& judgement);
  /// True if every record is certified or undecided.
  bool nothing_refuted() const { return count(RecordVerdict::certified) + count(RecordVerdict::undecided) == records; }
  /// True if there are records and all are certified.
  bool all_certified() const { return records > 0 && count(RecordVerdict::certified) == records; }
};

/// Receives complete output lines, in the order of the records.
using LineSink = std::function<void(std::string_view)>;
/// Receives the number of records judged so far, in ascending order.
using Progress = std::function<void(std::uint64_t)>;

/// Reads records to the end of the input and writes a line for each. Memory does not grow with their number. Records
/// that have arrived are answered before the call waits for more. Records count from 1; blank lines do not count.
/// Throws InputError for a header that cannot be used, for a line longer than max_record_line, and, with
/// stop_at_broken, for a record that cannot be read; the lines judged before are written.
CertifySummary certify(const ByteSource& input, const LineSink& output, const CertifyOptions& options,
                       const Progress& progress = {});

/// Certifies a stream, which is read in blocks.
CertifySummary certify(std::istream& input, const LineSink& output, const CertifyOptions& options,
                       const Progress& progress = {});

/// The output line of a record, ending in a newline.
void append_line(std::string& out, std::uint64_t record, const RecordJudgement& judgement);

/// {"records":..,"verdicts":{..},"tiers":{..},...} without the schema.
std::string to_json(const CertifySummary& summary);

}  // namespace slipproof
