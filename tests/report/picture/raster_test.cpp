// Maps of scenes in space as pictures: a rectangle of colour and a dot for each place, and what is not known hatched.
#include <doctest/doctest.h>

#include <string>

#include "base/output/json.hpp"
#include "report/phase/phase_svg.hpp"
#include "report/picture/drawn_mechanism.hpp"
#include "report/values/set_json.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

MotionSet set_in_space(std::vector<std::vector<MechanismMode>> motions, bool complete = true) {
  MotionSet set;
  set.motions = std::move(motions);
  set.in_space = true;
  set.complete = complete;
  return set;
}

/// Below the diagonal it slips, on it is not known what else, above it is the domain's end.
PhaseDiagram drawn_raster() {
  Plane plane;
  plane.id = "r";
  plane.title = "raster";
  plane.x = {"mu", 0, 4};
  plane.y = {"F", 0, 4};
  plane.finds_domain = plane.joins_alike = true;
  plane.words = [](const MechanismMode&) { return std::string("words"); };
  plane.place = [](const Rational& x, const Rational& y) -> std::optional<MotionSet> {
    if (y > x) return std::nullopt;
    return set_in_space({{{ElementState::slip_forward}}}, y < x);
  };
  return raster_diagram(std::move(plane), 4, 4, {});
}

}  // namespace

TEST_CASE("a raster has a dot for each place of the domain, and says what is not decided") {
  const DrawnMechanism picture = read_picture(phase_svg_file(drawn_raster()));
  CHECK(picture.tree.select_nodes("//circle[@class='ink place']").size() == 10);
  CHECK(picture.tree.select_nodes("//pattern").size() == 1);
  CHECK(picture.tree.select_nodes("//pattern/path[@class='hatching']").size() == 1);
  const std::string text = all_text(picture.tree.document_element());
  for (const char* words : {"slip: words", "slip, perhaps others", "12 of 16 completely", "White is out of the domain",
                            "hatched: not proved that there are no others"}) {
    CAPTURE(words);
    CHECK(text.find(words) != std::string::npos);
  }
  CHECK(text.find("slip+") == std::string::npos);
}

TEST_CASE("motions at a place are told by their modes, complete or not") {
  CHECK(set_json(std::nullopt) == Json{{"inside", false}});
  const MechanismMode slips{ElementState::slip_forward, ElementState::lift};
  const Json set = set_json(set_in_space({{slips}}, false));
  CHECK(set["motions"] == Json::array({"slip/lift"}));
  CHECK(set["complete"] == false);
  CHECK(name(set_in_space({})) == "no motion");
  CHECK(name(set_in_space({}, false)) == "not decided");
}
