#include <doctest/doctest.h>

#include <algorithm>

#include "support/run_program.hpp"

using namespace slipproof::test;

TEST_CASE("show prints what was understood of a shipped mechanism, and of a file") {
  const auto shipped = run({"show", "painleve-rod"});
  CHECK(shipped.exit_code == 0);
  CHECK(shipped.err.empty());
  CHECK(shipped.out.find("  phi  I * phi = l * c * N + l * s * S\n") != std::string::npos);
  CHECK(shipped.out.find("  tip: slides forward, friction mu\n") != std::string::npos);
  CHECK(shipped.out.find("\nModes: 2\n") != std::string::npos);
  const auto file = run({"show", SLIPPROOF_SOURCE_DIR "/cases/mechanisms/painleve-rod.toml"});
  CHECK(file.out == shipped.out);
}

TEST_CASE("show tells what looks wrong, and refuses what is wrong") {
  const TemporaryFolder folder;
  std::string text = read_file(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/painleve-rod.toml");
  const auto replace = [&](const std::string& what, const std::string& by) {
    text.replace(text.find(what), what.size(), by);
  };
  replace("\"m*ay = -m*g\"", "\"m*ay = -g\"");
  const auto odd = run({"show", folder.write("odd.toml", text)});
  CHECK(odd.exit_code == 0);
  std::string unwrapped = odd.out;
  std::replace(unwrapped.begin(), unwrapped.end(), '\n', ' ');
  CHECK(unwrapped.find("odd.toml:30:7: warning: the equation ay has m.kg.s-2 and m.s-2") != std::string::npos);
  replace("m*ay = -g", "m*az = -g");
  const auto wrong = run({"show", folder.write("wrong.toml", text)});
  CHECK(wrong.exit_code == 3);
  CHECK(wrong.out.empty());
  CHECK(wrong.err.find("wrong.toml:30:9: ay: unknown symbol 'az', did you mean 'ax'?") != std::string::npos);
  CHECK(run({"show", "painleve"}).exit_code == 3);
  CHECK(run({"show"}).exit_code == 2);
}
