#include <unistd.h>

#include <iostream>
#include <memory>
#include <string>

#include "cli/command.hpp"
#include "report/verify_report.hpp"

namespace slipproof::cli {

namespace {

struct Options {
  CommonOptions common;
  VerifyOptions verify;
  std::string claims;
};

/// A bar on a terminal, and nowhere else.
std::function<void(std::uint64_t, std::uint64_t)> progress_bar() {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [shown = std::uint64_t{101}](std::uint64_t done, std::uint64_t all) mutable {
    const std::uint64_t percent = all == 0 ? 100 : done * 100 / all;
    if (percent == shown) return;
    shown = percent;
    std::cerr << "\r[" << std::string(percent / 2, '#') << std::string(50 - percent / 2, ' ') << "] " << percent << " %"
              << (done == all ? "\r\033[K" : "") << std::flush;
  };
}

}  // namespace

void add_verify(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App& command =
      *app.add_subcommand("verify", "The claims of a paper at sampled rational bicycles, every force at once");
  command.add_option("CLAIMS", options->claims, "Claims file (TOML); default: the shipped paper");
  command.add_option("--samples", options->verify.samples, "Bicycles for each setting of the paper")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}))
      ->capture_default_str();
  add_common_options(command, options->common);
  command.callback([options, &exit_code] {
    const ClaimsFile file = read_claims(options->claims.empty() ? shipped("proofs/rozenblat-yashin/claims.toml")
                                                                : std::filesystem::path(options->claims));
    options->verify.seed = options->common.seed;
    options->verify.threads = options->common.threads;
    if (!options->common.quiet) options->verify.progress = progress_bar();
    const VerifyResult result = verify(file, options->verify);
    print(options->common.json ? verify_json(file, result) : verify_text(file, result, options->common.quiet));
    switch (summary(file, result)) {
      case Summary::as_expected:
        exit_code = as_it_should_be;
        break;
      case Summary::refuted:
        exit_code = refuted_or_not_certified;
        break;
      case Summary::undecided:
        exit_code = undecided;
        break;
    }
  });
}

}  // namespace slipproof::cli
