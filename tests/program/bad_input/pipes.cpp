// Named pipes among the files that the program finds or names itself: it must not wait for them. Each command has a
// minute: 124 says that it was still waiting.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <string>

#include "support/run_program.hpp"

using slipproof::test::ProgramEnd;
using slipproof::test::quoted;
using slipproof::test::TemporaryFolder;

namespace {

/// A claim with the two statements P.always and P.only-then about a block that is pushed.
class Paper : public TemporaryFolder {
 public:
  Paper() {
    write("m.toml", R"(schema = "slipproof/mechanism/1"
name = "m"
gravity = ["0", "-g"]
parameters = { m = "m > 0", mu = "mu >= 0", g = "g > 0" }
load = { symbol = "F" }
body = [{ name = "A", mass = "m", turning = "0" }]
contact = [{ name = "q", of = "A", point = ["0", "0"], normal = ["0", "1"], through = ["0", "0"], friction = "mu" }]
force = [{ on = "A", is = ["F", "0"] }]
)");
    write("claims.toml", R"(schema = "slipproof/claims/1"
paper = { title = "t", authors = ["a"], source = "n.txt" }
[[setting]]
id = "a"
mechanism = "m.toml"
motions = "closed"
[setting.parameters]
m = { domain = "m > 0", meaning = "x" }
mu = { domain = "mu >= 0", meaning = "x" }
g = { domain = "g > 0", meaning = "x" }
[[claim]]
id = "P"
line = 1
statement = "x"
kind = "interval"
mode = "slip+"
forces = "F >= mu*m*g"
)");
  }

  void pipe(const std::string& name) const {
    std::filesystem::create_directories((path() / name).parent_path());
    std::filesystem::remove(path() / name);
    REQUIRE(::mkfifo((path() / name).c_str(), 0600) == 0);
  }
};

ProgramEnd within(const TemporaryFolder& folder, const std::string& arguments) {
  const std::string program = std::string(SLIPPROOF_BINARY_DIR) + "/slipproof";
  const std::string script = "cd " + quoted(folder.path().string()) + " && timeout 60 " + quoted(program) + ' ' +
                             arguments + " --quiet >out 2>err";
  const int status = std::system(script.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, slipproof::test::read_file(folder.path() / "out"),
          slipproof::test::read_file(folder.path() / "err")};
}

const std::string verify = "verify claims.toml --samples 20 --lines 0 --threads 1";

}  // namespace

TEST_CASE("verify: a named pipe in place of a statement or a certificate proves nothing and is not waited for") {
  const Paper paper;
  paper.pipe("certificates/P.always.statement");
  const ProgramEnd end = within(paper, verify);
  CHECK(end.exit_code != 124);
  CHECK(end.out.find(" proved 0 missing 2") != std::string::npos);
  const Paper other;
  REQUIRE(within(other, "prove claims.toml --threads 1").exit_code == 0);
  CHECK(within(other, verify).exit_code == 0);
  other.pipe("claims.theorems");
  CHECK(within(other, verify).exit_code != 124);
}

TEST_CASE("prove: a named pipe in place of a statement or a certificate is refused by its name") {
  for (const char* name : {"claims.theorems", "by-hand.theorems", "mine.statement", "certificates/P.always.statement",
                           "certificates/P.always.cert", "certificates/claims.canonical"}) {
    CAPTURE(name);
    const Paper paper;
    paper.pipe(name);
    const ProgramEnd end = within(paper, "prove claims.toml --threads 1");
    if (std::string(name) == "certificates/P.always.cert" || std::string(name) == "certificates/claims.canonical") {
      CHECK(end.exit_code == 0);  // the theorem file replaces the folder, and nobody opens it
      continue;
    }
    CHECK((end.exit_code == 3 || end.exit_code == 6));
    CHECK(end.err.find(std::string(name) + ": ") != std::string::npos);
    CHECK(end.err.find("a pipe or a device") != std::string::npos);
  }
}

TEST_CASE("report: a named pipe beside the claims is refused by its name") {
  for (const char* name : {"figures.toml", "second-opinions.csv"}) {
    CAPTURE(name);
    const Paper paper;
    paper.pipe(name);
    const ProgramEnd end = within(paper, "report claims.toml --samples 20 --lines 0 --threads 1 --out page.html");
    CHECK(end.exit_code == 3);
    CHECK(end.err.find(name) != std::string::npos);
  }
}

TEST_CASE("an input that the user names may be a pipe") {
  const Paper paper;
  const std::string program = quoted(std::string(SLIPPROOF_BINARY_DIR) + "/slipproof");
  paper.write("scene.toml", R"(name = "x"
mechanism = "m.toml"
values = { m = "1", mu = "1", g = "1", F = "2" }
)");
  paper.pipe("scene");
  // tee opens the pipe itself, so that its minute ends where nobody reads
  const std::string script = "cd " + quoted(paper.path().string()) +
                             " && { timeout 60 tee scene <scene.toml >/dev/null 2>&1 & } && timeout 60 " + program +
                             " solve scene --quiet >out 2>err";
  const int status = std::system(script.c_str());
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(slipproof::test::read_file(paper.path() / "out").find("s SOLVED") != std::string::npos);
}
