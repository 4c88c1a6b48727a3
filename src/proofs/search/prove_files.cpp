#include "proofs/search/prove_files.hpp"

#include <algorithm>
#include <mutex>

#include "base/crew/bytes.hpp"
#include "base/crew/crew.hpp"
#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"
#include "base/parallel/failure.hpp"
#include "base/parallel/in_parallel.hpp"
#include "proofs/check/judge.hpp"
#include "proofs/statement/statement.hpp"
#include "proofs/statement/theorems.hpp"

namespace slipproof {

namespace {

/// The mistakes of a statement, at their places in its file.
std::vector<Diagnostic> mistakes_of(const StatementSource& source) {
  const std::filesystem::path origin = source.origin.empty() ? source.path : source.origin, file = file_of(origin);
  try {
    prove::Statement(origin.string(), source.text);
    return {};
  } catch (const InputError& error) {
    std::vector<Diagnostic> mistakes = error.diagnostics();
    if (file == origin) return mistakes;
    for (Diagnostic& mistake : mistakes) {
      mistake.file = file.string();
      mistake.line += mistake.line > 0 ? source.line - 1 : source.line;
      mistake.message = source.path.stem().string() + ": " + mistake.message;
    }
    return mistakes;
  }
}

/// Throws InputError with what is wrong with all of them.
void refuse_malformed(const std::vector<StatementSource>& statements, unsigned threads) {
  std::vector<std::vector<Diagnostic>> mistakes(statements.size());
  on_threads(threads, [&] {
    in_parallel(0, statements.size(), [&](std::size_t i) { mistakes[i] = mistakes_of(statements[i]); });
  });
  std::vector<Diagnostic> all;
  for (const auto& some : mistakes) all.insert(all.end(), some.begin(), some.end());
  if (!all.empty()) throw InputError(std::move(all));
}

std::string outcome_bytes(const FileOutcome& file) {
  const ProofOutcome& o = file.outcome;
  ByteWriter bytes;
  bytes.number(file.kept ? 1 : 0).text(o.theorem).number(static_cast<std::uint64_t>(o.verdict)).text(o.certificate);
  bytes.number(o.vacuous ? 1 : 0).number(o.exhausted ? 1 : 0).number(o.steps).number(o.counterexample.size());
  for (const auto& [name, value] : o.counterexample) bytes.text(name).rationals({value});
  bytes.number(o.leftover.size());
  for (const std::string& left : o.leftover) bytes.text(left);
  return bytes.take();
}

FileOutcome read_outcome(std::string_view text) {
  ByteReader bytes(text);
  FileOutcome file;
  ProofOutcome& o = file.outcome;
  file.kept = bytes.number() != 0;
  o.theorem = bytes.text();
  o.verdict = static_cast<ProofOutcome::Verdict>(bytes.number());
  o.certificate = bytes.text();
  o.vacuous = bytes.number() != 0;
  o.exhausted = bytes.number() != 0;
  o.steps = bytes.number();
  for (std::uint64_t left = bytes.number(); left > 0; --left) {
    std::string name(bytes.text());
    o.counterexample.emplace_back(std::move(name), bytes.rationals().at(0));
  }
  for (std::uint64_t left = bytes.number(); left > 0; --left) o.leftover.emplace_back(bytes.text());
  bytes.end();
  return file;
}

/// The outcome if the statement has an accepted certificate.
std::optional<FileOutcome> kept(const StatementSource& source) {
  if (!source.certificate) return std::nullopt;
  const check::Judgement judged = check::judge(source.text, *source.certificate);
  if (judged.verdict != check::Verdict::accepted) return std::nullopt;
  FileOutcome result{.statement = source.path, .outcome = {}, .kept = true};
  result.outcome.theorem = judged.theorem;
  result.outcome.verdict = ProofOutcome::Verdict::proved;
  result.outcome.certificate = *source.certificate;
  result.outcome.vacuous =
      uses_assumptions_only(result.outcome.certificate) && !claims_contradiction(source.path.string(), source.text);
  return result;
}

FileOutcome searched(const std::filesystem::path& statement, const std::string& text, const prove::Limits& limits) {
  FileOutcome result{.statement = statement, .outcome = {}};
  const std::string why = failure_of([&] { result.outcome = prove_statement(statement.string(), text, limits); });
  if (!why.empty()) {
    result.outcome.theorem = statement.stem().string();
    result.outcome.leftover = {"a search that failed: " + why};
  }
  return result;
}

/// Without the certificate that it has so far: a run that goes on finds what it answered before.
std::string statement_request(const StatementSource& source) {
  return ByteWriter().text(source.path.string()).text(source.text).take();
}

std::string answer_within(std::string_view request, const prove::Limits& limits) {
  ByteReader bytes(request);
  const std::filesystem::path statement = bytes.text();
  const std::string text(bytes.text());
  bytes.end();
  return outcome_bytes(searched(statement, text, limits));
}

class Run {
 public:
  Run(const std::vector<StatementSource>& statements, const ProveOptions& options)
      : statements_(statements), options_(options), outcomes_(statements.size()) {}

  std::vector<FileOutcome> outcomes() {
    on_threads(options_.threads, [&] {
      const std::vector<std::size_t> open = keep_accepted();
      share(
          options_.crew, [&](std::string_view asked) { return search(asked); }, open.size(),
          [&](std::uint64_t k) { return statement_request(statements_[open[k]]); },
          [&](std::uint64_t k, const std::string& result) { take(open[k], read_outcome(result)); });
    });
    return std::move(outcomes_);
  }

 private:
  /// Takes the accepted certificates, unless they come from an earlier part of this run. Returns what is left to
  /// search.
  std::vector<std::size_t> keep_accepted() {
    std::vector<std::optional<FileOutcome>> accepted(statements_.size());
    in_parallel(0, options_.again ? 0 : statements_.size(), [&](std::size_t i) {
      if (options_.crew != nullptr && options_.crew->has(statement_request(statements_[i]))) return;
      accepted[i] = kept(statements_[i]);
    });
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < accepted.size(); ++i) {
      if (accepted[i]) {
        take(i, *std::move(accepted[i]));
      } else {
        open.push_back(i);
      }
    }
    return open;
  }

  void take(std::size_t i, FileOutcome outcome) {
    outcome.statement = statements_[i].path;
    if (options_.again && !outcome.outcome.proved()) {
      if (auto old = kept(statements_[i])) outcome = *std::move(old);
    }
    outcomes_[i] = std::move(outcome);
    const std::scoped_lock lock(mutex_);
    ++progress_.done;
    if (options_.finished) options_.finished(i, outcomes_[i]);
    tell();
  }

  std::string search(std::string_view request) {
    prove::Limits limits = options_.limits;
    const std::filesystem::path statement = ByteReader(request).text();
    limits.tick = [&](std::uint64_t steps) {
      const std::scoped_lock lock(mutex_);
      progress_.theorem = statement.stem().string();
      progress_.steps = steps;
      tell();
    };
    return answer_within(request, limits);
  }

  void tell() {
    progress_.all = statements_.size();
    if (options_.progress) options_.progress(progress_);
  }

  const std::vector<StatementSource>& statements_;
  const ProveOptions& options_;
  std::vector<FileOutcome> outcomes_;
  std::mutex mutex_;
  ProveProgress progress_;
};

}  // namespace

std::filesystem::path certificate_of(std::filesystem::path statement) {
  return statement.replace_extension(".cert");
}

std::vector<std::filesystem::path> statements_in(const std::filesystem::path& folder_or_file) {
  std::vector<std::filesystem::path> result, files;
  if (is_theorem_file(folder_or_file)) {
    files.push_back(folder_or_file);
  } else {
    std::error_code error;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_or_file, error)) {
      if (entry.path().extension() == ".statement" || is_theorem_file(entry.path())) files.push_back(entry.path());
    }
    if (error)
      throw InputError(
          {{folder_or_file.string(), 0, 0, "found " + error.message() + ", expected a folder of statements"}});
    std::sort(files.begin(), files.end());
  }
  for (const std::filesystem::path& file : files) {
    if (!is_theorem_file(file)) result.push_back(file);
    if (!is_theorem_file(file)) continue;
    for (const Theorem& theorem : read_theorems(file).theorems) result.push_back(file / (theorem.name + ".statement"));
  }
  return result;
}

std::vector<StatementSource> read_statements(const std::vector<std::filesystem::path>& paths) {
  TheoremTexts texts;
  std::vector<StatementSource> result;
  for (const std::filesystem::path& path : paths) {
    const bool is_part = file_of(path) != path;
    const std::string text = is_part ? texts.at(path).value_or("") : read_found_file(path);
    result.push_back({path, text, texts.at(certificate_of(path)), {}, texts.line_of(path)});
  }
  return result;
}

std::string answer_statement(std::string_view request, const ProveOptions& options) {
  return answer_within(request, options.limits);
}

std::vector<FileOutcome> prove_files(const std::vector<StatementSource>& statements, const ProveOptions& options) {
  refuse_malformed(statements, options.threads);
  return Run(statements, options).outcomes();
}

}  // namespace slipproof
