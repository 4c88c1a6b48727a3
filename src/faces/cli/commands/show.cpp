#include "mechanics/checks/show.hpp"

#include <memory>
#include <string>

#include "base/output/output_file.hpp"
#include "faces/cli/command.hpp"
#include "mechanics/checks/checks.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/reading/write_mechanism.hpp"

namespace slipproof::cli {

void add_show(CLI::App& app, int& exit_code) {
  auto file = std::make_shared<std::string>(), equations = std::make_shared<std::string>();
  CLI::App& command =
      *app.add_subcommand("show", "Show how a mechanism file was understood, and what looks wrong in it");
  command.add_option("MECHANISM", *file, "Mechanism file (TOML), or the name of a shipped one")->required();
  command.add_option("--equations", *equations,
                     "Also write the mechanism by its equations, as they follow from its bodies, to this file");
  command.callback([file, equations, &exit_code] {
    const Mechanism mechanism = open_mechanism(*file, {}, Dimensions::any);
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
