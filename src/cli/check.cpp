#include <memory>
#include <string>
#include <vector>

#include "check/files.hpp"
#include "cli/command.hpp"
#include "report/exact_json.hpp"

namespace slipproof::cli {

namespace {

struct Options {
  CommonOptions common;
  std::vector<std::string> certificates;
};

std::string_view name(check::Verdict verdict) {
  constexpr std::array<std::string_view, 3> names{"accepted", "rejected", "unreadable"};
  return names[static_cast<std::size_t>(verdict)];
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App& command =
      *app.add_subcommand("check", "Certificates against their statements; slipproof-check does the same");
  command.add_option("CERT", options->certificates, "Certificates, or folders of them")->required();
  add_common_options(command, options->common);
  command.callback([options, &exit_code] {
    std::array<std::size_t, 3> count{};
    Json document, results = Json::array();
    std::string text;
    const auto add = [&](const check::FileResult& result) {
      ++count[static_cast<std::size_t>(result.verdict)];
      const bool accepted = result.verdict == check::Verdict::accepted;
      text += std::string(name(result.verdict)) + ' ' + (accepted ? result.theorem : result.message) + '\n';
      Json entry;
      entry["certificate"] = result.certificate.string();
      entry["theorem"] = result.theorem;
      entry["verdict"] = name(result.verdict);
      entry["message"] = result.message;
      results.push_back(std::move(entry));
    };
    for (const std::string& argument : options->certificates) {
      const auto certificates = check::certificates_in(argument);
      if (certificates.empty()) {
        check::FileResult nothing;
        nothing.certificate = argument;
        nothing.message = argument + ": no statements in this folder";
        add(nothing);
      }
      for (const auto& certificate : certificates) add(check::check_file(certificate));
    }
    const auto [accepted, rejected, unreadable] = count;
    exit_code = rejected > 0 ? certificate_rejected : unreadable > 0 ? bad_input : as_it_should_be;
    if (options->common.json) {
      document["schema"] = "slipproof/check/1";
      document["certificates"] = std::move(results);
      return print(dump(document));
    }
    if (options->common.quiet) text.clear();
    print(text +
          (rejected > 0     ? "s REJECTED "
           : unreadable > 0 ? "s UNREADABLE "
                            : "s ACCEPTED ") +
          std::to_string(accepted) + " accepted, " + std::to_string(rejected) + " rejected, " +
          std::to_string(unreadable) + " unreadable\n");
  });
}

}  // namespace slipproof::cli
