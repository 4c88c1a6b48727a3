// What `verify` and `report` share: running a verification, and writing the page about it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/output/output_file.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/crew_run.hpp"
#include "report/html/page.hpp"
#include "report/papers/papers_report.hpp"
#include "report/papers/verify_report.hpp"

namespace slipproof::cli {

/// What both are asked for.
struct JudgeArguments {
  CommonOptions common;
  VerifyOptions verify;
  CrewArguments crew;
  std::string claims, trade;
  std::string second_checker;  ///< a program; empty: none is asked

  std::shared_ptr<Certificates> certificates_of(const std::filesystem::path& file) const {
    return std::make_shared<Certificates>(paper_folder(file), second_checker);
  }
};

/// A bar on a terminal, and nowhere else.
std::function<void(std::uint64_t, std::uint64_t)> progress_bar();

/// Verifies papers with the common options, and a progress bar on a terminal, by all ranks there are; says on standard
/// error which certificates are rejected.
class VerifyRun {
 public:
  struct Paper {
    std::filesystem::path path;
    const ClaimsFile* file;
    VerifyOptions options;
  };

  VerifyRun(std::vector<Paper> papers, const JudgeArguments& arguments);

  bool served() { return crew_->served(); }  ///< as CrewRun has it
  /// Of each paper once.
  VerifyResult result(std::size_t paper);

 private:
  struct Work {
    std::once_flag made;
    std::unique_ptr<Verification> verification;
  };
  Verification& verification(std::size_t paper);

  std::vector<Paper> papers_;
  std::vector<Work> works_;  ///< each is made when it is first asked for
  std::optional<CrewRun> crew_;
};

Exit exit_of(Summary summary);

/// The sources of the page's parts: what comes with the program, and a measurement of trade if there is one.
PageFolders page_folders(const std::filesystem::path& claims, const std::filesystem::path& trade);

/// What the page about a verification is made from, all but the result. It is read before the work, so that bad input
/// costs no result. Throws InputError.
PageInput report_input(const std::filesystem::path& claims, const ClaimsFile& file, const JudgeArguments& arguments,
                       Certificates& certificates);

/// The claims files of a folder and of the folders in it, in the order of their names. Nothing if the path is not a
/// folder. Throws InputError if there are none.
std::vector<std::filesystem::path> papers_in(const std::filesystem::path& path);

/// So many samples for each setting, where a folder is judged and no number is asked for.
inline constexpr std::uint64_t samples_of_many = 2000;

/// --samples, which is returned, --lines, and --second-checker.
CLI::Option* add_judging_options(CLI::App& command, JudgeArguments& arguments);

/// Judges each of them, on rank 0, and writes the page of each and that of all into a folder, if one is given.
std::vector<JudgedPaper> judge_papers(const std::vector<std::filesystem::path>& papers, const JudgeArguments& arguments,
                                      const std::filesystem::path& report);

}  // namespace slipproof::cli
