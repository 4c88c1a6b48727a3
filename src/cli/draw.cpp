#include <memory>
#include <optional>
#include <string>

#include "cli/command.hpp"
#include "model/scene.hpp"
#include "output/output_file.hpp"
#include "picture/bicycle_figure.hpp"

namespace slipproof::cli {

namespace {

struct DrawArguments {
  CommonOptions common;
  std::string scene, out;
};

}  // namespace

void add_draw(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DrawArguments>();
  CLI::App& command =
      *app.add_subcommand("draw", "The bicycle of a scene, to scale, with its axes, signs and symbols: a labelled SVG");
  command.add_option("SCENE", options->scene, "Scene file (TOML)")->required();
  command.add_option("-o,--out", options->out, "The file to write; default: standard output");
  add_common_options(command, options->common);
  command.callback([options, &exit_code] {
    const std::string figure = bicycle_figure_file(read_scene(options->scene));
    exit_code = as_it_should_be;
    if (options->out.empty() || options->out == "-") return print(figure);
    write_file(options->out, figure, Inputs{options->scene});
    if (!options->common.quiet) print("s DRAWN " + options->out + "\n");
  });
}

}  // namespace slipproof::cli
