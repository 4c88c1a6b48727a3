// From where scenes in space are drawn, and whether the shipped ones can be read from there.
#include "report/picture/space/space_view.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "report/picture/drawn_mechanism.hpp"
#include "report/picture/space/space_svg.hpp"

using namespace slipproof;
using namespace slipproof::test;

TEST_CASE("a direction to look from is three numbers or two angles, and anything else is refused in words") {
  const Vec3 axis = view_direction("0, 0, 5"), angles = view_direction("90,0"), high = view_direction("-60,30");
  CHECK(axis[2] == doctest::Approx(1));
  CHECK(angles[1] == doctest::Approx(1));
  CHECK(high[0] == doctest::Approx(std::cos(std::numbers::pi / 6) / 2));
  CHECK(high[2] == doctest::Approx(0.5));
  for (const char* wrong : {"", "1", "1,2,3,4", "a,b", "1,,2", "0,0,0", "10,91"}) {
    CAPTURE(wrong);
    try {
      view_direction(wrong);
      CHECK(false);
    } catch (const std::invalid_argument& error) {
      const std::string message = error.what();
      CHECK(message.starts_with("found '" + std::string(wrong) + "'"));
      CHECK(message.find("expected a direction x,y,z to look from, such as 1,-2,1") != std::string::npos);
    }
  }
}

TEST_CASE("every shipped scene in space can be read, from several sides") {
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SLIPPROOF_SOURCE_DIR "/cases/space")) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path());
    const MechanismScene scene = read_scene(entry.path(), Dimensions::any);
    for (const char* from : {"-62,22", "30,40", "0,0,1", "1,0,0"}) {
      CAPTURE(from);
      const DrawnMechanism picture = read_picture(space_svg_file(scene, view_direction(from)));
      check_readable(picture);
      CHECK(picture.tree.select_nodes("//circle[starts-with(@class,'contact')]").size() ==
            scene.mechanism.contacts.size());
      ++pictures;
    }
  }
  CHECK(pictures >= 4);
}
