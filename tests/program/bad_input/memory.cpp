// Small files that say that they are large: what the program refuses takes no memory.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>

#include "support/files/npy_file.hpp"
#include "support/run_program.hpp"

using namespace slipproof::test;

namespace {

struct Spent {
  int exit_code = -1;
  double megabytes = 0;  ///< the most that it held
  std::string said;
};

Spent certify(std::vector<std::string> arguments) {
  const TemporaryFolder folder;
  const std::string said = (folder.path() / "said").string();
  arguments.insert(arguments.begin(), {SLIPPROOF_BINARY_DIR "/slipproof", "certify"});
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  pid_t child = 0;
  REQUIRE(posix_spawn(&child, words[0], &actions, nullptr, words.data(), environ) == 0);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  rusage usage{};
  REQUIRE(wait4(child, &status, 0, &usage) == child);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, static_cast<double>(usage.ru_maxrss) / 1024, read_file(said)};
}

/// The program alone has some 20 MB; under the address sanitizer ten times as much.
constexpr double little_memory = 300;

void check_refused(const Spent& spent, const std::string& message) {
  CHECK(spent.exit_code == 3);
  CHECK_MESSAGE(spent.said.find(message) != std::string::npos, spent.said);
  CHECK(spent.megabytes < little_memory);
}

const std::string problem = R"({"dimension": 3, "W": [[1,0,0],[0,1,0],[0,0,1]], "q": [-10, 3, 4], "mu": 0.25})";

}  // namespace

TEST_CASE("a list of many numbers takes no more than a few times its file") {
  const TemporaryFolder folder;
  std::string list = "{\"r\": [0";
  for (int k = 1; k < 4'000'000; ++k) list += ",0";
  check_refused(certify({folder.write("p.json", problem), "--answer", folder.write("a.json", list + "]}")}),
                "a.json: r: found 4000000 numbers, expected 3\n");
}

TEST_CASE("an array whose rows are as long as a disk is refused") {
  const TemporaryFolder folder;
  const std::string path = folder.write("t.npy", npy_with(npy_dictionary("[('mode', '|S536870912')]", "(1,)"), ""));
  std::filesystem::resize_file(path, std::filesystem::file_size(path) + (std::uintmax_t{1} << 29U));  // a hole
  check_refused(certify({path, "--scene", city_bicycle}), "found items of 536870912 bytes, expected at most 1048576\n");
}
