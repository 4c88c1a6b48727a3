#include "records/certify/chunk_judge.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "base/files/numpy.hpp"
#include "base/files/words.hpp"
#include "records/judging/block_judge.hpp"
#include "records/problems/contact_record.hpp"
#include "records/problems/problem_reader.hpp"
#include "records/reading/record_reader.hpp"
#include "records/record/bicycle_records.hpp"

namespace slipproof {

namespace {

/// Records of lines that give the same fields, looked at together.
class LineGroup {
 public:
  LineGroup(const RecordJudge& judge, const RecordReader& reader, const std::vector<bool>& fields)
      : reader_(reader), block_(judge.fields()), lanes_(judge), exact_(judge.exact()) {
    block_.begin(fields);
  }

  const std::vector<bool>& fields() const { return block_.present(); }
  RecordBlock& block() { return block_; }
  /// Of the record that was added last.
  void set_line(std::string_view line, RecordJudgement& judgement) { lines_[block_.size() - 1] = {line, &judgement}; }

  void finish() {
    lanes_.look_at(block_);
    for (std::size_t i = 0; i < block_.size(); ++i) {
      const Line& line = lines_[i];
      if (lanes_.certified(i, *line.judgement)) continue;
      reader_.read(line.text, record_);
      *line.judgement = exact_(record_);
    }
    block_.clear();
  }

 private:
  struct Line {
    std::string_view text;
    RecordJudgement* judgement = nullptr;
  };

  const RecordReader& reader_;
  RecordBlock block_;
  BlockJudge lanes_;
  ExactJudge exact_;
  Record record_;
  std::array<Line, block_records> lines_;
};

/// Judges the lines of a chunk, whatever they are records of.
class LineJudge {
 public:
  LineJudge(const RecordJudge& judge, const RecordReader& reader, const CertifyOptions& options, std::string_view chunk)
      : judge_(judge), reader_(reader), options_(options), chunk_(chunk), plain_(reader.plain_lines()) {}

  /// Throws BrokenRecord. The judgement may come later, but before finish() returns.
  void judge(std::string_view line, std::uint64_t at, RecordJudgement& judgement) {
    const bool may_be_problem = !options_.mechanism && options_.format == RecordFormat::json_lines;
    if (options_.as_files() && !may_be_problem) {
      throw BrokenRecord{0, "found a record, expected a contact problem, which --law and --within are for"};
    }
    if (reader_.has_plain_lines() && read_plain(line, judgement)) return;
    // A record has no lists.
    const bool looks_like_problem = may_be_problem && (options_.as_files() || line.find('[') != std::string_view::npos);
    if (!looks_like_problem || !judge_problem_of(line, at, judgement)) judge_record(line, at, judgement);
  }

  void finish() {
    for (const auto& group : groups_) group->finish();
    plain_.forget();
  }

 private:
  static RecordJudgement not_finite(const NotFinite& found, std::uint64_t at) {
    return invalid_judgement(place_text(at, found.column) + found.reason);
  }

  /// False for an object that is no problem.
  bool judge_problem_of(std::string_view line, std::uint64_t at, RecordJudgement& judgement) const {
    const JsonProblem json = of_line([&] { return JsonProblem(line, options_.file); });
    if (options_.as_files() || json.is_large()) {
      judgement = judge_contact_line(json, options_);
      return true;
    }
    if (!json.is_problem()) return false;
    const ProblemRecord record =
        of_line([&] { return read_problem(json, line, options_.decimal_exact, options_.ignore_unknown); });
    if (record.not_finite) {
      judgement = not_finite(*record.not_finite, at);
      return true;
    }
    JudgeOptions judge = options_.judge;
    judge.tolerance = options_.contact.tolerance;
    judgement = judge_problem(record.problem, record.answer, judge);
    return true;
  }

  /// One with room for a record.
  LineGroup& group(const std::vector<bool>& fields) {
    constexpr std::size_t most = 8;
    auto found = std::ranges::find_if(groups_, [&](const auto& group) { return group->fields() == fields; });
    if (found == groups_.end()) {
      if (groups_.size() == most) {
        finish();
        groups_.clear();
      }
      groups_.push_back(std::make_unique<LineGroup>(judge_, reader_, fields));
      found = groups_.end() - 1;
    }
    if ((*found)->block().full()) {
      (*found)->finish();
      plain_.forget();
    }
    return **found;
  }

  bool read_plain(std::string_view line, RecordJudgement& judgement) {
    LineGroup& plain = group(reader_.plain_fields());
    if (!reader_.read_plain({line, chunk_}, plain_, plain.block())) return false;
    plain.set_line(line, judgement);
    return true;
  }

  /// Judges a line that is not a plain one.
  void judge_record(std::string_view line, std::uint64_t at, RecordJudgement& judgement) {
    reader_.read(line, record_);
    if (record_.not_finite) {
      judgement = not_finite(*record_.not_finite, at);
      return;
    }
    LineGroup& own = group(record_.present);
    own.block().add(record_);
    own.set_line(line, judgement);
    plain_.forget();  // a plain line after it may have no row before
  }

  const RecordJudge& judge_;
  const RecordReader& reader_;
  const CertifyOptions& options_;
  std::string_view chunk_;
  PlainLines plain_;
  std::vector<std::unique_ptr<LineGroup>> groups_;
  Record record_;
};

/// Sets the format from the first byte if the options do not give it.
CertifyOptions with_format(CertifyOptions options, ChunkReader& chunks) {
  if (options.format != RecordFormat::by_first_byte) return options;
  if (chunks.begins_with(zip_signature)) {
    refuse(
        options.file,
        "found an archive of NumPy (.npz), expected CSV, JSON Lines or one structured array (.npy). Python makes one "
        "of its columns: z = numpy.load(\"a.npz\"); numpy.save(\"a.npy\", "
        "numpy.rec.fromarrays(list(z.values()), names=z.files))");
  }
  if (chunks.begins_with(npy_signature)) {
    refuse(options.file,
           "found a NumPy array in a stream, expected CSV or JSON Lines; arrays are read from files, by their names");
  }
  options.format = chunks.first() == '{' ? RecordFormat::json_lines : RecordFormat::csv;
  return options;
}

}  // namespace

/// Objects that are made once for all chunks.
struct ChunkJudge::Judges {
  RecordJudge judge;
  RecordReader reader;

  Judges(const CertifyOptions& options, std::string_view header)
      : judge(options.mechanism ? *options.mechanism : bicycle_records(), options.judge),
        reader(options, judge.certified(), judge.fields(), header) {}
};

ChunkJudge::ChunkJudge(const CertifyOptions& options, ChunkReader& chunks)
    : options_(with_format(options, chunks)),
      judges_(std::make_unique<Judges>(options_, options_.format == RecordFormat::csv ? chunks.header() : "")) {}

ChunkJudge::~ChunkJudge() = default;

Judged ChunkJudge::judge(const Chunk& chunk) const {
  LineJudge judge(judges_->judge, judges_->reader, options_, chunk.text);
  const auto finish = [&] { judge.finish(); };
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
        number, at, [&](RecordJudgement& to) { judge.judge(line, at, to); }, finish);
  });
  return records.result(finish);
}

}  // namespace slipproof
