#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "faces/cli/command.hpp"
#include "proofs/check/files.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof::cli {

namespace {

struct CheckArguments {
  CommonOptions common;
  std::vector<std::string> certificates;
  std::optional<std::string> show;
};

/// Prints a part of a theorem file.
int show(const CheckArguments& options) {
  if (options.certificates.size() != 1)
    throw CLI::ValidationError("--show", "found several files, expected one theorem file");
  const check::Shown part = check::show_part(*options.show, options.certificates.front());
  if (!part.problem.empty()) throw InputError({{"", 0, 0, part.problem}});
  print(part.text);
  return success;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CheckArguments>();
  CLI::App& command =
      *app.add_subcommand("check", "Check certificates against their statements, as slipproof-check does");
  command
      .add_option("CERT", options->certificates, "Certificates, their statements, theorem files, or folders of them")
      ->required();
  command.add_option("--show", options->show,
                     "Do not check; print this part of a theorem file: NAME.statement, NAME.cert, NAME for both, or "
                     "claims.canonical");
  add_common_options(command, options->common);
  add_examples(command, {"proofs/ladder"});
  command.callback([options, &exit_code] {
    if (options->show) {
      exit_code = show(*options);
      return;
    }
    const check::Report report = check::check_files(options->certificates);
    exit_code = report.exit_code;
    if (!options->common.json) return print((options->common.quiet ? "" : report.text) + report.summary);
    Json document, results = Json::array();
    for (const check::FileResult& result : report.results) {
      Json entry;
      entry["certificate"] = result.certificate.string();
      entry["theorem"] = result.theorem;
      entry["verdict"] = check::to_string(result.verdict);
      entry["message"] = result.message;
      results.push_back(std::move(entry));
    }
    document["schema"] = "slipproof/check/1";
    document["certificates"] = std::move(results);
    print(dump(document));
  });
}

}  // namespace slipproof::cli
