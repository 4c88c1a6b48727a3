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
#include "faces/cli/commands/papers/prove_output.hpp"
#include "faces/cli/progress.hpp"
#include "proofs/search/prove_files.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof::cli {

class ProveRun {
 public:
  /// Results must not overwrite one of `inputs`, or a statement that is to be proved.
  ProveRun(const ProveOptions& options, const CommonOptions& common, Inputs inputs = {});

  /// Throws as OutputFile does if the theorem file could not be written, and InputError if there is another file.
  void reserve(const std::filesystem::path& file) { output_.contents(file); }
  /// What a theorem file will contain when it is written, unless prove_claims() says otherwise.
  void contain(const std::filesystem::path& file, TheoremFile contents);
  /// Proves the statements, and writes for each its certificate, or why there is none, to its folder or theorem file.
  void prove(const std::vector<StatementSource>& statements);
  /// Proves the statements of the claims together with those that were written by hand. If a statement is false, also
  /// proves its refutation. If a claim is not settled, tries to refute it. If the statements of a claim cannot be
  /// written or read, only this claim fails. The theorem file then has these statements and no others.
  void prove_claims(const ClaimsFile& file, const PaperFolder& paper, const std::vector<StatementSource>& by_hand);
  /// Writes the theorem files and what has changed in them, reports the results of all statements, and returns the exit
  /// code.
  Exit conclude();

 private:
  struct Stated;
  template <class Write>
  std::vector<NamedStatement> sound(const Claim& claim, const Write& write);
  std::vector<Stated> stated(const ClaimsFile& file);
  std::vector<NamedStatement> refutations(const ClaimsFile& file, const Stated& stated);
  const ProofOutcome* outcome(const std::string& theorem) const;
  TheoremFile arranged(const ClaimsFile& file, const std::vector<Stated>& all, const TheoremFile& found) const;
  void keep_proved(const ClaimsFile& file, std::vector<Stated>& all, const TheoremFile& found) const;
  std::vector<StatementSource> sources(const std::vector<NamedStatement>& statements,
                                       const std::filesystem::path& theorems);
  void write(const FileOutcome& outcome);
  void say(const FileOutcome& outcome);
  void tell(const ProveProgress& progress);
  void note(const std::string& line);
  void save();

  ProveOptions options_;
  const CommonOptions& common_;
  ProveOutput output_;
  ProgressLine line_;
  std::vector<FileOutcome> outcomes_;
  std::map<std::string, std::string> settled_;  ///< undecided statements, and why they do not matter
  std::vector<TheoremChanges> changes_;
  std::vector<UnstatedClaim> unstated_;
  std::vector<UnstatedClaim> failed_;  ///< claims with an error
};

}  // namespace slipproof::cli
