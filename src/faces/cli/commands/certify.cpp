#include "records/certify/certify.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <memory>
#include <optional>

#include "base/input/text_file.hpp"
#include "base/number/format.hpp"
#include "base/output/output_file.hpp"
#include "base/output/terminal.hpp"
#include "contact/formats/read_files.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/commands/certify_problem.hpp"
#include "faces/cli/commands/gate.hpp"
#include "faces/cli/crew_run.hpp"
#include "faces/cli/interrupt.hpp"
#include "faces/cli/progress.hpp"
#include "faces/cli/warnings.hpp"
#include "mechanics/reading/shipped.hpp"
#include "records/certify/pieces.hpp"
#include "records/certify/table_records.hpp"
#include "records/problems/contact_file.hpp"
#include "records/record/bicycle_records.hpp"
#include "report/scenes/records/record_words.hpp"

namespace slipproof::cli {

namespace {

struct CertifyArguments {
  CommonOptions common;
  CertifyOptions certify;
  CertifyProblemArguments problem;
  std::string file, scene, mechanism, decimal = "nearest", broken = "report", format, summary;
  std::vector<std::string> columns;
  CrewArguments crew;
  GateArguments gate;
  std::uint64_t written = 0;  ///< records whose lines are on standard output
};

RecordFormat format_of(const CertifyArguments& options) {
  if (options.format == "jsonl") return RecordFormat::json_lines;
  if (options.format == "csv") return RecordFormat::csv;
  const auto ends_with = [&](std::string_view end) { return options.file.ends_with(end); };
  if (ends_with(".jsonl") || ends_with(".ndjson") || ends_with(".json")) return RecordFormat::json_lines;
  return ends_with(".csv") ? RecordFormat::csv : RecordFormat::by_first_byte;
}

std::string summary_text(const CertifySummary& s) {
  std::string text = counted(s.records, "record");
  for (std::size_t i = 0; i < record_verdict_count; ++i) {
    const auto verdict = static_cast<RecordVerdict>(i);
    if (verdict == RecordVerdict::undecided && s.count(verdict) == 0) continue;
    text += fmt::format("{} {} {}", i == 0 ? ":" : ",", s.verdicts[i], name(verdict));
  }
  text += fmt::format("\n{} decided in exact arithmetic, {} by floating point with proved error bounds{}\n", s.tiers[1],
                      s.tiers[0], s.broken == 0 ? "" : fmt::format("; {} could not be read", s.broken));
  if (s.with_rho == 0 || s.with_rho < s.count(RecordVerdict::certified)) {
    text += fmt::format("largest relative error of a certified record {:.3g}, of any right motion {:.3g}\n",
                        s.worst_certified_error, s.worst_error);
  }
  if (s.with_rho > 0)
    text +=
        fmt::format("largest rho of {}: {}\n", counted(s.with_rho, "certified contact problem"), at_most(s.worst_rho));
  return text + fmt::format("s {} {}/{}\n", s.all_certified() ? "CERTIFIED" : "NOT CERTIFIED",
                            s.count(RecordVerdict::certified), s.records);
}

/// The bytes of the input, counted: how many there will be is known of a file.
struct CountedBytes {
  std::atomic<std::uint64_t> read = 0;
  std::uint64_t all = 0;

  ByteSource open(const std::string& file) {
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) all = std::filesystem::file_size(file, error);
    return [this, source = open_bytes(file)](char* buffer, std::size_t size) {
      const std::size_t some = source(buffer, size);
      read += some;
      return some;
    };
  }
};

/// Reads the values that are the same for all records: a scene of a bicycle or of a mechanism, or a mechanism alone.
void read_setting(CertifyArguments& options) {
  if (!options.mechanism.empty())
    options.certify.mechanism.emplace(open_mechanism(options.mechanism, {}, Dimensions::any));
  if (!options.scene.empty()) {
    options.certify.mechanism = records_of_scene(read_text_file(options.scene), options.scene);
  }
  if (options.certify.mechanism) print_warnings(options.certify.mechanism->mechanism, options.common);
}

/// Whether the file holds one contact problem; otherwise it has records, or problems as JSON Lines.
bool is_one_problem(const CertifyArguments& options) {
  if (options.file != "-" && !is_json_lines(options.file)) {
    return options.problem.any() || is_problem_file(options.file);
  }
  if (options.problem.any_of_one()) {
    throw CLI::ValidationError("FILE", "found " + std::string(options.file == "-" ? "standard input" : "JSON Lines") +
                                           ", expected a file with one contact problem for --answer, --refine, "
                                           "--certificate, --check-certificate and --report");
  }
  return false;
}

/// Certifies a table, or lines of text.
CertifySummary certify_records(const CertifyArguments& options, bool table, const LineSink& sink,
                               const Progress& progress, CountedBytes& bytes) {
  if (table) return certify(open_table(options.file, options.columns), sink, options.certify, progress);
  if (!options.columns.empty())
    throw InputError({{options.file, 0, 0, "found no array (.npy), expected one with --columns"}});
  return certify(bytes.open(options.file), sink, options.certify, progress);
}

/// Everything that a line of the output may depend on.
std::string certified_work(const CertifyArguments& options, const RecordPieces& pieces) {
  const CertifyOptions& c = options.certify;
  return fmt::format(
      "certify {}\nscene {} mechanism {}\nformat {} decimal {} broken {} unknown {} from {}\n"
      "tolerance {} {} effort {} {} every-q {} law {} within {}\n",
      pieces.input(), options.scene.empty() ? "" : digest_of(options.scene),
      c.mechanism ? digest_of(c.mechanism->mechanism.file) : "", static_cast<int>(c.format), options.decimal,
      options.broken, c.ignore_unknown, c.first_record, c.judge.tolerance, c.contact.tolerance, c.judge.effort,
      c.contact.effort, c.judge.every_q, options.problem.law, c.contact.within.value_or(-1));
}

Exit certified_exit(const CertifySummary& summary) {
  if (summary.all_certified()) return success;
  return summary.nothing_refuted() ? undecided : refuted_or_not_certified;
}

/// Certifies by a crew; returns nothing on ranks that only answer.
std::optional<CertifySummary> certify_shared(const CertifyArguments& options, const LineSink& sink,
                                             const Progress& progress) {
  const RecordPieces pieces(options.certify);
  const auto crew = crew_of(
      options.crew, options.common.threads, [&] { return certified_work(options, pieces); },
      Inputs{options.file, options.scene}, [&](std::string_view request) { return pieces.answer(request); });
  if (crew->serve()) return std::nullopt;
  return pieces.certify(*crew, sink, progress);
}

/// Refuses other input than a file of lines, since a crew can share out nothing else.
void refuse_crew(const CertifyArguments& options, const char* found) {
  if (!options.crew.wanted()) return;
  throw CLI::ValidationError(
      "FILE", std::string("found ") + found + ", expected a file of CSV or JSON Lines for --checkpoint or many ranks");
}

int run_certify(CertifyArguments& options) {
  const bool table =
      options.file != "-" && !options.problem.any() && options.format.empty() && is_table_file(options.file);
  if (options.file == "-") refuse_crew(options, "standard input");
  if (table) refuse_crew(options, "an array");
  if (!table && is_one_problem(options)) {
    refuse_crew(options, "one contact problem");
    if (options.certify.judge.every_q || options.decimal == "exact") {
      throw CLI::ValidationError("--every-q, --decimal exact", "found with a file of one problem, expected lines");
    }
    options.problem.file = options.file;
    return run_certify_problem(options.problem, options.gate, options.common);
  }
  if (options.crew.wanted() && options.gate.writes()) {
    throw CLI::ValidationError("--junit, --sarif", "found with --checkpoint or many ranks, expected without");
  }
  const ContactFileOptions problems = options.problem.judging();
  options.certify.contact = problems.judge;
  options.certify.law = problems.law;
  if (options.problem.tolerance) options.certify.judge.tolerance = *options.problem.tolerance;
  if (options.problem.effort) options.certify.judge.effort = *options.problem.effort;
  options.certify.format = format_of(options);
  options.certify.file = options.file;
  options.certify.decimal_exact = options.decimal == "exact";
  options.certify.stop_at_broken = options.broken == "stop";
  options.certify.threads = options.common.threads;
  read_setting(options);
  std::optional<OutputFile> summary_file;
  if (!options.summary.empty())
    summary_file.emplace(options.summary, Inputs{options.file == "-" ? "/dev/stdin" : options.file, options.scene});
  const bool quiet = options.common.quiet;
  refuse_one_file_twice({options.summary, options.gate.junit, options.gate.sarif});
  Gate gate(options.gate, options.file, Inputs{options.file == "-" ? "/dev/stdin" : options.file, options.scene});
  if (options.gate.wanted() && !options.crew.wanted()) {
    options.certify.judged = [&](std::uint64_t record, const RecordJudgement& judgement) {
      gate.add(record, judgement);
    };
  }
  const bool in_words = !options.common.json && is_terminal(STDOUT_FILENO);
  ProgressLine line(!quiet);
  CountedBytes bytes;
  const Progress progress = [&](std::uint64_t records) {
    options.written = records;
    if (!line.is_shown()) return;
    const std::uint64_t read = bytes.read;  // ahead of what is judged
    line.at(read, bytes.all == 0 ? 0 : std::max(bytes.all, read + 1), counted(records, "record"));
  };
  const LineSink sink = [&](std::string_view lines) {
    line.make_way();
    if (!quiet) print(in_words ? record_words(lines, takes_colours(STDOUT_FILENO)) : std::string(lines));
  };
  const std::optional<CertifySummary> found = options.crew.wanted()
                                                  ? certify_shared(options, sink, progress)
                                                  : certify_records(options, table, sink, progress, bytes);
  if (!found) return success;
  const CertifySummary& summary = *found;
  line.clear();
  if (summary_file) summary_file->write(R"({"schema":"slipproof/certify/1",)" + to_json(summary).substr(1) + '\n');
  const std::string text = (options.crew.wanted() ? "" : gate.text()) + summary_text(summary);
  if (!options.common.json) {
    print(in_words ? narrow(text) : text);
  } else if (!quiet) {
    std::cerr << text;  // standard output has only a line for each record
  }
  gate.write();
  return gate.exit_code(summary, certified_exit(summary));
}

/// The records whose lines are written need no second look.
Continuation by_records(const CertifyArguments& options) {
  if (options.crew.wanted() || options.common.quiet || options.written == 0) return by_checkpoint(options.crew);
  const std::uint64_t next = options.certify.first_record + options.written;
  return {fmt::format("the lines of {} are on standard output, and the rest begins with record {}",
                      counted(options.written, "record"), next),
          {"--from", std::to_string(next)}};
}

}  // namespace

void add_certify(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CertifyArguments>();
  CLI::App& command = *app.add_subcommand("certify",
                                          "Certify outputs of floating-point solvers, for scenes or contact problems: "
                                          "a line of JSON for each, or words on a terminal");
  command
      .add_option("FILE", options->file,
                  "CSV with a header, JSON Lines (- for standard input), NumPy's .npy; or a contact problem's file: " +
                      problem_formats())
      ->required();
  auto* scene = command.add_option("--scene", options->scene,
                                   "Scene file, of a bicycle or a mechanism, with the values that all records share");
  command
      .add_option("--mechanism", options->mechanism, "Mechanism of the records: its file, or the name of a shipped one")
      ->excludes(scene);
  command
      .add_option(
          "--tolerance", options->problem.tolerance,
          "Largest relative error of a component, 1e-9; for contact problems, relative to the largest force, 1e-6")
      ->check(number_in(0, 1));
  command.add_option("--decimal", options->decimal, "Value of a decimal: the nearest binary64, or exactly as written")
      ->check(CLI::IsMember({"nearest", "exact"}))
      ->capture_default_str();
  command.add_option("--format", options->format, "csv or jsonl; default: by the file's name, or by the first byte")
      ->check(CLI::IsMember({"csv", "jsonl"}));
  command.add_option("--broken", options->broken, "Records that cannot be read: report them as invalid, or stop")
      ->check(CLI::IsMember({"report", "stop"}))
      ->capture_default_str();
  command.add_option("--from", options->certify.first_record, "Record to begin with, to continue where a run stopped")
      ->check(whole_number(1))
      ->capture_default_str();
  command
      .add_option(
          "--effort", options->problem.effort,
          fmt::format("Limit of work for one record, in operations on words, {}; for a contact problem's file {}",
                      JudgeOptions().effort, ContactJudgeOptions().effort))
      ->check(whole_number(1));
  command
      .add_option("--columns", options->columns,
                  "Names of the columns of an array without names, as in --columns F,a,S2,S3,N2,N3")
      ->delimiter(',');
  command.add_flag("--ignore-unknown", options->certify.ignore_unknown, "Skip unknown columns");
  command.add_option("--summary", options->summary, "Write the counts to this file, as JSON");
  command.add_flag("--every-q", options->certify.judge.every_q,
                   "For each contact problem in a line: does it have one solution for every q?");
  add_problem_options(command, options->problem);
  add_gate_options(command, options->gate);
  add_crew_options(command, options->crew);
  add_common_options(command, options->common);
  add_examples(command, {"--ignore-unknown cases/solvers/siconos-fc2d-lemke.csv",
                         "cases/contact-problems/leaning-body.json --all"});
  command.callback([options, &exit_code, &command] {
    options->problem.refine = command.count("--refine") > 0;
    exit_code = stoppable([&] { return run_certify(*options); }, [&] { return by_records(*options); });
  });
}

}  // namespace slipproof::cli
