#include <doctest/doctest.h>

#include <string>

#include "mechanics/scene/scene.hpp"
#include "table.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::string bad_scenes = SLIPPROOF_SOURCE_DIR "/tests/program/bad_input/scenes.toml";

}  // namespace

TEST_CASE("every malformed scene gets its messages") {
  check_bad_inputs(bad_scenes, 60, [](const std::string& text) { parse_scene(text, "scene.toml"); });
}

TEST_CASE("the good scene of the table is good") {
  CHECK_NOTHROW(parse_scene(good_input(bad_scenes), "good"));
}
