// Small mechanisms whose motions one finds with a pencil.
#include <doctest/doctest.h>

#include <map>
#include <string>

#include "mechanics/kernel/motions.hpp"
#include "mechanics/points/problem.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"

using namespace slipproof;

namespace {

/// Accelerations `names`, the motion and what else there is; the load is F.
Mechanism small(const std::string& names, const std::string& rest, const std::string& load = "symbol = \"F\"\n") {
  return parse_mechanism("schema = \"slipproof/mechanism/1\"\nname = \"small\"\n[load]\n" + load +
                             "[unknowns]\naccelerations = [" + names + "]\n" + rest,
                         "small.toml");
}

FrictionProblem problem_of(const Mechanism& mechanism) {
  return friction_problem(mechanism, default_values(mechanism));
}

/// The modes' loads, for every load.
std::map<std::string, std::string> loads_of(const FrictionProblem& problem) {
  std::map<std::string, std::string> result;
  for (const ConsistentMode& mode : modes_of(without_equations(problem), std::nullopt).consistent) {
    result[name(mode.mode)] = to_string(mode.solutions.loads);
  }
  return result;
}

using Loads = std::map<std::string, std::string>;

/// The first acceleration of the only motion, and that its strict modes are these.
Rational only(const FrictionProblem& problem, const std::optional<Rational>& load, const std::string& modes) {
  const MotionsAtLoad found = motions_of(problem, load);
  CHECK(found.continua.empty());
  REQUIRE(found.motions.size() == 1);
  std::string names;
  for (const auto& mode : found.motions[0].modes) names += (names.empty() ? "" : " ") + name(mode);
  CHECK(names == modes);
  return found.motions[0].accelerations[0];
}

/// A block under the horizontal force H and the vertical force V.
std::string block(const std::string& mass, const std::string& H, const std::string& V) {
  return "[motion]\nx = \"" + mass + "*x = " + H + "\"\ny = \"" + mass + "*y = " + V + "\"\n";
}

std::string foot(const std::string& how) {
  return "[[contact]]\nname = \"foot\"\ngap = \"y\"\nslip = \"x\"\n" + how + "\n";
}

/// A shipped mechanism at values of its parameters and of its angle.
FrictionProblem shipped(const std::string& name, const std::map<std::string, Rational>& values,
                        const MechanismValues::Circle& angle = {}) {
  const Mechanism mechanism = parse_mechanism(find_shipped(name)->text, name);
  MechanismValues all = default_values(mechanism);
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    all.parameters[i] = values.at(mechanism.parameters[i].symbol);
  }
  if (!all.angles.empty()) all.angles[0] = angle;
  return friction_problem(mechanism, all);
}

}  // namespace

TEST_CASE("a block stays until the force is mu N, then slides with what is left") {
  const FrictionProblem p = problem_of(small("\"x\", \"y\"", block("2", "F", "-20") + foot("friction = \"1/2\"")));
  CHECK(loads_of(p) == Loads{{"stick", "[-10, 10]"}, {"slip+", "[10, +oo)"}, {"slip-", "(-oo, -10]"}});
  CHECK(only(p, Rational(13), "slip+") == Rational(3, 2));
  CHECK(only(p, Rational(-13), "slip-") == Rational(-3, 2));
  CHECK(only(p, Rational(10), "") == 0);
}

TEST_CASE("a block without friction is lifted by more than its weight") {
  const FrictionProblem p = problem_of(small("\"y\", \"x\"", block("2", "3", "F - 20") + foot("")));
  CHECK(loads_of(p) == Loads{{"touch", "(-oo, 20]"}, {"lift", "[20, +oo)"}});
  CHECK(only(p, Rational(27), "lift") == Rational(7, 2));
  CHECK(only(p, Rational(19), "touch") == 0);
}

TEST_CASE("a bead on a rod slides while its guide is pressed little, from either side") {
  const auto guide = foot("friction = \"1/2\"\nbilateral = true");
  const FrictionProblem p = problem_of(small("\"x\", \"y\"", block("1", "3", "F - 10") + guide));
  CHECK(loads_of(p) ==
        Loads{{"stick", "(-oo, 4]"}, {"slip+", "[4, 10]"}, {"slip+~", "[10, 16]"}, {"stick~", "[16, +oo)"}});
  CHECK(only(p, Rational(6), "slip+") == 3 - Rational(4, 2));
  CHECK(only(p, Rational(13), "slip+~") == 3 - Rational(3, 2));
  CHECK(only(p, Rational(10), "") == 3);
}

TEST_CASE("between two coefficients a block may stay or slide, which is hysteresis") {
  const auto feet = foot("friction = { static = \"1/2\", kinetic = \"1/4\" }");
  const FrictionProblem p = problem_of(small("\"x\", \"y\"", block("1", "F", "-10") + feet));
  CHECK(loads_of(p) == Loads{{"stick", "[-5, 5]"}, {"slip+", "[5/2, +oo)"}, {"slip-", "(-oo, -5/2]"}});
  const MotionsAtLoad both = motions_of(p, Rational(3));
  REQUIRE(both.motions.size() == 2);
  CHECK(both.motions[1].accelerations[0] == Rational(1, 2));
  REQUIRE(both.hysteresis.size() == 1);
  CHECK(name(both.hysteresis[0]) == "stick");
  CHECK(only(p, Rational(5, 2), "stick") == 0);  // slip+ begins there with the same motion
  CHECK(motions_of(p, Rational(6)).hysteresis.empty());
}

TEST_CASE("a block on a slope slides where its tangent is above mu") {
  const Mechanism m = small("\"x\", \"y\"", block("1", "10*s + F", "-10*c") + foot("friction = \"3/5\"") +
                                                "[angles]\ntheta = { cos = \"c\", sin = \"s\" }\n");
  MechanismValues values = default_values(m);
  values.angles[0] = {Rational(4, 5), Rational(3, 5)};  // tan = 3/4
  CHECK(only(friction_problem(m, values), Rational(0), "slip+") == 6 - Rational(3, 5) * 8);
  values.angles[0] = {Rational(12, 13), Rational(5, 13)};  // tan = 5/12
  CHECK(only(friction_problem(m, values), Rational(0), "stick") == 0);
  CHECK(loads_of(friction_problem(m, values))["stick"] == "[-122/13, 22/13]");  // |50 + 13 F| <= 72
}

TEST_CASE("a plate without mass cannot be pulled harder than friction holds it") {
  const auto plate =
      "[motion]\nx = \"0 = F\"\nu = \"u = 0\"\nv = \"v = -10\"\n[[contact]]\nname = \"on\"\n"
      "gap = \"v\"\nslip = \"u - x\"\nfriction = \"1/2\"\n";
  const FrictionProblem p = problem_of(small("\"x\", \"u\", \"v\"", plate));
  CHECK(loads_of(p) == Loads{{"stick", "[-5, 5]"}, {"slip+", "{-5}"}, {"slip-", "{5}"}});
  CHECK(only(p, Rational(4), "stick") == 4);
  const MotionsAtLoad torn = motions_of(p, Rational(5));
  REQUIRE(torn.continua.size() == 1);
  REQUIRE(torn.motions.size() == 1);  // rest is the end of the continuum
  CHECK(torn.motions[0].accelerations[0] == 5);
  CHECK_FALSE(torn.motions[0].strict());
  CHECK(torn.motions[0].continua == std::vector<MechanismMode>{torn.continua[0].mode});
  CHECK(modes_in(torn, torn.continua[0]) == torn.motions[0].boundary_modes);
  CHECK(torn.continua[0].accelerations[0] == Range{Rational(5), std::nullopt});
  CHECK(torn.continua[0].accelerations[1] == Range{Rational(5), Rational(5)});
  const MotionsAtLoad none = motions_of(p, Rational(6));
  CHECK(none.motions.empty());
  CHECK(none.continua.empty());
}

TEST_CASE("Painleve's rod has no motion, or two") {
  // gap = A + B N with A = -g + l s w^2 and B = 1/m + l^2 c (c - mu s)/I
  const auto rod = [](int w, int g) {
    return shipped("painleve-rod", {{"m", 1}, {"l", 1}, {"I", Rational(1, 3)}, {"mu", 3}, {"w", w}, {"g", g}},
                   {Rational(3, 5), Rational(4, 5)});
  };
  const Rational B = 1 + 3 * Rational(3, 5) * (Rational(3, 5) - 3 * Rational(4, 5));
  CHECK(B < 0);
  CHECK(motions_of(rod(0, 10), std::nullopt).motions.empty());
  const MotionsAtLoad two = motions_of(rod(5, 10), std::nullopt);
  REQUIRE(two.motions.size() == 2);
  CHECK(two.motions[0].forces[0] == Range{-10 / B, -10 / B});
  CHECK(two.motions[1].accelerations[3] == 10);  // its gap
  const MotionsAtLoad touch = motions_of(rod(5, 20), std::nullopt);
  REQUIRE(touch.motions.size() == 1);
  CHECK_FALSE(touch.motions[0].strict());
  CHECK(touch.motions[0].boundary_modes.size() == 2);
}

TEST_CASE("a block on a shaken floor tips or slides, and its friction is shared as it likes") {
  const auto at = [](const Rational& mu) {
    return shipped("block-shaken",
                   {{"m", 1}, {"b", Rational(1, 2)}, {"h", 1}, {"I", Rational(5, 12)}, {"mu", mu}, {"g", 10}});
  };
  CHECK(loads_of(at(1))["stick/stick"] == "[-1/2, 1/2]");                             // b/h
  CHECK(loads_of(at(Rational(1, 3)))["stick/stick"] == "[-1/3, 1/3]");                // mu
  CHECK(only(at(Rational(1, 3)), Rational(2, 5), "slip-/slip-") == Rational(10, 3));  // mu g
  const MotionsAtLoad rest = motions_of(at(1), Rational(3, 10));
  REQUIRE(rest.motions.size() == 1);
  const auto& forces = rest.motions[0].forces;  // N1 = m g/2 + h m A g/(2 b), S1 + S2 = m A g, |S2| <= N2
  CHECK(forces == std::vector<Range>{{8, 8}, {1, 5}, {2, 2}, {-2, 2}});
}

TEST_CASE("a drawer jams where mu e > a") {
  const auto drawer = [](int e) {
    return shipped("drawer", {{"m", 1}, {"I", 1}, {"a", 1}, {"e", e}, {"mu", Rational(1, 2)}});
  };
  CHECK(only(drawer(1), Rational(6), "slip+/slip+~") == 3);  // F (1 - mu e/a)/m
  const FrictionProblem jammed = drawer(3);
  const MotionsAtLoad rest = motions_of(jammed, Rational(6));
  REQUIRE(rest.motions.size() == 1);
  CHECK(rest.motions[0].accelerations[0] == 0);
  CHECK(rest.motions[0].forces[1] == Range{Rational(-9, 2), Rational(-3, 2)});  // S + S' = -6, |S|, |S'| <= mu N = 9/2
  CHECK(only(drawer(2), Rational(6), "") == 0);
}

TEST_CASE("a gripper holds with 2 mu F >= m (g + u)") {
  const FrictionProblem p = shipped("gripper", {{"m", 2}, {"mj", 1}, {"mu", Rational(1, 4)}, {"u", 1}, {"g", 10}});
  CHECK(loads_of(p)["stick/stick"] == "[44, +oo)");
  CHECK(loads_of(p)["slip-/slip-"] == "[0, 44]");
}

TEST_CASE("two weights on a rope fall as their brake allows") {
  const FrictionProblem p =
      problem_of(small("\"x\", \"y\"",
                       "[motion]\nx = \"x = -10\"\ny = \"2*y = -20\"\n[[link]]\nname = \"rope\"\nzero = \"x + y\"\n"
                       "[[friction]]\nname = \"brake\"\nslip = \"x\"\nlimit = \"F\"\n",
                       "symbol = \"F\"\ndomain = \"F >= 0\"\n"));
  CHECK(only(p, Rational(3), "slip+") == Rational(10 - 3, 3));
  CHECK(loads_of(p) == Loads{{"stick", "[10, +oo)"}, {"slip+", "[0, 10]"}});
  const auto modes = modes_of(without_equations(p), std::nullopt).consistent;
  CHECK(to_string(strict_loads(modes[1].solutions)) == "(0, 10)");  // a limit of 0 is not strict
}

TEST_CASE("a beam on six feet may stand on any of them that can carry it") {
  std::string feet = "[motion]\ny = \"2*y = -20\"\nphi = \"phi = 0\"\n";
  for (const int x : {-3, -2, -1, 1, 2, 3}) {
    feet += "[[contact]]\nname = \"f" + std::to_string(x + 3) + "\"\ngap = \"y + (" + std::to_string(x) + ")*phi\"\n";
  }
  Mechanism m = small("\"y\", \"phi\"", feet, "symbol = \"F\"\n");
  const MotionsAtLoad found = motions_of(problem_of(m), Rational(0));
  REQUIRE(found.motions.size() == 1);
  // Together with the one at the other end, which is 3 away: N = 20 * 3/(3 + |x|).
  const std::vector<Range> expected{{0, 10}, {0, 12}, {0, 15}, {0, 15}, {0, 12}, {0, 10}};
  CHECK(found.motions[0].forces == expected);
  CHECK(found.motions[0].modes.size() == 1);            // all six touch
  CHECK(found.motions[0].boundary_modes.size() == 48);  // one on each side at least: 7 * 7, and that one is strict
}

TEST_CASE("of six carts that are pulled more and more, more and more slide") {
  std::string names, motion = "[motion]\n", brakes;
  for (int i = 1; i <= 6; ++i) {
    const std::string x = "x" + std::to_string(i);
    names += (i > 1 ? ", \"" : "\"") + x + "\"";
    motion += x + " = \"" + x + " = " + std::to_string(i) + "*F\"\n";
    brakes += "[[friction]]\nname = \"b" + std::to_string(i) + "\"\nslip = \"" + x + "\"\nlimit = \"6\"\n";
  }
  const FrictionProblem p = problem_of(small(names, motion + brakes));
  const Loads loads = loads_of(p);
  CHECK(loads.size() == 13);  // cart i slides from |F| = 6/i on
  CHECK(loads.at("stick/stick/slip+/slip+/slip+/slip+") == "[2, 3]");
  CHECK(loads.at("slip-/slip-/slip-/slip-/slip-/slip-") == "(-oo, -6]");
  const MotionsAtLoad at = motions_of(p, Rational(5, 2));
  REQUIRE(at.motions.size() == 1);
  CHECK(at.motions[0].accelerations[5] == 6 * Rational(5, 2) - 6);
  CHECK(at.motions[0].accelerations[1] == 0);
}
