#include "records/certify/chunk_judge.hpp"

#include <optional>

#include "base/files/npy_header.hpp"
#include "contact/formats/json_problem.hpp"
#include "records/certify/contact_record.hpp"
#include "records/certify/exact_judge.hpp"
#include "records/certify/mechanism_judge.hpp"
#include "records/certify/mechanism_reader.hpp"
#include "records/certify/problem_reader.hpp"
#include "records/certify/record_reader.hpp"

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
  if (record.not_finite) return not_finite(*record.not_finite);
  JudgeOptions judge = options.judge;
  judge.tolerance = options.contact.tolerance;
  return judge_problem(record.problem, record.answer, judge);
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

/// Of bicycles in CSV, most of which are read into lanes and certified there; the others are judged one by one.
class LaneLines final : public LineJudge {
 public:
  LaneLines(const RecordReader& reader, const LaneJudge& lanes, const CertifyOptions& options, std::string_view chunk)
      : reader_(reader), lanes_(lanes), options_(options), chunk_(chunk), usual_(reader.usual_lines()) {
    reader.fill_constants(records_);
    records_.count = 0;
  }
  void judge(std::string_view line, std::uint64_t at, RecordJudgement& judgement) override {
    if (!reader_.read_usual({line, chunk_}, usual_, records_)) {
      judgement = judge_line(line, at, reader_, options_);
      return;
    }
    lines_[records_.count++] = {line, at, &judgement};
    if (records_.count == lane_records) finish();
  }
  void finish() override {
    lanes_.answers(records_, found_);
    for (std::size_t i = 0; i < records_.count; ++i) {
      const Line& line = lines_[i];
      if (!found_.certified(i, options_.judge.tolerance, *line.judgement)) {
        *line.judgement = judge_line(line.text, line.at, reader_, options_);
      }
    }
    records_.count = 0;
    usual_.forget();
  }

 private:
  struct Line {
    std::string_view text;
    std::uint64_t at = 0;
    RecordJudgement* judgement = nullptr;
  };

  const RecordReader& reader_;
  const LaneJudge& lanes_;
  const CertifyOptions& options_;
  std::string_view chunk_;
  UsualLines usual_;
  LaneRecords records_;
  CertifiedLanes found_;
  std::array<Line, lane_records> lines_;
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

/// The format, where the options leave it to the first byte.
CertifyOptions with_format(CertifyOptions options, ChunkReader& chunks) {
  if (options.format != RecordFormat::by_first_byte) return options;
  if (chunks.first() == npy_signature[0]) {
    throw InputError({{options.file, 0, 0,
                       "found a NumPy array in a stream, expected CSV or JSON Lines; arrays are read from files, by "
                       "their names"}});
  }
  options.format = chunks.first() == '{' ? RecordFormat::json_lines : RecordFormat::csv;
  return options;
}

}  // namespace

/// What is made once for all chunks.
class ChunkJudge::Judges {
 public:
  Judges(const CertifyOptions& options, std::string_view header) : options_(options) {
    if (!options.mechanism) {
      records_.emplace(options, header);
      lanes_ = records_->lanes();
      return;
    }
    mechanism_records_.emplace(options, header);
    mechanism_judge_.emplace(*options.mechanism, mechanism_records_->fields());
  }

  std::unique_ptr<LineJudge> make(std::string_view chunk) const {
    if (lanes_) return std::make_unique<LaneLines>(*records_, *lanes_, options_, chunk);
    if (records_) return std::make_unique<SceneLines>(*records_, options_);
    return std::make_unique<MechanismLines>(*mechanism_records_, *mechanism_judge_, options_);
  }

 private:
  const CertifyOptions& options_;
  std::optional<RecordReader> records_;
  std::optional<LaneJudge> lanes_;
  std::optional<MechanismReader> mechanism_records_;
  std::optional<MechanismJudge> mechanism_judge_;
};

ChunkJudge::ChunkJudge(const CertifyOptions& options, ChunkReader& chunks)
    : options_(with_format(options, chunks)),
      judges_(std::make_unique<Judges>(options_, options_.format == RecordFormat::csv ? chunks.header() : "")) {}

ChunkJudge::~ChunkJudge() = default;

Judged ChunkJudge::judge(const Chunk& chunk) const {
  const auto judge = judges_->make(chunk.text);
  const auto finish = [&] { judge->finish(); };
  JudgedRecords records(options_, chunk.text.size() / 4);
  std::uint64_t line_number = chunk.first_line, record = chunk.first_record;
  bool ended = false;
  each_line(chunk.text, [&](std::string_view line) {
    const std::uint64_t at = line_number++;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (blank(line)) return;
    const std::uint64_t number = record++;
    if (number < options_.first_record || ended) return;
    ended = !records.add(
        number, at, [&](RecordJudgement& to) { judge->judge(line, at, to); }, finish);
  });
  return records.result(finish);
}

}  // namespace slipproof
