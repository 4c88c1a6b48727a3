#include <memory>
#include <stdexcept>
#include <string>

#include "base/input/diagnostic.hpp"
#include "base/output/output_file.hpp"
#include "claims/uniqueness/scene_along.hpp"
#include "contact/space/space_plane.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/load_option.hpp"
#include "faces/cli/png.hpp"
#include "faces/cli/progress.hpp"
#include "faces/cli/warnings.hpp"
#include "report/uniqueness/sets_report.hpp"
#include "report/uniqueness/uniqueness_report.hpp"
#include "report/uniqueness/uniqueness_svg.hpp"

namespace slipproof::cli {

namespace {

struct CriticalArguments {
  CommonOptions common;
  std::string scene, x, out, load;
  std::vector<std::string> x_range;
  std::size_t columns = 12;
  std::uint64_t effort = effort_of_a_place;
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

/// At single values.
Exit run_in_space(const CriticalArguments& arguments, const MechanismScene& scene) {
  if (!arguments.out.empty()) throw CLI::ValidationError("--out", "found a scene in space, expected map for a picture");
  print_warnings(scene.mechanism, arguments.common);
  try {
    const auto x = range_of(arguments.x_range);
    const SetsAlong along = space_along(scene, {arguments.x, x[0], x[1], {}, {}}, arguments.columns, arguments.effort,
                                        progress_bar(!arguments.common.quiet));
    print_report(
        arguments.common, [&] { return sets_json(scene, along); },
        [&] { return sets_document(scene, along, arguments.digits); });
    return along.is_complete() ? success : undecided;
  } catch (const std::invalid_argument& error) {
    throw InputError({{arguments.scene, 0, 0, error.what()}});
  }
}

Exit run_critical(const CriticalArguments& arguments) {
  const MechanismScene scene = at_load(read_scene(arguments.scene, Dimensions::any), arguments.load);
  if (scene.mechanism.dimension == 3) return run_in_space(arguments, scene);
  if (!arguments.load.empty() || !arguments.x_range.empty()) {
    throw CLI::ValidationError("--load, --x-range",
                               "found a scene in the plane, in which all loads and values are searched");
  }
  const SceneAlong found = read_scene_along(arguments.scene, arguments.x);
  print_warnings(found.scene.mechanism, arguments.common);
  if (!arguments.out.empty()) draw(arguments, found);
  print_report(
      arguments.common, [&] { return uniqueness_json(found.scene, found.along); },
      [&] { return uniqueness_document(found.scene, found.along, arguments.digits); });
  return success;
}

}  // namespace

void add_critical(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CriticalArguments>();
  CLI::App& command = *app.add_subcommand(
      "critical",
      "Find the coefficients of friction and the loads with several motions; in space where motions change");
  command.add_option("SCENE", options->scene, "Scene file (TOML), of a bicycle or of a mechanism")->required();
  command.add_option("--x", options->x,
                     "The parameter to vary; default: f of a bicycle, or a mechanism's first coefficient of "
                     "friction");
  add_range_option(command, "--x-range", options->x_range,
                   "In space: FROM TO of the parameter, which is tried at single values; for an angle in degrees");
  command.add_option("--columns", options->columns, "In space: evenly spaced parts of the range")
      ->check(whole_number(1, 10'000))
      ->capture_default_str();
  add_load_option(command, options->load);
  add_place_effort_option(command, options->effort);
  add_digits_option(command, options->digits);
  command.add_option("-o,--out", options->out,
                     "Also draw a picture over the parameter and the load: a file .svg or .png");
  add_report_options(command, options->common);
  add_examples(command, {"cases/city-bicycle.toml"});
  command.callback([options, &exit_code] {
    expect_picture_name(options->out);
    exit_code = run_critical(*options);
  });
}

}  // namespace slipproof::cli
