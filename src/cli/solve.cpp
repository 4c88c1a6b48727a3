#include <memory>
#include <string>

#include "cli/command.hpp"
#include "model/scene.hpp"
#include "wording/solve_report.hpp"

namespace slipproof::cli {

namespace {

struct SolveArguments {
  CommonOptions common;
  SolveReportOptions report;
  std::string scene;
};

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  return text.substr(text.rfind('\n', end) + 1);
}

}  // namespace

void add_solve(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SolveArguments>();
  CLI::App& command = *app.add_subcommand("solve", "Every motion of a scene; without a force, for every force at once");
  command.add_option("SCENE", options->scene, "Scene file (TOML)")->required();
  command.add_flag("--chain", options->report.chain, "Also the sprocket's acceleration and the chain tension");
  command.add_option("--digits", options->report.digits, "Significant digits of decimals")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
  add_common_options(command, options->common);
  command.callback([options, &exit_code] {
    const SolvedScene solved(read_scene(options->scene));
    if (options->common.json) {
      print(solve_json(solved, options->report));
    } else {
      const std::string text = solve_text(solved, options->report);
      print(options->common.quiet ? last_line(text) : text);
    }
    exit_code = as_it_should_be;
  });
}

}  // namespace slipproof::cli
