// What `verify` and `report` share: running a verification, and writing the page about it.
#pragma once

#include <filesystem>
#include <functional>

#include "cli/command.hpp"
#include "html/page.hpp"
#include "wording/verify_report.hpp"

namespace slipproof::cli {

/// A bar on a terminal, and nowhere else.
std::function<void(std::uint64_t, std::uint64_t)> progress_bar();

/// Verifies with the common options, and a progress bar on a terminal; says on standard error which certificates are
/// rejected.
VerifyResult run_verify(const ClaimsFile& file, VerifyOptions options, const CommonOptions& common);

Exit exit_of(Summary summary);

/// Where the parts of the page come from: what comes with the program, and a measurement of trade if there is one.
PageFolders page_folders(const std::filesystem::path& claims, const std::filesystem::path& trade);

/// What the page about a verification is made from, all but the result. It is read before the work, so that bad input
/// costs no result. Throws InputError.
PageInput report_input(const std::filesystem::path& claims, const ClaimsFile& file, const VerifyOptions& options,
                       const CommonOptions& common, const std::filesystem::path& trade);

}  // namespace slipproof::cli
