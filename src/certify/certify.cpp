#include "certify/certify.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>

#include "certify/exact_judge.hpp"
#include "certify/problem_reader.hpp"
#include "certify/record_reader.hpp"

namespace slipproof {

namespace {

constexpr std::size_t chunk_size = 1U << 18U;

bool blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

/// Whole lines, and where they stand.
struct Chunk {
  std::string text;
  std::uint64_t first_line = 0, first_record = 0;
};

struct Judged {
  std::string lines;
  CertifySummary summary;
  std::optional<Diagnostic> broken;  ///< the first one, with stop_at_broken
};

/// Calls see(line) for each line of a text.
template <class See>
void each_line(std::string_view text, const See& see) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    see(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

class ChunkReader {
 public:
  ChunkReader(std::istream& input, const std::string& file) : input_(input), file_(file) {}

  /// The first line that is not blank, without its end; empty at the end of the input.
  std::string header() {
    std::string line;
    while (blank(line)) {
      while (rest_.find('\n') == std::string::npos && fill()) {
      }
      if (rest_.empty()) return {};
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      line = rest_.substr(0, end);
      rest_.erase(0, std::min(end + 1, rest_.size()));
      ++line_;
    }
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
  }

  bool next(Chunk& chunk) {
    while (rest_.size() < chunk_size && fill()) {
    }
    std::size_t cut = rest_.rfind('\n');
    while (cut == std::string::npos && !at_end_) {
      fill();
      cut = rest_.rfind('\n');
    }
    if (rest_.empty()) return false;
    const std::size_t size = at_end_ ? rest_.size() : cut + 1;
    chunk = {rest_.substr(0, size), line_, record_};
    rest_.erase(0, size);
    each_line(chunk.text, [&](std::string_view line) {
      ++line_;
      if (!blank(line)) ++record_;
    });
    return true;
  }

 private:
  bool fill() {
    if (at_end_) return false;
    const std::size_t size = rest_.size(), newline = rest_.rfind('\n');
    if (size - (newline == std::string::npos ? 0 : newline) > max_record_line) {
      throw InputError(
          {{file_, static_cast<std::size_t>(line_), 0,
            "found a line of more than " + std::to_string(max_record_line) + " bytes, expected a record"}});
    }
    rest_.resize(size + chunk_size);
    input_.read(rest_.data() + size, static_cast<std::streamsize>(chunk_size));
    rest_.resize(size + static_cast<std::size_t>(input_.gcount()));
    if (input_.bad()) throw InputError({{file_, static_cast<std::size_t>(line_), 0, "cannot be read"}});
    at_end_ = !input_;
    return true;
  }

  std::istream& input_;
  std::string file_, rest_;
  std::uint64_t line_ = 1, record_ = 1;
  bool at_end_ = false;
};

void count(CertifySummary& summary, const RecordJudgement& j) {
  ++summary.records;
  ++summary.verdicts[static_cast<std::size_t>(j.verdict)];
  if (j.verdict != RecordVerdict::invalid) ++summary.tiers[static_cast<std::size_t>(j.tier)];
  if (j.verdict == RecordVerdict::certified)
    summary.worst_certified_error = std::max(summary.worst_certified_error, j.max_error);
  summary.worst_error = std::max(summary.worst_error, j.max_error);
}

/// "1.3e-16": two digits, rounded up, as JSON text. printf and its like take longer than the whole judgement.
void append_upper_bound(std::string& out, double x) {
  constexpr int lowest = -40, highest = 4;
  if (!(x >= 1e-39 && x < 1e4)) {
    fmt::format_to(std::back_inserter(out), "\"{:.3g}\"", x);
    return;
  }
  static const auto powers = [] {  // 10^(1 - e) for the exponents e that occur
    std::array<double, highest - lowest + 1> result{};
    for (int e = lowest; e <= highest; ++e) result[static_cast<std::size_t>(e - lowest)] = std::pow(10.0, 1 - e);
    return result;
  }();
  int exponent = static_cast<int>(std::floor(std::log10(x)));
  const auto digits_at = [&](int e) {
    return static_cast<int>(std::ceil(x * powers[static_cast<std::size_t>(e - lowest)] * (1 + 0x1p-48)));
  };
  int digits = digits_at(exponent);
  if (digits < 10) digits = digits_at(--exponent);
  if (digits >= 100) {
    digits = (digits + 9) / 10;
    ++exponent;
  }
  const int size = std::abs(exponent);
  const auto digit = [](int d) { return static_cast<char>('0' + d); };
  const char text[] = {'"',
                       digit(digits / 10),
                       '.',
                       digit(digits % 10),
                       'e',
                       exponent < 0 ? '-' : '+',
                       digit(size / 10),
                       digit(size % 10),
                       '"'};
  out.append(text, sizeof text);
}

RecordJudgement judge_line(std::string_view line, const RecordReader& reader, const CertifyOptions& options) {
  if (options.format != RecordFormat::json_lines || !is_problem(line)) return judge(reader.read(line), options.judge);
  const ProblemRecord record = read_problem(line, options.decimal_exact, options.ignore_unknown);
  if (!record.not_finite.empty()) return invalid_judgement(record.not_finite);
  return judge_problem(record.problem, record.answer, options.judge);
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
      judgement = judge_line(line, reader, options);
    } catch (const BrokenRecord& broken) {
      if (options.stop_at_broken) {
        result.broken = {options.file, static_cast<std::size_t>(at), broken.column, broken.message};
        return;
      }
      judgement = invalid_judgement("line " + std::to_string(at) +
                                    (broken.column == 0 ? "" : ", column " + std::to_string(broken.column)) + ": " +
                                    broken.message);
      ++result.summary.broken;
    }
    count(result.summary, judgement);
    append_line(result.lines, number, judgement);
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

void append_line(std::string& out, std::uint64_t record, const RecordJudgement& j) {
  const auto append = [&out](std::uint64_t x) {
    const fmt::format_int text(x);
    out.append(text.data(), text.size());
  };
  out += "{\"record\":";
  append(record);
  out += ",\"verdict\":\"";
  out += name(j.verdict);
  out += '"';
  if (j.verdict != RecordVerdict::invalid) {
    out += ",\"modes\":[";
    for (unsigned rest = j.modes; rest != 0; rest &= rest - 1) {
      const ContactMode mode = all_modes()[static_cast<std::size_t>(std::countr_zero(rest))];
      out += rest == j.modes ? "\"" : ",\"";
      out += name(mode.rear);
      out += '/';
      out += name(mode.front);
      out += '"';
    }
    out += j.mode_names;
    out += j.contact_problem ? "],\"solutions\":" : "],\"motions\":";
    if (j.verdict == RecordVerdict::undecided) {
      out += "null";  // nobody has counted them
    } else {
      append(j.motions);
    }
    out += ",\"max_relative_error\":";
    if (j.modes == 0 && j.mode_names.empty()) {
      out += "null";
    } else {
      append_upper_bound(out, j.max_error);
    }
    out += ",\"tier\":\"";
    out += name(j.tier);
    out += '"';
  }
  out += j.details;
  out += "}\n";
}

CertifySummary certify(std::istream& input, const LineSink& output, const CertifyOptions& options,
                       const Progress& progress) {
  ChunkReader chunks(input, options.file);
  const std::string header = options.format == RecordFormat::csv ? chunks.header() : std::string();
  const RecordReader reader(options, header);
  CertifySummary summary;
  const auto write = [&](const Judged& judged) {
    if (!judged.lines.empty()) output(judged.lines);
    summary.add(judged.summary);
    if (judged.broken) throw InputError({*judged.broken});
    if (progress) progress(summary.records);
  };

  if (options.threads == 1) {
    Chunk chunk;
    while (chunks.next(chunk)) write(judge_chunk(chunk, reader, options));
    return summary;
  }
  tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic : static_cast<int>(options.threads));
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
