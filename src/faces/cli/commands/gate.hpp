// What fails a run of `certify`, and where continuous integration reads it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/output/output_file.hpp"
#include "faces/cli/command.hpp"
#include "records/certify/certify.hpp"
#include "report/scenes/gate.hpp"

namespace slipproof::cli {

struct GateArguments {
  std::vector<std::string> fail_on;
  std::string junit, sarif;
  bool writes() const { return !junit.empty() || !sarif.empty(); }
  /// Whether records have to be looked at one by one.
  bool wanted() const { return writes() || !fail_on.empty(); }
};

void add_gate_options(CLI::App& command, GateArguments& options);

/// Refuses two results in one file, of which one would be lost. Empty names are passed over. Throws
/// CLI::ValidationError.
void refuse_one_file_twice(const std::vector<std::string>& files);

class Gate {
 public:
  /// Opens the files. Throws OutputError.
  Gate(const GateArguments& options, std::string file, const Inputs& inputs);

  void add(std::uint64_t record, const RecordJudgement& judgement) { run_.add(record, judgement, fails_); }
  /// Writes the files.
  void write();
  /// What fails, for a log; empty without --fail-on.
  std::string text() const { return asked_ ? gate_text(run_) : ""; }
  /// With --fail-on whether anything of it occurred; otherwise what would be without a gate.
  int exit_code(const CertifySummary& summary, int without) const;
  int exit_code(int without) const;

 private:
  bool asked_;
  FailingVerdicts fails_;
  GateRun run_;
  std::optional<OutputFile> junit_, sarif_;
};

}  // namespace slipproof::cli
