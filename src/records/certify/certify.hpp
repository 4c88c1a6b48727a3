// Certifying solver outputs in bulk: a stream of records in, a line of JSON for each out.
#pragma once

#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "base/input/byte_source.hpp"
#include "base/input/diagnostic.hpp"
#include "contact/judge/judge.hpp"
#include "records/certify/judge.hpp"
#include "records/certify/mechanism_record.hpp"

namespace slipproof {

enum class RecordFormat {
  by_first_byte,  ///< JSON Lines begin with a brace, CSV does not
  csv,
  json_lines
};

struct CertifyOptions {
  JudgeOptions judge;
  ContactJudgeOptions contact = {};  ///< for lines with a contact problem as `read_problem_line` takes it
  RecordFormat format = RecordFormat::by_first_byte;
  std::string file = "-";      ///< how messages call the input
  std::optional<Scene> scene;  ///< parameters that are the same for all records
  /// Records are of this mechanism, and not of the bicycle or contact problems.
  std::optional<CertifiedMechanism> mechanism = std::nullopt;
  bool decimal_exact = false;      ///< decimals mean what they say, not the nearest binary64
  bool stop_at_broken = false;     ///< throw at the first record that cannot be read, instead of reporting it
  bool ignore_unknown = false;     ///< columns and keys that are no field
  std::uint64_t first_record = 1;  ///< records before it are skipped: where an earlier run stopped
  unsigned threads = 0;            ///< 0: as many as there are
  /// Also told of each record that is judged, in order: its number, and what was found.
  std::function<void(std::uint64_t record, const RecordJudgement& judgement)> judged = {};
};

/// Counts over the records judged.
struct CertifySummary {
  std::uint64_t records = 0;
  std::array<std::uint64_t, record_verdict_count> verdicts{};
  TierCounts tiers{};
  std::uint64_t broken = 0;          ///< of the invalid ones, those that could not be read
  double worst_certified_error = 0;  ///< largest relative error of a component among certified records
  double worst_error = 0;            ///< and among those that are the right motion, certified or not
  std::uint64_t with_rho = 0;        ///< contact problems whose certified answers have a rho in place of an error
  double worst_rho = 0;              ///< and the largest

  std::uint64_t count(RecordVerdict v) const { return verdicts[static_cast<std::size_t>(v)]; }
  void add(const CertifySummary& other);
  void add(const RecordJudgement& judgement);
  /// What is not certified is undecided.
  bool nothing_refuted() const { return count(RecordVerdict::certified) + count(RecordVerdict::undecided) == records; }
  /// Records were judged, and each is certified.
  bool all_certified() const { return records > 0 && count(RecordVerdict::certified) == records; }
};

/// Receives output lines, whole ones, in the order of the records.
using LineSink = std::function<void(std::string_view)>;
/// Is told the number of records judged so far, in order.
using Progress = std::function<void(std::uint64_t)>;

/// Reads records to the end of the input and writes a line for each, in memory that does not grow with their number.
/// The records that are there are answered before more are waited for. Records count from 1; blank lines do not count.
/// Throws InputError for a header that cannot be used, a line beyond max_record_line, and with stop_at_broken for a
/// record that cannot be read; what was judged before is written.
CertifySummary certify(const ByteSource& input, const LineSink& output, const CertifyOptions& options,
                       const Progress& progress = {});

/// The same from a stream, which is read in blocks.
CertifySummary certify(std::istream& input, const LineSink& output, const CertifyOptions& options,
                       const Progress& progress = {});

inline constexpr std::size_t max_record_line = 1U << 23U;

/// The output line of a record, ending in a newline.
void append_line(std::string& out, std::uint64_t record, const RecordJudgement& judgement);

/// {"records":..,"verdicts":{..},"tiers":{..},...} without the schema.
std::string to_json(const CertifySummary& summary);

}  // namespace slipproof
