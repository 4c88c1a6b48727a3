#include "base/output/output_file.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "base/input/diagnostic.hpp"
#include "base/output/output_error.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using slipproof::test::read_file;
using slipproof::test::TemporaryFolder;

namespace {

std::size_t entries(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

unsigned mode_of(const std::filesystem::path& file) {
  struct stat found {};
  REQUIRE(::stat(file.c_str(), &found) == 0);
  return found.st_mode & 0777U;
}

ino_t inode_of(const std::filesystem::path& file) {
  struct stat found {};
  REQUIRE(::stat(file.c_str(), &found) == 0);
  return found.st_ino;
}

std::string refusal(const std::filesystem::path& path, const Inputs& inputs = {}) {
  try {
    const OutputFile file(path, inputs);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

/// No file may grow beyond `bytes`, as if the disk were full, as long as this lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before_) == 0);
    const rlimit limit{bytes, before_.rlim_max};
    REQUIRE(setrlimit(RLIMIT_FSIZE, &limit) == 0);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*signal_)(int);
};

}  // namespace

TEST_CASE("a file is written whole, in place of what stood there, and nothing else stays in the folder") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "result";
  write_file(file, "first");
  CHECK(read_file(file) == "first");
  const OutputFile output(file);
  CHECK(read_file(file) == "first");
  output.write("second");
  CHECK(read_file(file) == "second");
  output.write("");
  CHECK(read_file(file).empty());
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("whoever has the older file open, or another name for it, keeps the older content") {
  const TemporaryFolder folder;
  const auto file = folder.write("result", "older"), other = folder.path() / "other";
  std::filesystem::create_hard_link(file, other);
  const ino_t before = inode_of(file);
  write_file(file, "newer");
  CHECK(read_file(file) == "newer");
  CHECK(read_file(other) == "older");
  CHECK(inode_of(file) != before);
}

TEST_CASE("where writing fails, the older content stands and nothing else stays in the folder") {
  const TemporaryFolder folder;
  const auto file = folder.write("result", "older");
  {
    const FileSizeLimit full(1000);
    CHECK_THROWS_WITH_AS(write_file(file, std::string(5000, 'x')),
                         (file.string() + ": cannot be written: File too large").c_str(), OutputError);
    CHECK_THROWS_AS(write_file(folder.path() / "new", std::string(5000, 'x')), OutputError);
  }
  CHECK(read_file(file) == "older");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("permissions are those of the older file, or what the umask leaves") {
  const TemporaryFolder folder;
  const auto file = folder.write("result", "older");
  REQUIRE(::chmod(file.c_str(), 0640) == 0);
  write_file(file, "newer");
  CHECK(mode_of(file) == 0640);
  const mode_t before = ::umask(027);
  write_file(folder.path() / "new", "text");
  ::umask(before);
  CHECK(mode_of(folder.path() / "new") == 0640);
}

TEST_CASE("a symbolic link stays, and the file that it leads to is replaced, there or not there yet") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "below");
  const auto target = folder.path() / "below" / "target", link = folder.path() / "link",
             to_link = folder.path() / "two";
  std::filesystem::create_symlink("below/target", link);
  std::filesystem::create_symlink("link", to_link);
  for (const std::string text : {"first", "second"}) {
    write_file(to_link, text);
    CHECK(read_file(target) == text);
    CHECK(std::filesystem::is_symlink(link));
    CHECK(std::filesystem::is_symlink(to_link));
  }
  CHECK(entries(folder.path() / "below") == 1);
  std::filesystem::create_symlink("circle", folder.path() / "circle");
  CHECK(refusal(folder.path() / "circle").ends_with("cannot be written: Too many levels of symbolic links"));
}

TEST_CASE("pipes, devices and open descriptors are written as they are") {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::string read;
  std::thread reader([&] { read = read_file(pipe); });
  write_file(pipe, "through a pipe");
  reader.join();
  CHECK(read == "through a pipe");
  CHECK(std::filesystem::is_fifo(pipe));

  write_file("/dev/null", "nothing");
  CHECK(std::filesystem::is_character_file("/dev/null"));
  CHECK_THROWS_WITH_AS(write_file("/dev/full", "text"), "/dev/full: cannot be written: No space left on device",
                       OutputError);

  const auto file = folder.path() / "file";
  const int open = ::open(file.c_str(), O_CREAT | O_WRONLY, 0600);
  REQUIRE(::write(open, "one ", 4) == 4);
  write_file("/dev/fd/" + std::to_string(open), "two ");
  REQUIRE(::write(open, "three", 5) == 5);
  ::close(open);
  CHECK(read_file(file) == "one two three");
}

TEST_CASE("where no file can be written is told before the work, and no folder is made") {
  const TemporaryFolder folder;
  const auto file = folder.write("file", "text"), nowhere = folder.path() / "nowhere";
  CHECK(refusal(nowhere / "result") ==
        (nowhere / "result").string() + ": cannot be written: No such file or directory");
  CHECK(refusal(file / "result").ends_with("/result: cannot be written: Not a directory"));
  CHECK(refusal(folder.path()).ends_with("cannot be written: Is a directory"));
  CHECK(refusal("").ends_with("cannot be written: No such file or directory"));
  CHECK(refusal(folder.path() / "new").empty());
  CHECK(entries(folder.path()) == 1);
  CHECK_THROWS_AS(OutputFolder(nowhere / "below"), OutputError);
  CHECK_THROWS_AS(OutputFolder{file}, OutputError);
  CHECK_FALSE(std::filesystem::exists(nowhere));
}

TEST_CASE("a folder for results is made, and whatever the names of the results need in it") {
  const TemporaryFolder folder;
  const OutputFolder results(folder.path() / "results");
  CHECK(std::filesystem::is_directory(folder.path() / "results"));
  results.write("one", "1");
  results.write("more/deep/two", "2");
  CHECK(read_file(folder.path() / "results" / "one") == "1");
  CHECK(read_file(folder.path() / "results" / "more" / "deep" / "two") == "2");
  CHECK_NOTHROW(OutputFolder(folder.path() / "results"));
}

TEST_CASE("no input is written over, by whatever name") {
  const TemporaryFolder folder;
  const auto input = folder.write("input", "text"), other = folder.write("other", "text");
  std::filesystem::create_hard_link(input, folder.path() / "hard");
  std::filesystem::create_symlink("input", folder.path() / "soft");
  const Inputs inputs{other, input, folder.path() / "missing", "/dev/null", ""};
  for (const char* name : {"input", "hard", "soft", "./input", "other"}) {
    CAPTURE(name);
    CHECK(refusal(folder.path() / name, inputs).find("found the input '") != std::string::npos);
    CHECK_THROWS_AS(write_file(folder.path() / name, "lost", inputs), InputError);
    CHECK_THROWS_AS(OutputFolder(folder.path(), inputs).write(name, "lost"), InputError);
  }
  CHECK(read_file(input) == "text");
  CHECK(read_file(other) == "text");
  CHECK(refusal(folder.path() / "missing", inputs).empty());
  CHECK(refusal("/dev/null", inputs).empty());
}
