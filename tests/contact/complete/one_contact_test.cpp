// One contact in space against a quartic: with d = (1 - t^2, 2 t) / (1 + t^2) for the direction of slip u_N = 0 gives
// r_N, and u_T x d = 0 is a polynomial in t.
#include <doctest/doctest.h>

#include "base/algebra/real_roots.hpp"
#include "contact/complete/complete.hpp"
#include "contact/complete/random_contacts.hpp"

using namespace slipproof;

namespace {

using StateKind = ContactState::Kind;
using Coefficients = std::vector<Rational>;

Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

Coefficients sum(const Coefficients& a, const Rational& factor, const Coefficients& b) {
  Coefficients result = a;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] += factor * b[i];
  return result;
}

/// d times (1 + t^2), and 1 times it.
const Coefficients direction_x{1, 0, -1}, direction_y{0, 2, 0}, circle{1, 0, 1};

struct MotionCount {
  int open = 0, stick = 0, slip = 0;
  bool operator==(const MotionCount&) const = default;
};

int slips(const ExactContacts& p) {
  const auto& W = p.W;
  const Rational& mu = p.mu[0];
  const auto row = [&](std::size_t i) {  // W_i (1, -mu d)
    return sum(sum(sum({0, 0, 0}, W[i][0], circle), -mu * W[i][1], direction_x), -mu * W[i][2], direction_y);
  };
  // r_N = -q_N / row(0), and row(0) u_T = row(0) q_T - q_N row(T).
  const Coefficients x = sum(sum({0, 0, 0}, p.q[1], row(0)), -p.q[0], row(1));
  const Coefficients y = sum(sum({0, 0, 0}, p.q[2], row(0)), -p.q[0], row(2));
  const auto cross = IntegerPolynomial::proportional_to(sum(product(x, direction_y), -1, product(y, direction_x)));
  const auto speed = IntegerPolynomial::proportional_to(sum(product(x, direction_x), 1, product(y, direction_y)));
  const auto stiffness = IntegerPolynomial::proportional_to(row(0));
  REQUIRE(cross.degree() == 4);  // so that d = (-1, 0) is none
  int result = 0;
  for (const RealRoot& root : real_roots({cross, speed, stiffness})) {
    if (cross.sign_at(root.lower) * cross.sign_at(root.upper) > 0 ||
        (root.is_rational() && cross.sign_at(root.lower) != 0)) {
      continue;
    }
    const int force = -p.q[0].sign() * stiffness.sign_at(root.lower);
    if (force > 0 && speed.sign_at(root.lower) * stiffness.sign_at(root.lower) > 0) ++result;
  }
  return result;
}

MotionCount by_quartic(const ExactContacts& p) {
  MotionCount count{p.q[0].sign() >= 0, 0, slips(p)};
  RationalMatrix system = p.W;
  for (std::size_t i = 0; i < 3; ++i) system[i].push_back(-p.q[i]);
  const Echelon echelon = eliminate(system);
  REQUIRE(echelon.rank(3) == 3);
  std::array<Rational, 3> r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = Rational(echelon.rows[i][3], echelon.pivot);
  const Rational limit = p.mu[0] * r[0];
  count.stick = r[0].sign() > 0 && r[1] * r[1] + r[2] * r[2] <= limit * limit;
  return count;
}

MotionCount by_tree(const ExactContacts& p) {
  const CompleteSolutions all = all_solutions(p);
  CHECK(all.complete());
  MotionCount count;
  for (const SpatialMotion& motion : all.motions) {
    const StateKind kind = motion.mode[0].kind;
    ++(kind == StateKind::open ? count.open : kind == StateKind::stick ? count.stick : count.slip);
  }
  return count;
}

}  // namespace

TEST_CASE("one contact in space has the motions that a quartic has") {
  RandomContacts random(3);
  int several = 0, none = 0, slipping = 0;
  for (int i = 0; i < 500; ++i) {
    ExactContacts problem = i % 3 == 0   ? random.body(1, 2)
                            : i % 3 == 1 ? random.symmetric(3, 1, 3, 2, 8)
                                         : random.any(3, 1, 2, 16);
    if (problem.mu[0].is_zero()) problem.mu[0] = Rational(1, 3);
    CAPTURE(i);
    const MotionCount expected = by_quartic(problem), found = by_tree(problem);
    CHECK(found.open == expected.open);
    CHECK(found.stick == expected.stick);
    CHECK(found.slip == expected.slip);
    const int motions = expected.open + expected.stick + expected.slip;
    several += motions > 1;
    none += motions == 0;
    slipping += expected.slip > 0;
  }
  MESSAGE(several << " with several motions, " << none << " with none, " << slipping << " slip");
  CHECK(several > 20);
  CHECK(none > 20);
  CHECK(slipping > 100);
}
