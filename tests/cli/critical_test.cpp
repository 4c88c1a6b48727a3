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
  CHECK(document["ranges"].size() == 4);
}

TEST_CASE("critical refuses what it cannot vary") {
  const std::string scene = SLIPPROOF_SOURCE_DIR "/cases/ambiguous.toml";
  const auto wrong = run({"critical", scene, "--x", "mu_wall"});
  CHECK(wrong.exit_code == 3);
  CHECK(wrong.err.find("mu_wall") != std::string::npos);
  CHECK(run({"critical", "nowhere.toml"}).exit_code == 3);
}
