#include "base/output/output_file.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/description.hpp"

namespace slipproof::cli {

void add_documentation(CLI::App& app, int& exit_code) {
  auto folder = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("documentation", "Write man pages and shell completions");
  command.group("");  // for packagers, so hidden from the help
  command.add_option("FOLDER", *folder, "Folder to write to: man/, completions/")->required();
  command.callback([folder, &exit_code, &app] {
    const OutputFolder output(*folder);
    for (const WrittenPage& page : manual_pages(app, SLIPPROOF_VERSION)) output.write("man/" + page.name, page.text);
    output.write("completions/slipproof", bash_completion(app));
    output.write("completions/_slipproof", zsh_completion(app));
    exit_code = as_it_should_be;
  });
}

}  // namespace slipproof::cli
