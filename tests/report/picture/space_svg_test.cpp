// Pictures of scenes in space: forces, cones and slips where they are, to scale and seen from where one asks; nothing
// outside and no label over another.
#include "report/picture/space/space_svg.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "base/input/diagnostic.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "report/picture/drawn_mechanism.hpp"
#include "report/picture/labels/contact_table.hpp"
#include "report/picture/space/space_view.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::string space_header =
    "schema = \"slipproof/mechanism/1\"\nname = \"drawn\"\ndimension = 3\ngravity = [\"0\", \"0\", \"-10\"]\n";
const Vec3 from_above{0, 0, 1}, from_in_front{0, -1, 0};

/// A box of mass 2 on four corners that a force pushes.
MechanismScene pushed_box() {
  std::string text = space_header + R"(
[[body]]
name = "box"
mass = "2"
inertia = ["1", "1", "1"]
at = ["0", "0", "1"]
shape = { box = ["4", "2", "2"] }
[[force]]
on = "box"
at = ["-2", "0", "0"]
is = ["8", "6", "0"]
)";
  int number = 0;
  for (const char* corner :
       {"[\"-2\", \"-1\", \"-1\"]", "[\"2\", \"-1\", \"-1\"]", "[\"2\", \"1\", \"-1\"]", "[\"-2\", \"1\", \"-1\"]"}) {
    text += "[[contact]]\nname = \"p" + std::to_string(++number) + "\"\nof = \"box\"\npoint = " + corner +
            "\nnormal = [\"0\", \"0\", \"1\"]\nthrough = [\"0\", \"0\", \"0\"]\ntangent = [\"1\", \"0\", \"0\"]\n"
            "friction = \"1/2\"\n";
  }
  return parse_scene(text, "box.toml", Dimensions::any);
}

Range exact_range(const Rational& x) {
  return {x, x};
}

/// The first corner slips along (3, 4)/5, the second sticks, the third touches hardly, the fourth lifts.
SpaceMotion motion_of_box(const MechanismScene& scene) {
  const Mechanism& m = scene.mechanism;
  SpaceMotion motion;
  motion.modes = {"slip", "stick", "stick", "lift"};
  motion.slips = {exact_range(Rational(5313, 100)), {}, {}, {}};
  motion.accelerations.assign(acceleration_names(m).size(), exact_range(0));
  motion.forces.assign(force_names(m).size(), exact_range(0));
  const auto set = [&](std::size_t contact, const Rational& N, const Rational& T1, const Rational& T2) {
    const MechanismContact& c = m.contacts[contact];
    motion.forces[c.normal - m.accelerations] = exact_range(N);
    motion.forces[*c.tangent - m.accelerations] = exact_range(T1);
    motion.forces[c.second->force - m.accelerations] = exact_range(T2);
  };
  set(0, 10, -3, -4);
  set(1, 8, -1, 2);
  set(2, 4, Rational(1, 2), -1);
  motion.strict = true;
  return motion;
}

DrawnMechanism picture_of(const MechanismScene& scene, const SpaceMotion& motion, const Vec3& from) {
  SolvedSpace solved;
  solved.scene = scene;
  solved.motions = {motion};
  return read_picture(space_svg_file(solved, 0, from));
}

/// How many nodes of the drawing, without its legend, have a class.
std::size_t class_count(const DrawnMechanism& picture, const std::string& css) {
  return picture.tree.select_nodes(("//*[@class='" + css + "'][not(ancestor::g[@class='legend'])]").c_str()).size();
}
std::vector<DrawnArrow> drawn_arrows(const DrawnMechanism& picture, const std::string& css) {
  std::vector<DrawnArrow> all = arrows(picture, css);
  const std::size_t samples =
      picture.tree.select_nodes(("//g[@class='legend']/g[@class='" + css + "']").c_str()).size();
  all.resize(all.size() - samples);  // the legend is last
  return all;
}

}  // namespace

TEST_CASE("in space all drawn forces of a body add up to its mass times its acceleration, from everywhere") {
  const MechanismScene scene = pushed_box();
  const SpaceMotion motion = motion_of_box(scene);
  const Vec3 sum{8 - 3 - 1 + 0.5, 6 - 4 + 2 - 1, 10 + 8 + 4 - 20};
  for (const char* from : {"0,-1,0", "0,0,1", "1,-2,1", "-62,22", "170,-40"}) {
    CAPTURE(from);
    const DrawnMechanism picture = picture_of(scene, motion, view_direction(from));
    double right = 0, down = 0;
    for (const char* css : {"friction", "load", "load weight"}) {
      for (const DrawnArrow& arrow : drawn_arrows(picture, css)) right += arrow.dx, down += arrow.dy;
    }
    const SpaceView view(view_direction(from), {0, 0, 1});
    const double unit = 78.0 / 20;  // pixels for 1 N: the weight is the largest
    CHECK(right == doctest::Approx(unit * view.flat(sum)[0]).epsilon(0.01).scale(10));
    CHECK(down == doctest::Approx(-unit * view.flat(sum)[1]).epsilon(0.01).scale(10));
    check_readable(picture);
  }
}

TEST_CASE("each contact that pushes has its force in its cone, on the circle where it slips") {
  const MechanismScene scene = pushed_box();
  const DrawnMechanism picture = picture_of(scene, motion_of_box(scene), from_above);
  const auto forces = drawn_arrows(picture, "friction");
  REQUIRE(forces.size() == 3);
  CHECK(class_count(picture, "cone") == 6);  // the cone and its circle
  CHECK(class_count(picture, "contact ink") == 3);
  CHECK(class_count(picture, "contact paper frame") == 1);
  const double unit = 78.0 / 20;
  CHECK(forces[0].length() == doctest::Approx(unit * 5).epsilon(0.01));  // mu N
  CHECK(forces[1].length() == doctest::Approx(unit * std::sqrt(5.0)).epsilon(0.01));
  double radius = 0;
  const auto circle = numbers(picture.tree.select_nodes("//path[@class='cone']")[1].node().attribute("d").value());
  for (std::size_t i = 0; i < circle.size(); i += 2)
    radius = std::max(radius, std::hypot(circle[i] - forces[0].from_x, circle[i + 1] - forces[0].from_y));
  CHECK(radius == doctest::Approx(unit * 5).epsilon(0.01));
}

TEST_CASE("a slip points where its angle says, and a wide enclosure has a sector") {
  const MechanismScene scene = pushed_box();
  SpaceMotion motion = motion_of_box(scene);
  const DrawnMechanism narrow = picture_of(scene, motion, from_above);
  const auto slips = drawn_arrows(narrow, "slips");
  REQUIRE(slips.size() == 1);
  CHECK(std::atan2(-slips[0].dy, slips[0].dx) * 180 / std::numbers::pi == doctest::Approx(53.13).epsilon(0.01));
  CHECK(class_count(narrow, "arc") == 0);
  motion.slips[0] = Range{Rational(20), Rational(80)};
  const DrawnMechanism wide = picture_of(scene, motion, from_above);
  REQUIRE(class_count(wide, "arc") == 1);
  const auto sector = numbers(wide.tree.select_node("//path[@class='arc']").node().attribute("d").value());
  const auto angle = [&](std::size_t i) {
    return std::atan2(sector[1] - sector[i + 1], sector[i] - sector[0]) * 180 / std::numbers::pi;
  };
  CHECK(angle(2) == doctest::Approx(20).epsilon(0.02));
  CHECK(angle(sector.size() - 2) == doctest::Approx(80).epsilon(0.02));
  CHECK(all_text(wide.tree.document_element()).find("slip at [20.0°, 80.0°]") != std::string::npos);
}

TEST_CASE("a force that is open is dashed, and one of which a part is not known is not drawn") {
  const MechanismScene scene = pushed_box();
  SpaceMotion motion = motion_of_box(scene);
  const Mechanism& m = scene.mechanism;
  motion.forces[m.contacts[1].normal - m.accelerations] = Range{Rational(6), Rational(10)};
  const auto forces = drawn_arrows(picture_of(scene, motion, from_in_front), "friction");
  REQUIRE(forces.size() == 3);
  CHECK_FALSE(forces[0].dashed);
  CHECK(forces[1].dashed);
  motion.forces[m.contacts[1].normal - m.accelerations] = std::nullopt;
  const DrawnMechanism unknown = picture_of(scene, motion, from_in_front);
  CHECK(drawn_arrows(unknown, "friction").size() == 2);
  CHECK(all_text(unknown.tree.document_element()).find("N open") != std::string::npos);
}

TEST_CASE("velocities are whole, accelerations dotted, and who does not move has neither") {
  MechanismScene scene = parse_scene(space_header + R"(
[[body]]
name = "ball"
mass = "1"
inertia = ["1", "1", "1"]
at = ["0", "0", "1"]
velocity = ["0", "3", "0"]
shape = { sphere = "1" }
[[body]]
name = "still"
acceleration = ["0", "0", "0"]
at = ["4", "0", "1"]
shape = [{ cylinder = ["1", "2"] }, { capsule = ["1/2", "1"], at = ["0", "0", "2"], axis = ["1", "0", "0"] },
         { hull = [["0", "0", "0"], ["2", "0", "0"], ["0", "2", "0"], ["0", "0", "2"]] }]
[[contact]]
name = "below"
of = "ball"
point = ["0", "0", "-1"]
on = "still"
normal = ["0", "0", "1"]
through = ["-4", "0", "-1"]
)",
                                     "ball.toml", Dimensions::any);
  SpaceMotion motion;
  motion.modes = {"touch"};
  motion.slips.resize(1);
  motion.forces.assign(force_names(scene.mechanism).size(), exact_range(0));
  motion.accelerations.assign(acceleration_names(scene.mechanism).size(), exact_range(0));
  motion.accelerations[2] = exact_range(-10);
  const DrawnMechanism picture = picture_of(scene, motion, view_direction("1,-3,1"));
  CHECK(drawn_arrows(picture, "velocity").size() == 1);
  const auto accelerations = drawn_arrows(picture, "acceleration");
  REQUIRE(accelerations.size() == 1);
  CHECK(accelerations[0].dashed);
  CHECK(accelerations[0].dy > 0);
  CHECK(class_count(picture, "solid") == 4);
  check_readable(picture);
}

TEST_CASE("a shadow falls straight down, and what is asked decides where one looks from") {
  const MechanismScene scene = parse_scene(space_header + R"(
[[body]]
name = "ball"
mass = "1"
inertia = ["1", "1", "1"]
at = ["3", "0", "5"]
shape = { sphere = "1" }
[[contact]]
name = "below"
of = "ball"
point = ["0", "0", "-5"]
normal = ["0", "0", "1"]
through = ["0", "0", "0"]
)",
                                           "ball.toml", Dimensions::any);
  const auto spans = [](const DrawnMechanism& picture, const std::string& path) {
    std::array<double, 2> span{1e300, -1e300};
    for (const auto& found : picture.tree.select_nodes(path.c_str())) {
      const auto all = numbers(found.node().attribute("d").value());
      for (std::size_t i = 0; i < all.size(); i += 2) span = {std::min(span[0], all[i]), std::max(span[1], all[i])};
    }
    return span;
  };
  const DrawnMechanism front = read_picture(space_svg_file(scene, view_direction("0,-4,1")));
  const auto shadow = spans(front, "//path[@class='shadow']"), ball = spans(front, "//g[@class='solid']//path");
  CHECK(shadow[0] == doctest::Approx(ball[0]).epsilon(0.01).scale(100));
  CHECK(shadow[1] == doctest::Approx(ball[1]).epsilon(0.01).scale(100));
  CHECK(space_svg_file(scene, from_above) != space_svg_file(scene, from_in_front));
  const DrawnMechanism below = read_picture(space_svg_file(scene, view_direction("0,-4,-1")));
  CHECK(class_count(below, "shadow") == 0);
}

/// A ball of the weight 10 hangs from the ceiling.
TEST_CASE("a rope pulls the ball, with its own symbol, its name once, and units where the file has some") {
  const auto picture = [](const std::string& unit) {
    const Mechanism mechanism =
        parse_mechanism(space_header + "parameters = { r = { domain = \"r > 0\"" + unit + R"( } }
[[body]]
name = "ball"
mass = "1"
inertia = ["1", "1", "1"]
at = ["0", "0", "0"]
velocity = ["1", "0", "0"]
shape = { sphere = "r" }
[[joint]]
name = "cord"
kind = "rope"
between = ["ground", "ball"]
at = ["0", "0", "3"]
to = ["0", "0", "0"]
length = "3"
)",
                        "ball.toml");
    MechanismScene scene{"ball", mechanism, default_values(mechanism), std::nullopt, {}};
    scene.values.parameters = {1};
    SpaceMotion motion;
    motion.modes = {"touch"};
    motion.slips.resize(1);
    motion.forces.assign(1, exact_range(10));
    motion.accelerations.assign(acceleration_names(scene.mechanism).size(), exact_range(0));
    return picture_of(scene, motion, from_in_front);
  };
  const DrawnMechanism plain = picture("");
  const auto forces = drawn_arrows(plain, "friction"), weights = drawn_arrows(plain, "load weight");
  REQUIRE(forces.size() == 1);
  REQUIRE(weights.size() == 1);
  CHECK(forces[0].dy < -70);  // up
  CHECK(forces[0].from_y == doctest::Approx(weights[0].from_y).epsilon(0.01).scale(100));
  const std::string text = all_text(plain.tree.document_element());
  CHECK(text.find("T = 10") != std::string::npos);
  CHECK(text.find("N = ") == std::string::npos);
  CHECK(text.find("v = 1 m/s") == std::string::npos);
  CHECK(plain.tree.select_nodes("//text[starts-with(.,'cord') and @class='soft halo']").size() == 1);
  CHECK(all_text(picture(", unit = \"m\"").tree.document_element()).find("v = 1 m/s") != std::string::npos);
}

TEST_CASE("motions side by side say what they are, each with all of its contacts") {
  SolvedSpace solved;
  solved.scene = pushed_box();
  solved.motions = {motion_of_box(solved.scene), motion_of_box(solved.scene)};
  solved.motions[1].unique = false;
  solved.motions[1].open_directions = 1;
  solved.motions[1].strict = false;
  const DrawnMechanism sheet = read_picture(space_motions_svg_file(solved, view_direction(usual_view)));
  CHECK(sheet.tree.select_nodes("/svg/svg").size() == 2);
  CHECK(sheet.tree.select_nodes("//circle[starts-with(@class,'contact')]").size() == 8);
  const std::string text = all_text(sheet.tree.document_element());
  for (const char* words :
       {"1 motion and a continuum of motions", "1: slip/stick/stick/lift", "2: slip/stick/stick/lift (boundary)",
        "one of a continuum, forces open along 1 direction", "N = 10", "T = (−3, −4)"}) {
    CAPTURE(words);
    CHECK(text.find(words) != std::string::npos);
  }
  solved.motions.clear();
  CHECK(space_motions_svg_file(solved, from_above).find(">no motion<") != std::string::npos);
}

TEST_CASE("many contacts have letters, which a table explains, alone and in a motion") {
  std::string text =
      space_header +
      "[[body]]\nname = \"slab\"\nmass = \"1\"\ninertia = [\"1\", \"1\", \"1\"]\nat = [\"0\", \"0\", \"1\"]\n"
      "shape = { box = [\"10\", \"2\", \"2\"] }\n";
  for (int i = 0; i < 9; ++i) {
    text += "[[contact]]\nname = \"foot" + std::to_string(i) + "\"\nof = \"slab\"\npoint = [\"" +
            std::to_string(i - 4) + "\", \"" + std::to_string(i % 2) +
            "\", \"-1\"]\nnormal = [\"0\", \"0\", \"1\"]\nthrough = [\"0\", \"0\", \"0\"]\ntangent = [\"1\", \"0\", "
            "\"0\"]\n"
            "friction = \"1/2\"\n";
  }
  const MechanismScene scene = parse_scene(text, "slab.toml", Dimensions::any);
  SpaceMotion motion;
  motion.modes.assign(9, "stick");
  motion.slips.resize(9);
  motion.accelerations.assign(acceleration_names(scene.mechanism).size(), exact_range(0));
  motion.forces.assign(force_names(scene.mechanism).size(), exact_range(Rational(1, 7)));
  const auto check = [](const DrawnMechanism& picture, const std::string& also) {
    check_readable(picture);
    const std::string words = all_text(picture.tree.document_element());
    for (const std::string& expected : {std::string("i  foot8"), also}) {
      CAPTURE(expected);
      CHECK(words.find(expected) != std::string::npos);
    }
  };
  const DrawnMechanism alone = read_picture(space_svg_file(scene, view_direction(usual_view)));
  check(alone, "N of a contact");
  std::vector<double> across;
  for (const auto& found : alone.tree.select_nodes("//circle[starts-with(@class,'contact')]"))
    across.push_back(found.node().attribute("cx").as_double());
  const auto [left, right] = std::ranges::minmax(across);
  CHECK(right - left > lettered_width / 2);  // the rest is the floor around the slab
  check(picture_of(scene, motion, view_direction(usual_view)), "T = (1/7, 1/7)");
}
