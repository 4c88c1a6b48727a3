#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/run_program.hpp"

using slipproof::test::last_line;
using slipproof::test::run;

TEST_CASE("critical tells where several motions begin, as text and as JSON") {
  const std::string scene = SLIPPROOF_SOURCE_DIR "/cases/ambiguous.toml";
  const auto text = run({"critical", scene});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("f in (21/25, oo)") != std::string::npos);
  CHECK(text.out.find("up to 3 motions") != std::string::npos);
  CHECK(last_line(text.out) == "s SEVERAL at f = 1; critical f 21/25\n");
  CHECK(run({"critical", scene, "--quiet"}).out == "s SEVERAL at f = 1; critical f 21/25\n");
  const auto document = nlohmann::json::parse(run({"critical", scene, "--json"}).out);
  CHECK(document["schema"] == "slipproof/critical/1");
  CHECK(document["critical"] == "21/25");
  CHECK(document["at_value"]["one_motion"] == false);
  CHECK(document["ranges"].size() == 5);
  CHECK(text.out.find("f = 2/5\n    one motion at every F\n    not one under all other forces: the determinant of "
                      "slip-/slip+ is 0\n  f in (2/5, 21/25)\n") != std::string::npos);
}

TEST_CASE("critical refuses what it cannot vary") {
  const std::string scene = SLIPPROOF_SOURCE_DIR "/cases/ambiguous.toml";
  const auto wrong = run({"critical", scene, "--x", "mu_wall"});
  CHECK(wrong.exit_code == 3);
  CHECK(wrong.err.find("mu_wall") != std::string::npos);
  CHECK(run({"critical", "nowhere.toml"}).exit_code == 3);
}

TEST_CASE("critical draws what it tells over the parameter and the load") {
  const std::string scene = SLIPPROOF_SOURCE_DIR "/cases/ambiguous.toml";
  const slipproof::test::TemporaryFolder folder;
  const auto drawn = [&](const std::string& from) {
    const std::string file = (folder.path() / "critical.svg").string();
    CHECK(run({"critical", from, "--quiet", "-o", file}).exit_code == 0);
    return slipproof::test::read_file(file);
  };
  const std::string several = drawn(scene);
  CHECK(several.find("f = 21/25") != std::string::npos);
  CHECK(several.find("several motions") != std::string::npos);
  CHECK(several.find("no motion") == std::string::npos);
  CHECK(drawn(SLIPPROOF_SOURCE_DIR "/cases/mechanisms/scenes/ladder.toml").find("no motion") == std::string::npos);
  CHECK(run({"critical", scene, "-o", "critical.txt"}).err.find(".svg") != std::string::npos);
}
