#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <random>

#include "base/output/output_file.hpp"
#include "support/how_many.hpp"
#include "support/run_program.hpp"

using slipproof::OutputFile;
using slipproof::test::read_file;
using slipproof::test::TemporaryFolder;

namespace {

/// Writes one text after the other, each of one letter, until it is killed.
[[noreturn]] void write_for_ever(const std::filesystem::path& path, std::size_t size) {
  const OutputFile file(path);
  for (char letter = 'a';; letter = letter == 'z' ? 'a' : static_cast<char>(letter + 1)) {
    file.write(std::string(size, letter));
  }
}

}  // namespace

TEST_CASE("whenever the writer is killed, one whole text stands there") {
  const int kills = slipproof::test::how_many("SLIPPROOF_KILLS", 25);
  constexpr std::size_t size = 1U << 21U;
  const TemporaryFolder folder;
  const auto file = folder.write("result", std::string(size, '-'));
  std::mt19937 random(14);
  int replaced = 0;
  for (int i = 0; i < kills; ++i) {
    const pid_t writer = fork();
    REQUIRE(writer >= 0);
    if (writer == 0) write_for_ever(file, size);
    usleep(std::uniform_int_distribution<useconds_t>(0, 20'000)(random));
    // However slow the machine is, the last writer is killed after it has written.
    while (i + 1 == kills && read_file(file)[0] == '-') usleep(1000);
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    const std::string text = read_file(file);
    REQUIRE(text.size() == size);
    CHECK(std::count(text.begin(), text.end(), text[0]) == std::ptrdiff_t{size});
    replaced += text[0] != '-' ? 1 : 0;
  }
  CHECK(replaced > 0);
}
