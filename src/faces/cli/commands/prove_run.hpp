// Proving many statements: each result is written and said as it comes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/output/inputs.hpp"
#include "claims/paper/claims_file.hpp"
#include "claims/paper/paper_folder.hpp"
#include "claims/statements/unstated.hpp"
#include "faces/cli/command.hpp"
#include "proofs/search/prove_files.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof::cli {

class ProveRun {
 public:
  /// No result is written over one of `inputs`, or over a statement that is to be proved.
  ProveRun(const ProveOptions& options, const CommonOptions& common, Inputs inputs = {});

  /// Proves the statements, and writes next to each its certificate, or why there is none.
  void prove(const std::vector<std::filesystem::path>& statements);
  /// Writes the statements of the claims to the folder for generated files, and proves them together with all others of
  /// the paper. If a statement is false, writes and proves that, too; if a claim could not be settled, tries to refute
  /// it. If the statements of a claim cannot be written or read, only this claim fails.
  void prove_claims(const ClaimsFile& file, const PaperFolder& paper);
  /// Says what came of all, and gives the exit code.
  Exit conclude();

 private:
  struct Stated;
  template <class Write>
  std::vector<NamedStatement> sound(const Claim& claim, const Write& write);
  std::vector<Stated> stated(const ClaimsFile& file);
  std::vector<NamedStatement> refutations(const ClaimsFile& file, const Stated& stated);
  const ProofOutcome* outcome(const std::string& theorem) const;
  void write(const FileOutcome& outcome) const;
  void say(const FileOutcome& outcome);
  void tell(const ProveProgress& progress) const;
  void note(const std::string& line);

  ProveOptions options_;
  const CommonOptions& common_;
  Inputs inputs_;
  bool shows_progress_;
  std::vector<FileOutcome> outcomes_;
  std::map<std::string, std::string> settled_;  ///< left undecided, and why that does not matter
  std::vector<std::string> outdated_;
  std::vector<UnstatedClaim> unstated_;
  std::vector<UnstatedClaim> failed_;  ///< what went wrong with a claim
};

}  // namespace slipproof::cli
