// Judging and proving end when they are asked to.
#include <doctest/doctest.h>

#include "claims/mutation/mutation.hpp"
#include "claims/verify/verify.hpp"
#include "proofs/search/prove.hpp"
#include "support/papers/shipped.hpp"
#include "support/stopped.hpp"

using namespace slipproof;
using test::is_stopped;

TEST_CASE("verifying and judging mutants end when they are asked to") {
  const ClaimsFile& paper = test::shipped_paper();
  VerifyOptions samples;
  samples.samples = 10'000'000;
  CHECK(is_stopped([&] { verify(paper, samples); }));
  MutationOptions mutants;
  mutants.samples = 20'000;
  CHECK(is_stopped([&] { judge_mutants(paper, mutants); }));
}

TEST_CASE("proving ends when it is asked to") {
  // What nobody has a certificate for: it would be searched for until all steps are spent.
  const std::string hard =
      "slipproof-statement 1\n"
      "theorem hard\n"
      "real x y z\n"
      "assume here: x^4*y^2 + x^2*y^4 + z^6 - 3*x^2*y^2*z^2 + x*y*z > 1\n"
      "show x^6 + y^6 + z^6 > x*y*z*(x + y + z)^3/27 + 1/1000\n";
  prove::Limits limits;
  limits.steps = 1'000'000'000'000;
  CHECK(is_stopped([&] { prove_statement("hard.statement", hard, limits); }));
}
