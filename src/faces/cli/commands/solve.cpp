#include <memory>
#include <string>

#include "contact/problem/every_push.hpp"
#include "contact/space/solve_space.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/load_option.hpp"
#include "faces/cli/warnings.hpp"
#include "mechanics/scene/solve_mechanism.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/scenes/space_report.hpp"

namespace slipproof::cli {

namespace {

struct SolveArguments {
  CommonOptions common;
  std::string scene, load;
  int digits = 6;
};

Exit answer_in_space(const SolveArguments& arguments, MechanismScene scene) {
  const SolvedSpace solved = solve_space(std::move(scene));
  print_warnings(solved.scene, arguments.common);
  print_report(
      arguments.common, [&] { return space_json(solved); }, [&] { return space_document(solved, arguments.digits); });
  return solved.complete() ? success : undecided;
}

Exit answer(const SolveArguments& arguments) {
  MechanismScene scene = at_load(read_scene(arguments.scene, Dimensions::any), arguments.load);
  if (scene.mechanism.dimension == 3) return answer_in_space(arguments, std::move(scene));
  const SolvedMechanism solved = solve_mechanism(std::move(scene));
  print_warnings(solved.scene, arguments.common);
  const auto every_q = for_every_push(solved.problem);
  print_report(
      arguments.common, [&] { return solve_json(solved, every_q); },
      [&] { return solve_document(solved, every_q, arguments.digits); });
  return success;
}

}  // namespace

void add_solve(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SolveArguments>();
  CLI::App& command =
      *app.add_subcommand("solve", "Find every motion of a scene; without a force, for every force at once");
  command.add_option("SCENE", options->scene, "Scene file (TOML)")->required();
  add_load_option(command, options->load);
  add_digits_option(command, options->digits);
  add_report_options(command, options->common);
  add_examples(command, {"cases/city-bicycle.toml", "cases/three-motions/three-motions.toml --load 2"});
  command.callback([options, &exit_code] { exit_code = answer(*options); });
}

}  // namespace slipproof::cli
