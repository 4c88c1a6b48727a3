#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/output/output_file.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/commands/papers/verify_run.hpp"
#include "faces/cli/interrupt.hpp"
#include "faces/cli/progress.hpp"
#include "faces/cli/warnings.hpp"
#include "mechanics/mechanism/names.hpp"
#include "report/papers/errata.hpp"
#include "report/papers/mutation_report.hpp"
#include "report/papers/verify_report.hpp"

namespace slipproof::cli {

namespace {

struct VerifyArguments : JudgeArguments {
  MutationOptions mutation;
  std::vector<std::string> papers;
  std::string lemmas, report;
  bool mutants = false;
  bool errata = false, sarif = false, coverage = false;
  bool names = false;

  bool lists_findings() const { return errata || sarif; }
};

/// Writes the lemmas as files that slipproof-check reads.
void write_lemmas(const OutputFolder& folder, const MutationResult& result) {
  std::size_t number = 0;
  for (const Lemma* lemma : lemmas_of(result)) {
    const std::string name = "lemma-" + std::to_string(++number);
    for (const auto& [extension, text] : {std::pair(".statement", &lemma->statement), {".cert", &lemma->certificate}}) {
      folder.write(name + extension, *text);
    }
  }
}

/// Refuses a report together with options that give no verdicts, because a report shows verdicts.
void refuse_report_without_verdicts(const VerifyArguments& options) {
  if (options.report.empty() || (!options.coverage && !options.mutants)) return;
  const std::string mode = options.coverage ? "--coverage" : "--mutants";
  throw CLI::ValidationError("--report", "the report shows verdicts, and " + mode + " gives none; leave " + mode +
                                             " out, or write the report in a call of its own");
}

/// Refuses a crew or a checkpoint with --mutants and --coverage, because a crew can only judge papers.
void refuse_crew_without_verdicts(const VerifyArguments& options) {
  if (!options.crew.wanted() || (!options.mutants && !options.coverage)) return;
  throw CLI::ValidationError(
      options.mutants ? "--mutants" : "--coverage",
      "found --checkpoint or many ranks, expected neither: this runs on one rank only, without a checkpoint");
}

int judge_mutants(const std::filesystem::path& claims, const ClaimsFile& file, VerifyArguments& options) {
  options.mutation.seed = options.common.seed;
  options.mutation.threads = options.common.threads;
  options.mutation.progress = progress_bar(!options.common.quiet);
  std::optional<OutputFolder> lemmas;
  if (!options.lemmas.empty()) lemmas.emplace(options.lemmas, Inputs{claims});
  const MutationResult result = judge_mutants(file, options.mutation);
  if (lemmas) write_lemmas(*lemmas, result);
  print_report(
      options.common, [&] { return mutation_json(result); }, [&] { return mutation_document(result); });
  return result.count(MutantEnd::survivor) == 0 && result.vacuous.empty() ? success : undecided;
}

/// The first option given that applies to one paper only; empty if there is none.
std::string flag_about_one_paper(const VerifyArguments& options) {
  if (options.mutants) return "--mutants";
  if (options.coverage) return "--coverage";
  return options.lists_findings() ? "--errata" : "";
}

/// The papers with a claim that --only asks for.
std::vector<std::filesystem::path> with_claims(std::vector<std::filesystem::path> papers, const std::string& only,
                                               const std::filesystem::path& folder) {
  if (only.empty()) return papers;
  std::erase_if(papers, [&](const std::filesystem::path& path) {
    const ClaimsFile file = read_claims(path);
    return std::none_of(file.claims.begin(), file.claims.end(), [&](const Claim& c) { return c.id.starts_with(only); });
  });
  if (!papers.empty()) return papers;
  throw InputError({{folder.string(), 0, 0, "found no claim whose id begins with '" + only + "' in its papers"}});
}

void expect_claim(const ClaimsFile& file, const std::string& only) {
  std::vector<std::string_view> ids;
  for (const Claim& claim : file.claims) {
    if (claim.id.starts_with(only)) return;
    ids.push_back(claim.id);
  }
  throw InputError({{file.file, 0, 0, "--only: " + unknown_name("claim", only, ids)}});
}

/// Verifies several papers, or all in a folder.
int verify_papers(const std::vector<std::filesystem::path>& papers, const VerifyArguments& options) {
  if (const std::string flag = flag_about_one_paper(options); !flag.empty()) {
    throw CLI::ValidationError(
        "CLAIMS", flag + " is about one paper; found a folder or several papers, expected one claims.toml");
  }
  const auto judged = judge_papers(papers, options, options.report);
  if (launched().rank != 0) return success;
  print_report(
      options.common, [&] { return papers_json(judged); }, [&] { return papers_document(judged); });
  return exit_of(summary(judged));
}

int run_verify(VerifyArguments& options, const CLI::Option& samples) {
  refuse_report_without_verdicts(options);
  refuse_crew_without_verdicts(options);
  std::vector<std::filesystem::path> paths;
  for (const std::string& paper : options.papers) paths.push_back(claims_path(paper));
  if (paths.empty()) paths.push_back(claims_path(""));
  std::filesystem::path path = paths.front();
  const auto papers = paths.size() == 1 ? papers_in(path) : papers_in(paths);
  const bool as_one = !options.verify.only.empty() || !flag_about_one_paper(options).empty();
  if (papers.size() > 1 || (papers.size() == 1 && !as_one)) {
    if (samples.empty()) options.verify.samples = samples_of_many;
    const std::filesystem::path named = paths.size() == 1 ? path : "CLAIMS";
    return verify_papers(with_claims(papers, options.verify.only, named), options);
  }
  if (papers.size() == 1) path = papers.front();
  const ClaimsFile file = read_claims(path);
  expect_claim(file, options.verify.only);
  print_warnings(file, options.common);
  if (options.coverage) {
    print(markdown_of(coverage_document(file)));
    return uncovered_equations(file).empty() ? success : refuted_or_not_certified;
  }
  if (options.mutants) {
    if (!samples.empty()) options.mutation.more_samples = options.verify.samples;
    if (options.verify.lines) options.mutation.lines = *options.verify.lines;
    return judge_mutants(path, file, options);
  }
  options.verify.certificates = options.certificates_of(path);
  VerifyRun run({{path, &file, options.verify}}, options);
  if (run.served()) return success;
  std::optional<OutputFile> report;
  PageInput input;
  if (!options.report.empty()) {
    report.emplace(options.report, files_of(page_folders(path, options.trade), file));
    expect_page_name("--report", options.report);
    input = report_input(path, file, options, *options.verify.certificates);
  }
  const VerifyResult result = run.result(0);
  input.result = &result;
  if (report) report->write(page_html(input));
  if (options.sarif) {
    print(errata_sarif(file, errata(file, result)));
  } else if (options.errata) {
    const Errata findings = errata(file, result);
    print_report(
        options.common, [&] { return errata_json(file, findings); }, [&] { return errata_document(file, findings); });
  } else {
    print_report(
        options.common, [&] { return verify_json(file, result); },
        [&] { return verify_document(file, result, options.names ? Names::all : Names::few); });
  }
  return exit_of(summary(file, result));
}

}  // namespace

void add_verify(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<VerifyArguments>();
  CLI::App& command =
      *app.add_subcommand("verify", "Judge the claims of a paper at sampled rational bicycles, every force at once");
  command.add_option("CLAIMS", options->papers,
                     "Claims files (TOML), or folders of papers; default: the shipped paper");
  auto* samples = add_judging_options(command, *options);
  auto* list = command.add_flag("--errata", options->errata, "List what is wrong with the paper");
  auto* sarif =
      command.add_flag("--sarif", options->sarif, "Write the errata as SARIF 2.1.0, for editors and code hosts");
  command.add_flag("--coverage", options->coverage, "List the claims of each numbered equation; judge nothing")
      ->excludes(list)
      ->excludes(sarif);
  auto* only = command.add_option("--only", options->verify.only,
                                  "Judge only the claims whose id begins with this, such as A or E4.7");
  auto* mutants = command.add_flag("--mutants", options->mutants,
                                   "Change every formula in every small way, and report which changes are noticed");
  mutants->excludes(list)->excludes(sarif)->excludes(only);
  command.add_option("--every", options->mutation.every, "Judge one mutant in this many")
      ->check(whole_number(1, 1'000'000'000))
      ->needs(mutants);
  command.add_option("--lemmas", options->lemmas, "Folder for the lemmas of the arguments, with certificates")
      ->needs(mutants);
  auto* report =
      command.add_option("--report", options->report,
                         "Also write the HTML report of the verdicts to this file; for several papers: to this folder");
  command.add_option("--trade", options->trade, "Output of slipproof trade --json, for the report")->needs(report);
  command.add_flag("--names", options->names, "Name all certificates of each claim, also where there are many");
  add_crew_options(command, options->crew);
  add_report_options(command, options->common);
  sarif->excludes("--markdown");
  add_examples(command, {"proofs/ladder/claims.toml --samples 200"});
  command.callback([options, samples, &exit_code] {
    exit_code = stoppable([&] { return run_verify(*options, *samples); },
                          [&] {
                            // A crew can only judge papers.
                            return options->mutants ? Continuation{"nothing is kept of --mutants"}
                                                    : by_checkpoint(options->crew);
                          });
  });
}

}  // namespace slipproof::cli
