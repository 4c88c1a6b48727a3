#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
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

/// What the program writes to a terminal, without the carriage returns of one.
std::string on_terminal(const std::filesystem::path& folder, const std::string& arguments,
                        const std::string& environment = "TERM=dumb") {
  shell(folder, "env " + environment + " script -qec \"$slipproof " + arguments + "\" typescript >shown </dev/null");
  std::string text = read_file(folder / "shown");
  std::erase(text, '\r');
  const std::string cleared = "\033[K";
  for (std::size_t end = text.find(cleared); end != text.npos; end = text.find(cleared)) {  // a line of progress
    const std::size_t begin = text.rfind('\n', end) + 1;
    text.erase(begin, end + cleared.size() - begin);
  }
  return text;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, line.size());
  return widest;
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

TEST_CASE("certify answers in words on a terminal, with what to change, and in JSON elsewhere") {
  const TemporaryFolder folder;
  std::filesystem::create_directory_symlink(sources + "/cases", folder.path() / "cases");
  folder.write("answers.csv",
               "F,mode,a,S2,S3,N2,N3\n3.27,stick/stick,2.9727272727272727,3.1213636363636363,-0.14863636363636363,"
               "9.642784090909091,0.16721590909090908\n3.2,stick/slip+,3,3.05,-0.05,9.75,0.06\n");
  const std::string ambiguous = "certify --scene cases/ambiguous.toml answers.csv";
  const std::string words = on_terminal(folder.path(), ambiguous);
  CAPTURE(words);
  CHECK(words.starts_with("record 1: ambiguous\n  It is the motion stick/stick, "));
  CHECK(has(words, "\n  3 motions exist:\n    stick/stick: a=2.97273, "));
  CHECK(has(words,
            "record 2: wrong\n  It claims the mode stick/slip+, which violates N3 >= 0: the margin is\n  -0.50125.\n"));
  CHECK_FALSE(has(words, "{"));
  CHECK(widest_line(words) <= 80);
  CHECK(on_terminal(folder.path(), ambiguous + " --json").starts_with("{\"record\":1,"));
  CHECK(run({"certify", "--scene", sources + "/cases/ambiguous.toml", folder.path() / "answers.csv"})
            .out.starts_with("{\"record\":1,"));

  // The tolerance that is advised is one that helps.
  folder.write("belt.csv", "mu,ax,ay,az,alphax,alphay,alphaz\n0.3,2.3545,-1.7658,0,-88.29,-117.72,0\n");
  folder.write("plane.json", R"({"W": [[2, 0], [0, 2]], "q": [-1, 0], "mu": [0.5], "r": [0.5001, 0]})");
  for (const std::string rough : {"certify --scene cases/space/ball-on-belt.toml belt.csv", "certify plane.json"}) {
    CAPTURE(rough);
    const std::string inaccurate = on_terminal(folder.path(), rough), advice = "To accept it: --tolerance ";
    REQUIRE(has(inaccurate, advice));
    const std::size_t begin = inaccurate.find(advice) + advice.size();
    const std::string tolerance = inaccurate.substr(begin, inaccurate.find(".\n", begin) - begin);
    CHECK(tolerance != "0.01");  // no larger than it must be
    CHECK(has(on_terminal(folder.path(), rough + " --tolerance " + tolerance), "s CERTIFIED 1/1\n"));
    CHECK_FALSE(has(on_terminal(folder.path(), rough + " --tolerance 1e-5"), "s CERTIFIED"));
  }

  const std::string one = on_terminal(folder.path(), "certify cases/contact-problems/pushed-block.json");
  CHECK_FALSE(has(one, "{"));
  CHECK(has(one, "To find all solutions: --all."));
  CHECK(widest_line(one) <= 80);
}

TEST_CASE("results are coloured on a terminal that has colours, unless NO_COLOR says no") {
  const TemporaryFolder folder;
  const std::string command = "solve " + city_bicycle + " --load 1", green = "\033[1;32ms SOLVED ";
  CHECK(has(on_terminal(folder.path(), command, "TERM=xterm"), green));
  CHECK(has(on_terminal(folder.path(), command, "TERM=xterm NO_COLOR="), green));
  for (const std::string environment : {"TERM=dumb", "TERM=xterm NO_COLOR=1"}) {
    CHECK_FALSE(has(on_terminal(folder.path(), command, environment), "\033"));
  }
  CHECK_FALSE(has(run({"solve", city_bicycle}).out, "\033"));
}

TEST_CASE("help is at most 80 columns wide, has groups of options, and examples that run") {
  const TemporaryFolder folder;
  for (const char* name : {"cases", "proofs"}) {
    std::filesystem::create_directory_symlink(sources + "/" + name, folder.path() / name);
  }
  const std::string whole = run({"--help"}).out;
  CHECK(widest_line(whole) <= 80);
  std::istringstream lines(whole.substr(whole.find("Subcommands:")));
  std::size_t commands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ") || line.size() < 4 || line[2] == ' ') continue;
    const std::string name = line.substr(2, line.find(' ', 2) - 2), help = run({name, "--help"}).out;
    CAPTURE(name);
    ++commands;
    CHECK(widest_line(help) <= 80);
    const std::string begin = "\n  slipproof " + name + " ";
    REQUIRE(has(help, begin));
    const bool is_long = name == "trade" || name == "prove" || name == "report";  // they take seconds
    if (is_long || name == "import") continue;  // which needs parsers that a build may lack
    for (std::size_t at = help.find(begin); at != help.npos; at = help.find(begin, at + 1)) {
      const std::string example = help.substr(at + 13, help.find('\n', at + 1) - at - 13);
      CAPTURE(example);
      const auto end = shell(folder.path(), "$slipproof " + example + " >/dev/null");
      CHECK((end.exit_code == 0 || end.exit_code == 1));
      CHECK(end.err.empty());
    }
  }
  CHECK(commands >= 19);
  const std::string help = run({"certify", "--help"}).out;
  for (const char* group : {"\nOutput:\n", "\nWork:\n", "\nContact problems: ", "\nContinuous integration: "}) {
    CHECK(has(help, group));
  }
}
