#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

#include "mechanics/scene/scene.hpp"
#include "table.hpp"

using namespace slipproof;
using namespace slipproof::test;

TEST_CASE("every malformed scene gets its messages") {
  const auto rows = read_bad_inputs(SLIPPROOF_SOURCE_DIR "/tests/program/bad_input/scenes.toml");
  CHECK(rows.size() >= 60);
  std::set<std::string> names;
  for (const BadInput& row : rows) {
    CAPTURE(row.what);
    CHECK(names.insert(row.what).second);
    CHECK(row.exit == 3);
    const auto messages = said(row, [](const std::string& text) { parse_scene(text, "scene.toml"); });
    for (std::size_t i = 0; i < std::max(messages.size(), row.says.size()); ++i) {
      const std::string expected = i < row.says.size() ? row.says[i] : "nothing more";
      const std::string found = i < messages.size() ? messages[i] : "nothing more";
      CHECK(found == expected);
    }
  }
}

TEST_CASE("the good scene of the table is good") {
  Mistakes mistakes("scenes.toml");
  const auto table = parse_toml(read_text_file(SLIPPROOF_SOURCE_DIR "/tests/program/bad_input/scenes.toml"), mistakes);
  REQUIRE(table);
  CHECK_NOTHROW(parse_scene(table->find("good")->value.text.text(), "good"));
}
