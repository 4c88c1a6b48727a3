#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "base/os/sha256.hpp"
#include "base/output/output_file.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/commands/explore.hpp"
#include "faces/cli/commands/papers/verify_run.hpp"
#include "faces/cli/warnings.hpp"
#include "report/engines/engine_pages.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof::cli {

namespace {

struct ReportArguments : JudgeArguments {
  std::string out;
};

/// Reports on what engines answered: a page for all, one for each class of scenes and one for each scene.
int report_engines(const std::filesystem::path& folder, const ReportArguments& options, const CLI::App& command) {
  if (options.out == "-") throw CLI::ValidationError("--out", "found -, expected a folder: engines have many pages");
  for (const char* name : {"--only", "--samples", "--lines", "--second-checker", "--trade", "--address"}) {
    if (command.count(name) > 0) {
      throw CLI::ValidationError(name, "found a folder of engines, expected claims, which this option is for");
    }
  }
  const OutputFolder pages(options.out, {explorer_file()});
  const std::string explorer = copy_explorer(pages);
  const EngineResults results = engine_results(judge_engines(folder));
  std::size_t count = 0;
  write_engine_pages(results, folder.generic_string(), SLIPPROOF_VERSION, explorer,
                     [&](const auto& name, const auto& html) {
                       pages.write(name, html);
                       count += name.ends_with(".html") ? 1 : 0;
                     });
  print(options.common.json ? engine_table_json(results) : fmt::format("s REPORTED {} {} pages\n", options.out, count));
  return success;
}

/// Reports on all papers in a folder: a page for each, and one for all.
int report_papers(const std::vector<std::filesystem::path>& papers, const ReportArguments& options) {
  if (options.out == "-" || options.out.ends_with(".html")) {
    throw CLI::ValidationError("--out", "found " + options.out + ", expected a folder to write: " +
                                            std::to_string(papers.size()) + " papers have a page each");
  }
  if (!options.verify.only.empty()) {
    throw CLI::ValidationError("--only", "a folder of papers has a page for each, expected one claims.toml");
  }
  const auto judged = judge_papers(papers, options, options.out);
  if (options.common.json) {
    print(papers_json(judged));
  } else {
    print(fmt::format("s REPORTED {} {} pages\n", options.out, judged.size() + 1));
  }
  return exit_of(summary(judged));
}

}  // namespace

void add_report(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ReportArguments>();
  CLI::App& command =
      *app.add_subcommand("report", "Write one self-contained HTML file with verdicts, proofs and pictures");
  command.add_option("CLAIMS", options->claims,
                     "Claims file (TOML), or a folder of papers, or one of engines and their scenes; default: the "
                     "shipped paper");
  command.add_option("--out", options->out,
                     "The file to write; default: report.html; - for standard output. For a folder: the "
                     "folder to write; default: report");
  auto* samples = add_judging_options(command, *options);
  command.add_option("--only", options->verify.only,
                     "Judge only the claims whose id begins with this, such as A or E4.7");
  command.add_option("--trade", options->trade,
                     "Output of slipproof trade --json, for the section on speed and accuracy");
  command
      .add_option("--address", options->address,
                  "Where a folder of pages will be published, https://...: each page then names a picture of its worst "
                  "finding for those who share it")
      ->check([](const std::string& text) {
        const bool web = text.starts_with("https://") || text.starts_with("http://");
        return web ? std::string() : "found " + text + ", expected an address, https://...";
      });
  add_common_options(command, options->common);
  add_examples(command, {"proofs/ladder/claims.toml --samples 200 --out report.html"});
  command.callback([options, samples, &command, &exit_code] {
    std::filesystem::path path = claims_path(options->claims);
    if (is_engines_folder(path)) {
      if (options->out.empty()) options->out = "report";
      exit_code = report_engines(path, *options, command);
      return;
    }
    auto papers = papers_in(path);
    const bool one_page = options->out == "-" || options->out.ends_with(".html") || !options->verify.only.empty();
    if (!options->address.empty() && (papers.empty() || one_page)) {
      throw CLI::ValidationError("--address",
                                 "a page in one file has no picture beside it, expected a folder of papers");
    }
    if (papers.size() == 1 && one_page) {
      path = papers.front();
      papers.clear();
    }
    if (options->out.empty()) options->out = papers.empty() ? "report.html" : "report";
    if (!papers.empty()) {
      if (samples->empty()) options->verify.samples = samples_of_many;
      exit_code = report_papers(papers, *options);
      return;
    }
    const ClaimsFile file = read_claims(path);
    print_warnings(file, options->common);
    options->verify.certificates = options->certificates_of(path);
    std::optional<OutputFile> out;
    if (options->out != "-") out.emplace(options->out, files_of(page_folders(path, options->trade), file));
    expect_page_name("--out", options->out);
    PageInput input = report_input(path, file, *options, *options->verify.certificates);
    const VerifyResult result = VerifyRun({{path, &file, options->verify}}, *options).result(0);
    input.result = &result;
    const std::string html = page_html(input);
    exit_code = exit_of(summary(file, result));
    if (!out) return print(html);
    out->write(html);
    if (options->common.json) {
      Json document;
      document["schema"] = "slipproof/report/1";
      document["file"] = options->out;
      document["bytes"] = html.size();
      document["sha256"] = sha256(html);
      return print(dump(document));
    }
    print(fmt::format("s REPORTED {} {} bytes\n", options->out, html.size()));
  });
}

}  // namespace slipproof::cli
