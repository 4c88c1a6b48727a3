#include <fmt/format.h>

#include <memory>
#include <string>

#include "base/input/diagnostic.hpp"
#include "base/output/output_file.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/png.hpp"
#include "faces/cli/warnings.hpp"
#include "mechanics/scene/bicycle_scene.hpp"
#include "report/picture/bicycle_figure.hpp"
#include "report/picture/mechanism_svg.hpp"
#include "report/scenes/mechanism_report.hpp"

namespace slipproof::cli {

namespace {

struct DrawArguments {
  CommonOptions common;
  std::string scene, out;
  std::size_t motion = 0;  ///< 0: none
};

/// The requested motion, counted from 1.
MotionAtLoad motion_of(const MechanismScene& scene, const DrawArguments& arguments) {
  const auto refuse = [&](const std::string& message) { throw InputError({{arguments.scene, 0, 0, message}}); };
  if (scene.mechanism.load && !scene.load) {
    refuse("the scene has no value of the load " + scene.mechanism.load->symbol + ", expected one for --motion");
  }
  const MotionsAtLoad found = *SolvedMechanism(scene).at_load;
  if (arguments.motion <= found.motions.size()) return found.motions[arguments.motion - 1];
  refuse(fmt::format("found --motion {}, expected at most {}: so many motions it has there{}", arguments.motion,
                     found.motions.size(), found.continua.empty() ? "" : ", and a continuum"));
  return {};
}

std::string figure_of(const DrawArguments& arguments, Inputs& inputs) {
  const MechanismScene scene = read_scene(arguments.scene);
  inputs.add(scene.mechanism.file);
  print_warnings(scene.mechanism, arguments.common);
  if (arguments.motion == 0) {
    return is_bicycle(scene.mechanism) ? bicycle_figure_file(scene) : mechanism_svg_file(scene, nullptr);
  }
  const MotionAtLoad motion = motion_of(scene, arguments);
  return mechanism_svg_file(scene, &motion);
}

}  // namespace

void add_draw(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DrawArguments>();
  CLI::App& command = *app.add_subcommand("draw",
                                          "Draw a scene to scale: a bicycle with its axes, signs and symbols, or a "
                                          "mechanism with the forces at its contacts; a labelled SVG");
  command.add_option("SCENE", options->scene, "Scene file (TOML), of a bicycle or of a mechanism")->required();
  command
      .add_option("--motion", options->motion,
                  "Draw the forces of this motion, as `solve` numbers them, from 1; default: forces in their positive "
                  "directions")
      ->check(whole_number(1, 1'000'000));
  command.add_option("-o,--out", options->out,
                     "The file to write, a PNG if its name ends in .png; default: standard output");
  add_common_options(command, options->common);
  command.callback([options, &exit_code] {
    Inputs inputs{options->scene};
    const std::string figure = figure_of(*options, inputs);
    exit_code = as_it_should_be;
    if (options->out.empty() || options->out == "-") return print(figure);
    write_file(options->out, picture_for(options->out, figure), inputs);
    if (!options->common.quiet) print("s DRAWN " + options->out + "\n");
  });
}

}  // namespace slipproof::cli
