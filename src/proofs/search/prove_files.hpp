// Proves many statements in parallel: texts in, certificates out.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/search/prove.hpp"

namespace slipproof {

class Crew;

/// The statements in a folder and the folders in it, in the order of their names; those of a theorem file in its order,
/// with the paths of its parts (proofs/statement/theorems.hpp). Throws InputError.
std::vector<std::filesystem::path> statements_in(const std::filesystem::path& folder_or_file);

/// The path of a statement's certificate: in the same folder or file.
std::filesystem::path certificate_of(std::filesystem::path statement);

/// A statement that is to be proved.
struct StatementSource {
  std::filesystem::path path;
  std::string text;
  std::optional<std::string> certificate{};  ///< its present certificate, or the record in its place
  std::filesystem::path origin{};            ///< place of the text in messages; empty: `path`
  std::size_t line = 1;                      ///< its first line in that file
};

/// Reads statements and what they have as certificates. Throws InputError.
std::vector<StatementSource> read_statements(const std::vector<std::filesystem::path>& paths);

/// The outcome for a statement.
struct FileOutcome {
  std::filesystem::path statement;
  ProofOutcome outcome;
  bool kept = false;  ///< its certificate is accepted: not searched again
};

/// The progress of the work.
struct ProveProgress {
  std::size_t done = 0, all = 0;
  std::string theorem;      ///< a theorem whose search is running
  std::uint64_t steps = 0;  ///< steps of that search
};

struct ProveOptions {
  prove::Limits limits;
  unsigned threads = 0;  ///< 0: all cores
  bool again = false;    ///< search also for what has an accepted certificate
  Crew* crew = nullptr;  ///< does the searches, instead of threads; its service is answer_statement()
  /// Called for each file as soon as it is done, in any order; from one thread at a time.
  std::function<void(std::size_t index, const FileOutcome& outcome)> finished;
  std::function<void(const ProveProgress& progress)> progress;  ///< now and then, from one thread at a time
};

/// Answers a request to a rank: a statement's path and text. Only those `options` count that the outcome
/// depends on. Throws InputError.
std::string answer_statement(std::string_view request, const ProveOptions& options);

/// Proves each; the outcomes are in the order of the statements, the same at any number of threads. An accepted
/// certificate is never given up: if `again` finds none, the old one is kept. Before any search, throws InputError with
/// the mistakes of all statements.
std::vector<FileOutcome> prove_files(const std::vector<StatementSource>& statements, const ProveOptions& options);

}  // namespace slipproof
