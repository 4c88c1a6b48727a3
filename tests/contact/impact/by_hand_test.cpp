// Impacts in the plane whose outcome is worked out by hand.
#include <doctest/doctest.h>

#include <array>

#include "base/input/diagnostic.hpp"
#include "contact/impact/impact_of.hpp"

using namespace slipproof;
using test::after;
using test::energy_after;
using test::impact;
using test::impulse;

namespace {

constexpr std::array every_law{ImpactLaw::newton, ImpactLaw::moreau, ImpactLaw::poisson};

}  // namespace

TEST_CASE("a ball without friction bounces with e, by each law") {
  for (const ImpactLaw law : every_law) {
    const SolvedImpact ball = impact("ball-with-spin", law, {{"mu", 0}, {"e", Rational(1, 3)}});
    CHECK(after(ball, "vy") == Rational(1, 3));
    CHECK(after(ball, "omega") == -7);
    CHECK(impulse(ball, "N_floor") == Rational(4, 3));
    CHECK(ball.energy == Rational(1, 2) + Rational(49, 5));
    CHECK(energy_after(ball) == Rational(1, 18) + Rational(49, 5));
    CHECK(ball.outcomes.front().gains == false);
  }
}

TEST_CASE("a ball with spin keeps sliding, or rolls away") {
  for (const ImpactLaw law : every_law) {
    const SolvedImpact slides = impact("ball-with-spin", law, {{"mu", 1}});
    CHECK(impulse(slides, "S_floor") == Rational(3, 2));  // mu (1 + e) m v
    CHECK(after(slides, "vx") == Rational(3, 2));
    CHECK(after(slides, "omega") == -7 + Rational(15, 4));
    const SolvedImpact rolls = impact("ball-with-spin", law, {{"mu", 2}});
    CHECK(impulse(rolls, "S_floor") == 2);  // two sevenths of the sliding velocity
    CHECK(after(rolls, "vx") == 2);
    CHECK(after(rolls, "omega") == -2);
  }
}

TEST_CASE("only a tangential restitution turns the spin of a super ball round") {
  const SolvedImpact super = impact("super-ball", ImpactLaw::newton);
  CHECK(after(super, "vx") == Rational(-5, 7));
  CHECK(after(super, "omega") == Rational(-16, 7));
  CHECK(energy_after(super) == super.energy);
  CHECK(super.outcomes.front().gains == false);
  const SolvedImpact other = impact("super-ball", ImpactLaw::newton, {{"et", 0}});
  CHECK(after(other, "vx") == Rational(1, 7));
  CHECK(after(other, "omega") == Rational(-1, 7));
  CHECK_THROWS_WITH_AS(impact("super-ball", ImpactLaw::poisson), doctest::Contains("floor-tangential-restitution"),
                       InputError);
}

TEST_CASE("a rod that lands askew: smooth, and on a foot that holds") {
  const Rational c(21, 29), e(1, 2);
  for (const ImpactLaw law : every_law) {
    const SolvedImpact smooth = impact("rod-at-45-degrees", law, {{"theta", Rational(2, 5)}});
    const Rational normal = (1 + e) / (1 + 3 * c * c);
    CHECK(impulse(smooth, "N_foot") == normal);
    CHECK(after(smooth, "vy") == normal - 1);
    CHECK(after(smooth, "omega") == -3 * c * normal);
    const SolvedImpact holds = impact("rod-at-45-degrees", law, {{"theta", Rational(2, 5)}, {"mu", 10}, {"e", 0}});
    CHECK(after(holds, "omega") == Rational(-3, 4) * c);  // its moment of momentum about the foot stays
  }
}

TEST_CASE("at 45 degrees the numbers of a smooth rod are simple") {
  const SolvedImpact rod = impact("rod-at-45-degrees", ImpactLaw::newton);
  const Rational about = abs(Rational(impulse(rod, "N_foot") - Rational(3, 5)));  // (1 + e)/(1 + 3/2)
  CHECK(about < Rational(1, 1'000'000));
}

TEST_CASE("cradles: two balls exchange, and of three not only the last one leaves") {
  for (const ImpactLaw law : every_law) {
    const SolvedImpact two = impact("two-balls", law);
    CHECK(after(two, "vx_b1") == Rational(1, 4));
    CHECK(after(two, "vx_b2") == Rational(3, 4));
    const SolvedImpact three = impact("newtons-cradle", law);
    CHECK(after(three, "vx_b1") == Rational(-1, 3));
    CHECK(after(three, "vx_b2") == Rational(2, 3));
    CHECK(after(three, "vx_b3") == Rational(2, 3));
    CHECK(energy_after(three) == three.energy);
  }
}

TEST_CASE("a slender block lands as Housner says, if it neither slips nor bounces") {
  for (const ImpactLaw law : every_law) {
    const SolvedImpact block = impact("rocking-block", law);  // b = 1, h = 4
    const Rational rate = 1 - Rational(3, 2) / 17;
    CHECK(after(block, "omega") == -rate);
    CHECK(energy_after(block) == block.energy * rate * rate);
  }
  const SolvedImpact slips = impact("rocking-block", ImpactLaw::moreau, {{"mu", Rational(1, 10)}});
  CHECK(after(slips, "omega") != -(1 - Rational(3, 2) / 17));
}

TEST_CASE("joints bear impulses, and a brake with a limit of its own does not") {
  const SolvedImpact bar = test::impact_of_text(R"(
restitution = "1/2"
[[body]]
name = "bar"
mass = "3"
inertia = "1"
at = ["1", "0"]
velocity = ["0", "-1"]
spin = "-1"
[[joint]]
name = "hinge"
kind = "pin"
between = ["ground", "bar"]
at = ["0", "0"]
to = ["-1", "0"]
[[friction]]
name = "brake"
between = ["bar", "ground"]
limit = "5"
[[contact]]
name = "end"
of = "bar"
point = ["1", "0"]
normal = ["0", "1"]
through = ["2", "0"]
)");
  CHECK(after(bar, "omega") == Rational(1, 2));  // 4 (w + 1) = 2 N about the hinge
  CHECK(impulse(bar, "N_end") == 3);
  CHECK(impulse(bar, "R_hinge_y") == Rational(-3, 2));  // of the ground, as 3 (1/2 + 1) = N + 3/2
  CHECK(bar.scene.mechanism.impact->left_out == std::vector<std::string>{"brake"});
}

TEST_CASE("a wall that moves hits a ball, and the report does not call that a gain") {
  const SolvedImpact wall = test::impact_of_text(R"(
[[body]]
name = "wall"
velocity = ["2", "0"]
acceleration = ["0", "0"]
[[body]]
name = "ball"
mass = "1"
turning = "0"
at = ["1", "0"]
[[contact]]
name = "face"
of = "ball"
point = ["-1", "0"]
on = "wall"
normal = ["1", "0"]
restitution = "1/2"
)");
  CHECK(after(wall, "vx") == 3);
  CHECK(wall.driven);
  CHECK(!wall.outcomes.front().gains);
}

TEST_CASE("Newton's law leaves a contact that opens alone, Moreau's does not") {
  const std::string text = R"(
restitution = "1"
[[body]]
name = "bar"
mass = "1"
inertia = "1"
velocity = ["0", "-1"]
spin = "2"
[[contact]]
name = "left"
of = "bar"
point = ["-1", "0"]
normal = ["0", "1"]
through = ["-1", "0"]
[[contact]]
name = "right"
of = "bar"
point = ["3/4", "0"]
normal = ["0", "1"]
through = ["3/4", "0"]
)";
  // left: -1 - 2 = -3, right: -1 + 3/2 = 1/2
  const SolvedImpact newton = test::impact_of_text(text, ImpactLaw::newton),
                     moreau = test::impact_of_text(text, ImpactLaw::moreau);
  CHECK(newton.outcomes.size() == 1);
  CHECK(after(newton, "gap_right") == after(newton, "vy") + after(newton, "omega") * Rational(3, 4));
  CHECK(after(moreau, "gap_right") == after(moreau, "vy") + after(moreau, "omega") * Rational(3, 4) + Rational(1, 2));
}

TEST_CASE("each law can gain energy, and one restitution for everything cannot") {
  const auto gains = [](const SolvedImpact& solved) { return solved.outcomes.at(0).gains == true; };
  for (const ImpactLaw law : {ImpactLaw::newton, ImpactLaw::moreau}) {
    const SolvedImpact bar = impact("bar-that-gains", law);
    CHECK(after(bar, "vy") == Rational(8, 3));  // the ends leave with 4 and 0
    CHECK(after(bar, "omega") == Rational(-4, 3));
    CHECK(energy_after(bar) == Rational(104, 27));
    CHECK(gains(bar));
    CHECK(gains(impact("rod-that-gains", law)));
    CHECK(gains(impact("kane-pendulum", law)));
  }
  CHECK(!gains(impact("bar-that-gains", ImpactLaw::poisson)));
  CHECK(gains(impact("wedge-that-gains", ImpactLaw::poisson)));
  CHECK(!gains(impact("wedge-that-gains", ImpactLaw::newton)));
  CHECK(!gains(impact("ball-with-spin", ImpactLaw::moreau, {{"e", 1}, {"et", 1}, {"mu", 100}})));
}

TEST_CASE("mistakes about impacts say what is wrong, and where, in the plane and in space") {
  for (const bool in_space : {false, true}) {
    const std::string zero = in_space ? "\"0\", \"0\", " : "\"0\", ";
    const auto says = [&](const std::string& velocity, const std::string& more, const std::string& top = "") {
      const std::string text =
          (in_space ? "dimension = 3\n" : "") + top +
          "[[body]]\nname = \"ball\"\nmass = \"1\"\ninertia = " + (in_space ? "[\"1\", \"1\", \"1\"]" : "\"1\"") +
          "\nvelocity = [" + zero + "\"" + velocity + "\"]\n[[contact]]\nname = \"floor\"\nof = \"ball\"\npoint = [" +
          zero + "\"0\"]\nnormal = [" + zero + "\"1\"]\n" + more;
      try {
        test::impact_of_text(text);
      } catch (const InputError& error) {
        return std::string(error.what());
      }
      return std::string("no mistake");
    };
    const std::string place = in_space ? "test.toml:15:16: " : "test.toml:14:16: ";
    CHECK(says("-1", "restitution = \"1/2\"\n") == "no mistake");
    CHECK(says("-1", "").find("contact floor: missing restitution, from 0 to 1") != std::string::npos);
    CHECK(says("-1", "restitution = \"-1/4\"\n").find(place + "contact floor: restitution: found -1/4") !=
          std::string::npos);
    CHECK(says("-1", "restitution = \"2\"\n")
              .find(place + "contact floor: restitution: found e with 1 - e = -1, expected 0 to 1") !=
          std::string::npos);
    CHECK(says("-1", "friction = \"1\"\nrestitution = \"1\"\ntangential_restitution = \"3/2\"\n")
              .find("tangential_restitution: found e with 1 - e = -1/2, expected 0 to 1") != std::string::npos);
    CHECK(says("0", "restitution = \"1\"\n").find("found no contact that approaches") != std::string::npos);
    CHECK(says("1", "restitution = \"1\"\n").find("found no contact that approaches") != std::string::npos);
    CHECK(says("-1", "restitution = \"1\"\n", "[impact]\nlaw = \"hertz\"\n")
              .find("law: found 'hertz', expected \"newton\", \"moreau\" or \"poisson\"") != std::string::npos);
    CHECK(says("-1", "restitution = \"1\"\n", "[impact]\n").find("missing law in [impact]") != std::string::npos);
  }
}
