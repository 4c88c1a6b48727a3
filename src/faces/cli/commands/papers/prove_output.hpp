// Where the results of `prove` go: certificates beside statements that are files of their own, at once; theorem files
// whole.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/output/inputs.hpp"
#include "proofs/search/prove_files.hpp"
#include "proofs/statement/theorems.hpp"

namespace slipproof::cli {

/// What is different in a theorem file that was written.
struct TheoremChanges {
  std::filesystem::path file;
  std::size_t added = 0, changed = 0, as_before = 0;
  std::vector<std::string> removed{};
};

class ProveOutput {
 public:
  /// Results must not overwrite one of `inputs`.
  explicit ProveOutput(Inputs inputs) : inputs_(std::move(inputs)) {}

  /// Throws as OutputFile does if the certificate of a statement could not be written.
  void prepare(const std::vector<StatementSource>& statements);
  /// What a theorem file contains from now on, until it is written anew. Compares with the file as it is on the disk.
  void contain(const std::filesystem::path& file, TheoremFile contents);
  const TheoremFile& contents(const std::filesystem::path& file) { return target(file).now; }
  /// Writes a certificate. Theorem files are written now and then, so that a stopped search loses little.
  void put(const std::filesystem::path& statement, const std::string& certificate);
  /// Writes the theorem files that have changed.
  void save();
  /// The theorem files that are different from those at the beginning.
  std::vector<TheoremChanges> changes() const;

 private:
  struct Target {
    TheoremFile before, now;
    bool written = true;  ///< what is on the disk is `now`
  };
  Target& target(const std::filesystem::path& file);

  Inputs inputs_;
  std::map<std::filesystem::path, Target> targets_;
  std::chrono::steady_clock::time_point saved_ = std::chrono::steady_clock::now();
};

}  // namespace slipproof::cli
