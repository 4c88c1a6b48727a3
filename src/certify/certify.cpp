#include "certify/certify.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "certify/chunk_reader.hpp"
#include "certify/exact_judge.hpp"
#include "certify/problem_reader.hpp"
#include "certify/record_reader.hpp"
#include "parallel/thread_count.hpp"

namespace slipproof {

namespace {

struct Judged {
  std::string lines;
  std::vector<std::pair<std::uint64_t, RecordJudgement>> judgements;  ///< with `judged`
  CertifySummary summary;
  std::optional<Diagnostic> broken;  ///< the first one, with stop_at_broken
};

void count(CertifySummary& summary, const RecordJudgement& j) {
  ++summary.records;
  ++summary.verdicts[static_cast<std::size_t>(j.verdict)];
  if (j.verdict != RecordVerdict::invalid) ++summary.tiers[static_cast<std::size_t>(j.tier)];
  if (j.verdict == RecordVerdict::certified)
    summary.worst_certified_error = std::max(summary.worst_certified_error, j.max_error);
  summary.worst_error = std::max(summary.worst_error, j.max_error);
}

RecordJudgement judge_line(std::string_view line, std::uint64_t at, const RecordReader& reader,
                           const CertifyOptions& options) {
  const auto not_finite = [at](const NotFinite& found) {
    return invalid_judgement(place_text(at, found.column) + found.reason);
  };
  if (options.format != RecordFormat::json_lines || !is_problem(line)) {
    const Record record = reader.read(line);
    return record.not_finite ? not_finite(*record.not_finite) : judge(record, options.judge);
  }
  const ProblemRecord record = read_problem(line, options.decimal_exact, options.ignore_unknown);
  return record.not_finite ? not_finite(*record.not_finite)
                           : judge_problem(record.problem, record.answer, options.judge);
}

Judged judge_chunk(const Chunk& chunk, const RecordReader& reader, const CertifyOptions& options) {
  Judged result;
  std::uint64_t line_number = chunk.first_line, record = chunk.first_record;
  each_line(chunk.text, [&](std::string_view line) {
    const std::uint64_t at = line_number++;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (blank(line)) return;
    const std::uint64_t number = record++;
    if (number < options.first_record || result.broken) return;
    RecordJudgement judgement;
    try {
      judgement = judge_line(line, at, reader, options);
    } catch (const BrokenRecord& broken) {
      if (options.stop_at_broken) {
        result.broken = {options.file, static_cast<std::size_t>(at), broken.column, broken.message};
        return;
      }
      judgement = invalid_judgement(place_text(at, broken.column) + broken.message);
      ++result.summary.broken;
    }
    count(result.summary, judgement);
    append_line(result.lines, number, judgement);
    if (options.judged) result.judgements.emplace_back(number, std::move(judgement));
  });
  return result;
}

}  // namespace

void CertifySummary::add(const CertifySummary& other) {
  records += other.records;
  for (std::size_t i = 0; i < record_verdict_count; ++i) verdicts[i] += other.verdicts[i];
  for (std::size_t i = 0; i < tier_count; ++i) tiers[i] += other.tiers[i];
  broken += other.broken;
  worst_certified_error = std::max(worst_certified_error, other.worst_certified_error);
  worst_error = std::max(worst_error, other.worst_error);
}

CertifySummary certify(const ByteSource& input, const LineSink& output, const CertifyOptions& given,
                       const Progress& progress) {
  ChunkReader chunks(input, given.file);
  CertifyOptions options = given;
  if (options.format == RecordFormat::by_first_byte) {
    options.format = chunks.first() == '{' ? RecordFormat::json_lines : RecordFormat::csv;
  }
  const std::string header = options.format == RecordFormat::csv ? chunks.header() : std::string();
  const RecordReader reader(options, header);
  CertifySummary summary;
  const auto write = [&](const Judged& judged) {
    if (!judged.lines.empty()) output(judged.lines);
    for (const auto& [record, judgement] : judged.judgements) options.judged(record, judgement);
    summary.add(judged.summary);
    if (judged.broken) throw InputError({*judged.broken});
    if (progress) progress(summary.records);
  };

  if (options.threads == 1) {
    Chunk chunk;
    while (chunks.next(chunk)) write(judge_chunk(chunk, reader, options));
    return summary;
  }
  tbb::task_arena arena(thread_count(options.threads));
  const auto in_flight = 3 * static_cast<std::size_t>(arena.max_concurrency());
  arena.execute([&] {
    tbb::parallel_pipeline(
        in_flight,
        tbb::make_filter<void, std::shared_ptr<Chunk>>(tbb::filter_mode::serial_in_order,
                                                       [&](tbb::flow_control& control) {
                                                         auto chunk = std::make_shared<Chunk>();
                                                         if (!chunks.next(*chunk)) control.stop();
                                                         return chunk;
                                                       }) &
            tbb::make_filter<std::shared_ptr<Chunk>, std::shared_ptr<Judged>>(
                tbb::filter_mode::parallel,
                [&](const std::shared_ptr<Chunk>& chunk) {
                  return std::make_shared<Judged>(judge_chunk(*chunk, reader, options));
                }) &
            tbb::make_filter<std::shared_ptr<Judged>, void>(
                tbb::filter_mode::serial_in_order, [&](const std::shared_ptr<Judged>& judged) { write(*judged); }));
  });
  return summary;
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
  return json.dump();
}

}  // namespace slipproof
