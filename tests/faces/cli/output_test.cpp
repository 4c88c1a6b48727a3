#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/run_program.hpp"

using slipproof::test::city_bicycle;
using slipproof::test::last_line;
using slipproof::test::quoted;
using slipproof::test::read_file;
using slipproof::test::rear_drive;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;

namespace {

const std::string sources = SLIPPROOF_SOURCE_DIR;
const std::string answers = "F,a,S2,S3,N2,N3\n300,0,0,0,0,0\n";

struct Shelled {
  int exit_code = -1;
  std::string err;
};

/// Runs a line of shell in a folder, with $slipproof for the program.
Shelled shell(const std::filesystem::path& folder, const std::string& line) {
  const auto err = folder / "standard-error";
  const std::string command = "cd " + quoted(folder.string()) +
                              " && slipproof=" + quoted(SLIPPROOF_BINARY_DIR "/slipproof") + " && { " + line +
                              "; } 2>" + quoted(err.string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(err)};
}

/// A copy of a small paper that may be overwritten.
std::string own_paper(const TemporaryFolder& folder) {
  return folder.write("claims.toml", read_file(rear_drive));
}

}  // namespace

TEST_CASE("a result that cannot be written to standard output has an exit code of its own, and a message") {
  const TemporaryFolder folder;
  folder.write("answers.csv", answers);
  folder.write("x.statement", "slipproof-statement 1\ntheorem x\nreal x\nshow x^2 >= 0\n");
  const std::vector<std::string> commands{"solve " + city_bicycle,
                                          "map " + city_bicycle + " --columns 4",
                                          "verify " + rear_drive + " --samples 3 --lines 0",
                                          "verify " + rear_drive + " --coverage",
                                          "certify answers.csv --scene " + city_bicycle,
                                          "prove x.statement",
                                          "check x.cert",
                                          "--help",
                                          "--version"};
  for (const std::string& command : commands) {
    CAPTURE(command);
    const auto full = shell(folder.path(), "$slipproof " + command + " >/dev/full");
    CHECK(full.exit_code == 6);
    CHECK(full.err.find("standard output: cannot be written: No space left on device") != std::string::npos);
  }
  const auto closed = shell(folder.path(), "$slipproof solve " + city_bicycle + " >&-");
  CHECK(closed.exit_code == 6);
  CHECK(closed.err.find("standard output: cannot be written: Bad file descriptor") != std::string::npos);
}

TEST_CASE("where standard output is closed, no file that is written gets what was meant for it") {
  const TemporaryFolder folder;
  CHECK(shell(folder.path(), "$slipproof map " + city_bicycle + " --columns 4 -o map.svg >&-").exit_code == 6);
  CHECK(read_file(folder.path() / "map.svg").ends_with("</svg>\n"));
}

TEST_CASE("a disk that is full leaves the older file, and exits with 6") {
  const TemporaryFolder folder;
  folder.write("answers.csv", answers);
  folder.write("x.statement", "slipproof-statement 1\ntheorem x\nreal x\nshow x^2 >= 0\n");
  const std::vector<std::pair<std::string, std::string>> commands{
      {"map.svg", "map " + city_bicycle + " --columns 4 -o map.svg"},
      {"summary", "certify answers.csv --quiet --summary summary --scene " + city_bicycle},
      {"x.cert", "prove x.statement"},
      {"out/x.cert", "prove x.statement --out out"},
      {"smt/x.smt2", "prove x.statement --smtlib smt"},
      {"report.html", "report " + rear_drive + " --samples 3 --lines 0"}};
  for (const auto& [file, command] : commands) {
    CAPTURE(command);
    std::filesystem::create_directories((folder.path() / file).parent_path());
    folder.write(file, "older");
    // No file may grow at all.
    const auto full = shell(folder.path(), "exec 2>&1 && ulimit -f 0 && $slipproof " + command + " >/dev/null 2>&1");
    CHECK(full.exit_code == 6);
    CHECK(read_file(folder.path() / file) == "older");
  }
  const auto device = shell(folder.path(), "$slipproof map " + city_bicycle + " --columns 4 --svg -o /dev/full");
  CHECK(device.exit_code == 6);
  CHECK(device.err == "/dev/full: cannot be written: No space left on device\n");
}

TEST_CASE("a folder that is not there is told before the work, and not made") {
  const TemporaryFolder folder;
  folder.write("answers.csv", answers);
  folder.write("x.statement", "slipproof-statement 1\ntheorem x\nreal x\nshow x^2 >= 0\n");
  const std::string long_work = " --samples 100000000 ";
  for (const std::string& command : std::vector<std::string>{
           "map " + city_bicycle + " -o nowhere/map.svg", "report" + long_work + "--out nowhere/report.html",
           "verify" + long_work + "--report nowhere/report.html", "verify --mutants --lemmas nowhere/lemmas",
           "certify answers.csv --summary nowhere/summary --scene " + city_bicycle,
           "prove x.statement --out nowhere/out", "prove x.statement --smtlib nowhere/smt"}) {
    CAPTURE(command);
    const auto outcome = shell(folder.path(), "$slipproof " + command + " >out");
    CHECK(outcome.exit_code == 6);
    CHECK(outcome.err.find("cannot be written: No such file or directory") != std::string::npos);
    CHECK(read_file(folder.path() / "out").empty());
    CHECK_FALSE(std::filesystem::exists(folder.path() / "nowhere"));
  }
}

TEST_CASE("no command writes over what it reads, by whatever name, and says so before the work") {
  const TemporaryFolder folder;
  const std::string claims = own_paper(folder);
  folder.write("answers.csv", answers);
  folder.write("scene.toml", read_file(city_bicycle));
  const std::string statement = "slipproof-statement 1\ntheorem x\nreal x\nshow x^2 >= 0\n";
  folder.write("x.statement", statement);
  for (const char* name : {"x.cert", "claims.theorems", "figures.toml", "trade.json"})
    folder.write(name, "");  // refused before they are read
  const std::string report = "report claims.toml --samples 100000000 --trade trade.json --out ";
  const std::string verify = "verify claims.toml --samples 100000000 --trade trade.json --report ";
  const std::string certify = "certify answers.csv --scene scene.toml --summary ";
  const std::vector<std::pair<std::string, std::string>> commands{{"claims.toml", report},
                                                                  {"trade.json", report},
                                                                  {"x.statement", report},
                                                                  {"x.cert", report},
                                                                  {"figures.toml", report},
                                                                  {"claims.theorems", report},
                                                                  {"claims.toml", verify},
                                                                  {"x.cert", verify},
                                                                  {"answers.csv", certify},
                                                                  {"scene.toml", certify},
                                                                  {"scene.toml", "map scene.toml --svg -o "}};
  for (const auto& [input, command] : commands) {
    const auto file = folder.path() / input;
    const std::string before = read_file(file);
    std::filesystem::create_hard_link(file, folder.path() / "hard");
    std::filesystem::create_symlink(input, folder.path() / "soft");
    for (const std::string& name : {"./" + input, std::string("hard"), std::string("soft")}) {
      const std::string line = command + name;
      CAPTURE(line);
      const auto outcome = shell(folder.path(), "$slipproof " + line + " >out");
      CHECK(outcome.exit_code == 3);
      CHECK(outcome.err.find(name + ": found the input '") != std::string::npos);
      CHECK(read_file(file) == before);
    }
    std::filesystem::remove(folder.path() / "hard");
    std::filesystem::remove(folder.path() / "soft");
  }
  const auto from_stdin =
      shell(folder.path(), "$slipproof certify - --scene scene.toml --summary answers.csv <answers.csv");
  CHECK(from_stdin.exit_code == 3);
  CHECK(read_file(folder.path() / "answers.csv") == answers);
}

TEST_CASE("prove writes neither over the claims nor over a statement") {
  const TemporaryFolder folder;
  own_paper(folder);
  const std::string statement = "slipproof-statement 1\ntheorem x\nreal x\nshow x^2 >= 0\n";
  folder.write("x.statement", statement);
  std::filesystem::create_directories(folder.path() / "out");
  const auto refused = [&](const std::string& link, const std::string& to, const std::string& command) {
    CAPTURE(command);
    std::filesystem::create_symlink(to, folder.path() / link);
    const std::string before = read_file(folder.path() / link);
    const auto outcome = shell(folder.path(), "$slipproof " + command + " >out.txt");
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.err.find("found the input '") != std::string::npos);
    CHECK(read_file(folder.path() / link) == before);
    std::filesystem::remove(folder.path() / link);
  };
  refused("x.cert", "x.statement", "prove x.statement");
  refused("out/x.cert", "../x.statement", "prove x.statement --out out");
  refused("out/x.smt2", "../x.statement", "prove x.statement --smtlib out");
  refused("out/claims.theorems", "../claims.toml", "prove claims.toml --out out");
}

TEST_CASE("the report as Markdown ends as the text does, and is not asked for together with JSON") {
  const std::string root = SLIPPROOF_SOURCE_DIR, scenes = root + "/cases/mechanisms/scenes/";
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"solve", scenes + "ladder.toml"},
           {"critical", scenes + "ladder.toml"},
           {"simulate", root + "/cases/ambiguous.toml", "--stiffness-ratio", "1", "--damping", "0.5"},
           {"search", "ladder", "--samples", "20"},
           {"verify", "--only", "A5.1", "--samples", "50", "--lines", "0"}}) {
    CAPTURE(command.front());
    const auto with = [&](const std::string& option) {
      std::vector<std::string> all = command;
      all.push_back(option);
      return run(all);
    };
    const auto text = run(command), markdown = with("--markdown");
    CHECK(markdown.exit_code == text.exit_code);
    CHECK(markdown.out.starts_with("# " + text.out.substr(0, text.out.find('\n')) + "\n\n"));
    const std::string status = last_line(text.out);
    CHECK(markdown.out.ends_with("\n\n`" + status.substr(0, status.size() - 1) + "`\n"));
    CHECK(with("--quiet").out == status);
  }
  CHECK(run({"critical", scenes + "ladder.toml", "--json", "--markdown"}).exit_code == 2);
}
