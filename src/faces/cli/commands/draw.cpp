#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/number/format.hpp"
#include "base/output/output_file.hpp"
#include "contact/rest/rest.hpp"
#include "contact/space/solve_space.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/load_option.hpp"
#include "faces/cli/png.hpp"
#include "faces/cli/warnings.hpp"
#include "mechanics/scene/solve_mechanism.hpp"
#include "report/picture/mechanism_svg.hpp"
#include "report/picture/motions_svg.hpp"
#include "report/picture/rest_svg.hpp"
#include "report/picture/space/space_svg.hpp"
#include "report/picture/space/space_view.hpp"

namespace slipproof::cli {

namespace {

constexpr std::string_view every_motion = "all", at_rest = "rest";

struct DrawArguments {
  CommonOptions common;
  std::string scene, out, load;
  std::string motion;  ///< a number from 1, every_motion, or at_rest; empty: none
  std::string from;    ///< where one looks at a scene in space from; empty: usual_view
  bool animate = false;
};

[[noreturn]] void refuse(const DrawArguments& arguments, const std::string& message) {
  throw InputError({{arguments.scene, 0, 0, message}});
}

/// The mode that is asked for by its place in the list of `solve` for all loads; sets the simplest load at which it has
/// a motion.
MechanismMode choose_load(MechanismScene& scene, const DrawArguments& arguments) {
  const std::string& symbol = scene.mechanism.load->symbol;
  if (arguments.motion == every_motion) {
    refuse(arguments, "the scene has no value of the load " + symbol + ", expected --load for --motion all");
  }
  const std::vector<ConsistentMode> modes = solve_mechanism(scene).modes;
  const std::size_t number = std::stoul(arguments.motion);
  if (number > modes.size()) {
    refuse(arguments, fmt::format("found --motion {}, expected at most {}: so many modes have a motion at some {}",
                                  number, modes.size(), symbol));
  }
  const ConsistentMode& mode = modes[number - 1];
  const ForceInterval within = mode.solutions.loads.interior();
  scene.load = (within.empty() ? mode.solutions.loads : within).sample();
  return mode.mode;
}

std::string figure_of_motions(MechanismScene scene, const DrawArguments& arguments) {
  CommonLook look;
  look.animated = arguments.animate;
  std::optional<MechanismMode> mode;
  if (scene.mechanism.load && !scene.load) mode = choose_load(scene, arguments);
  const MotionsAtLoad found = *solve_mechanism(scene).at_load;
  if (arguments.motion == every_motion) return motions_svg_file(scene, found);
  const std::vector<MotionAtLoad> motions = drawn_motions(found);
  if (motions.empty()) refuse(arguments, "there is no motion at this load, and none to draw");
  const auto has_mode = [&](const MotionAtLoad& motion) {
    const auto modes = motion.all_modes();
    return std::find(modes.begin(), modes.end(), *mode) != modes.end();
  };
  if (mode) {
    const auto motion = std::find_if(motions.begin(), motions.end(), has_mode);
    if (motion != motions.end()) return mechanism_svg_file(scene, &*motion, look);
    refuse(arguments, "the motion of " + name(*mode) + " at " + scene.mechanism.load->symbol + " = " +
                          exact_text(*scene.load) + " is one of a continuum, which --load with --motion all draws");
  }
  const std::size_t number = std::stoul(arguments.motion);
  if (number <= motions.size()) return mechanism_svg_file(scene, &motions[number - 1], look);
  refuse(arguments, fmt::format("found --motion {}, expected at most {}: so many motions it has there{}", number,
                                motions.size(), found.continua.empty() ? "" : ", continua counted"));
}

std::string figure_in_space(MechanismScene scene, const DrawArguments& arguments) {
  const Vec3 from = view_direction(arguments.from.empty() ? usual_view : arguments.from);
  if (arguments.motion.empty()) return space_svg_file(scene, from);
  const SolvedSpace solved = solve_space(std::move(scene));
  if (arguments.motion == every_motion) return space_motions_svg_file(solved, from);
  const std::size_t number = std::stoul(arguments.motion);
  if (number <= solved.motions.size()) return space_svg_file(solved, number - 1, from);
  refuse(arguments, fmt::format("found --motion {}, expected at most {}: so many motions are known there", number,
                                solved.motions.size()));
}

std::string figure_of(MechanismScene scene, const DrawArguments& arguments) {
  print_warnings(scene, arguments.common);
  scene = at_load(scene, arguments.load);
  const bool one = !arguments.motion.empty() && arguments.motion != every_motion && arguments.motion != at_rest;
  if (arguments.animate && (!one || scene.mechanism.dimension == 3)) {
    refuse(arguments, "found --animate, expected it with --motion NUMBER of a scene in the plane");
  }
  if (arguments.animate && !scene.mechanism.bodies) {
    refuse(arguments,
           "found a mechanism by equations, which does not say how its shapes move, expected one of bodies "
           "for --animate, as in cases/mechanisms/bodies");
  }
  if (arguments.motion == at_rest) {
    RestQuestions questions;
    questions.only_whether = true;
    return rest_svg_file(find_rest(std::move(scene), questions),
                         view_direction(arguments.from.empty() ? usual_view : arguments.from));
  }
  if (scene.mechanism.dimension == 3) return figure_in_space(std::move(scene), arguments);
  if (!arguments.from.empty())
    refuse(arguments, "found --from, but the scene is in the plane, which is drawn as it is");
  if (!arguments.motion.empty()) return figure_of_motions(std::move(scene), arguments);
  return mechanism_svg_file(scene, nullptr);
}

/// `all`, `rest`, or a number from 1.
CLI::Validator motion_choice() {
  return CLI::Validator(
      [](std::string& text) {
        const bool word = text == every_motion || text == at_rest;
        const std::string mistake = word ? std::string() : whole_number(1, 1'000'000)(text);
        return mistake.empty() ? mistake : mistake + ", all or rest";
      },
      "NUMBER|all|rest");
}

}  // namespace

void add_draw(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DrawArguments>();
  CLI::App& command = *app.add_subcommand(
      "draw", "Draw a scene to scale, with its symbols and the forces at its contacts; a labelled SVG");
  command.add_option("SCENE", options->scene, "Scene file (TOML), of a bicycle or of a mechanism")->required();
  command
      .add_option("--motion", options->motion,
                  "Draw the forces of this motion, as `solve` numbers them, from 1; of a scene without a load, of the "
                  "mode that `solve` lists there; `all`: all motions side by side; `rest`: the forces that hold it at "
                  "rest, or the virtual motion that "
                  "proves its fall; default: forces in their positive "
                  "directions")
      ->check(motion_choice());
  add_load_option(command, options->load);
  add_view_option(command, options->from);
  command.add_flag(
      "--animate", options->animate,
      "Of one motion of bodies in the plane: let the outlines go on for half a second as the accelerations "
      "say, in an SVG that moves; no simulation");
  command.add_option("-o,--out", options->out, "The file to write, .svg or .png; default: standard output");
  add_common_options(command, options->common);
  add_examples(command, {"cases/ambiguous.toml --motion all -o motions.svg"});
  command.callback([options, &exit_code] {
    MechanismScene scene = read_scene(options->scene, Dimensions::any);
    std::optional<OutputFile> out;
    if (!options->out.empty() && options->out != "-")
      out.emplace(options->out, Inputs{options->scene, scene.mechanism.file});
    expect_picture_name(options->out);
    const std::string figure = figure_of(std::move(scene), *options);
    exit_code = success;
    if (!out) return print(figure);
    out->write(picture_for(options->out, figure));
    if (!options->common.quiet) print("s DRAWN " + options->out + "\n");
  });
}

}  // namespace slipproof::cli
