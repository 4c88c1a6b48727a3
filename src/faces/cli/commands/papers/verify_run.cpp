#include "faces/cli/commands/papers/verify_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "base/input/diagnostic.hpp"
#include "base/output/percent.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "faces/cli/commands/explore.hpp"
#include "faces/cli/png.hpp"
#include "faces/cli/progress.hpp"
#include "faces/cli/warnings.hpp"
#include "report/html/gallery.hpp"
#include "report/html/headline.hpp"

namespace slipproof::cli {

namespace {

std::string verified_work(const std::vector<VerifyRun::Paper>& papers) {
  std::string text = "verify\n";
  for (const auto& [path, file, options] : papers) {
    text += fmt::format("{} samples {} lines {} seed {} only {}\n", digest_of(path), options.samples,
                        options.line_count(), options.seed, options.only);
    for (const Setting& setting : file->settings) text += "mechanism " + digest_of(setting.mechanism->file) + '\n';
  }
  return text;
}

}  // namespace

VerifyRun::VerifyRun(std::vector<Paper> papers, const JudgeArguments& arguments)
    : papers_(std::move(papers)), works_(papers_.size()) {
  Inputs inputs;
  for (Paper& paper : papers_) {
    paper.options.seed = arguments.common.seed;
    paper.options.threads = arguments.common.threads;
    paper.options.progress = progress_bar(!arguments.common.quiet);
    inputs.add(paper.path);
  }
  crew_ = crew_of(
      arguments.crew, arguments.common.threads, [&] { return verified_work(papers_); }, inputs,
      [this](std::string_view request) { return verification(Verification::paper_of(request)).answer(request); });
}

Verification& VerifyRun::verification(std::size_t paper) {
  Work& work = works_.at(paper);
  std::call_once(work.made, [&] {
    work.verification = std::make_unique<Verification>(*papers_[paper].file, papers_[paper].options, paper);
  });
  return *work.verification;
}

VerifyResult VerifyRun::result(std::size_t paper) {
  VerifyResult result = verification(paper).result(crew_.get());
  for (const ClaimResult& claim : result.claims) {
    for (const std::string& objection : claim.rejections) std::cerr << "certificate rejected: " << objection << '\n';
  }
  return result;
}

CLI::Option* add_judging_options(CLI::App& command, JudgeArguments& arguments) {
  VerifyOptions& options = arguments.verify;
  auto* samples = command.add_option("--samples", options.samples,
                                     "Bicycles, or points of a mechanism, for each setting of the paper; for a folder "
                                     "of papers: " +
                                         std::to_string(samples_of_many) + "; for mutants: those that survive 400");
  samples->check(whole_number(1, 1'000'000'000))->capture_default_str();
  command
      .add_option("--lines", options.lines,
                  "Lines of bicycles for each claim, 0 for none; default: one for 200 samples, and 64 for a mutant")
      ->check(whole_number(0, 1'000'000));
  command.add_option(
      "--second-checker", arguments.second_checker,
      "A program that must also accept each certificate, such as slipproof-check-verified; or judge claims, "
      "too, as slipproof-judge-verified does");
  return samples;
}

Exit exit_of(Summary summary) {
  switch (summary) {
    case Summary::rejected:
      return certificate_rejected;
    case Summary::refuted:
      return refuted_or_not_certified;
    case Summary::undecided:
      return undecided;
    case Summary::as_expected:
      break;
  }
  return success;
}

namespace {

bool is_shipped(const std::filesystem::path& claims) {
  std::error_code error;
  return std::filesystem::equivalent(claims, claims_path(""), error);
}

}  // namespace

PageFolders page_folders(const std::filesystem::path& claims, const std::filesystem::path& trade) {
  PageFolders folders{claims, shipped("cases/city-bicycle.toml"), {}, {}, trade};
  // Our scenes and solvers' answers to them do not belong in a report on somebody else's paper.
  if (is_shipped(claims)) folders.cases = shipped("cases"), folders.solvers = shipped("cases/solvers");
  return folders;
}

PageInput report_input(const std::filesystem::path& claims, const ClaimsFile& file, const JudgeArguments& arguments,
                       Certificates& certificates) {
  const VerifyOptions& options = arguments.verify;
  const std::filesystem::path trade = arguments.trade;
  PageInput input = gather(page_folders(claims, trade), file, certificates);
  input.command = "slipproof report" + (is_shipped(claims) ? "" : " " + claims.filename().string()) + " --samples " +
                  std::to_string(options.samples) +
                  (options.lines ? " --lines " + std::to_string(*options.lines) : "") + " --seed " +
                  std::to_string(arguments.common.seed);
  if (!options.only.empty()) input.command += " --only " + options.only;
  if (!trade.empty()) input.command += " --trade " + trade.filename().string();
  if (const auto second = certificates.second_checker()) input.command += " --second-checker " + second->name;
  input.version = SLIPPROOF_VERSION;
  return input;
}

/// The name of a paper among others: its folder, with the name of the claims file if the folder has several.
std::string paper_name(const std::filesystem::path& claims) {
  const std::string folder = std::filesystem::absolute(claims).parent_path().filename().string();
  return paper_folder(claims).is_main ? folder : folder + "." + claims.stem().string();
}

std::vector<std::filesystem::path> papers_in(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return {};
  std::vector<std::filesystem::path> papers;
  const auto add = [&](const std::filesystem::path& folder) {
    for (std::filesystem::path& claims : claims_files_in(folder)) papers.push_back(std::move(claims));
  };
  add(path);
  for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
    if (entry.is_directory(error)) add(entry.path());
  }
  std::sort(papers.begin(), papers.end());
  if (!papers.empty()) return papers;
  throw InputError(
      {{path.string(), 0, 0, "found no claims.toml in the folder or in the folders in it, and no other claims file"}});
}

std::vector<std::filesystem::path> papers_in(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::filesystem::path> papers;
  std::set<std::string> names;
  for (const std::filesystem::path& path : paths) {
    auto found = papers_in(path);
    if (found.empty()) found.push_back(path);
    for (std::filesystem::path& paper : found) {
      const std::string name = paper_name(paper);
      if (!names.insert(name).second) {
        throw InputError({{paper.string(), 0, 0, "found a second paper called '" + name + "', expected another name"}});
      }
      papers.push_back(std::move(paper));
    }
  }
  return papers;
}

namespace {

/// Draws the worst finding of a paper for those who share its page. Returns the picture's address; empty if there is no
/// such finding, or if the pages are not published.
std::string shared_picture(const OutputFolder& pages, const JudgedPaper& paper, std::string address) {
  const ClaimResult* worst = address.empty() ? nullptr : worst_refuted(paper.file, paper.result);
  if (worst == nullptr) return "";
  const std::string name = paper.name + ".png";
  pages.write(name, png_of(worst_motions_svg(*worst)));
  if (!address.ends_with('/')) address += '/';
  return address + percent_encoded(name);
}

}  // namespace

std::vector<JudgedPaper> judge_papers(const std::vector<std::filesystem::path>& papers, const JudgeArguments& arguments,
                                      const std::filesystem::path& report) {
  std::vector<JudgedPaper> judged;
  Inputs inputs;
  for (const std::filesystem::path& path : papers) {
    judged.push_back({paper_name(path), read_claims(path), {}});
    print_warnings(judged.back().file, arguments.common);
    for (const auto& file : files_of(page_folders(path, arguments.trade), judged.back().file)) inputs.add(file);
  }
  std::vector<JudgeArguments> own(papers.size(), arguments);
  std::vector<VerifyRun::Paper> work;
  for (std::size_t i = 0; i < papers.size(); ++i) {
    own[i].verify.certificates = arguments.certificates_of(papers[i]);
    if (!is_shipped(papers[i])) own[i].trade.clear();
    work.push_back({papers[i], &judged[i].file, own[i].verify});
  }
  VerifyRun run(std::move(work), arguments);
  if (run.served()) return {};
  std::optional<OutputFolder> pages;
  if (!report.empty()) {
    inputs.add(explorer_file());
    pages.emplace(report, inputs);
  }
  const std::string explorer = pages ? copy_explorer(*pages) : "";
  std::vector<PageInput> pages_of(papers.size());  // read before the work, so that bad input does not lose results
  for (std::size_t i = 0; pages && i < papers.size(); ++i) {
    pages_of[i] = report_input(papers[i], judged[i].file, own[i], *own[i].verify.certificates);
    pages_of[i].gallery = "index.html";
    pages_of[i].explorer = explorer;
  }
  for (std::size_t i = 0; i < papers.size(); ++i) {
    judged[i].result = run.result(i);
    if (!pages) continue;
    pages_of[i].result = &judged[i].result;
    pages_of[i].image = shared_picture(*pages, judged[i], arguments.address);
    pages->write(page_name(judged[i]), page_html(pages_of[i]));
  }
  const auto image = std::ranges::find_if(pages_of, [](const PageInput& page) { return !page.image.empty(); });
  if (pages)
    pages->write("index.html", gallery_html(judged, SLIPPROOF_VERSION, image == pages_of.end() ? "" : image->image));
  return judged;
}

}  // namespace slipproof::cli
