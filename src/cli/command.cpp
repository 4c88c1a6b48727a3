#include "cli/command.hpp"

#include <cmath>

namespace slipproof::cli {

void add_common_options(CLI::App& command, CommonOptions& options) {
  command.add_flag("--json", options.json, "JSON on standard output");
  command.add_option("--seed", options.seed, "Seed of everything random")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--threads", options.threads, "Number of threads; 0: all cores")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  command.add_flag("--quiet", options.quiet, "The result only: no progress, no details");
}

CLI::Validator number_in(double low, double high) {
  CLI::Validator range = CLI::Range(low, high);
  const std::string description = range.get_description();
  return CLI::Validator(
      [range, description](std::string& text) {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && std::isnan(value)) return "Value NaN not in range " + description;
        return range(text);
      },
      description);
}

std::filesystem::path shipped(const std::filesystem::path& file) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    const auto installed = program.parent_path().parent_path() / SLIPPROOF_DATA_DIRECTORY / file;
    if (std::filesystem::exists(installed, error)) return installed;
  }
  return std::filesystem::path(SLIPPROOF_SOURCE_DIRECTORY) / file;
}

std::filesystem::path claims_path(const std::string& argument) {
  return argument.empty() ? shipped("proofs/rozenblat-yashin/claims.toml") : std::filesystem::path(argument);
}

}  // namespace slipproof::cli
