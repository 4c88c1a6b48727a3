#include "faces/cli/commands/gate.hpp"

#include <filesystem>
#include <set>
#include <stdexcept>

namespace slipproof::cli {

void add_gate_options(CLI::App& command, GateArguments& options) {
  const auto group = command.add_option_group("Continuous integration", "what fails, and where it is read");
  group
      ->add_option(
          "--fail-on", options.fail_on,
          "Verdicts that end with exit code 1, others with 0: some of ambiguous (or not proved to be the only "
          "solution), "
          "inaccurate, eps-solution, wrong, undecided, with commas; invalid ones always do. Without it all are told "
          "by their own "
          "exit codes")
      ->delimiter(',')
      ->check([](const std::string& word) {
        try {
          FailingVerdicts({word});
          return std::string();
        } catch (const std::invalid_argument&) {
          return "found " + word + ", expected ambiguous, inaccurate, eps-solution, wrong, invalid or undecided";
        }
      });
  const auto named = [](const std::string& file) {
    return file.empty() ? std::string("found an empty name, expected a file") : std::string();
  };
  group->add_option("--junit", options.junit, "Write what fails to this file, as JUnit's XML")->check(named);
  group->add_option("--sarif", options.sarif, "Write what fails to this file, as SARIF 2.1.0")->check(named);
}

void refuse_one_file_twice(const std::vector<std::string>& files) {
  std::set<std::filesystem::path> seen;
  for (const std::string& file : files) {
    if (file.empty() || file.starts_with("/dev/")) continue;
    if (seen.insert(std::filesystem::weakly_canonical(file)).second) continue;
    throw CLI::ValidationError(file, "found for two results, expected a file for each");
  }
}

Gate::Gate(const GateArguments& options, std::string file, const Inputs& inputs) : asked_(!options.fail_on.empty()) {
  if (asked_) fails_ = FailingVerdicts(options.fail_on);
  run_.file = std::move(file);
  if (!options.junit.empty()) junit_.emplace(options.junit, inputs);
  if (!options.sarif.empty()) sarif_.emplace(options.sarif, inputs);
}

void Gate::write() {
  if (junit_) junit_->write(junit(run_));
  if (sarif_) sarif_->write(sarif(run_));
}

int Gate::exit_code(const CertifySummary& summary, int without) const {
  if (!asked_) return without;
  if (summary.records == 0) return refuted_or_not_certified;  // nothing has been looked at
  return fails_(summary) ? refuted_or_not_certified : success;
}

int Gate::exit_code(int without) const {
  if (!asked_) return without;
  return run_.failed > 0 ? refuted_or_not_certified : success;
}

}  // namespace slipproof::cli
