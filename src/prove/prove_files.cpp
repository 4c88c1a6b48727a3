#include "prove/prove_files.hpp"

#include <algorithm>
#include <mutex>

#include "check/files.hpp"
#include "input/diagnostic.hpp"
#include "input/text_file.hpp"
#include "parallel/in_parallel.hpp"
#include "prove/statement.hpp"

namespace slipproof {

namespace {

constexpr std::size_t max_certificate_size = std::size_t{1} << 28U;

/// One statement a task: they differ by orders of magnitude.
template <class Work>
void for_each_index(std::size_t size, unsigned threads, const Work& work) {
  on_threads(threads, [&] { each_in_parallel(0, size, work); });
}

/// Throws InputError with what is wrong with all of them.
void refuse_malformed(const std::vector<std::filesystem::path>& statements, unsigned threads) {
  std::vector<std::vector<Diagnostic>> mistakes(statements.size());
  for_each_index(statements.size(), threads, [&](std::size_t i) {
    try {
      prove::Statement(statements[i].string(), read_text_file(statements[i]));
    } catch (const InputError& error) {
      mistakes[i] = error.diagnostics();
    }
  });
  std::vector<Diagnostic> all;
  for (const auto& some : mistakes) all.insert(all.end(), some.begin(), some.end());
  if (!all.empty()) throw InputError(std::move(all));
}

/// The outcome that an accepted certificate beside the statement stands for.
std::optional<FileOutcome> kept(const std::filesystem::path& statement) {
  const std::filesystem::path certificate = certificate_of(statement);
  std::error_code error;
  if (!std::filesystem::is_regular_file(certificate, error)) return std::nullopt;
  const check::FileResult checked = check::check_file(certificate);
  if (checked.verdict != check::Verdict::accepted) return std::nullopt;
  FileOutcome result{.statement = statement, .outcome = {}, .kept = true};
  result.outcome.theorem = checked.theorem;
  result.outcome.verdict = ProofOutcome::Verdict::proved;
  result.outcome.certificate = read_text_file(certificate, max_certificate_size);
  result.outcome.vacuous = uses_assumptions_only(result.outcome.certificate) &&
                           !claims_contradiction(statement.string(), read_text_file(statement));
  return result;
}

class Run {
 public:
  Run(const std::vector<std::filesystem::path>& statements, const ProveOptions& options)
      : statements_(statements), options_(options), outcomes_(statements.size()) {}

  std::vector<FileOutcome> outcomes() {
    for_each_index(statements_.size(), options_.threads, [&](std::size_t i) {
      outcomes_[i] = outcome(statements_[i]);
      const std::scoped_lock lock(mutex_);
      ++progress_.done;
      if (options_.finished) options_.finished(i, outcomes_[i]);
      tell();
    });
    return std::move(outcomes_);
  }

 private:
  FileOutcome outcome(const std::filesystem::path& statement) {
    if (!options_.again) {
      if (auto old = kept(statement)) return *std::move(old);
    }
    FileOutcome result{.statement = statement, .outcome = search(statement)};
    if (options_.again && !result.outcome.proved()) {
      if (auto old = kept(statement)) return *std::move(old);
    }
    return result;
  }

  ProofOutcome search(const std::filesystem::path& statement) {
    prove::Limits limits = options_.limits;
    limits.tick = [&](std::uint64_t steps) {
      const std::scoped_lock lock(mutex_);
      progress_.theorem = statement.stem().string();
      progress_.steps = steps;
      tell();
    };
    return prove_statement(statement.string(), read_text_file(statement), limits);
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

std::vector<FileOutcome> prove_files(const std::vector<std::filesystem::path>& statements,
                                     const ProveOptions& options) {
  refuse_malformed(statements, options.threads);
  return Run(statements, options).outcomes();
}

}  // namespace slipproof
