#include "certify/certify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "certify/chunk_reader.hpp"
#include "certify/contact_file.hpp"
#include "certify/contact_record.hpp"
#include "certify/exact_judge.hpp"
#include "certify/judged.hpp"
#include "certify/mechanism_judge.hpp"
#include "certify/mechanism_reader.hpp"
#include "certify/problem_reader.hpp"
#include "certify/record_reader.hpp"
#include "formats/json_problem.hpp"
#include "formats/npy_header.hpp"

namespace slipproof {

namespace {

RecordJudgement judge_line(std::string_view line, std::uint64_t at, const RecordReader& reader,
                           const CertifyOptions& options) {
  const auto not_finite = [at](const NotFinite& found) {
    return invalid_judgement(place_text(at, found.column) + found.reason);
  };
  if (options.format == RecordFormat::json_lines && is_json_problem(line)) return judge_contact_line(line, options);
  if (options.format != RecordFormat::json_lines || !is_problem(line)) {
    const Record record = reader.read(line);
    return record.not_finite ? not_finite(*record.not_finite) : judge(record, options.judge);
  }
  const ProblemRecord record = read_problem(line, options.decimal_exact, options.ignore_unknown);
  return record.not_finite ? not_finite(*record.not_finite)
                           : judge_problem(record.problem, record.answer, options.judge);
}

/// Judges the lines of a chunk, whatever they are records of.
class LineJudge {
 public:
  virtual ~LineJudge() = default;
  /// Throws BrokenRecord. A judgement may come later, but before finish() returns.
  virtual void judge(std::string_view line, std::uint64_t at, RecordJudgement& judgement) = 0;
  virtual void finish() {}
};

/// Of bicycles and contact problems.
class SceneLines final : public LineJudge {
 public:
  SceneLines(const RecordReader& reader, const CertifyOptions& options) : reader_(reader), options_(options) {}
  void judge(std::string_view line, std::uint64_t at, RecordJudgement& judgement) override {
    judgement = judge_line(line, at, reader_, options_);
  }

 private:
  const RecordReader& reader_;
  const CertifyOptions& options_;
};

class MechanismLines final : public LineJudge {
 public:
  MechanismLines(const MechanismReader& reader, const MechanismJudge& judge, const CertifyOptions& options)
      : reader_(reader), block_(judge, options.judge) {}
  void judge(std::string_view line, std::uint64_t at, RecordJudgement& judgement) override {
    reader_.read(line, record_);
    if (record_.not_finite) {
      judgement = invalid_judgement(place_text(at, record_.not_finite->column) + record_.not_finite->reason);
    } else {
      block_.add(record_, judgement);
    }
  }
  void finish() override { block_.finish(); }

 private:
  const MechanismReader& reader_;
  MechanismBlock block_;
  MechanismRecord record_;
};

/// What is made once for all chunks.
class LineJudges {
 public:
  LineJudges(const CertifyOptions& options, std::string_view header) : options_(options) {
    if (!options.mechanism) {
      records_.emplace(options, header);
      return;
    }
    mechanism_records_.emplace(options, header);
    mechanism_judge_.emplace(*options.mechanism, mechanism_records_->fields());
  }

  std::unique_ptr<LineJudge> make() const {
    if (records_) return std::make_unique<SceneLines>(*records_, options_);
    return std::make_unique<MechanismLines>(*mechanism_records_, *mechanism_judge_, options_);
  }

 private:
  const CertifyOptions& options_;
  std::optional<RecordReader> records_;
  std::optional<MechanismReader> mechanism_records_;
  std::optional<MechanismJudge> mechanism_judge_;
};

Judged judge_chunk(const Chunk& chunk, const LineJudges& judges, const CertifyOptions& options) {
  const auto judge = judges.make();
  const auto finish = [&] { judge->finish(); };
  JudgedRecords records(options);
  std::uint64_t line_number = chunk.first_line, record = chunk.first_record;
  bool ended = false;
  each_line(chunk.text, [&](std::string_view line) {
    const std::uint64_t at = line_number++;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (blank(line)) return;
    const std::uint64_t number = record++;
    if (number < options.first_record || ended) return;
    ended = !records.add(
        number, at, [&](RecordJudgement& to) { judge->judge(line, at, to); }, finish);
  });
  return records.result(finish);
}

}  // namespace

void CertifySummary::add(const CertifySummary& other) {
  records += other.records;
  for (std::size_t i = 0; i < record_verdict_count; ++i) verdicts[i] += other.verdicts[i];
  for (std::size_t i = 0; i < tier_count; ++i) tiers[i] += other.tiers[i];
  broken += other.broken;
  worst_certified_error = std::max(worst_certified_error, other.worst_certified_error);
  worst_error = std::max(worst_error, other.worst_error);
  with_rho += other.with_rho;
  worst_rho = std::max(worst_rho, other.worst_rho);
}

void CertifySummary::add(const RecordJudgement& judgement) {
  ++records;
  ++verdicts[static_cast<std::size_t>(judgement.verdict)];
  if (judgement.verdict != RecordVerdict::invalid) ++tiers[static_cast<std::size_t>(judgement.tier)];
  if (judgement.verdict == RecordVerdict::certified)
    worst_certified_error = std::max(worst_certified_error, judgement.max_error);
  worst_error = std::max(worst_error, judgement.max_error);
  if (judgement.verdict == RecordVerdict::certified && !judgement.members.empty()) {
    ++with_rho;
    worst_rho = std::max(worst_rho, judgement.rho);
  }
}

CertifySummary certify(const ByteSource& input, const LineSink& output, const CertifyOptions& given,
                       const Progress& progress) {
  ChunkReader chunks(input, given.file);
  CertifyOptions options = given;
  if (options.format == RecordFormat::by_first_byte) {
    if (chunks.first() == npy_signature[0]) {
      throw InputError({{given.file, 0, 0,
                         "found a NumPy array in a stream, expected CSV or JSON Lines; arrays are read from files, by "
                         "their names"}});
    }
    options.format = chunks.first() == '{' ? RecordFormat::json_lines : RecordFormat::csv;
  }
  const std::string header = options.format == RecordFormat::csv ? chunks.header() : std::string();
  const LineJudges judges(options, header);
  return judge_in_order<Chunk>(
      options, output, progress, [&](Chunk& chunk) { return chunks.next(chunk); },
      [&](const Chunk& chunk) { return judge_chunk(chunk, judges, options); });
}

CertifySummary certify(std::istream& input, const LineSink& output, const CertifyOptions& options,
                       const Progress& progress) {
  return certify(bytes_of(input, options.file), output, options, progress);
}

std::string to_json(const CertifySummary& s) {
  nlohmann::ordered_json json{{"records", s.records}};
  for (std::size_t i = 0; i < record_verdict_count; ++i)
    json["verdicts"][std::string(name(static_cast<RecordVerdict>(i)))] = s.verdicts[i];
  for (std::size_t i = 0; i < tier_count; ++i) json["tiers"][std::string(name(static_cast<Tier>(i)))] = s.tiers[i];
  json["broken"] = s.broken;
  json["worst_certified_error"] = fmt::format("{:.3g}", s.worst_certified_error);
  json["worst_error"] = fmt::format("{:.3g}", s.worst_error);
  if (s.with_rho > 0) json["worst_rho"] = at_most(s.worst_rho);
  return json.dump();
}

}  // namespace slipproof
