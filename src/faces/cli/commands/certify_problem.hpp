// `slipproof certify PROBLEM`: answers to contact problems at real size.
#pragma once

#include <optional>
#include <string>

#include "base/number/effort.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/commands/gate.hpp"
#include "records/problems/contact_file.hpp"

namespace slipproof::cli {

struct CertifyProblemArguments {
  std::string file, answer, certificate, check_certificate, report, refined;
  std::string law;  ///< empty: that of the problem
  std::optional<double> tolerance, within;
  std::optional<Work> effort;
  bool refine = false, all = false;
  /// Whether an option was given that only a file with one problem has, or only problems have.
  bool any_of_one() const {
    return !answer.empty() || !certificate.empty() || !check_certificate.empty() || !report.empty() || refine;
  }
  bool any() const { return any_of_one() || within || !law.empty() || all; }
  /// What the options say about every contact problem, in a file or in a line.
  ContactFileOptions judging() const;
};

/// Adds these options to `certify`.
void add_problem_options(CLI::App& command, CertifyProblemArguments& options);

/// Judges the answers, prints a line for each and a summary in words, and writes the requested files. Throws InputError
/// and OutputError. Returns the exit code.
int run_certify_problem(const CertifyProblemArguments& options, const GateArguments& gate, const CommonOptions& common);

}  // namespace slipproof::cli
