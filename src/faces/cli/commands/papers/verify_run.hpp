// The common part of `verify` and `report`: running a verification, and writing its page.
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

/// The options that both have.
struct JudgeArguments {
  CommonOptions common;
  VerifyOptions verify;
  CrewArguments crew;
  std::string claims, trade;
  std::string second_checker;  ///< a program; empty: there is none
  std::string address;         ///< where a folder of pages will be published; empty: nowhere

  std::shared_ptr<Certificates> certificates_of(const std::filesystem::path& file) const {
    return std::make_shared<Certificates>(paper_folder(file), second_checker);
  }
};

/// Verifies papers with the common options on all ranks, with a progress bar on a terminal. Reports rejected
/// certificates on standard error.
class VerifyRun {
 public:
  struct Paper {
    std::filesystem::path path;
    const ClaimsFile* file;
    VerifyOptions options;
  };

  VerifyRun(std::vector<Paper> papers, const JudgeArguments& arguments);

  bool served() { return crew_ && crew_->serve(); }  ///< as Crew::serve(); false without a crew
  /// The result for a paper; call once for each.
  VerifyResult result(std::size_t paper);

 private:
  struct Work {
    std::once_flag made;
    std::unique_ptr<Verification> verification;
  };
  Verification& verification(std::size_t paper);

  std::vector<Paper> papers_;
  std::vector<Work> works_;  ///< each is made at its first use
  std::unique_ptr<Crew> crew_;
};

Exit exit_of(Summary summary);

/// The sources of the page's parts: files that come with the program, and a measurement of trade if there is one.
PageFolders page_folders(const std::filesystem::path& claims, const std::filesystem::path& trade);

/// The input of the page about a verification, except the result. It is read before the work, so that bad input does
/// not lose results. Throws InputError.
PageInput report_input(const std::filesystem::path& claims, const ClaimsFile& file, const JudgeArguments& arguments,
                       Certificates& certificates);

/// The claims files of a folder and its subfolders, by name. Nothing if the path is not a folder. Throws InputError if
/// there are none.
std::vector<std::filesystem::path> papers_in(const std::filesystem::path& path);
/// The same of several paths, in their order; a path that is not a folder is one paper. Throws InputError for a name
/// that two papers have, as each is reported by its name.
std::vector<std::filesystem::path> papers_in(const std::vector<std::filesystem::path>& paths);

/// The number of samples for each setting if a folder is judged and no number is given.
inline constexpr std::uint64_t samples_of_many = 2000;

/// Adds --samples, --lines and --second-checker; returns --samples.
CLI::Option* add_judging_options(CLI::App& command, JudgeArguments& arguments);

/// Judges the papers on rank 0, and writes a page for each and one for all into the folder, if one is given.
std::vector<JudgedPaper> judge_papers(const std::vector<std::filesystem::path>& papers, const JudgeArguments& arguments,
                                      const std::filesystem::path& report);

}  // namespace slipproof::cli
