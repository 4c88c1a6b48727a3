// The name of a file to write promises a format: an ending that is not the format's is refused, with those that are.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/run_program.hpp"

using namespace slipproof::test;

TEST_CASE("a name with another ending than the format's is refused, and nothing is written") {
  const TemporaryFolder folder;
  const std::string cases = SLIPPROOF_SOURCE_DIR "/cases/", out = (folder.path() / "out").string();
  const std::string scene = cases + "wheelie.toml", cube = cases + "engines/scenes/one-motion/cube-tips.toml";
  const std::string paper = SLIPPROOF_SOURCE_DIR "/proofs/rear-drive/claims.toml";
  struct Case {
    std::vector<std::string> command;
    std::string ending, accepted;
  };
  const std::vector<Case> refused{
      {{"draw", scene, "-o"}, ".jpg", ".svg or .png"},
      {{"draw", scene, "-o"}, "", ".svg or .png"},
      {{"draw", scene, "--motion", "1", "-o"}, ".pdf", ".svg or .png"},
      {{"map", scene, "--columns", "4", "-o"}, ".jpg", ".svg or .png"},
      {{"map", scene, "--columns", "4", "--json", "-o"}, ".svg", ".json"},
      {{"critical", scene, "-o"}, ".gif", ".svg or .png"},
      {{"expect", cube, "-o"}, ".csv", ".json"},
      {{"expect", cube, "--format", "pytest", "-o"}, ".txt", ".py"},
      {{"export", cube, "-o"}, ".toml", ".json"},
      {{"import", cases + "imported/crate.sdf", "-o"}, ".json", ".toml"},
      {{"import", cases + "imported/crate.sdf", "--spatial", "-o"}, ".toml", ".json"},
      {{"explore", scene, "-o"}, ".pdf", ".html"},
      {{"report", paper, "--samples", "5", "--out"}, ".pdf", ".html"},
      {{"verify", paper, "--samples", "5", "--report"}, ".pdf", ".html"},
      {{"certify", cases + "contact-problems/pushed-block.json", "--report"}, ".pdf", ".html"},
  };
  for (const Case& one : refused) {
    std::vector<std::string> command = one.command;
    command.push_back(out + one.ending);
    CAPTURE(command.front());
    CAPTURE(one.ending);
    const auto outcome = run(command);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("expected a name that ends in " + one.accepted) != std::string::npos);
    CHECK(!std::filesystem::exists(out + one.ending));
  }
}

TEST_CASE("a name with the format's ending is written, and so is a device") {
  const TemporaryFolder folder;
  const std::string cube = SLIPPROOF_SOURCE_DIR "/cases/engines/scenes/one-motion/cube-tips.toml";
  const auto written = [&](std::vector<std::string> command, const std::string& file) {
    command.push_back(file);
    CHECK(run(command).exit_code == 0);
  };
  written({"draw", cube, "-o"}, folder.path() / "cube.svg");
  written({"export", cube, "-o"}, folder.path() / "cube.json");
  written({"draw", cube, "-o"}, "/dev/null");
  written({"expect", cube, "-o"}, "/dev/null");
}
