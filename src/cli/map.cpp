#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "cli/command.hpp"
#include "cli/png.hpp"
#include "input/diagnostic.hpp"
#include "model/scene.hpp"
#include "number/parse.hpp"
#include "output/output_file.hpp"
#include "picture/phase_points.hpp"
#include "picture/phase_svg.hpp"
#include "picture/scene_plane.hpp"

namespace slipproof::cli {

namespace {

struct MapArguments {
  CommonOptions common;
  std::string scene, x = "f", y = "F", out;
  std::vector<std::string> x_range, y_range;
  std::size_t columns = 240;
  bool svg = false, png = false;
};

/// The ends of a range; the check of the option has seen that they are numbers.
void set_range(const std::vector<std::string>& texts, std::optional<Rational>& from, std::optional<Rational>& to) {
  if (texts.empty()) return;
  from = parse_rational(texts[0]);
  to = parse_rational(texts[1]);
}

std::string number_or_complaint(const std::string& text) {
  try {
    parse_rational(text);
    return {};
  } catch (const NumberError& error) {
    return error.what();
  }
}

std::string axis_or_complaint(const std::string& text) {
  for (const std::string_view known : scene_parameters()) {
    if (text == known) return {};
  }
  std::string all;
  for (const std::string_view known : scene_parameters()) all += (all.empty() ? "" : ", ") + std::string(known);
  return "no parameter of a scene: " + text + "; expected one of " + all;
}

/// A name that says neither SVG nor PNG must not get one of them unasked.
void expect_picture_name(const MapArguments& options) {
  const bool asked = options.svg || options.png || options.common.json || options.out.empty() || options.out == "-";
  if (asked || options.out.ends_with(".svg") || options.out.ends_with(".png")) return;
  throw CLI::ValidationError("--out", "found " + in_quotes(options.out) +
                                          ", expected a name that ends in .svg or .png; or say --svg or --png");
}

PhaseDiagram diagram_of(const MapArguments& options) {
  SceneAxes axes;
  axes.x = options.x;
  set_range(options.x_range, axes.x_from, axes.x_to);
  set_range(options.y_range, axes.y_from, axes.y_to);
  const Scene scene = read_scene(options.scene);
  try {
    return phase_diagram(scene_plane(scene, axes, "map"), options.columns);
  } catch (const std::invalid_argument& error) {
    throw InputError({{options.scene, 0, 0, error.what()}});
  }
}

}  // namespace

void add_map(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<MapArguments>();
  CLI::App& command =
      *app.add_subcommand("map", "The phase diagram of a scene: a parameter and the force, exact in every column");
  command.add_option("SCENE", options->scene, "Scene file (TOML)")->required();
  command.add_option("--x", options->x, "The parameter across: f, b, h, R, ...")
      ->check(axis_or_complaint)
      ->capture_default_str();
  // What goes up is the force, and nothing else as yet: commands may say so.
  command.add_option("--y", options->y)->check(CLI::IsMember({"F"}))->group("");
  command.add_option("--x-range", options->x_range, "FROM TO of the parameter")
      ->expected(2)
      ->check(number_or_complaint);
  command.add_option("--y-range", options->y_range, "FROM TO of the force, N")->expected(2)->check(number_or_complaint);
  command.add_option("--columns", options->columns, "Evenly spaced values of the parameter")
      ->check(whole_number(2, 10'000))
      ->capture_default_str();
  command.add_option("-o,--out", options->out, "The file to write, .svg or .png; default: standard output");
  auto* svg = command.add_flag("--svg", options->svg, "An SVG picture, whatever the file is called");
  auto* png = command.add_flag("--png", options->png, "A PNG picture, whatever the file is called")->excludes(svg);
  add_common_options(command, options->common);
  command.get_option("--json")->excludes(svg)->excludes(png);
  command.callback([options, &exit_code] {
    expect_picture_name(*options);
    std::optional<OutputFile> out;
    if (!options->out.empty() && options->out != "-") out.emplace(options->out, Inputs{options->scene});
    const PhaseDiagram diagram = diagram_of(*options);
    const bool as_png = options->png || (!options->svg && options->out.ends_with(".png"));
    const std::string contents = options->common.json ? map_json(diagram)
                                 : as_png             ? png_of(phase_svg_file(diagram))
                                                      : phase_svg_file(diagram);
    exit_code = as_it_should_be;
    if (!out) return print(contents);
    out->write(contents);
    print(fmt::format("s MAPPED {} columns {} sets {}\n", options->out, diagram.columns.size(),
                      phase_regions(diagram).sets.size()));
  });
}

}  // namespace slipproof::cli
