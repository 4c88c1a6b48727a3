// Small files that say that they are large: what the program refuses takes no memory.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>

#include "support/files/zip_file.hpp"
#include "support/run_program.hpp"

using namespace slipproof::test;

namespace {

/// Deflated: a text, stored, and then zeros in copies of 258, which are 13 bits each.
class Deflated {
 public:
  Deflated(const std::string& text, std::size_t zeros) : bytes_(1, '\0'), size_(text.size() + zeros) {
    bytes_ += little(text.size(), 2) + little(~text.size() & 0xffffU, 2) + text;
    put("110");       // the last block, with fixed codes
    put("00110000");  // a zero
    for (std::size_t left = zeros - 1; left >= 258; left -= 258) put("1100010100000");
    for (std::size_t left = (zeros - 1) % 258; left > 0; --left) put("00110000");
    put("0000000");
    bytes_ += static_cast<char>(byte_);
  }
  Packed packed(const std::string& name) const { return {name, bytes_, size_, 8, 0}; }

 private:
  void put(std::string_view bits) {
    for (const char bit : bits) {
      byte_ |= static_cast<unsigned>(bit == '1') << used_;
      if (++used_ < 8) continue;
      bytes_ += static_cast<char>(byte_);
      byte_ = used_ = 0;
    }
  }

  std::string bytes_;
  unsigned byte_ = 0, used_ = 0;
  std::size_t size_;
};

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

TEST_CASE("answers that inflate to more than the problem has are not inflated") {
  const TemporaryFolder folder;
  const std::string array = npy_with(npy_dictionary("'<f8'", "(67108864,)"), "");
  const std::string bomb = zip({Deflated(array, std::size_t{1} << 29U).packed("r.npy")});
  CHECK(bomb.size() < 4'000'000);
  check_refused(certify({folder.write("p.json", problem), "--answer", folder.write("a.npz", bomb)}),
                "a.npz: r: found 67108864 numbers, expected 3\n");
}

TEST_CASE("a list of many numbers takes no more than a few times its file") {
  const TemporaryFolder folder;
  std::string list = "{\"r\": [0";
  for (int k = 1; k < 4'000'000; ++k) list += ",0";
  check_refused(certify({folder.write("p.json", problem), "--answer", folder.write("a.json", list + "]}")}),
                "a.json: r: found 4000000 numbers, expected 3\n");
}

TEST_CASE("a table's column of texts that are as long as a disk is refused") {
  const TemporaryFolder folder;
  std::vector<Packed> columns;
  for (const char* name : {"a.npy", "F.npy", "S2.npy", "S3.npy", "N2.npy", "N3.npy"}) {
    columns.push_back({name, npy_with(npy_dictionary("'<f8'", "(1,)"), npy_number(1, "<f8"))});
  }
  const std::string array = npy_with(npy_dictionary("'|S536870912'", "(1,)"), "");
  columns.push_back(Deflated(array, std::size_t{1} << 29U).packed("mode.npy"));
  check_refused(certify({folder.write("t.npz", zip(columns)), "--scene", city_bicycle}),
                "mode: found items of 536870912 bytes, expected at most 1048576\n");
}
