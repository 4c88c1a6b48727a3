// Which quantities are of one kind: by units where a file has them, otherwise by what its equations add up.
#include "mechanics/checks/kinds.hpp"

#include <doctest/doctest.h>

#include <string>

#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"

using namespace slipproof;

namespace {

/// A block on a floor with a brake on a wheel, with these units.
Mechanism block(const std::string& units) {
  return parse_mechanism(R"(schema = "slipproof/mechanism/1"
name = "block"
[parameters]
m = "m > 0"
b = "b > 0"
h = "h > 0"
I = "I > 0"
B = "B > 0"
mu = "mu >= 0"
g = "g > 0"
[load]
symbol = "F"
[unknowns]
accelerations = ["ax", "ay", "phi"]
)" + units + R"(
[motion]
ax = "m*ax = F"
ay = "m*ay = -m*g"
phi = "I*phi = 0"
[[contact]]
name = "left"
gap = "ay - b*phi"
slip = "ax + h*phi"
friction = "mu"
[[friction]]
name = "brake"
slip = "phi"
limit = "B"
)",
                         "block");
}

}  // namespace

TEST_CASE("quantities that equations add up are of one kind, and no others") {
  const MechanismKinds kinds(block(""));
  // ax, ay, phi, gap, slip of the contact, slip of the brake
  const auto& a = kinds.accelerations;
  REQUIRE(a.size() == 6);
  CHECK(a[0] == a[1]);
  CHECK(a[0] == a[3]);
  CHECK(a[0] == a[4]);
  CHECK(a[2] == a[5]);
  CHECK(a[0] != a[2]);
  // N, S, the brake's torque
  REQUIRE(kinds.forces.size() == 3);
  CHECK(kinds.forces[0] == kinds.forces[1]);
  CHECK(kinds.forces[0] != kinds.forces[2]);
  CHECK(kinds.lines[0] == kinds.forces[0]);
  CHECK(kinds.lines[2] == kinds.forces[2]);
  // Rotations by levers: b and h.
  REQUIRE(kinds.levers.size() == 1);
  CHECK(kinds.levers[0].kind == a[2]);
  CHECK(kinds.levers[0].places.size() == 2);
}

TEST_CASE("units that a file gives say the same, and keep apart what has others") {
  const Mechanism plain = block(""), with_units = block("[units]\nax = \"m/s^2\"\nay = \"m/s^2\"\nphi = \"s^-2\"\n");
  const MechanismKinds kinds(plain), same(with_units);
  CHECK(kinds.accelerations == same.accelerations);
  CHECK(kinds.forces == same.forces);
  const MechanismKinds apart(block("[units]\nax = \"m/s^2\"\nay = \"mm/s^2\"\n"));
  CHECK(apart.accelerations[0] != apart.accelerations[1]);
  // The bicycle's tension of the chain is a force, but sets no yardstick.
  const MechanismKinds bicycle(open_mechanism("bicycle"));
  CHECK(bicycle.forces == std::vector<std::size_t>(5, bicycle.forces[0]));
  CHECK(bicycle.own_force == std::vector{true, false, false, false, false});
}
