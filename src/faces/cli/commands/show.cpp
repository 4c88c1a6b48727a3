#include "mechanics/checks/show.hpp"

#include <filesystem>
#include <memory>
#include <string>

#include "base/input/text_file.hpp"
#include "base/output/output_file.hpp"
#include "faces/cli/command.hpp"
#include "mechanics/checks/checks.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/reading/write_mechanism.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof::cli {

namespace {

/// Of a scene: the one that it names.
Mechanism mechanism_of(const std::string& file) {
  std::error_code error;
  if (std::filesystem::is_regular_file(file, error) && is_mechanism_scene(read_text_file(file))) {
    return read_scene(file, Dimensions::any).mechanism;
  }
  return open_mechanism(file, {}, Dimensions::any);
}

}  // namespace

void add_show(CLI::App& app, int& exit_code) {
  auto file = std::make_shared<std::string>(), equations = std::make_shared<std::string>();
  CLI::App& command =
      *app.add_subcommand("show", "Show how a mechanism file was understood, and what looks wrong in it");
  command
      .add_option("MECHANISM", *file,
                  "Mechanism file (TOML), or the name of a shipped one; of a scene file, its mechanism")
      ->required();
  command.add_option("--equations", *equations,
                     "Also write the mechanism by its equations, as they follow from its bodies, to this file");
  add_examples(command, {"ladder"});
  command.callback([file, equations, &exit_code] {
    const Mechanism mechanism = mechanism_of(*file);
    if (!equations->empty()) {
      refuse_other(mechanism, Dimensions::plane);
      Inputs inputs;
      inputs.add(mechanism.file);
      write_file(*equations, to_toml(mechanism), inputs);
    }
    print(show_text(mechanism, check_mechanism(mechanism)));
    exit_code = success;
  });
}

}  // namespace slipproof::cli
