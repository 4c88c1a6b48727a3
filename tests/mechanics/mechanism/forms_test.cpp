#include "mechanics/mechanism/forms.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <tuple>

#include "mechanics/checks/free_motion.hpp"
#include "mechanics/points/problem.hpp"
#include "mechanics/points/sampling.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"
#include "support/bicycle/linear_form.hpp"
#include "support/scenes/random_scene.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// Where the model's unknowns a, a_y, phi, eps1, eps2, eps3, T, S2, S3, N2, N3 stand in the mechanism.
constexpr std::array<std::size_t, 11> place_of{0, 1, 2, 3, 4, 5, 6, 8, 10, 7, 9};

AffineForm of(const LinearForm<Rational>& form) {
  AffineForm result;
  result.constant = form.constant;
  result.coefficients.resize(12);
  for (std::size_t i = 0; i < 11; ++i) result.coefficients[place_of[i]] = form.coefficients[i];
  result.coefficients[11] = form.coefficients[11];
  return result;
}

bool equal(const AffineForm& x, const AffineForm& y) {
  return x.constant == y.constant && x.coefficients == y.coefficients;
}

/// The same equation: one is a multiple of the other.
bool proportional(const AffineForm& x, const AffineForm& y) {
  std::vector<Rational> a = x.coefficients, b = y.coefficients;
  a.push_back(x.constant);
  b.push_back(y.constant);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (Rational(a[i] * b[k]) != Rational(a[k] * b[i])) return false;
    }
  }
  return true;
}

/// Gives a parameter its value, if the mechanism has it.
void set(const Mechanism& mechanism, MechanismValues& values, std::string_view symbol, const Rational& value) {
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    if (mechanism.parameters[i].symbol == symbol) values.parameters[i] = value;
  }
}

MechanismValues values_of(const Mechanism& m, const Bicycle<Rational>& p, const Road<Rational>& road) {
  MechanismValues values = default_values(m);
  const std::pair<std::string_view, Rational> all[] = {
      {"M", p.M},     {"R", p.R},    {"h", p.h},   {"b2", p.b2}, {"b3", p.b3},           {"I1", p.I1},  {"I2", p.I2},
      {"I3", p.I3},   {"r1", p.r1},  {"r2", p.r2}, {"L", p.L},   {"J", p.J.value_or(0)}, {"f", road.f}, {"f2", road.f},
      {"f3", road.f}, {"g", road.g}, {"R2", p.R},  {"R3", p.R},  {"h0", p.h + p.R}};
  for (const auto& [symbol, value] : all) set(m, values, symbol, value);
  for (std::size_t i = 0; i < m.parameters.size(); ++i) {
    if (m.parameters[i].symbol == "J") values.given[i] = p.J.has_value();
  }
  return values;
}

}  // namespace

TEST_CASE("the bicycle's forms are the model's raw system") {
  const Mechanism m = open_mechanism("bicycle");
  const ProblemMaker maker(m);
  RandomScenes random(5);
  const ContactMode stick{WheelState::stick, WheelState::stick};
  for (int i = 0; i < 200; ++i) {
    const Bicycle<Rational> p = random.bicycle(i % 3 != 0);
    const Road<Rational> road{random.positive(), random.positive()};
    const ForceKind kind = i % 2 == 0 ? ForceKind::internal : ForceKind::external;
    MechanismValues values = values_of(m, p, road);
    set(m, values, "external", kind == ForceKind::external ? 1 : 0);
    CHECK(maker.broken(values).empty());
    const FrictionProblem problem = maker.problem(values);
    const auto raw = raw_system(p, road, kind, stick);
    REQUIRE(problem.equations.size() == 7);
    for (std::size_t k = 0; k < 7; ++k) {
      CAPTURE(k);
      CHECK(proportional(problem.equations[k], of(raw[k])));
    }
    const auto slipping = raw_system(p, road, kind, {WheelState::slip_forward, WheelState::slip_backward});
    for (std::size_t wheel = 0; wheel < 2; ++wheel) {
      const ProblemElement& element = problem.elements[wheel];
      CHECK(equal(element.gap, of(raw[7 + 2 * wheel])));
      CHECK(equal(element.slip, of(raw[8 + 2 * wheel])));
      const StateEquation resists = wheel == 0 ? StateEquation::resists_forward : StateEquation::resists_backward;
      CHECK(equal(form_of(element, ElementState::slip_forward, resists), of(slipping[8 + 2 * wheel])));
      CHECK(element.kind.lifts == p.J.has_value());
    }
  }
}

TEST_CASE("by virtual work the bicycle is the one of the printed equations") {
  const Mechanism printed = open_mechanism("bicycle");
  RandomScenes random(6);
  for (const char* name : {"bicycle-two-coefficients", "bicycle-two-radii", "bicycle-on-slope"}) {
    CAPTURE(name);
    const Mechanism derived = open_mechanism(name);
    for (int i = 0; i < 20; ++i) {
      const Bicycle<Rational> p = random.bicycle(true);
      const Road<Rational> road{random.positive(), random.positive()};
      const FrictionProblem x = friction_problem(printed, values_of(printed, p, road));
      const FrictionProblem y = friction_problem(derived, values_of(derived, p, road));
      using namespace mechanism_checks;
      const auto wx = delassus(printed, x, pairings(printed, x));
      auto pairs = pairings(derived, y);
      // The chain is a force in the one and a link in the other, and holds in both.
      const auto wy = delassus(derived, y, pairs);
      if (!wx || !wy) continue;
      const Rational chain = (*wy)[4][4];
      for (std::size_t r = 0; r < 4; ++r) {
        for (std::size_t c = 0; c < 4; ++c) CHECK((*wx)[r][c] == (*wy)[r][c] - (*wy)[r][4] * (*wy)[4][c] / chain);
      }
      const auto fx = free_motion(printed, x), fy = free_motion(derived, y);
      REQUIRE(fx);
      REQUIRE(fy);
      CHECK(fx->gaps == fy->gaps);
    }
  }
}

TEST_CASE("a form gives what its expression gives, at every point of the unknowns") {
  std::mt19937 random(3);
  for (const ShippedMechanism& shipped : shipped_mechanisms()) {
    CAPTURE(shipped.name);
    const Mechanism m = open_mechanism(std::string(shipped.name));
    const ProblemMaker maker(m);
    const auto samples = sample_values(m, maker, 3, 7);
    CHECK(samples.size() == 3);
    for (const MechanismValues& values : samples) {
      const FrictionProblem problem = maker.problem(values);
      std::vector<Rational> x;
      for (std::size_t i = 0; i <= m.unknowns.size(); ++i) x.emplace_back(static_cast<int>(random() % 21) - 10, 3);
      // The expression itself: with the unknowns as further symbols of a scope.
      Scope scope = maker.compiled().scope();
      const auto value = [&](const Expression& expression) {
        Scope wide = scope;
        for (const MechanismUnknown& unknown : m.unknowns) wide.slots.push_back({unknown.symbol, {}});
        const auto slot = [&](std::string_view symbol) -> std::optional<std::size_t> {
          for (std::size_t i = 0; i < wide.slots.size(); ++i) {
            if (wide.slots[i].name == symbol) return i;
          }
          return std::nullopt;
        };
        Evaluator<Rational> at(wide);
        for (std::size_t i = 0; i < values.parameters.size(); ++i) at.set(i, values.parameters[i]);
        for (std::size_t i = 0; i < values.angles.size(); ++i) {
          at.set(maker.compiled().cosine(i), values.angles[i].cosine);
          at.set(maker.compiled().sine(i), values.angles[i].sine);
        }
        at.set(maker.compiled().load(), x.back());
        for (std::size_t i = 0; i < m.unknowns.size(); ++i) at.set(scope.slots.size() + i, x[i]);
        const auto result = at.number(Program(expression, slot));
        REQUIRE(result.number);
        return *result.number;
      };
      for (std::size_t i = 0; i < m.equations.size(); ++i) {
        const Rational expected = value(m.equations[i].left.expression) - value(m.equations[i].whole_right());
        CHECK(problem.equations[i].at(x) == expected);
      }
      for (std::size_t i = 0; i < m.contacts.size(); ++i) {
        CHECK(problem.elements[i].gap.at(x) == value(m.contacts[i].gap.expression));
        CHECK(problem.elements[i].slip.at(x) == value(m.contacts[i].slip.expression));
        CHECK(problem.elements[i].static_limit.at(x) ==
              value(m.contacts[i].static_friction.expression) * x[m.contacts[i].normal]);
      }
      for (std::size_t i = 0; i < m.friction.size(); ++i) {
        const ProblemElement& element = problem.elements[m.contacts.size() + i];
        CHECK(element.kinetic_limit.at(x) == value(m.friction[i].kinetic_limit.expression));
        CHECK(element.tangent.at(x) == x[m.friction[i].force]);
      }
      CHECK(problem.accelerations.size() == acceleration_names(m).size());
      CHECK(problem.forces.size() == force_names(m).size());
    }
  }
}

TEST_CASE("the loads of a domain are one interval") {
  const auto domain = [](const std::string& text) {
    const std::string file =
        "schema = \"slipproof/mechanism/1\"\nname = \"x\"\n[parameters]\nb = \"b > 0\"\n[load]\nsymbol = \"F\"\ndomain "
        "= \"" +
        text + "\"\n[unknowns]\naccelerations = [\"y\"]\n[motion]\ny = \"y = F\"\n";
    const Mechanism m = parse_mechanism(file, "x.toml");
    MechanismValues values = default_values(m);
    values.parameters[0] = 2;
    return to_string(friction_problem(m, values).load_domain);
  };
  CHECK(domain("real") == "(-oo, +oo)");
  CHECK(domain("F >= 0") == "[0, +oo)");
  CHECK(domain("0 < F <= 5") == "(0, 5]");
  CHECK(domain("-b < 3*F and F < b") == "(-2/3, 2)");
  CHECK(domain("F/b = 3") == "{6}");
  CHECK(domain("F > 1 and F < 1/b") == "{}");
  CHECK(domain("1 - F > b/(b - 1)") == "(-oo, -1)");
  CHECK(domain("F < 1/(b - 2)") == "{}");
}

TEST_CASE("a coefficient without a value is named") {
  const Mechanism m = parse_mechanism(
      "schema = \"slipproof/mechanism/1\"\nname = \"x\"\n[parameters]\nb = \"real\"\n[definitions]\nk = "
      "\"1/b\"\n[unknowns]\n"
      "accelerations = [\"y\"]\n[motion]\ny = \"k*y = 1\"\n",
      "x.toml");
  MechanismValues values = default_values(m);
  CHECK_THROWS_WITH(friction_problem(m, values), "the equation y has no value: it divides by zero");
  values.parameters[0] = 2;
  CHECK(friction_problem(m, values).equations[0].coefficients[0] == Rational(1, 2));
}

TEST_CASE("forms are evaluated over other numbers") {
  const Mechanism m = open_mechanism("painleve-rod");
  const ProblemMaker maker(m);
  const auto samples = sample_values(m, maker, 4, 2);
  REQUIRE(samples.size() == 4);
  for (const MechanismValues& values : samples) {
    const FrictionProblem problem = maker.problem(values);
    Evaluator<double> at(maker.compiled().scope());
    for (std::size_t i = 0; i < values.parameters.size(); ++i) at.set(i, values.parameters[i].to_double());
    at.set(maker.compiled().cosine(0), values.angles[0].cosine.to_double());
    at.set(maker.compiled().sine(0), values.angles[0].sine.to_double());
    const auto gap = coefficients(maker.compiled().contacts[0].gap, at, m.unknowns.size());
    REQUIRE(gap);
    REQUIRE(gap->size() == m.unknowns.size() + 2);
    for (std::size_t i = 0; i < m.unknowns.size(); ++i) {
      CHECK((*gap)[i] == doctest::Approx(problem.elements[0].gap.coefficients[i].to_double()));
    }
    CHECK(gap->back() == doctest::Approx(problem.elements[0].gap.constant.to_double()));
  }
}

TEST_CASE("Painleve's rod has the closed form of the textbook") {
  // m and I with the tip ahead: gap = -g + l s w^2 + (1/m + l^2 c (c - mu s)/I) N, which a coefficient above 4/3 can
  // turn.
  const Mechanism m = open_mechanism("painleve-rod");
  const ProblemMaker maker(m);
  for (const MechanismValues& values : sample_values(m, maker, 20, 4)) {
    const auto& [mass, l, I, mu, w, g] = std::tie(values.parameters[0], values.parameters[1], values.parameters[2],
                                                  values.parameters[3], values.parameters[4], values.parameters[5]);
    const Rational &c = values.angles[0].cosine, &s = values.angles[0].sine;
    const FrictionProblem problem = maker.problem(values);
    const auto pairs = mechanism_checks::pairings(m, problem);
    const auto matrix = mechanism_checks::delassus(m, problem, pairs);
    REQUIRE(matrix);
    const Rational expected = Rational(1) / mass + l * l * c * (c - mu * s) / I;
    CHECK(Rational((*matrix)[0][0] - mu * (*matrix)[0][1]) == expected);
    const auto falling = mechanism_checks::free_motion(m, problem);
    REQUIRE(falling);
    CHECK(falling->gaps[0] == Rational(l * s * w * w - g));
  }
}
