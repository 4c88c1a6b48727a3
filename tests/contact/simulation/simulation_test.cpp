// Contacts that give, against closed forms: blocks that slide and tip, energy, and the bicycle of several motions.
#include "contact/simulation/simulation.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "mechanics/elements/element.hpp"

using namespace slipproof;

namespace {

constexpr Compliance at_once{.stiffness_ratio = 0.5, .damping = 0.3, .rise = 0};

/// A block of mass 2 on one contact below its centre, pushed by F: W = 1/2 along both axes, g = 10, mu = 1/2.
LoadedContacts pushed_block(const Rational& F) {
  const Rational half = Rational(1) / 2;
  return {{{{half, 0}, {0, half}}, {-10, F / 2}, {half}}, {-10, 0}};
}

MechanismScene ambiguous(const std::string& force) {
  return parse_scene(
      "[bicycle]\nR = '1/4'\nh = '1'\nb = '0.4'\nM2 = '1/20'\nM3 = '1/20'\nJ = '0.4'\n"
      "[road]\nf = '1'\ng = '9.81'\n[force]\nkind = 'internal'\nP = '" +
          force + "'\n",
      "scene");
}

std::vector<Compliance> kinds_of_contacts(double rise) {
  return {{0.25, 0.05, rise}, {1, 0.5, rise}, {4, 0.2, rise}};
}

/// Kinetic and elastic energy of the pushed block less the work of its weight: mass 2 along both axes.
double energy(const CompliantMotion& motion, double ratio) {
  const auto &u = motion.displacement(), &v = motion.velocity();
  const double compressed = std::min(u[0], 0.0), z = motion.bristles()[0];
  return v[0] * v[0] + v[1] * v[1] + (compressed * compressed + ratio * z * z) / 2 + 20 * u[0];
}

}  // namespace

TEST_CASE("a block slides where the push exceeds friction, with (F - mu m g)/m, and else stays") {
  struct Push {
    Rational F;
    double slip, T;
    const char* mode;
  };
  for (const auto& [F, slip, T, mode] :
       {Push{9, 0, -9, "stick"}, Push{12, 1, -10, "slip+"}, Push{-14, -2, 10, "slip-"}}) {
    CAPTURE(F.str());
    // What slides when the push comes at once may stick when it comes slowly, and here does not: one motion.
    for (const double rise : {0.0, 20.0}) {
      const auto simulation = simulate(pushed_block(F), kinds_of_contacts(rise));
      REQUIRE(simulation.exact.one());
      for (const SimulatedRun& run : simulation.runs) {
        const SeenMotion& seen = run.seen.back();
        CHECK(seen.motion == 0);
        CHECK(name(seen.mode) == mode);
        CHECK(seen.share > 0.9);
        CHECK(seen.accelerations[1] == doctest::Approx(slip).epsilon(1e-3));
        CHECK(seen.forces[0] == doctest::Approx(20).epsilon(1e-3));
        CHECK(seen.forces[1] == doctest::Approx(T).epsilon(1e-3));
      }
    }
  }
}

TEST_CASE("a block that is lifted flies off") {
  LoadedContacts contacts = pushed_block(0);
  contacts.problem.q[0] = 3;
  const auto simulation = simulate(contacts, kinds_of_contacts(0));
  for (const SimulatedRun& run : simulation.runs) {
    CHECK(name(run.seen.back().mode) == "lift");
    CHECK(run.seen.back().accelerations[0] == doctest::Approx(3).epsilon(1e-2));
    CHECK(run.seen.back().motion == 0);
  }
}

TEST_CASE("a spring that is pushed at once goes twice as far, and rings with its period where nothing damps it") {
  // m = 2, k = 1 along the tangent: period 2 pi sqrt(2), and that of all contacts, as both stiffnesses are the same.
  CompliantMotion motion(pushed_block(3), {.stiffness_ratio = 1, .damping = 0, .rise = 0}, 0.01);
  double furthest = 0;
  while (motion.periods() < 0.5) motion.advance(), furthest = std::max(furthest, motion.displacement()[1]);
  CHECK(motion.time() == doctest::Approx(std::acos(-1.0) * std::sqrt(2.0)).epsilon(0.01));
  CHECK(furthest == doctest::Approx(6).epsilon(1e-3));
  while (motion.periods() < 10) motion.advance();
  CHECK(motion.displacement()[1] == doctest::Approx(0).scale(6).epsilon(0.01));
}

TEST_CASE("without a load all stays at rest, to the last digits") {
  for (const double damping : {0.0, 0.4}) {
    CompliantMotion motion(loaded_contacts(ambiguous("0")), {1, damping, 0});
    const std::vector<double> start = motion.displacement();
    while (motion.periods() < 100) motion.advance();
    for (std::size_t i = 0; i < start.size(); ++i) {
      CHECK(motion.displacement()[i] == doctest::Approx(start[i]).scale(10).epsilon(1e-9));
    }
  }
}

TEST_CASE(
    "contacts never make energy: a block thrown up and along loses it, and keeps it where nothing rubs or damps") {
  for (const double damping : {0.0, 0.3}) {
    for (const Rational& mu : {Rational(0), Rational(1) / 2}) {
      CAPTURE(damping);
      CAPTURE(mu.str());
      // The push that throws it ends: what rises is its going away.
      LoadedContacts contacts = pushed_block(0);
      contacts.problem.mu = {mu};
      contacts.problem.q = contacts.rest;
      contacts.rest = {-40, mu.is_zero() ? 0 : 8};
      CompliantMotion motion(contacts, {.stiffness_ratio = 0.5, .damping = damping, .rise = 0}, 0.01);
      const double start = energy(motion, 0.5);
      double least = start;
      bool flew = false;
      while (motion.periods() < 20) {
        motion.advance();
        const double now = energy(motion, 0.5);
        CHECK_MESSAGE(now <= least + 1e-3 * std::abs(start), motion.periods());
        least = std::min(least, now);
        flew = flew || motion.mode()[0] == ElementState::lift;
      }
      CHECK(flew);
      if (damping == 0 && mu.is_zero()) {
        CHECK(least == doctest::Approx(start).epsilon(1e-3));
      } else {
        CHECK(least < start - 0.05 * std::abs(start));
      }
    }
  }
}

TEST_CASE("contacts four times as stiff do the same twice as fast") {
  // k = 4 with W is k = 1 with 4 W, for forces; q is an acceleration, as 4 W is one for each force.
  const LoadedContacts soft = pushed_block(7);
  LoadedContacts stiff = soft;
  for (auto& row : stiff.problem.W) {
    for (Rational& entry : row) entry *= 4;
  }
  for (auto* q : {&stiff.problem.q, &stiff.rest}) {
    for (Rational& entry : *q) entry *= 4;
  }
  CompliantMotion x(soft, at_once), y(stiff, at_once);
  for (int i = 0; i < 5000; ++i) x.advance(), y.advance();
  CHECK(x.time() == doctest::Approx(2 * y.time()));
  CHECK(x.periods() == doctest::Approx(y.periods()));
  CHECK(x.forces()[1] == doctest::Approx(y.forces()[1]).epsilon(1e-9));
}

TEST_CASE("of three motions the one with a negative determinant is never seen; how the load comes decides the others") {
  const auto modes_seen = [](double rise) {
    const auto simulation = simulate(loaded_contacts(ambiguous("3.27")), kinds_of_contacts(rise));
    REQUIRE(simulation.exact.solutions.size() == 3);
    std::vector<std::string> seen;
    for (const SimulatedRun& run : simulation.runs) {
      REQUIRE(run.seen.back().motion);
      seen.push_back(name(simulation.exact.solutions[*run.seen.back().motion].modes.front()));
    }
    return seen;
  };
  CHECK(modes_seen(0) == std::vector<std::string>(3, "stick/lift"));
  CHECK(modes_seen(100) == std::vector<std::string>(3, "stick/stick"));
}

TEST_CASE("beside the forces of several motions there is one, and a load that comes slowly shows it") {
  for (const auto& [force, mode] : {std::pair{"3.2", "stick/stick"}, {"3.35", "stick/lift"}, {"-30", "lift/stick"}}) {
    CAPTURE(force);
    const auto simulation = simulate(loaded_contacts(ambiguous(force)), kinds_of_contacts(100));
    REQUIRE(simulation.exact.one());
    for (const SimulatedRun& run : simulation.runs) CHECK(run.seen.back().motion == 0);
    CHECK(name(simulation.exact.solutions[0].modes.front()) == mode);
  }
}

TEST_CASE("what is close to a motion is closer by far than the motions are to each other") {
  ContactProblem problem = pushed_block(12).problem;
  const ContactSolutions one = *ContactSolver(problem).all();
  CHECK(motion_close_to({0, 1.05}, problem, one) == 0);
  CHECK_FALSE(motion_close_to({0, 1.2}, problem, one));
  ContactSolutions two = one;
  two.solutions.push_back(two.solutions.front());
  two.solutions.back().w[1] = 2;
  CHECK_FALSE(motion_close_to({0, 1.05}, problem, two));
  CHECK(motion_close_to({0, 1.995}, problem, two) == 1);
}

TEST_CASE("scenes that do not begin at rest, or have no load, are refused") {
  LoadedContacts contacts = pushed_block(0);
  contacts.rest[1] = 6;  // more than friction holds
  CHECK_THROWS_AS(CompliantMotion(contacts, at_once), std::invalid_argument);
  MechanismScene scene = ambiguous("3.27");
  scene.load.reset();
  CHECK_THROWS_WITH_AS(loaded_contacts(scene), doctest::Contains("expected one"), std::invalid_argument);
}
