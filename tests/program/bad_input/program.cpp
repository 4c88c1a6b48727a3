// The same tables through the program itself: its exit code, and its messages on stderr and nowhere else.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "table.hpp"

using namespace slipproof::test;

namespace {

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("the program refuses every malformed scene with its messages and exit code") {
  const auto directory = std::filesystem::temp_directory_path() / ("slipproof-bad-input-" + std::to_string(::getpid()));
  std::filesystem::create_directory(directory);
  const std::string scene = (directory / "scene.toml").string();
  const std::string command = "'" SLIPPROOF_BINARY_DIR "/slipproof' solve --json '" + scene + "' >'" +
                              (directory / "out").string() + "' 2>'" + (directory / "err").string() + "'";
  for (const BadInput& row : read_bad_inputs(SLIPPROOF_SOURCE_DIR "/tests/program/bad_input/scenes.toml")) {
    CAPTURE(row.what);
    std::ofstream(scene, std::ios::binary) << row.text;
    const int status = std::system(command.c_str());
    REQUIRE(WIFEXITED(status));  // no crash, no abort
    CHECK(WEXITSTATUS(status) == row.exit);
    std::string expected;
    for (const std::string& message : row.says) expected += scene + ":" + message + "\n";
    CHECK(contents(directory / "err") == expected);
    CHECK(contents(directory / "out").empty());
  }
  std::filesystem::remove_all(directory);
}
