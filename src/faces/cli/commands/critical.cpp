#include <memory>
#include <stdexcept>
#include <string>

#include "base/input/diagnostic.hpp"
#include "base/output/output_file.hpp"
#include "claims/uniqueness/scene_along.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/png.hpp"
#include "faces/cli/warnings.hpp"
#include "report/uniqueness/uniqueness_report.hpp"
#include "report/uniqueness/uniqueness_svg.hpp"

namespace slipproof::cli {

namespace {

struct CriticalArguments {
  CommonOptions common;
  std::string scene, x, out;
  int digits = 6;
};

void draw(const CriticalArguments& arguments, const SceneAlong& found) {
  const OutputFile out(arguments.out, {arguments.scene, found.scene.mechanism.file});
  try {
    const std::string svg = uniqueness_svg(uniqueness_diagram(found.scene, found.along), found.along);
    out.write(picture_for(arguments.out, svg));
  } catch (const std::invalid_argument& error) {
    throw InputError({{arguments.scene, 0, 0, error.what()}});
  }
}

void run_critical(const CriticalArguments& arguments) {
  const SceneAlong found = read_scene_along(arguments.scene, arguments.x);
  print_warnings(found.scene.mechanism, arguments.common);
  if (!arguments.out.empty()) draw(arguments, found);
  print_report(
      arguments.common, [&] { return uniqueness_json(found.scene, found.along); },
      [&] { return uniqueness_document(found.scene, found.along, arguments.digits); });
}

}  // namespace

void add_critical(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CriticalArguments>();
  CLI::App& command =
      *app.add_subcommand("critical", "Find the coefficients of friction and the loads with several motions");
  command.add_option("SCENE", options->scene, "Scene file (TOML), of a bicycle or of a mechanism")->required();
  command.add_option("--x", options->x,
                     "The parameter to vary; default: f of a bicycle, or a mechanism's first coefficient of "
                     "friction");
  add_digits_option(command, options->digits);
  command.add_option("-o,--out", options->out,
                     "Also draw a picture over the parameter and the load: a file .svg or .png");
  add_report_options(command, options->common);
  command.callback([options, &exit_code] {
    expect_picture_name(options->out);
    run_critical(*options);
    exit_code = success;
  });
}

}  // namespace slipproof::cli
