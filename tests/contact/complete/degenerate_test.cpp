// Problems at the borders of modes, and with forces that are open: what is known of them by hand is found, or left
// undecided, never contradicted.
#include <doctest/doctest.h>

#include <algorithm>

#include "contact/complete/complete.hpp"
#include "contact/complete/random_contacts.hpp"

using namespace slipproof;

namespace {

using Velocity = std::vector<Rational>;

/// Whether all motions are proved to be found. All that are found are among `known`, and then all of these are found.
bool finds(const ExactContacts& contacts, const std::vector<Velocity>& known, std::size_t most_nodes = 2000) {
  CompleteOptions options;
  options.most_nodes = most_nodes;
  const CompleteSolutions all = all_solutions(contacts, options);
  std::vector<bool> found(known.size(), false);
  for (const SpatialMotion& motion : all.motions) {
    const Velocity u = in_given_units(motion.u, all.scaled.velocity_unit);
    const Velocity radius = in_given_units(motion.u_radius, all.scaled.velocity_unit);
    const auto is_motion = [&](const Velocity& v) {
      for (std::size_t i = 0; i < v.size(); ++i) {
        if (abs(v[i] - u[i]) > radius[i]) return false;
      }
      return true;
    };
    const auto at = std::ranges::find_if(known, is_motion);
    REQUIRE(at != known.end());
    found[static_cast<std::size_t>(at - known.begin())] = true;
  }
  if (all.complete()) CHECK(std::ranges::count(found, true) == static_cast<std::ptrdiff_t>(known.size()));
  return all.complete();
}

/// On four feet.
ContactBody box(const Rational& mu) {
  ContactBody result;
  result.acceleration = {0, 0, -1, 0, 0, 0};
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) result.add({x, y, Rational(-1, 2)}, mu);
  }
  return result;
}

/// The velocities of four feet that all move like this.
Velocity all_feet(const Vector3& u) {
  Velocity result;
  for (int k = 0; k < 4; ++k) result.insert(result.end(), u.begin(), u.end());
  return result;
}

/// A point of mass 1 on the floor: W is the unit matrix.
ExactContacts point_mass(const Rational& normal, const Rational& x, const Rational& y, const Rational& mu) {
  return {3, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {normal, x, y}, {mu}};
}

}  // namespace

TEST_CASE("a box on four feet rests, with forces that are open") {
  CHECK(finds(box(Rational(1, 2)).contacts(), {all_feet({0, 0, 0})}));
  ContactBody leaning = box(Rational(1, 2));
  leaning.acceleration[0] = Rational(1, 4);
  CHECK(finds(leaning.contacts(), {all_feet({0, 0, 0})}));
  leaning.acceleration[0] = Rational(1, 2);  // as much as friction holds
  finds(leaning.contacts(), {all_feet({0, 0, 0})}, 200);
}

TEST_CASE("a box on four feet without friction, and one that lifts") {
  ContactBody body = box(0);
  body.acceleration[0] = Rational(1, 4);
  body.acceleration[1] = Rational(-1, 3);
  CHECK(finds(body.contacts(), {all_feet({0, Rational(1, 4), Rational(-1, 3)})}));
  body = box(Rational(1, 2));
  body.acceleration[2] = 1;
  CHECK(finds(body.contacts(), {all_feet({1, 0, 0})}));
}

TEST_CASE("a box on four feet that slides, with forces that are open") {
  ContactBody body = box(Rational(1, 4));
  body.acceleration[0] = 1;
  finds(body.contacts(), {all_feet({0, Rational(3, 4), 0})}, 200);
}

TEST_CASE("a point that touches without load") {
  for (const Rational& mu : {Rational(0), Rational(1, 2)}) {
    CAPTURE(mu);
    CHECK(finds(point_mass(0, 0, 0, mu), {{0, 0, 0}}));
    CHECK(finds(point_mass(0, 1, 0, mu), {{0, 1, 0}}));
    CHECK(finds(point_mass(0, Rational(-3, 7), Rational(2, 7), mu), {{0, Rational(-3, 7), Rational(2, 7)}}));
  }
}

TEST_CASE("a point at the edge of its cone, and beyond it in a direction that is an arc's end or none") {
  const Rational mu(1, 2);
  CHECK(finds(point_mass(-1, Rational(1, 2), 0, mu), {{0, 0, 0}}));
  finds(point_mass(-1, Rational(3, 10), Rational(4, 10), mu), {{0, 0, 0}}, 200);
  CHECK(finds(point_mass(-1, 1, 0, mu), {{0, Rational(1, 2), 0}}));
  CHECK(finds(point_mass(-1, Rational(6, 10), Rational(-8, 10), mu), {{0, Rational(3, 10), Rational(-4, 10)}}));
  CHECK(finds(point_mass(-1, 1, 0, 0), {{0, 1, 0}}));
}

TEST_CASE("a point on two contacts at once, which share its weight in any way") {
  ExactContacts twice{3, RationalMatrix(6, std::vector<Rational>(6)), {-1, 0, 0, -1, 0, 0}, {Rational(1, 2), 1}};
  for (std::size_t i = 0; i < 6; ++i) twice.W[i][i] = twice.W[i][(i + 3) % 6] = 1;
  CHECK(finds(twice, {Velocity(6)}));
  twice.q[1] = twice.q[4] = 2;  // slides, and the sum of mu r_N may be anything from 1/2 to 1
  CompleteOptions options;
  options.most_nodes = 200;
  CHECK_FALSE(all_solutions(twice, options).complete());
}

TEST_CASE("a contact that nothing moves is pressed by any force or opens") {
  ExactContacts still{3, RationalMatrix(3, std::vector<Rational>(3)), {0, 0, 0}, {Rational(1, 2)}};
  CHECK(finds(still, {{0, 0, 0}}));
  still.q[0] = -1;
  CHECK(finds(still, {}));
  still.q[0] = 1;
  CHECK(finds(still, {{1, 0, 0}}));
}

TEST_CASE("a problem without contacts has one motion") {
  CHECK(finds({3, {}, {}, {}}, {Velocity{}}));
}

TEST_CASE("a search that may not go on leaves patterns undecided") {
  ContactBody leaning = box(Rational(1, 2));
  leaning.acceleration[0] = Rational(1, 4);
  const ExactContacts contacts = leaning.contacts();
  CompleteOptions options;
  options.effort = 0;
  CHECK(all_solutions(contacts, options).undecided() == 1);
  options.effort = 20'000'000;
  const CompleteSolutions some = all_solutions(contacts, options);
  CHECK(some.nodes.size() > 1);
  CHECK(some.undecided() > 0);
  options.effort = CompleteOptions{}.effort;
  options.most_nodes = 10;
  CHECK_FALSE(all_solutions(contacts, options).complete());
}
