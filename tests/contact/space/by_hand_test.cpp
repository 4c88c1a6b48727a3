// Scenes in space whose motion is worked out by hand.
#include <doctest/doctest.h>

#include <string>

#include "contact/space/motion_value.hpp"
#include "contact/space/solved_text.hpp"

using namespace slipproof;
using test::contains;
using test::is;
using test::value;

namespace {

/// A particle on a disc that turns about the z axis with the spin 2, at the distance 1 from it.
std::string particle_on_disc(const std::string& velocity, const std::string& mu) {
  return R"(
[[body]]
name = "disc"
acceleration = ["0", "0", "0"]
spin = ["0", "0", "2"]
[[body]]
name = "particle"
mass = "3"
turning = ["0", "0", "0"]
spin = ["0", "0", "0"]
at = ["1", "0", "0"]
velocity = [)" +
         velocity + "]\n" + test::standing("p", "particle", R"("0", "0", "0")", mu, "disc");
}

const std::string moving_belt = R"(
[[body]]
name = "belt"
velocity = ["1", "0", "0"]
acceleration = ["1", "0", "0"]
)";

std::string sliding_box(const std::string& vx, const std::string& vy) {
  return R"(
[[body]]
name = "box"
mass = "4"
inertia = ["1", "1", "1"]
at = ["0", "0", "1"]
velocity = [")" +
         vx + "\", \"" + vy + "\", \"0\"]\n";
}

std::string four_feet(const std::string& on) {
  std::string text;
  for (const auto& [name, x, y] :
       {std::tuple("pp", "1", "1"), {"pm", "1", "-1"}, {"mp", "-1", "1"}, {"mm", "-1", "-1"}}) {
    text += test::standing(name, "box", std::string("\"") + x + "\", \"" + y + "\", \"-1\"", "1/5", on);
  }
  return text;
}

}  // namespace

TEST_CASE("what rests on a turning disc follows it, or slips outwards") {
  const SolvedSpace follows = test::solved_text(particle_on_disc(R"("0", "2", "0")", "1/2"));
  CHECK(follows.motions.front().modes == std::vector<std::string>{"stick"});
  CHECK(is(follows, "ax", -4));  // spin^2 r, below mu g = 5
  CHECK(is(follows, "ay", 0));
  CHECK(is(follows, "T1_p", -12));
  const SolvedSpace slips = test::solved_text(particle_on_disc(R"("0", "2", "0")", "3/10"));
  CHECK(slips.motions.front().modes == std::vector<std::string>{"slip"});
  CHECK(contains(slips, "ax", -3));     // - mu g
  CHECK(contains(slips, "slip_p", 1));  // 4 - 3
  CHECK(contains(slips, "N_p", 30));
  CHECK(contains(slips, "T1_p", -9));
  REQUIRE(slips.motions.front().slips[0]);
  CHECK(abs(*slips.motions.front().slips[0]->lower) < Rational(1, 1'000'000));
}

TEST_CASE("what slides on a turning disc feels Coriolis' force where it is seen from the disc") {
  const SolvedSpace slides = test::solved_text(particle_on_disc(R"("7", "2", "0")", "3/10"));  // outwards, with 7
  CHECK(is(slides, "ax", -3));
  CHECK(is(slides, "ay", 0));
  CHECK(is(slides, "slip_p", 1));     // spin^2 r - mu g
  CHECK(is(slides, "slip2_p", -28));  // - 2 spin v
  CHECK(is(slides, "T1_p", -9));
  CHECK(is(slides, "T2_p", 0));
}

/// With the moment A about each axis across its own and C about it, and the distance 1 from the foot to the centre of
/// mass: a regular precession P of a top whose axis makes the angle t with the vertical has
/// C w P - (A + m) P^2 cos t = m g, where w is its spin along its axis, and turns all vectors with P.
TEST_CASE("a spinning top precesses about its foot") {
  const SolvedSpace top = test::solved_text(R"(
[[body]]
name = "top"
mass = "1"
inertia = ["3/2", "3/2", "2"]
at = ["4/5", "0", "3/5"]
turn = ["2", "0", "1", "0"]
velocity = ["0", "4/5", "0"]
spin = ["103/25", "0", "409/100"]
)" + test::standing("foot", "top", R"("0", "0", "-1")", "1/2"));
  CHECK(top.motions.front().modes == std::vector<std::string>{"stick"});
  CHECK(is(top, "ax", Rational(-4, 5)));
  CHECK(is(top, "ay", 0));
  CHECK(is(top, "az", 0));
  CHECK(is(top, "alphax", 0));
  CHECK(is(top, "alphay", Rational(103, 25)));
  CHECK(is(top, "alphaz", 0));
  CHECK(is(top, "N_foot", 10));
}

/// A x alpha = R T2 + (C - A) w P with T2 = -m R alpha: w is its rolling, P its turning about the vertical.
TEST_CASE("a coin that rolls upright and is steered leans") {
  const SolvedSpace coin = test::solved_text(R"(
[[body]]
name = "coin"
mass = "1"
inertia = ["1/4", "1/2", "1/4"]
at = ["0", "0", "1"]
velocity = ["5", "0", "0"]
spin = ["0", "5", "1"]
)" + test::standing("edge", "coin", R"("0", "0", "0")", "1/2") +
                                             "radius = \"1\"\n");
  CHECK(coin.motions.front().modes == std::vector<std::string>{"stick"});
  CHECK(is(coin, "alphax", 1));
  CHECK(is(coin, "ay", -1));
  CHECK(is(coin, "T2_edge", -1));
  CHECK(is(coin, "N_edge", 10));
}

/// A ball rolls on the outside of a fixed one: at the top with the velocity v it is held by N = m g - m v^2/D. Its spin
/// w about the normal, which turns by v/D, would let it slip by w (v2, -v1)/D; forces move it by 1/m + R^2/I.
TEST_CASE("a ball that rolls over another is lighter") {
  const SolvedSpace ball = test::solved_text(R"(
[[body]]
name = "ball"
mass = "2"
inertia = ["4/5", "4/5", "4/5"]
at = ["0", "0", "3"]
velocity = ["3", "4", "0"]
spin = ["-4", "3", "1/2"]
[[contact]]
name = "top"
of = "ball"
point = ["0", "0", "0"]
radius = "1"
on_point = ["0", "0", "0"]
on_radius = "2"
friction = "1"
)");
  CHECK(ball.motions.front().modes == std::vector<std::string>{"stick"});
  CHECK(is(ball, "az", Rational(-25, 3)));
  CHECK(is(ball, "N_top", Rational(10, 3)));
  CHECK(is(ball, "T1_top", Rational(-2, 3) / Rational(7, 4)));
  CHECK(is(ball, "T2_top", Rational(1, 2) / Rational(7, 4)));
}

TEST_CASE("a box slides to where its velocity points, also where that is no rational direction") {
  const SolvedSpace solved = test::solved_text(sliding_box("1", "1") + four_feet("ground"));
  CHECK(solved.motions.front().modes.front() == "slip");
  for (const char* along : {"ax", "ay"}) {
    const Range a = value(solved, along);  // - mu g / sqrt(2) = - sqrt(2)
    CHECK(*a.upper < 0);
    CHECK(*a.lower * *a.lower >= 2);
    CHECK(*a.upper * *a.upper <= 2);
    CHECK(*a.upper - *a.lower < Rational(1, 1'000'000));
  }
  CHECK(solved.motions.front().slips[0]->lower.value() <= 45);
  CHECK(solved.motions.front().slips[0]->upper.value() >= 45);
}

TEST_CASE("a box that slides on four feet has one motion, by forces that are open along one direction") {
  const SolvedSpace solved = test::solved_text(moving_belt + sliding_box("0", "0") + four_feet("belt"));
  REQUIRE(solved.motions.size() == 1);
  const SpaceMotion& motion = solved.motions.front();
  CHECK(motion.unique);
  CHECK(motion.strict);
  CHECK(motion.open_directions == 1);  // of four normal forces with three equations
  CHECK(motion.modes == std::vector<std::string>(4, "slip"));
  CHECK(is(solved, "ax", 2));  // mu g, forwards
  CHECK(*value(solved, "N_pp").lower + *value(solved, "N_mm").lower == 20);
}

/// Forces at the floor that balance without a turn: found with a foot that only touches, which others can share.
TEST_CASE("forces are open as well where the directions of slips are no rational numbers") {
  const std::string pull = "[[force]]\non = \"box\"\nat = [\"0\", \"0\", \"-1\"]\nis = [\"10\", \"7\", \"0\"]\n";
  const SolvedSpace solved = test::solved_text(sliding_box("0", "0") + pull + four_feet("ground"));
  REQUIRE(solved.motions.size() == 1);
  CHECK(solved.motions.front().modes == std::vector<std::string>(4, "slip"));
  CHECK(solved.motions.front().strict);
  CHECK(solved.motions.front().open_directions == 1U);  // of four normal forces with three equations
}
