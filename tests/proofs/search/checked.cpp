// Small statements of every shape: the prover finds a certificate, and the checker accepts it.
#include <doctest/doctest.h>

#include <string>

#include "proofs/check/files.hpp"
#include "proofs/search/prove.hpp"
#include "proofs/search/small_statement.hpp"
#include "support/run_program.hpp"

namespace {

using namespace slipproof;
using test::statement;

/// `accepted`, what the checker objects to, or `undecided`.
std::string checked(const std::string& lines, const prove::Limits& limits = {}) {
  const ProofOutcome outcome = prove_statement("small", statement(lines), limits);
  if (!outcome.proved()) return std::string(name(outcome.verdict));
  const test::TemporaryFolder folder;
  folder.write("small.statement", statement(lines));
  const check::FileResult result = check::check_file(folder.write("small.cert", outcome.certificate));
  return result.verdict == check::Verdict::accepted ? "accepted" : result.message;
}

}  // namespace

TEST_CASE("hypotheses in nested conjunctions and disjunctions have the names that the checker gives them") {
  const std::string positive = "real x y z\nassume a: x > 0 and y > 0 and z > 0\n";
  for (const std::string& lines :
       {positive + "show {x > 0 or y < 0} or z < 0\n", positive + "show z < 0 or {y < 0 or x > 0}\n",
        positive + "show {{y < 0 or x < 0} or z < 0} or {x < 0 or {x < 0 or x*y > 0}}\n",
        std::string("real x y z\nassume a: {x > 0 and y > 0} and z > 0\nshow x + y*z > 0\n"),
        std::string("real x y z\nassume a: x > 0 and {y > 0 and z > 0}\nshow x + y*z > 0\n"),
        std::string("real x y z\nassume a: {x > 0 or y > 1} or z > 0\nassume b: y < 0 and z < 0\nshow x > 0\n"),
        std::string("real x y\ndefine d: x > 0 or y > 0\nassume a: d or x > 1\nshow {x > 0 or x > 1} or y > 0\n"),
        std::string("real x\nassume a: {x = 0 or x = 1} or x = 2\nshow {x = 0 or {x = 1 and x > 0}} or {x = 2}\n"),
        std::string("real x y\nassume a: y > 0\nassume b: x/y > 1\nshow {{x > y or x < 0} and y > 0} or {x = 2 or "
                    "x/y < 0}\n"),
        std::string("real x\nassume a: x > 0\nexists z\nshow z = x/2 and {{z < x or z > 2*x} or z < 0}\n")}) {
    CAPTURE(lines);
    CHECK(checked(lines) == "accepted");
  }
}

TEST_CASE("products of hypotheses prove what no other tactic does") {
  prove::Limits with, without;
  with.split_depth = without.split_depth = 0;
  without.products = 0;
  const std::string square = "real x y\nassume a: -1 <= x <= 1 and -1 <= y <= 1\n";
  for (const std::string& lines :
       {square + "show x*y >= -1\n", square + "show 1 + x + y + x*y >= 0 and x*y <= 1\n",
        std::string("real x y\nassume a: -1 < x < 1 and -1 < y < 1\nshow (x + y)/(1 + x*y) < 1\n"),
        // Products of three.
        std::string("real x y z\nassume a: 0 <= x <= 1 and 0 <= y <= 1 and 0 <= z <= 1\n"
                    "show x*(1 - y) + y*(1 - z) + z*(1 - x) <= 1\n"),
        std::string("real x y z\nassume a: -1 <= x <= 1 and -1 <= y <= 1 and -1 <= z <= 1\n"
                    "show x*y + y*z + z*x >= -1\n"),
        // Equations with multipliers of any sign.
        std::string("real x y\nassume a: x >= 0 and y >= 0 and x^2 + y^2 = 1\nshow x + y >= 1\n"),
        std::string("real x y\nassume a: x >= 0 and y >= 0 and x^3 + y^3 = 1\nshow x + y >= 1\n")}) {
    CAPTURE(lines);
    CHECK(checked(lines, with) == "accepted");
    CHECK(checked(lines, without) == "undecided");
  }
  CHECK(checked("real x y\nassume a: x >= 1 and y >= 1\nshow x*y >= x + y - 1\n") == "accepted");
}

TEST_CASE("products of hypotheses prove nothing that is false, and end") {
  for (const std::string lines : {"real x y\nassume a: -1 <= x <= 1 and -1 <= y <= 1\nshow x*y >= -1/2\n",
                                  "real x y\nassume a: -1 <= x <= 1 and -1 <= y <= 1\nshow x*y > -1\n",
                                  "real x y\nassume a: x >= 0 and y >= 0 and x^2 + y^2 = 1\nshow x + y > 1\n"}) {
    CAPTURE(lines);
    CHECK(checked(lines) == "refuted");
  }
  prove::Limits limits;
  limits.split_depth = 0;
  limits.steps = 1'000;
  const std::string many =
      "real x y z\nassume a: 0 <= x <= 1 and 0 <= y <= 1 and 0 <= z <= 1\n"
      "show x*(1 - y) + y*(1 - z) + z*(1 - x) <= 1\n";
  const ProofOutcome ended = prove_statement("small", statement(many), limits);
  REQUIRE(!ended.leftover.empty());
  CHECK(ended.leftover.front() == "no step left of 1000");
}

TEST_CASE("squares, and the order of the variables, prove what products of hypotheses do not") {
  const std::string positive = "real a b c\nassume h: a > 0 and b > 0 and c > 0\n";
  for (const std::string& lines :
       {std::string("real x y\nshow (x + y)^2 >= 4*x*y\n"), std::string("real x\nshow x^2 + x + 1 > 0\n"),
        std::string("real x y z\nshow x^2 + y^2 + z^2 >= x*y + y*z + z*x\n"),
        std::string("real a b c d\nshow (a^2 + b^2)*(c^2 + d^2) >= (a*c + b*d)^2\n"),
        std::string("real x y\nshow x^4 + y^4 >= x^3*y + x*y^3\n"), std::string("real x\nshow x^4 - 2*x^2 + 2 > 0\n"),
        std::string("real x y\nshow x^2*(y^2 + 1) + 2*x*y + 1 > 0\n"),
        std::string("real a b c x\nassume h: a != 0 and a*x^2 + b*x + c = 0\nshow b^2 >= 4*a*c\n"),
        positive + "show a/(b + c) + b/(c + a) + c/(a + b) >= 3/2\n", positive + "show (a + b + c)^3 >= 27*a*b*c\n"}) {
    CAPTURE(lines);
    CHECK(checked(lines) == "accepted");
    CHECK(checked(lines, {.products = 0}) == "undecided");
  }
  for (const std::string& lines :
       {std::string("real x y\nshow (x + y)^2 > 4*x*y\n"), std::string("real x\nshow x^2 + 2*x + 1 > 0\n"),
        std::string("real a b c x\nassume h: a > 0 and b^2 <= 4*a*c\nshow a*x^2 + b*x + c > 0\n"),
        std::string("real x y\nshow x^4 + y^4 >= 2*x^3*y\n"),
        positive + "show a/(b + c) + b/(c + a) + c/(a + b) > 3/2\n"}) {
    CAPTURE(lines);
    CHECK(checked(lines) == "refuted");
  }
}

TEST_CASE("assumptions may be called as the prover calls its own hypotheses") {
  CHECK(checked("real x y\nassume e1: x >= 1 or x <= -1\nassume e2: y > 1\nassume e4: x*y = 3\n"
                "show x^2*y > 1/2 and (x + y)^2 >= 4*x*y\n") == "accepted");
  CHECK(checked("real x y\nassume goal1: x != y\nexists w z\n"
                "show w = x + 1 and {{z = x and z > y} or {z = y and z > x}}\n") == "accepted");
}

TEST_CASE("a value between bounds is found, also where it has to be decided which bound is the stronger one") {
  for (const char* lines :
       {"real x y\nassume h: x < y\nexists z\nshow x < z < y\n", "real x\nexists z\nshow z > x\n",
        "real x y\nexists z\nshow z < x and z < y and z < 0\n",
        "real x y u\nassume h: x < u and y < u\nexists z\nshow x < z and y < z and z < u\n",
        "real x y w u\nassume h: x < u and y < u and w < u\nexists z\nshow x < z and y < z and w < z and z < u\n",
        "real x y m\nassume h: m < 0 and y < x/m\nexists z\nshow m*z > x and z > y\n",
        "real x y\nassume h: x < y\nexists z w\nshow x < z < y and w = 2*z and 3*x < w + z\n",
        "real f N F M\nassume h: f > 0 and N > 0 and M > 0 and F < f*N*(1 + M)\nexists a S\n"
        "show M*a = F - S and S < f*N and S > a\n"}) {
    CAPTURE(std::string(lines));
    CHECK(checked(lines) == "accepted");
  }
  CHECK(checked("real x y\nassume h: x <= y\nexists z\nshow x < z < y\n") == "refuted");
  CHECK(checked("real x y u\nassume h: x < u or y < u\nexists z\nshow x < z and y < z and z < u\n") == "refuted");
}

TEST_CASE("a bound that may be attained is a witness, where no value between bounds is one") {
  // The wall's friction is exhausted, and only then the forces are in both cones at the end of the range.
  CHECK(checked("real a b k u v g\nassume h: a > 0 and b > 0 and 0 < k < 1 and u >= 0 and v >= 0 and g > 0\n"
                "assume force: k*(1 + u*v)*a <= u*(b + v*a)\nexists N1 S1 N2 S2\n"
                "show S1 + N2 = 0 and N1 + S2 = g and k*a*N1 + k*b*S1 = (1 - k)*(b*N2 + a*S2) and N1 >= 0 and "
                "-u*N1 <= S1 <= u*N1 and N2 >= 0 and -v*N2 <= S2 <= v*N2\n") == "accepted");
}

TEST_CASE("a pivot of unknown sign is split on where something is to exist") {
  CHECK(checked("real x y\nassume h: x != 0 or y != 0\nexists z w\nshow x*z + y*w = 1\n") == "accepted");
  CHECK(checked("real x y\nexists z w\nshow x*z + y*w = 1\n") == "undecided");  // false where both are 0
}

TEST_CASE("a sign that is a sum of products of facts is found, and none that is not") {
  const std::string facts =
      "real m p q T I u v\nassume h: m > 0 and p > 0 and q > 0 and T > 0 and I > 0 and u >= 0 and v >= 0\n"
      "let need = (p + q)*T + v*q\nassume force: u*need <= p\n";
  const std::string determinant = "(1 + u*v)*(I + m*q^2*T*(v + T)) + m*(p - u*need)*(p + v*T*q)";
  CHECK(checked(facts + "exists z\nshow z*(" + determinant + ") = 1\n") == "accepted");
  CHECK(checked(facts + "exists z\nshow z*(" + determinant + " - 2*I) = 1\n") == "undecided");
}

TEST_CASE("numbers that a statement divides by do not end a search for numbers at which it is false") {
  CHECK(checked("real b F u c\nassume h: F < 0 and u > 0 and c > 0 and b > 0\nlet lead = F/(b - u*c)\n"
                "assume force: u*c <= b or b < lead\nexists N\nshow N = b + 1 and N > F\n") == "accepted");
}
