#include <fmt/format.h>

#include <iostream>
#include <iterator>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "base/input/diagnostic.hpp"
#include "base/output/output_file.hpp"
#include "contact/exchange/export_bodies.hpp"
#include "contact/exchange/export_scene.hpp"
#include "contact/exchange/planar.hpp"
#include "contact/exchange/space_mechanism.hpp"
#include "contact/exchange/spatial.hpp"
#include "contact/imported/read_scene.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/load_option.hpp"
#include "mechanics/bodies/bodies.hpp"

namespace slipproof::cli {

namespace {

struct ImportArguments {
  std::string file, output, plane, touch, mu, ground, gravity, key, mass;
  bool space = false, spatial = false, stand = false, without_meshes = false, without_overlaps = false, quiet = false;
};

std::optional<Rational> number_or_none(const std::string& option, const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(number_of(option, text));
}

imported::TouchOptions options_of(const ImportArguments& arguments) {
  imported::TouchOptions options;
  options.mu = number_or_none("--mu", arguments.mu);
  options.ground = number_or_none("--ground", arguments.ground);
  options.gravity = number_or_none("--gravity", arguments.gravity);
  if (!arguments.touch.empty()) options.touch = number_of("--touch", arguments.touch);
  for (const auto& [option, value] :
       {std::pair("--mu", options.mu), std::pair("--touch", std::optional(options.touch))}) {
    if (value && value->sign() < 0) throw CLI::ValidationError(option, "found a negative number, expected 0 or more");
  }
  return options;
}

void tell(const ImportArguments& arguments, const std::vector<std::string>& import_notes) {
  if (arguments.quiet) return;
  for (const std::string& one : import_notes) std::cerr << arguments.file << ": " << one << '\n';
}

/// What was made of a scene: a text, and what is told about it.
struct Written {
  std::string text;
  std::vector<std::string> import_notes;
  std::string words;
};

Written write_scene(const ImportArguments& arguments, imported::Scene scene) {
  const imported::TouchOptions touch = options_of(arguments);
  const std::size_t bodies = scene.bodies.size() - 1;
  if (arguments.space) {
    const imported::SpaceMechanism found = to_space(
        std::move(scene),
        {touch, arguments.without_overlaps ? imported::Overlaps::left_out : imported::Overlaps::within_one_robot,
         arguments.stand});
    return {found.text, found.import_notes,
            fmt::format("bodies {} contacts {} in space", found.bodies, found.contacts)};
  }
  if (arguments.spatial) {
    const imported::SpatialProblem found = to_spatial(std::move(scene), touch);
    return {to_json(found.problem), found.import_notes,
            fmt::format("bodies {} contacts {} in space", bodies, found.problem.contacts.size())};
  }
  const imported::PlanarMechanism found = to_planar(std::move(scene), {touch, arguments.plane});
  return {found.text, found.import_notes,
          fmt::format("bodies {} contacts {} plane {}", bodies, found.contacts, found.plane)};
}

void import_scene(const ImportArguments& arguments) {
  options_of(arguments);  // refuses what is no number, before a file is read
  Inputs inputs;
  inputs.add(arguments.file);
  const OutputFile output(arguments.output, inputs);
  expect_ending("--output", arguments.output, {arguments.spatial ? ".json" : ".toml"});
  const Written written = write_scene(
      arguments, imported::read_scene_of_bodies(arguments.file, {arguments.key, arguments.without_meshes,
                                                                 number_or_none("--mass", arguments.mass)}));
  tell(arguments, written.import_notes);
  output.write(written.text);
  print(fmt::format("s IMPORTED {} {}\n", arguments.output, written.words));
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
  CLI::Option* space = command.add_flag("--space", options->space, "Write a mechanism in space");
  command
      .add_flag("--spatial", options->spatial, "Write the contact problem in space, at rest, in place of a mechanism")
      ->excludes(space);
  command.add_option("--key", options->key, "The keyframe of an MJCF file: its places, velocities and controls");
  command.add_flag("--stand", options->stand, "Move robots that nothing holds up or down to stand on the ground")
      ->needs(space);
  command
      .add_flag("--without-overlaps", options->without_overlaps,
                "Leave contacts out of shapes that are inside each other; of one robot they always are")
      ->needs(space);
  command.add_option("--mass", options->mass, "The mass of bodies that have none, and their inertia about all axes");
  command.add_flag("--without-meshes", options->without_meshes, "Leave shapes out that are meshes");
  command.add_option("--touch", options->touch, "How far apart, or inside each other, shapes touch [0.0001]");
  command.add_option("--mu", options->mu, "The coefficient of friction of all contacts; URDF has none of its own");
  command.add_option("--ground", options->ground, "Add a level ground at this height; URDF has none");
  command.add_option("--gravity", options->gravity,
                     "Gravity along -z, in place of the file's; of URDF 9.81 if left out");
  command.add_flag("--quiet", options->quiet, "Do not tell what was left out, moved, turned or assumed");
  add_examples(command, {"cases/imported/cart.xml -o cart.toml"});
  command.callback([options, &exit_code] {
    import_scene(*options);
    exit_code = success;
  });
}

struct ExportArguments {
  std::string scene, output, load;
  std::vector<std::string> set;
  bool bodies = false, each = false;
};

/// NAME=VALUE
std::pair<std::string, Rational> setting(const std::string& text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) {
    throw CLI::ValidationError("--set", "found " + in_quotes(text) + ", expected NAME=VALUE");
  }
  return {text.substr(0, sign), number_of("--set", text.substr(sign + 1))};
}

MechanismScene at_settings(const MechanismScene& scene, const std::vector<std::string>& settings,
                           const std::string& load) {
  std::vector<std::pair<std::string, Rational>> values;
  for (const std::string& one : settings) values.push_back(setting(one));
  try {
    return at_load(with_values(scene, values), load);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--set", error.what());
  }
}

/// The text, and how many contacts it has.
std::pair<std::string, std::size_t> exported(const MechanismScene& scene, bool bodies) {
  if (bodies) return {bodies_json(scene) + '\n', scene.mechanism.bodies->contacts.size()};
  const GlobalProblem problem = global_problem(scene);
  return {to_json(problem), problem.contacts.size()};
}

void export_scene(const ExportArguments& arguments) {
  Inputs inputs;
  inputs.add(arguments.scene);
  const MechanismScene scene = at_settings(read_scene(arguments.scene, Dimensions::any), arguments.set, arguments.load);
  inputs.add(scene.mechanism.file);
  const OutputFile file(arguments.output, inputs);
  expect_ending("--output", arguments.output, {".json"});
  const auto [text, contacts] = exported(scene, arguments.bodies);
  file.write(text);
  print(fmt::format("s EXPORTED {} contacts {}\n", arguments.output, contacts));
}

/// Answers each line of standard input at once, as who asks may choose the next settings by the answer.
void export_each(const ExportArguments& arguments) {
  const MechanismScene scene = read_scene(arguments.scene, Dimensions::any);
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::vector<std::string> settings = arguments.set;
    settings.insert(settings.end(), std::istream_iterator<std::string>(words), {});
    std::string text = exported(at_settings(scene, settings, arguments.load), arguments.bodies).first;
    std::erase(text, '\n');  // of the problem's JSON, whose strings have none
    print(text + '\n');
  }
}

void add_export(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ExportArguments>();
  CLI::App& command =
      *app.add_subcommand("export", "Write the contact problem of a scene, for certify and other solvers");
  command.add_option("SCENE", options->scene, "Scene file (TOML)")->required();
  CLI::Option* output =
      command.add_option("-o,--output", options->output, "Where the problem, or the scene, goes (JSON)");
  add_load_option(command, options->load);
  command
      .add_option("--set", options->set,
                  "NAME=VALUE: another value of a parameter, of the load, or of an angle, by the tangent of its half; "
                  "may be repeated")
      ->take_all()
      ->expected(1);
  command.add_flag("--bodies", options->bodies,
                   "Write the bodies, contacts, joints and forces in numbers, for physics engines, on one line");
  command
      .add_flag("--each", options->each,
                "For each line of standard input, NAME=VALUE or several with blanks between them, write to standard "
                "output, on one line, in place of a file")
      ->excludes(output);
  add_examples(command, {"cases/ambiguous.toml -o problem.json"});
  command.callback([options, output, &exit_code] {
    if (!options->each && !*output) throw CLI::RequiredError("--output or --each");
    options->each ? export_each(*options) : export_scene(*options);
    exit_code = success;
  });
}

}  // namespace

void add_exchange(CLI::App& app, int& exit_code) {
  add_import(app, exit_code);
  add_export(app, exit_code);
}

}  // namespace slipproof::cli
