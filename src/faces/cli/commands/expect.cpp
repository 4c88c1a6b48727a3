#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/output/output_file.hpp"
#include "faces/cli/command.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/expected/expected.hpp"

namespace slipproof::cli {

namespace {

struct ExpectArguments {
  std::vector<std::string> scenes;
  std::string format = "json", output;
};

std::string text_of(const std::string& format, const std::vector<Expected>& answers) {
  return format == "pytest" ? expected_pytest(answers) : expected_json(answers);
}

std::string id_of(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

void expect(const ExpectArguments& arguments) {
  Inputs inputs;
  std::set<std::string> ids;
  for (const std::string& file : arguments.scenes) {
    if (ids.insert(id_of(file)).second) continue;
    throw CLI::ValidationError(
        "SCENE", "found two scenes called " + in_quotes(id_of(file)) + ", expected files with different names");
  }
  for (const std::string& file : arguments.scenes) {
    inputs.add(file);
    inputs.add(read_scene(file, Dimensions::any).mechanism.file);
  }
  std::optional<OutputFile> output;
  if (!arguments.output.empty()) output.emplace(arguments.output, inputs);
  expect_ending("--output", arguments.output, {arguments.format == "pytest" ? ".py" : ".json"}, ", as --format says");
  std::vector<Expected> answers;
  for (const std::string& file : arguments.scenes) answers.push_back(expected_of(file, id_of(file)));
  const std::string text = text_of(arguments.format, answers);
  output ? output->write(text) : print(text);
}

}  // namespace

void add_expect(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ExpectArguments>();
  CLI::App& command =
      *app.add_subcommand("expect", "Write the motions that a physics engine should find, as data or as tests");
  command.add_option("SCENE", options->scenes, "Scene files (TOML), each with a value of its load")->required();
  command.add_option("--format", options->format, "json, or pytest: a file of tests for an engine of one's own")
      ->check(CLI::IsMember({"json", "pytest"}))
      ->capture_default_str();
  command.add_option("-o,--output", options->output, "Where it goes; standard output if left out");
  add_examples(command, {"cases/engines/scenes/one-motion/cube-tips.toml"});
  command.callback([options, &exit_code] {
    expect(*options);
    exit_code = success;
  });
}

}  // namespace slipproof::cli
