#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "base/input/diagnostic.hpp"
#include "base/output/output_file.hpp"
#include "contact/space/space_plane.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/load_option.hpp"
#include "faces/cli/png.hpp"
#include "faces/cli/progress.hpp"
#include "faces/cli/warnings.hpp"
#include "mechanics/planes/mechanism_plane.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/phase/phase_regions.hpp"
#include "report/phase/phase_svg.hpp"
#include "report/planes/map_json.hpp"

namespace slipproof::cli {

namespace {

struct MapArguments {
  CommonOptions common;
  std::string scene, x, y, out;
  std::vector<std::string> x_range, y_range;
  std::size_t columns = 0, rows = 0;  ///< 0: default
  std::uint64_t effort = effort_of_a_place;
  bool svg = false, png = false;
};

/// An option that gives the format goes before the file's name.
void expect_map_name(const MapArguments& options) {
  if (options.svg || options.png) return;
  if (options.common.json) return expect_ending("--out", options.out, {".json"});
  expect_picture_name(options.out, "; or say --svg or --png");
}

/// What to draw; made before the work begins.
struct PlannedMap {
  Plane plane;
  MechanismScene scene;
};

PlannedMap planned(const MapArguments& options) {
  MechanismScene scene = read_scene(options.scene, Dimensions::any);
  try {
    if (!options.y.empty()) scene = with_load(scene, options.y);
    print_warnings(scene.mechanism, options.common);
    const auto x = range_of(options.x_range), y = range_of(options.y_range);
    const MechanismAxes axes{options.x, x[0], x[1], y[0], y[1]};
    const bool in_space = scene.mechanism.dimension == 3;
    if (!in_space && options.rows > 0) throw std::invalid_argument("--rows is for scenes in space");
    Plane plane = in_space ? space_plane(scene, axes, "map", options.effort) : mechanism_plane(scene, axes, "map");
    return {std::move(plane), std::move(scene)};
  } catch (const std::invalid_argument& error) {
    throw InputError({{options.scene, 0, 0, error.what()}});
  }
}

PhaseDiagram solved(Plane plane, const MapArguments& options) {
  constexpr std::size_t usual_columns = 240, usual_places = 12;
  if (!plane.place) return phase_diagram(std::move(plane), options.columns > 0 ? options.columns : usual_columns);
  const auto usual = [](std::size_t given) { return given > 0 ? given : usual_places; };
  return raster_diagram(std::move(plane), usual(options.columns), usual(options.rows),
                        progress_bar(!options.common.quiet));
}

std::string status_of(const MapArguments& options, const PhaseDiagram& diagram) {
  const std::size_t sets = phase_regions(diagram).sets.size();
  if (const auto& raster = diagram.raster) {
    return fmt::format("s MAPPED {} places {} complete {} sets {}\n", options.out, raster->places.size(),
                       raster->complete(), sets);
  }
  return fmt::format("s MAPPED {} columns {} sets {}\n", options.out, diagram.columns.size(), sets);
}

Exit draw_map(const MapArguments& options) {
  expect_map_name(options);
  PlannedMap map = planned(options);
  std::optional<OutputFile> out;
  if (!options.out.empty() && options.out != "-")
    out.emplace(options.out, Inputs{options.scene, map.scene.mechanism.file});
  const PhaseDiagram diagram = solved(std::move(map.plane), options);
  const Exit code = diagram.raster && diagram.raster->complete() < diagram.raster->places.size() ? undecided : success;
  std::string contents;
  if (options.common.json) {
    contents = map_json(diagram, map.scene);
  } else {
    contents = phase_svg_file(diagram);
    if (options.png || (!options.svg && options.out.ends_with(".png"))) contents = png_of(contents);
  }
  if (out) out->write(contents);
  print(out ? status_of(options, diagram) : contents);
  return code;
}

}  // namespace

void add_map(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<MapArguments>();
  CLI::App& command = *app.add_subcommand("map",
                                          "Draw the phase diagram of a scene over a parameter and the load, exact in "
                                          "every column, in space at single places");
  command.add_option("SCENE", options->scene, "Scene file (TOML), of a bicycle or of a mechanism")->required();
  command.add_option(
      "--x", options->x,
      "The parameter or angle across; of a bicycle in its own words also b, h0 and mu; default: the first "
      "coefficient of friction");
  command.add_option("--y", options->y,
                     "The load: any parameter that multiplies no unknown; default: the mechanism's own load");
  add_range_option(command, "--x-range", options->x_range, "FROM TO of the parameter; for an angle in degrees");
  add_range_option(command, "--y-range", options->y_range, "FROM TO of the load");
  command.add_option("--columns", options->columns, "Evenly spaced values of the parameter; default: 240, in space 12")
      ->check(whole_number(2, 10'000));
  command.add_option("--rows", options->rows, "In space: evenly spaced values of the load; default: 12")
      ->check(whole_number(2, 10'000));
  add_place_effort_option(command, options->effort);
  command.add_option("-o,--out", options->out, "The file to write, .svg or .png; default: standard output");
  auto* svg = command.add_flag("--svg", options->svg, "An SVG picture, whatever the file is called");
  auto* png = command.add_flag("--png", options->png, "A PNG picture, whatever the file is called")->excludes(svg);
  add_common_options(command, options->common);
  command.get_option("--json")->excludes(svg)->excludes(png);
  add_examples(command, {"cases/city-bicycle.toml --x f -o map.svg"});
  command.callback([options, &exit_code] { exit_code = draw_map(*options); });
}

}  // namespace slipproof::cli
