// Results that are remembered: computed once, and as dear at each call.
#include <doctest/doctest.h>

#include "proofs/branch/memo.hpp"
#include "proofs/branch/replacements.hpp"

using namespace slipproof;
using namespace slipproof::prove;

namespace {

struct Times {
  int computed = 0;
  Memo<Polynomial, 2> remembered{};

  Polynomial of(const Polynomial& p, const Polynomial& q, std::size_t number = 0) {
    return remembered.get([&] { return ++computed, p * q; }, number, p, q);
  }
};

}  // namespace

TEST_CASE("what is remembered of polynomials and a number is computed once, and spends its steps each time") {
  const Ring ring({"x", "y"});
  const Polynomial p = *Polynomial::parse(ring, "x^2 + 3*x*y + y + 1"), q = *Polynomial::parse(ring, "x - y^2 + 7");
  const auto steps = [&](const auto& work) {
    const std::uint64_t before = ring.budget().spent();
    work();
    return ring.budget().spent() - before;
  };
  const Polynomial expected = p * q;
  Times times;
  const auto first = steps([&] { CHECK(times.of(p, q) == expected); });
  CHECK(first > 0);
  const Polynomial copy = p;
  CHECK(steps([&] { times.of(copy, q); }) == first);
  CHECK(times.computed == 1);
  times.of(q, p);
  times.of(p, q, 1);
  CHECK(times.computed == 3);
  const Polynomial equal = *Polynomial::parse(ring, p.text());
  CHECK(times.of(equal, q) == expected);
  CHECK(times.computed == 4);
  ring.budget().renew(first - 1);
  CHECK_THROWS_AS(times.of(p, q), Budget::Spent);
  ring.budget().lift();
}

TEST_CASE("a variable is replaced by the slack of what is linear in it") {
  const Ring ring({"x", "y"});
  Replacements replacements;
  const auto read = [&](const char* text) { return *Polynomial::parse(ring, text); };
  for (int again = 0; again < 2; ++again) {
    // s = -2 y x + 3 y + 4, so x = (s - 3 y - 4) / (-2 y), and s is called x
    const Replacement r = replacements.solved(read("-2*x*y + 3*y + 4"), 0);
    CHECK(r.denominator == read("y"));
    CHECK(r.numerator == read("-x + 3*y + 4").scaled(Rational(1) / 2));
    CHECK(replacements.applied(r, read("x^2 + 1")) == r.numerator * r.numerator + read("y^2"));
    CHECK(replacements.applied(r, read("y + 5")) == read("y + 5"));
    const Replacement two_terms = replacements.solved(read("x - x*y"), 0);
    CHECK(two_terms.denominator.leading_coefficient() > 0);
  }
}
