// Blocks that slip on four feet: how these share the weight is open.
#include <doctest/doctest.h>

#include <algorithm>

#include "contact/complete/closing.hpp"
#include "contact/complete/complete.hpp"
#include "contact/complete/random_contacts.hpp"

namespace slipproof {

namespace {

constexpr int gravity = 10;

/// Mass 1, feet at the corners of a rectangle of 2 by 3/2, 1/2 below the centre of mass, mu = 5/16 unless it is given.
ContactBody block(const Rational& push, const Rational& twist, const Rational& mu = Rational(5, 16)) {
  ContactBody result;
  result.inertia = {Rational(1, 2), Rational(1, 2), 1};
  result.acceleration = {push, 0, -gravity, 0, 0, twist};
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) result.add({x, Rational(3 * y, 4), Rational(-1, 2)}, mu);
  }
  return result;
}

}  // namespace

TEST_CASE("a block that slips without turning has one motion, however its feet share the weight") {
  const CompleteSolutions found = all_solutions(block(5, 0).contacts());
  REQUIRE(found.complete());
  REQUIRE(found.motions.size() == 1);
  const VelocityBox place = place_of(found, 0);
  const Rational slip = 5 - Rational(5, 16) * gravity;  // each foot's, by friction in the direction of the push
  for (std::size_t k = 0; k < 4; ++k) {
    const Rational unit = found.scaled.velocity_unit[3 * k + 1];
    CHECK(place.low[3 * k + 1] * unit <= slip);
    CHECK(place.high[3 * k + 1] * unit >= slip);
    CHECK((place.high[3 * k + 1] - place.low[3 * k + 1]) * unit < Rational(1, 1000));
    CHECK(place.low[3 * k].sign() <= 0);
    CHECK(place.high[3 * k].sign() >= 0);
  }
}

TEST_CASE("a block that turns while it slips has a continuum of motions: two that differ, and a box that holds all") {
  const CompleteSolutions found = all_solutions(block(5, 3).contacts());
  REQUIRE(found.complete());
  REQUIRE(found.motions.size() > 1);
  std::size_t hosts = 0;
  for (std::size_t m = 0; m < found.motions.size(); ++m) {
    for (std::size_t o = 0; o < m; ++o) CHECK(found.motions[m].differs(found.motions[o]));
    const VelocityBox place = place_of(found, m);
    hosts +=
        std::ranges::all_of(found.motions, [&](const auto& o) { return place.contains(VelocityBox::of(o)); }) ? 1 : 0;
  }
  CHECK(hosts > 0);
}

TEST_CASE("of a continuum two motions are listed, though others were found, and borders of it are no second one") {
  for (const int twist : {6, 8}) {
    CAPTURE(twist);
    ContactBody turning = block(4, Rational(twist, 4), Rational(1, 4));
    turning.inertia[1] = Rational(3, 4);
    CompleteOptions options;
    options.most_nodes = 1000;
    const CompleteSolutions found = all_solutions(turning.contacts(), options);
    REQUIRE(found.complete());
    CHECK(found.motions.size() == 2);
  }
}

TEST_CASE("a body on eight contacts rests, though the forces that were found press only a few of them") {
  RandomContacts random(1);
  for (int i = 0; i < 19; ++i) {
    const ExactContacts body = random.body(8);
    if (i != 6 && i != 18) continue;
    CAPTURE(i);
    const CompleteSolutions found = all_solutions(body);
    CHECK(found.complete());
    CHECK(std::ranges::any_of(found.motions, [](const SpatialMotion& m) { return m.u == std::vector<Rational>(24); }));
  }
}

TEST_CASE("a foot above the floor's level that three others close is closed, without a force") {
  ContactBody body = block(0, 0);
  body.add({0, 0, Rational(-1, 2)}, Rational(5, 16));
  const CompleteSolutions found = all_solutions(body.contacts());
  REQUIRE(found.complete());
  REQUIRE(found.motions.size() == 1);
  CHECK(std::ranges::all_of(found.motions[0].u, [](const Rational& u) { return u.is_zero(); }));
  for (const PatternNode& node : found.nodes) {  // three that are closed leave nothing to decide about the others
    if (node.end == PatternNode::End::split) continue;
    const auto closed = std::ranges::count_if(node.pattern, [](const ContactState& s) {
      return s.kind != ContactState::Kind::open && s.kind != ContactState::Kind::any;
    });
    const auto open = std::ranges::count(node.pattern, ContactState::Kind::open, &ContactState::kind);
    if (closed > 2 && open > 0) CHECK(node.end == PatternNode::End::empty);
  }
}

}  // namespace slipproof
