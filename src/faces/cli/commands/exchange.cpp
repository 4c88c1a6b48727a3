#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "base/number/parse.hpp"
#include "base/output/output_file.hpp"
#include "contact/exchange/export_scene.hpp"
#include "contact/exchange/planar.hpp"
#include "contact/exchange/spatial.hpp"
#include "contact/imported/read_scene.hpp"
#include "faces/cli/command.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof::cli {

namespace {

struct ImportArguments {
  std::string file, output, plane, touch, mu, ground, gravity;
  bool spatial = false, quiet = false;
};

Rational number(const std::string& option, const std::string& text) {
  try {
    return parse_rational(text);
  } catch (const NumberError& error) {
    throw CLI::ValidationError(option, error.what());
  }
}

std::optional<Rational> number_or_none(const std::string& option, const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(number(option, text));
}

imported::PlanarOptions options_of(const ImportArguments& arguments) {
  imported::PlanarOptions options;
  options.plane = arguments.plane;
  options.mu = number_or_none("--mu", arguments.mu);
  options.ground = number_or_none("--ground", arguments.ground);
  options.gravity = number_or_none("--gravity", arguments.gravity);
  if (!arguments.touch.empty()) options.touch = number("--touch", arguments.touch);
  for (const auto& [option, value] :
       {std::pair("--mu", options.mu), std::pair("--touch", std::optional(options.touch))}) {
    if (value && value->sign() < 0) throw CLI::ValidationError(option, "found a negative number, expected 0 or more");
  }
  return options;
}

void tell(const ImportArguments& arguments, const std::vector<std::string>& told) {
  if (arguments.quiet) return;
  for (const std::string& one : told) std::cerr << arguments.file << ": " << one << '\n';
}

void import_scene(const ImportArguments& arguments) {
  const imported::PlanarOptions options = options_of(arguments);
  Inputs inputs;
  inputs.add(arguments.file);
  const OutputFile output(arguments.output, inputs);
  imported::Scene scene = imported::read_scene_of_bodies(arguments.file);
  const std::size_t bodies = scene.bodies.size() - 1;
  if (arguments.spatial) {
    const imported::SpatialProblem found = to_spatial(std::move(scene), options);
    tell(arguments, found.told);
    output.write(to_json(found.problem));
    print(fmt::format("s IMPORTED {} bodies {} contacts {} in space\n", arguments.output, bodies,
                      found.problem.contacts.size()));
  } else {
    const imported::PlanarMechanism found = to_planar(std::move(scene), options);
    tell(arguments, found.told);
    output.write(found.text);
    print(fmt::format("s IMPORTED {} bodies {} contacts {} plane {}\n", arguments.output, bodies, found.contacts,
                      found.plane));
  }
}

void add_import(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ImportArguments>();
  CLI::App& command = *app.add_subcommand("import", "Read a scene in URDF, SDF or MJCF as a mechanism of bodies");
  command.add_option("FILE", options->file, "A robot (URDF), a world or model (SDF), a model of MuJoCo (MJCF)")
      ->required();
  command.add_option("-o,--output", options->output, "Where the mechanism goes (TOML), or the problem (JSON)")
      ->required();
  command
      .add_option("--plane", options->plane,
                  "The plane that it is seen in: xz, yz or xy; the first that fits, if left out")
      ->check(CLI::IsMember({"xz", "yz", "xy"}));
  command.add_flag("--spatial", options->spatial,
                   "Write the contact problem in space, at rest, in place of a mechanism");
  command.add_option("--touch", options->touch, "How far apart, or inside each other, shapes touch [0.0001]");
  command.add_option("--mu", options->mu, "The coefficient of friction of all contacts; URDF has none of its own");
  command.add_option("--ground", options->ground, "Add a level ground at this height; URDF has none");
  command.add_option("--gravity", options->gravity,
                     "Gravity along -z, in place of the file's; of URDF 9.81 if left out");
  command.add_flag("--quiet", options->quiet, "Do not tell what was left out, moved, turned or assumed");
  command.callback([options, &exit_code] {
    import_scene(*options);
    exit_code = as_it_should_be;
  });
}

void add_export(CLI::App& app, int& exit_code) {
  auto scene = std::make_shared<std::string>(), output = std::make_shared<std::string>(),
       load = std::make_shared<std::string>();
  CLI::App& command =
      *app.add_subcommand("export", "Write the contact problem of a scene, for certify and other solvers");
  command.add_option("SCENE", *scene, "Scene file (TOML)")->required();
  command.add_option("-o,--output", *output, "Where the problem goes (JSON)")->required();
  command.add_option("--load", *load, "The value of the load, if not the scene's");
  command.callback([scene, output, load, &exit_code] {
    Inputs inputs;
    inputs.add(*scene);
    const OutputFile file(*output, inputs);
    MechanismScene read = read_scene(*scene);
    if (!load->empty()) {
      if (!read.mechanism.load) throw CLI::ValidationError("--load", "found a value, and the mechanism has no load");
      read.load = number("--load", *load);
      const ForceInterval domain = ProblemMaker(read.mechanism).load_domain(read.values);
      if (!domain.contains(*read.load)) {
        throw CLI::ValidationError("--load", "found " + *load + ", expected a value in " + to_string(domain));
      }
    }
    const GlobalProblem problem = global_problem(read);
    file.write(to_json(problem));
    print(fmt::format("s EXPORTED {} contacts {}\n", *output, problem.contacts.size()));
    exit_code = as_it_should_be;
  });
}

}  // namespace

void add_exchange(CLI::App& app, int& exit_code) {
  add_import(app, exit_code);
  add_export(app, exit_code);
}

}  // namespace slipproof::cli
