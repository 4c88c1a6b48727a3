// Motions that need no friction are the only ones where W is symmetric and semidefinite.
#include "contact/complete/motion/frictionless.hpp"

#include <doctest/doctest.h>

#include "contact/complete/complete.hpp"
#include "contact/complete/random_contacts.hpp"

namespace slipproof {

namespace {

/// W = I for two contacts that are independent of each other.
ExactContacts two_points(const std::vector<Rational>& q, const Rational& first_mu, const Rational& second_mu) {
  ExactContacts result{3, RationalMatrix(6, std::vector<Rational>(6)), q, {first_mu, second_mu}};
  for (std::size_t i = 0; i < 6; ++i) result.W[i][i] = 1;
  return result;
}

const std::vector<Rational> still(6);

}  // namespace

TEST_CASE("a motion by normal forces is one of rest, of lift, and of what slides without friction") {
  const Rational half(1, 2);
  const auto at_rest = motion_without_friction(two_points({-1, 0, 0, -2, 0, 0}, half, half), still);
  REQUIRE(at_rest);
  CHECK(at_rest->r == std::vector<Rational>{1, 0, 0, 2, 0, 0});
  const std::vector<Rational> lifts{3, 0, 0, 0, 0, 0}, slides{0, 0, 0, 0, 1, 0};
  CHECK(motion_without_friction(two_points({3, 0, 0, -2, 0, 0}, half, half), lifts));
  CHECK(motion_without_friction(two_points({-1, 0, 0, -2, 1, 0}, half, 0), slides));
}

TEST_CASE("a motion that needs friction, or pulls, or slides with friction, is none without it") {
  const Rational half(1, 2);
  const std::vector<Rational> slides{0, 0, 0, 0, 1, 0};
  CHECK_FALSE(motion_without_friction(two_points({-1, half, 0, -2, 0, 0}, half, half), still));
  CHECK_FALSE(motion_without_friction(two_points({-1, 0, 0, 2, 0, 0}, half, half), still));
  CHECK_FALSE(motion_without_friction(two_points({-1, 0, 0, -2, 1, 0}, half, half), slides));
  CHECK_FALSE(motion_without_friction(two_points({-1, 0, 0, -2, 1, 0}, half, 0), still));
}

TEST_CASE("of forces that are open the most even ones hold a stack") {
  const ExactContacts three = stack(3, Rational(1, 3), 0);
  const auto motion = motion_without_friction(three, std::vector<Rational>(three.size()));
  REQUIRE(motion);
  for (std::size_t k = 0; k < 12; ++k) CHECK(motion->r[3 * k].sign() > 0);
  CHECK(motion->open_directions == 36 - 18);
}

TEST_CASE("squares are those of symmetric, semidefinite matrices") {
  const auto squares = squares_of({{2, 1, 0}, {1, 2, 0}, {0, 0, 0}});
  REQUIRE(squares);
  CHECK(squares->size() == 2);
  CHECK((*squares)[1].factor == Rational(3, 2));
  CHECK_FALSE(squares_of({{1, 1}, {0, 2}}));  // asymmetric
  CHECK_FALSE(squares_of({{1, 2}, {2, 1}}));  // indefinite
  CHECK_FALSE(squares_of({{0, 1}, {1, 0}}));  // a pivot of 0
  CHECK_FALSE(squares_of({{-1}}));
}

TEST_CASE("rest without friction is not the only motion where W is asymmetric or indefinite") {
  // u_N = r_N + 3 r_T - 1, u_T = 3 r_N + r_T - 3: it rests with r = (1, 0), and slips back with r = (1/7, 2/7).
  const ExactContacts jams{2, {{1, 3}, {3, 1}}, {-1, -3}, {2}};
  const auto motion = motion_without_friction(jams, std::vector<Rational>(2));
  REQUIRE(motion);
  CHECK_FALSE(squares_of(jams.W));
  CHECK(all_solutions(jams).motions.size() == 2);
}

}  // namespace slipproof
