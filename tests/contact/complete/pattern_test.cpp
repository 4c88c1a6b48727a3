// Multipliers by hand: what they prove, and what is refused.
#include "contact/complete/pattern.hpp"

#include <doctest/doctest.h>

using namespace slipproof;

namespace {

/// A point of mass 1 on the floor.
struct PointMass {
  ExactContacts contacts;
  IntegerContacts integers;

  PointMass(const std::vector<Rational>& q, const Rational& mu)
      : contacts{3, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, q, {mu}}, integers(contacts) {}

  bool is_empty(const ContactState& state, const std::vector<Rational>& y) const {
    return proves_empty(contacts, integers, {state}, y);
  }
};

const Direction right{1, 0, 1}, up{0, 1, 1}, left{-1, 0, 1};

ContactState in(ContactState::Kind kind) {
  return {kind, {}, {}};
}

ContactState slip_between(const Direction& from, const Direction& to) {
  return {ContactState::Kind::slip, from, to};
}

}  // namespace

TEST_CASE("multipliers of the example on the page are accepted, and others are not") {
  using enum ContactState::Kind;
  const PointMass point({-1, 1, 0}, Rational(1, 2));
  const Rational half(1, 2);
  CHECK(point.is_empty(in(open), {-1, 0, 0}));
  CHECK_FALSE(point.is_empty(in(closed), {-1, 0, 0}));
  CHECK(point.is_empty(in(stick), {half, 1, 0}));
  CHECK_FALSE(point.is_empty(in(stick), {-half, 1, 0}));
  CHECK_FALSE(point.is_empty(in(stick), {half, Rational(11, 10), 0}));
  CHECK_FALSE(point.is_empty(in(closed), {half, 1, 0}));
  CHECK_FALSE(point.is_empty(in(any), {half, 1, 0}));
  CHECK(point.is_empty(slip_between(up, left), {half, 1, 0}));
  CHECK_FALSE(point.is_empty(slip_between(right, up), {half, 1, 0}));
}

TEST_CASE("a bound of 0 proves that there is no motion only where it is strict") {
  using enum ContactState::Kind;
  const PointMass point({0, 0, 0}, Rational(1, 2));
  CHECK(point.is_empty(in(open), {-1, 0, 0}));
  CHECK_FALSE(point.is_empty(in(any), {-1, 0, 0}));
  for (const auto kind : {closed, stick}) CHECK_FALSE(point.is_empty(in(kind), {1, 0, 0}));  // r_N may be 0
  for (const auto kind : {any, open, closed, stick}) CHECK_FALSE(point.is_empty(in(kind), {0, 0, 0}));
  CHECK_FALSE(point.is_empty(slip_between(right, up), {0, 0, 0}));
  CHECK_FALSE(
      point.is_empty(slip_between(right, up), {0, -1, 0}));  // d may be the second tangent: v . u and g . r are 0
  CHECK(point.is_empty(slip_between(right, up), {0, -1, -1}));
}

TEST_CASE("forces of an arc are bounded within it, too, not only at its ends") {
  const PointMass point({0, 0, 0}, 1);
  const ContactPattern arc{slip_between({3, -4, 5}, {3, 4, 5})};
  const ContactForm form{{{1, 1}}, {}};
  const auto bound = [&](const Rational& normal) {
    return lower_bound(point.contacts, point.integers, arc, form, std::vector<Rational>{normal, 1, 0});
  };
  CHECK_FALSE(bound(Rational(7, 10)));  // 7/10 - 3/5 > 0 at the ends, 7/10 - 1 < 0 in the middle
  REQUIRE(bound(1));
  CHECK_FALSE(bound(1)->strict);
  CHECK(bound(1)->value == 0);
}

TEST_CASE("without friction velocities along a contact that touches are anything") {
  const PointMass point({-1, 1, 0}, 0);
  CHECK_FALSE(point.is_empty(in(ContactState::Kind::closed), {-1, 1, 0}));
  CHECK_FALSE(point.is_empty(in(ContactState::Kind::closed), {1, 0, 0}));
}
