// What `verify` and `report` share: running a verification, and writing the page about it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "cli/command.hpp"
#include "report/verify_report.hpp"

namespace slipproof::cli {

/// The claims file that is asked for, or the shipped paper's.
std::filesystem::path claims_path(const std::string& argument);

/// A bar on a terminal, and nowhere else.
std::function<void(std::uint64_t, std::uint64_t)> progress_bar();

/// Verifies with the common options, and a progress bar on a terminal; looks for certificates beside the claims, and
/// says on standard error which are rejected.
VerifyResult run_verify(const std::filesystem::path& claims, const ClaimsFile& file, VerifyOptions options,
                        const CommonOptions& common);

Exit exit_of(Summary summary);

/// The page about a verification, with all that comes with the program, and a measurement of trade if there is one.
std::string report_html(const std::filesystem::path& claims, const ClaimsFile& file, const VerifyResult& result,
                        const std::string& only, const std::filesystem::path& trade);

/// Writes a file whole. Throws InputError.
void write_report(const std::filesystem::path& path, const std::string& contents);

}  // namespace slipproof::cli
