#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/load_option.hpp"
#include "faces/cli/warnings.hpp"
#include "report/scenes/simulation_report.hpp"

namespace slipproof::cli {

namespace {

struct SimulateArguments {
  CommonOptions common;
  std::string scene, load;
  std::vector<double> ratios{0.25, 1, 4}, dampings{0.05, 0.5}, rises{0, 100};
  int digits = 6;
};

std::vector<Compliance> compliances(const SimulateArguments& arguments) {
  std::vector<Compliance> all;
  for (const double ratio : arguments.ratios) {
    for (const double damping : arguments.dampings) {
      for (const double rise : arguments.rises) all.push_back({ratio, damping, rise});
    }
  }
  return all;
}

void run_simulate(const SimulateArguments& arguments) {
  const MechanismScene scene = at_load(read_scene(arguments.scene), arguments.load);
  refuse_impact(scene, "simulate");
  print_warnings(scene.mechanism, arguments.common);
  try {
    const Simulation simulation = simulate(loaded_contacts(scene), compliances(arguments), arguments.common.threads);
    print_report(
        arguments.common, [&] { return simulation_json(scene, simulation); },
        [&] { return simulation_document(scene, simulation, arguments.digits); });
  } catch (const std::invalid_argument& error) {
    throw InputError({{arguments.scene, 0, 0, error.what()}});
  } catch (const NoValue& error) {
    throw InputError({{arguments.scene, 0, 0, error.what()}});
  }
}

}  // namespace

void add_simulate(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SimulateArguments>();
  CLI::App& command = *app.add_subcommand(
      "simulate", "Simulate which of several motions compliant contacts settle to, from rest; no proof");
  command.add_option("SCENE", options->scene, "Scene file (TOML), of a bicycle or of a mechanism")->required();
  add_load_option(command, options->load);
  command
      .add_option("--stiffness-ratio", options->ratios,
                  "Tangential over normal stiffness of the contacts; each value in turn")
      ->check(number_in(0.01, 100))
      ->capture_default_str();
  command
      .add_option("--damping", options->dampings,
                  "Damping of each contact over the critical damping; each value in turn")
      ->check(number_in(0, 1))
      ->capture_default_str();
  command
      .add_option("--rise", options->rises, "Elastic periods over which the load rises; each value in turn; 0: at once")
      ->check(number_in(0, 10'000))
      ->capture_default_str();
  add_digits_option(command, options->digits);
  add_report_options(command, options->common);
  add_examples(command, {"cases/ambiguous.toml"});
  command.callback([options, &exit_code] {
    run_simulate(*options);
    exit_code = success;
  });
}

}  // namespace slipproof::cli
