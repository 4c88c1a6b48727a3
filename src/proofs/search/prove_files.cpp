#include "proofs/search/prove_files.hpp"

#include <algorithm>
#include <mutex>

#include "base/crew/bytes.hpp"
#include "base/crew/crew.hpp"
#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"
#include "base/parallel/failure.hpp"
#include "base/parallel/in_parallel.hpp"
#include "proofs/check/files.hpp"
#include "proofs/statement/statement.hpp"

namespace slipproof {

namespace {

constexpr std::size_t max_certificate_size = std::size_t{1} << 28U;

/// Throws InputError with what is wrong with all of them.
void refuse_malformed(const std::vector<std::filesystem::path>& statements, unsigned threads) {
  std::vector<std::vector<Diagnostic>> mistakes(statements.size());
  on_threads(threads, [&] {
    in_parallel(0, statements.size(), [&](std::size_t i) {
      try {
        prove::Statement(statements[i].string(), read_found_file(statements[i]));
      } catch (const InputError& error) {
        mistakes[i] = error.diagnostics();
      }
    });
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

/// The outcome for an accepted certificate of the statement.
std::optional<FileOutcome> kept(const std::filesystem::path& statement) {
  const std::filesystem::path certificate = certificate_of(statement);
  std::error_code error;
  if (!std::filesystem::is_regular_file(certificate, error)) return std::nullopt;
  const check::FileResult checked = check::check_file(certificate);
  if (checked.verdict != check::Verdict::accepted) return std::nullopt;
  FileOutcome result{.statement = statement, .outcome = {}, .kept = true};
  result.outcome.theorem = checked.theorem;
  result.outcome.verdict = ProofOutcome::Verdict::proved;
  result.outcome.certificate = read_found_file(certificate, max_certificate_size);
  result.outcome.vacuous = uses_assumptions_only(result.outcome.certificate) &&
                           !claims_contradiction(statement.string(), read_found_file(statement));
  return result;
}

FileOutcome outcome_of(const std::filesystem::path& statement, const std::string& text, const ProveOptions& options,
                       const prove::Limits& limits) {
  if (!options.again) {
    if (auto old = kept(statement)) return *std::move(old);
  }
  FileOutcome result{.statement = statement, .outcome = {}};
  const std::string why = failure_of([&] { result.outcome = prove_statement(statement.string(), text, limits); });
  if (!why.empty()) {
    result.outcome.theorem = statement.stem().string();
    result.outcome.leftover = {"a search that failed: " + why};
  }
  if (options.again && !result.outcome.proved()) {
    if (auto old = kept(statement)) return *std::move(old);
  }
  return result;
}

std::string statement_request(const std::filesystem::path& statement) {
  return ByteWriter().text(statement.string()).text(read_found_file(statement)).take();
}

std::string answer_within(std::string_view request, const ProveOptions& options, const prove::Limits& limits) {
  ByteReader bytes(request);
  const std::filesystem::path statement = bytes.text();
  const std::string text(bytes.text());
  bytes.end();
  return outcome_bytes(outcome_of(statement, text, options, limits));
}

class Run {
 public:
  Run(const std::vector<std::filesystem::path>& statements, const ProveOptions& options)
      : statements_(statements), options_(options), outcomes_(statements.size()) {}

  std::vector<FileOutcome> outcomes() {
    const auto request = [&](std::uint64_t i) { return statement_request(statements_[i]); };
    on_threads(options_.threads, [&] {
      share(
          options_.crew, [&](std::string_view asked) { return search(asked); }, statements_.size(), request,
          [&](std::uint64_t i, const std::string& result) {
            outcomes_[i] = read_outcome(result);
            outcomes_[i].statement = statements_[i];
            const std::scoped_lock lock(mutex_);
            ++progress_.done;
            if (options_.finished) options_.finished(i, outcomes_[i]);
            tell();
          });
    });
    return std::move(outcomes_);
  }

 private:
  std::string search(std::string_view request) {
    prove::Limits limits = options_.limits;
    const std::filesystem::path statement = ByteReader(request).text();
    limits.tick = [&](std::uint64_t steps) {
      const std::scoped_lock lock(mutex_);
      progress_.theorem = statement.stem().string();
      progress_.steps = steps;
      tell();
    };
    return answer_within(request, options_, limits);
  }

  void tell() {
    progress_.all = statements_.size();
    if (options_.progress) options_.progress(progress_);
  }

  const std::vector<std::filesystem::path>& statements_;
  const ProveOptions& options_;
  std::vector<FileOutcome> outcomes_;
  std::mutex mutex_;
  ProveProgress progress_;
};

}  // namespace

std::filesystem::path certificate_of(std::filesystem::path statement) {
  return statement.replace_extension(".cert");
}

std::vector<std::filesystem::path> statements_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> result;
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
    if (entry.path().extension() == ".statement") result.push_back(entry.path());
  }
  if (error)
    throw InputError({{folder.string(), 0, 0, "found " + error.message() + ", expected a folder of statements"}});
  std::sort(result.begin(), result.end());
  return result;
}

std::string answer_statement(std::string_view request, const ProveOptions& options) {
  return answer_within(request, options, options.limits);
}

std::vector<FileOutcome> prove_files(const std::vector<std::filesystem::path>& statements,
                                     const ProveOptions& options) {
  refuse_malformed(statements, options.threads);
  return Run(statements, options).outcomes();
}

}  // namespace slipproof
