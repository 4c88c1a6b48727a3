#include "mechanics/checks/show.hpp"

#include <memory>
#include <string>

#include "faces/cli/command.hpp"
#include "mechanics/checks/checks.hpp"
#include "mechanics/reading/shipped.hpp"

namespace slipproof::cli {

void add_show(CLI::App& app, int& exit_code) {
  auto file = std::make_shared<std::string>();
  CLI::App& command =
      *app.add_subcommand("show", "Show how a mechanism file was understood, and what looks wrong in it");
  command.add_option("MECHANISM", *file, "Mechanism file (TOML), or the name of a shipped one")->required();
  command.callback([file, &exit_code] {
    const Mechanism mechanism = open_mechanism(*file);
    print(show_text(mechanism, check_mechanism(mechanism)));
    exit_code = as_it_should_be;
  });
}

}  // namespace slipproof::cli
