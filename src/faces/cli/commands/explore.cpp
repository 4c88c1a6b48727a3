#include "faces/cli/commands/explore.hpp"

#include <memory>
#include <string>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"
#include "base/output/output_file.hpp"
#include "contact/space/solve_space.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/warnings.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/explorer/explorer_page.hpp"
#include "report/explorer/space_page.hpp"

namespace slipproof::cli {

namespace {

struct ExploreArguments {
  CommonOptions common;
  std::string scene, out;
};

constexpr std::size_t largest_page = 64U << 20U;

bool is_built(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error);
}

std::string built_page(const std::filesystem::path& file) {
  if (is_built(file)) return read_text_file(file, largest_page);
  throw InputError({{file.string(), 0, 0, "found no such file, expected the explorer: ./run explorer builds it"}});
}

void write_explorer(const ExploreArguments& arguments) {
  expect_page_name("--out", arguments.out);
  MechanismScene scene = read_scene(arguments.scene, Dimensions::any);
  print_warnings(scene.mechanism, arguments.common);
  if (scene.mechanism.dimension == 3) {
    const Inputs inputs{arguments.scene, scene.mechanism.file};
    write_file(arguments.out, space_page(solve_space(std::move(scene))), inputs);
  } else {
    const std::filesystem::path file = explorer_file();
    write_file(arguments.out, explorer_page(built_page(file), file.string(), scene),
               Inputs{arguments.scene, scene.mechanism.file, file});
  }
  if (!arguments.common.quiet) print("s EXPLORER " + arguments.out + "\n");
}

}  // namespace

std::filesystem::path explorer_file() {
  return shipped("build-explorer/explorer.html");
}

std::string copy_explorer(const OutputFolder& pages) {
  const std::filesystem::path file = explorer_file();
  if (!is_built(file)) return "";
  std::string name = file.filename().string();
  pages.write(name, built_page(file));
  return name;
}

void add_explore(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ExploreArguments>();
  CLI::App& command = *app.add_subcommand(
      "explore",
      "Write a page on which a scene's values are dragged and its motions follow, exactly; of a scene in space one on "
      "which it is turned. The page needs no network");
  command.add_option("SCENE", options->scene, "Scene file (TOML), of a bicycle or of a mechanism")->required();
  command.add_option("-o,--out", options->out, "The HTML file to write")->required();
  add_common_options(command, options->common);
  add_examples(command, {"cases/space/domino.toml -o domino.html"});
  command.callback([options, &exit_code] {
    write_explorer(*options);
    exit_code = success;
  });
}

}  // namespace slipproof::cli
