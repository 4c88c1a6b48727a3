#include <memory>
#include <optional>
#include <string>

#include "base/output/output_file.hpp"
#include "contact/impact/solve_impact.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/load_option.hpp"
#include "faces/cli/png.hpp"
#include "faces/cli/warnings.hpp"
#include "report/picture/space/space_view.hpp"
#include "report/picture/velocities/impact_svg.hpp"
#include "report/scenes/impact_report.hpp"

namespace slipproof::cli {

namespace {

struct ImpactArguments {
  CommonOptions common;
  std::string scene, load, law, out, from;
  int digits = 6;
};

Exit answer(const ImpactArguments& arguments) {
  const MechanismScene scene =
      read_scene(arguments.scene, {Dimensions::any, ImpactRequest{parse_impact_law(arguments.law)}});
  expect_picture_name(arguments.out);
  std::optional<OutputFile> out;
  if (!arguments.out.empty()) out.emplace(arguments.out, Inputs{arguments.scene, scene.mechanism.file});
  const SolvedImpact solved = solve_impact(at_load(scene, arguments.load));
  print_warnings(solved.scene, arguments.common);
  if (out) {
    const Vec3 from = view_direction(arguments.from.empty() ? usual_view : arguments.from);
    out->write(picture_for(arguments.out, impact_svg_file(solved, from)));
  }
  print_report(
      arguments.common, [&] { return impact_json(solved); }, [&] { return impact_document(solved, arguments.digits); });
  return solved.complete() ? success : undecided;
}

}  // namespace

void add_impact(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ImpactArguments>();
  CLI::App& command =
      *app.add_subcommand("impact", "Find all velocities after an impact, and whether energy is gained");
  command.add_option("SCENE", options->scene, "Scene file (TOML) of bodies with velocities, in the plane or in space")
      ->required();
  add_law_option(command, options->law, "as the file says, or moreau");
  command.add_option("-o,--out", options->out, "Draw before and after to this file, .svg or .png");
  add_view_option(command, options->from);
  add_load_option(command, options->load);
  add_digits_option(command, options->digits);
  add_report_options(command, options->common);
  add_examples(command, {"cases/impact/kane-pendulum.toml --law newton"});
  command.callback([options, &exit_code] { exit_code = answer(*options); });
}

}  // namespace slipproof::cli
