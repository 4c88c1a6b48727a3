#include <memory>
#include <string>

#include "base/input/text_file.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/warnings.hpp"
#include "mechanics/bicycle/scene.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/scenes/solve_report.hpp"

namespace slipproof::cli {

namespace {

struct SolveArguments {
  CommonOptions common;
  SolveReportOptions report;
  std::string scene;
};

/// Scenes of mechanisms, and those of the bicycle in their old form.
std::string answer(const SolveArguments& arguments) {
  const std::string scene = read_text_file(arguments.scene);
  const bool json = arguments.common.json;
  if (is_mechanism_scene(scene)) {
    const SolvedMechanism solved(parse_mechanism_scene(scene, arguments.scene));
    print_warnings(solved.scene.mechanism, arguments.common);
    return json ? solve_json(solved) : solve_text(solved, arguments.report.digits);
  }
  const SolvedScene solved(parse_scene(scene, arguments.scene));
  return json ? solve_json(solved, arguments.report) : solve_text(solved, arguments.report);
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
    const std::string text = answer(*options);
    print(options->common.quiet && !options->common.json ? last_line(text) : text);
    exit_code = as_it_should_be;
  });
}

}  // namespace slipproof::cli
