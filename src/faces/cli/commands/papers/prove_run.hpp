// Proves many statements. Writes and reports each result as it comes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/output/inputs.hpp"
#include "claims/paper/claims_file.hpp"
#include "claims/reading/paper_folder.hpp"
#include "claims/statements/unstated.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/progress.hpp"
#include "proofs/search/prove_files.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof::cli {

class ProveRun {
 public:
  /// Results must not overwrite one of `inputs`, or a statement that is to be proved.
  ProveRun(const ProveOptions& options, const CommonOptions& common, Inputs inputs = {});

  /// Proves the statements, and writes for each its certificate, or why there is none, to the folder of the statement.
  void prove(const std::vector<std::filesystem::path>& statements);
  /// Writes the statements of the claims to the folder for generated files, and proves them together with all other
  /// statements of the paper. If a statement is false, also writes and proves its refutation. If a claim is not
  /// settled, tries to refute it. If the statements of a claim cannot be written or read, only this claim fails.
  void prove_claims(const ClaimsFile& file, const PaperFolder& paper);
  /// Reports the results of all statements, and returns the exit code.
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
  void tell(const ProveProgress& progress);
  void note(const std::string& line);

  ProveOptions options_;
  const CommonOptions& common_;
  Inputs inputs_;
  ProgressLine line_;
  std::vector<FileOutcome> outcomes_;
  std::map<std::string, std::string> settled_;  ///< undecided statements, and why they do not matter
  std::vector<std::string> outdated_;
  std::vector<UnstatedClaim> unstated_;
  std::vector<UnstatedClaim> failed_;  ///< claims with an error
};

}  // namespace slipproof::cli
