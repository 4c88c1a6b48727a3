// Claims about mechanisms in space: friction in cones, whose conditions are not linear.
#include <doctest/doctest.h>

#include <string>

#include "base/input/diagnostic.hpp"
#include "claims/canonical/canonical_claims.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "claims/statements/unstated.hpp"
#include "claims/verify/verify.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "report/papers/explain.hpp"

using namespace slipproof;

namespace claims_in_space_test {

namespace {

const std::string block = "proofs/in-space/block", ball = "proofs/in-space/ball",
                  three_legs = "tests/claims/verify/three-legs";

ClaimsFile in_space(const std::string& mechanism, const std::string& says, const std::string& setting = "") {
  return parse_claims(
      "schema = \"slipproof/claims/1\"\npaper = { title = \"t\", authors = [], source = \"s.txt\" }\n[[setting]]\nid = "
      "\"first\"\nmotions = \"closed\"\nmechanism = \"" SLIPPROOF_SOURCE_DIR "/" +
          mechanism + ".toml\"\n" + setting + "\n[[claim]]\nid = \"X\"\nline = 1\nstatement = \"x\"\n" + says + "\n",
      "claims.toml");
}

ClaimResult result_of(const ClaimsFile& file, std::uint64_t samples = 100) {
  VerifyOptions options;
  options.samples = samples;
  options.lines = 2;
  return verify(file, options).claims.front();
}
Verdict verdict(const std::string& mechanism, const std::string& says) {
  return result_of(in_space(mechanism, says)).verdict;
}

std::string refused(const std::string& mechanism, const std::string& says, const std::string& setting = "") {
  try {
    in_space(mechanism, says, setting);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string interval(const std::string& forces) {
  return "kind = \"interval\"\nmode = \"stick\"\nforces = \"" + forces + "\"";
}

/// A contact that sticks with T2 = t, N = n, and T1 = 3 t or unknown, mu = 1.
FrictionProblem one_cone(const Rational& t, const Rational& n, bool is_open) {
  FrictionProblem problem;
  problem.unknowns = 6;  // gap, slips, N, T1, T2
  const auto unit = [](std::size_t i, const Rational& constant = 0) {
    AffineForm form{constant, std::vector<Rational>(7)};
    form.coefficients[i] = 1;
    return form;
  };
  problem.equations = {unit(3, -n), unit(5, -t)};
  if (!is_open) problem.equations.push_back(unit(4, Rational(-3 * t)));
  ProblemElement contact;
  contact.kind.law = ElementKind::Law::cone;
  contact.kind.slips = contact.kind.lifts = false;
  contact.gap = unit(0);
  contact.slip = unit(1);
  contact.second_slip = unit(2);
  contact.normal = contact.static_limit = contact.kinetic_limit = unit(3);
  contact.tangent = unit(4);
  contact.second_tangent = unit(5);
  contact.drag = contact.second_drag = unit(3);
  problem.accelerations = {contact.gap, contact.slip, contact.second_slip};
  problem.forces = {unit(3), unit(4), unit(5)};
  problem.elements = {contact};
  return problem;
}

/// `strict`, `boundary`, `none`, or `unknown`.
std::string sticks(const FrictionProblem& problem) {
  const auto motions = motions_over_loads(problem);
  const auto mode = motions->find({ElementState::stick});
  if (!mode) return "unknown";
  return !mode->strict->empty() ? "strict" : !mode->closed->empty() ? "boundary" : "none";
}

}  // namespace

TEST_CASE("a contact in space sticks where T1^2 + T2^2 <= (mu N)^2") {
  // T = (3, 1) t, of the size sqrt(10) t: 1053/333 < sqrt(10) < 1054/333
  CHECK(sticks(one_cone(1, 4, false)) == "strict");
  CHECK(sticks(one_cone(333, 1053, false)) == "none");
  CHECK(sticks(one_cone(333, 1054, false)) == "strict");
  CHECK(sticks(one_cone(0, 0, false)) == "boundary");
  CHECK(sticks(one_cone(-1, -4, false)) == "none");
  // T1 is not determined, and may be 0.
  CHECK(sticks(one_cone(999, 1000, true)) == "strict");
  CHECK(sticks(one_cone(1001, 1000, true)) == "none");
  CHECK(sticks(one_cone(1, 1, true)) == "boundary");
}

TEST_CASE("a block on a slope holds a sideways pull up to sqrt(mu^2 cos^2 - sin^2) m g") {
  CHECK(verdict(block, interval("P^2 <= m^2*g^2*(mu^2*c^2 - s^2)")) == Verdict::holds);
  CHECK(verdict(block, interval("P^2 < m^2*g^2*(mu^2*c^2 - s^2)")) == Verdict::refuted);
  CHECK(verdict(block, interval("P^2 <= m^2*g^2*(mu^2*c^2 - 1001/1000*s^2)")) == Verdict::refuted);
  CHECK(verdict(block, interval("P <= mu*m*g*c")) == Verdict::refuted);
  CHECK(verdict(block, interval("P <= m*g*(mu*c - s)")) == Verdict::refuted);
  CHECK(verdict(block, "kind = \"impossible\"\nmodes = [\"stick\"]\nregion = \"s > mu*c\"") == Verdict::holds);
  CHECK(verdict(block, "kind = \"impossible\"\nmodes = [\"stick\"]\nregion = \"2*s > mu*c\"") == Verdict::refuted);
  CHECK(verdict(block, "kind = \"exists\"\nmodes = [\"stick\"]\nforces = \"P > m*g*(mu*c - s)\"") == Verdict::holds);
  CHECK(verdict(block, "kind = \"formula\"\nmode = \"stick\"\nholds = \"T1_base^2 + T2_base^2 = P^2\"") ==
        Verdict::refuted);
  CHECK(verdict(block, "kind = \"formula\"\nmode = \"stick\"\nholds = \"T1_base = -m*g*s\"") == Verdict::holds);
}

TEST_CASE("a refuted claim in space shows a scene with its load, without motions that are not known") {
  const ClaimsFile file = in_space(block, interval("P <= mu*m*g*c"));
  const ClaimResult result = result_of(file);
  REQUIRE(result.counterexample);
  CHECK_FALSE(result.counterexample->motions);
  const std::string scene = scene_text(file.settings.front(), *result.counterexample);
  CHECK(scene.find("\nP = \"") != std::string::npos);
  CHECK(scene.find("\ntheta = { cos") != std::string::npos);
}

TEST_CASE("friction that the legs of a stool share as they like is decided where polygons decide it") {
  const std::string all = "stick/stick/stick";
  CHECK(verdict(three_legs, "kind = \"impossible\"\nmodes = [\"" + all + "\"]\nforces = \"F > mu*m*g\"") ==
        Verdict::holds);
  CHECK(verdict(three_legs, "kind = \"impossible\"\nmodes = [\"" + all + "\"]\nforces = \"F > 9/10*mu*m*g\"") ==
        Verdict::refuted);
  CHECK(verdict(three_legs, "kind = \"formula\"\nmode = \"" + all + "\"\nholds = \"N_ahead = m*g/2 + F*h/(2*a)\"") ==
        Verdict::holds);
  // T1 of one leg is not determined: whether a point is in the cones is not known here.
  CHECK(verdict(three_legs, "kind = \"formula\"\nmode = \"" + all + "\"\nholds = \"T1_ahead = 0\"") ==
        Verdict::undecided);
}

TEST_CASE("a contact that slides already drags along its direction, and its modes are all known") {
  CHECK(verdict(ball, "kind = \"motions\"\nmodes = [\"slip\"]") == Verdict::holds);
  CHECK(verdict(ball, "kind = \"motions\"\nmodes = [\"lift\"]") == Verdict::refuted);
  CHECK(verdict(ball, "kind = \"formula\"\nmode = \"slip\"\nholds = \"5*ay = -3*mu*g and 5*ax = 4*mu*g\"") ==
        Verdict::holds);
  CHECK(verdict(ball, "kind = \"formula\"\nmode = \"slip\"\nholds = \"ay = -mu*g\"") == Verdict::refuted);
}

TEST_CASE("slips from rest are not modelled, and no claim about them passes") {
  CHECK(verdict(block, "kind = \"impossible\"\nmodes = [\"slip\"]\nregion = \"mu*c > 2*s\"\nforces = \"P = 0\"") ==
        Verdict::undecided);
  CHECK(verdict(block, "kind = \"exists\"\nmodes = [\"slip\"]") == Verdict::undecided);
  CHECK(verdict(block, "kind = \"motions\"\nmodes = [\"stick\"]\nregion = \"mu*c > 2*s\"\nforces = \"P = 0\"") ==
        Verdict::undecided);
  CHECK(verdict(block, "kind = \"motions\"\nmodes = [\"lift\"]") == Verdict::refuted);
  const auto unstated = unstated_claims(in_space(block, "kind = \"impossible\"\nmodes = [\"slip\"]"));
  REQUIRE(unstated.size() == 1);
  CHECK(unstated[0].why.find("a slip of base from rest, in a direction that nobody knows") == 0);
  const auto others = unstated_claims(in_space(block, "kind = \"motions\"\nmodes = [\"stick\"]"));
  REQUIRE(others.size() == 1);
  CHECK(others[0].why.find("not all states of contacts are modelled") != std::string::npos);
}

TEST_CASE("statements have the cone as a polynomial inequality, and the judge in Coq is not asked") {
  const ClaimsFile file = in_space(block, interval("P^2 <= m^2*g^2*(mu^2*c^2 - s^2)"));
  const auto statements = claim_statements(file, file.claims.front(), Reading::printed);
  REQUIRE(statements.size() == 2);
  CHECK(statements[0].text.find("T1_base^2 + T2_base^2 <= (mu * N_base)^2") != std::string::npos);
  CHECK(canonical_claims(file).empty());
}

TEST_CASE("what claims in space do not take is refused, with what is expected") {
  CHECK(refused(block, interval("P = 0"), "force = { symbol = \"P\", domain = \"P > 0\" }")
            .find("force: found beside a mechanism in space, expected none: there the load is one of the parameters") !=
        std::string::npos);
  CHECK(refused(block, "kind = \"interval\"\nmode = \"slip+\"\nforces = \"P = 0\"").find("state of base") !=
        std::string::npos);
}

}  // namespace claims_in_space_test
