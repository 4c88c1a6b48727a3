#include "claims/verify/verify.hpp"

#include <doctest/doctest.h>

#include "base/expression/parser.hpp"
#include "claims/mutation/claims_mutants.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/sampling/simplify.hpp"
#include "report/papers/verify_report.hpp"
#include "support/bicycle/bicycle_motions.hpp"
#include "support/bicycle/conditions.hpp"
#include "support/bicycle/equations.hpp"
#include "support/crew_ranks.hpp"
#include "support/how_many.hpp"
#include "support/papers/shipped.hpp"

using namespace slipproof;

namespace {

constexpr std::uint64_t sampled_less = test::quick(1, 5);

VerifyOptions options(std::uint64_t samples, std::uint64_t seed = 1, unsigned threads = 0) {
  VerifyOptions o;
  o.samples = samples;
  o.seed = seed;
  o.threads = threads;
  return o;
}

/// The shipped paper, judged once for all that ask about its verdicts and counterexamples.
const VerifyResult& whole_paper() {
  static const VerifyResult result = verify(test::shipped_paper(), options(sampled_less > 1 ? 120 : 300));
  return result;
}

/// One claim of the repaired paper, changed, and judged.
ClaimResult judged(const std::string& id, const std::function<void(ClaimBody&)>& change) {
  ClaimsFile file = as_read(test::shipped_paper(), Reading::repaired);
  Claim claim = file.claims[test::index_of(file, id)];
  change(claim.printed);
  file.claims = {claim};
  return verify(file, options(400)).claims.front();
}

Expression truth(const char* text) {
  return parse_expression(text, Sort::truth);
}

Reason reason(const ClaimResult& r) {
  REQUIRE(r.counterexample);
  return r.counterexample->judgement.reason;
}

}  // namespace

TEST_CASE("the shipped paper: every verdict is the expected one") {
  const ClaimsFile& file = test::shipped_paper();
  const VerifyResult& result = whole_paper();
  for (const ClaimResult& claim : result.claims) {
    CAPTURE(file.claims[claim.claim].id);
    CAPTURE(name(claim.reading));
    CHECK(as_expected(file, claim));
    const bool of_existence = file.claims[claim.claim].kind().traits().seeks;  // refuted by finding nothing
    if (claim.verdict == Verdict::refuted && !of_existence) CHECK(claim.counterexample.has_value());
  }
  CHECK(summary(file, result) == Summary::as_expected);
}

TEST_CASE("the same bytes at any number of threads and ranks; another seed, other samples") {
  const ClaimsFile& file = test::shipped_paper();
  const auto bytes = [&](unsigned threads, std::uint64_t seed) {
    VerifyOptions o = options(40, seed, threads);
    o.lines = 0;  // theirs is a test of their own
    return verify_json(file, verify(file, o));
  };
  const std::string one = bytes(2, 1);
  VerifyOptions o = options(40, 1, 1);
  o.lines = 0;
  Verification verification(file, o, 7);
  test::by_crew(
      3,
      [&](std::string_view request) {
        CHECK(Verification::paper_of(request) == 7);
        return verification.answer(request);
      },
      [&](Crew& crew) { CHECK(verify_json(file, verification.result(&crew)) == one); });
  CHECK(bytes(2, 2) != one);
}

TEST_CASE("A2.1 as printed: the counterexample that a person can check") {
  // R = h = b = M2 = M3 = f = g = sigma = 1: b1 is printed as f h (2 M1) = 4 > b, xi2 = 3/(2 + 4) = 1/2 and
  // xi3 = 2/(1 + 2) = 2/3, so that xi3 < F < xi2 is empty; yet the front wheel slips for 1/2 < F < 2/3.
  const ClaimsFile& file = test::shipped_paper();
  VerifyOptions assertion = options(500);
  assertion.only = "A2.1";
  const VerifyResult result = verify(file, assertion);
  const ClaimResult& r = *result.find(file, "A2.1", Reading::printed);
  REQUIRE(r.counterexample);
  REQUIRE(r.simplest);  // its wheels of radius 1 overlap: one that can be built stands before it
  const Counterexample& e = *r.simplest;
  CHECK(e.minimal);
  for (const Rational& value : e.values) CHECK(value == 1);
  CHECK(e.judgement.claimed->empty());
  CHECK(*e.judgement.real == ForceInterval::open_between(Rational(1, 2), Rational(2, 3)));
  CHECK(e.motions->motions.size() == 1);
}

TEST_CASE("every counterexample to the shipped paper can be built: its wheels do not overlap, and are not too heavy") {
  const ClaimsFile& file = test::shipped_paper();
  std::size_t shown = 0;
  for (const ClaimResult& claim : whole_paper().claims) {
    if (!claim.counterexample) continue;
    CAPTURE(file.claims[claim.claim].id);
    CHECK(claim.counterexample->unrealisable.empty());
    const Bicycle<Rational> p = bicycle_of(claim.counterexample->scene.values).bicycle;
    CHECK(p.b2 + p.b3 > 2 * p.R);
    CHECK(p.I2 + p.I3 <= p.M * p.R * p.R);
    CHECK(p.L < p.R);
    CHECK(p.h + p.R > 0);
    if (!claim.simplest) continue;
    ++shown;
    CHECK_FALSE(claim.simplest->unrealisable.empty());
    CHECK(2 * complexity(claim.simplest->values).height <= complexity(claim.counterexample->values).height);
  }
  CHECK(shown > 0);
}

TEST_CASE("motions of a counterexample satisfy the raw equations and their conditions") {
  int checked = 0;
  for (const ClaimResult& claim : whole_paper().claims) {
    if (!claim.counterexample || !claim.counterexample->motions) continue;
    const BicycleOfValues scene = bicycle_of(claim.counterexample->scene.values);
    const Rational F = *claim.counterexample->scene.load;
    for (const MotionAtLoad& found : claim.counterexample->motions->motions) {
      const auto& x = found.accelerations;
      const auto force = [&](std::size_t i) { return *found.forces[i].lower; };  // T, N2, S2, N3, S3
      const Unknowns<Rational> u{x[0], x[1], x[2], x[3], x[4], x[5], force(0), force(2), force(4), force(1), force(3)};
      for (const auto& r : equations_of_motion(scene.bicycle, scene.road, scene.kind, u, F)) CHECK(r == 0);
      const Motion<Rational> motion = motion_of(scene.bicycle, u);
      for (const MechanismMode& m : found.all_modes()) {
        for (const Condition& c : conditions(*contact_mode(m))) CHECK(condition_value(c, motion, scene.road.f) >= 0);
      }
      ++checked;
    }
  }
  CHECK(checked >= 5);
}

TEST_CASE("each way to fail has its reason") {
  CHECK(judged("A1.1", [](ClaimBody&) {}).verdict == Verdict::holds);
  CHECK(reason(judged("A1.1", [](ClaimBody& b) { b.forces = truth("0 < F*sigma <= xi1"); })) == Reason::ends);
  CHECK(reason(judged("A1.1", [](ClaimBody& b) { b.forces = truth("0 < F*sigma < xi2"); })) == Reason::forces);
  CHECK(reason(judged("A2.4", [](ClaimBody& b) { b.region = truth("b >= b11"); })) == Reason::exists);
  CHECK(reason(judged("A2.1a", [](ClaimBody& b) { b.holds = truth("a = a22 + F"); })) == Reason::formula);
  CHECK(reason(judged("A2.2", [](ClaimBody& b) { b.region = truth("b1 <= b < b11"); })) == Reason::continuum);
  CHECK(reason(judged("A5.1", [](ClaimBody& b) { b.modes.pop_back(); })) == Reason::extra);
  CHECK(reason(judged("A5.1", [](ClaimBody& b) {
          b.modes.push_back({ElementState::slip_backward, ElementState::lift});
        })) == Reason::missing);
}

TEST_CASE("uniqueness: several motions are refuted although each of them is stated by some claim") {
  ClaimsFile file = as_read(test::shipped_paper(), Reading::repaired);
  file.claims[test::index_of(file, "A5.2")].printed.except.clear();
  VerifyOptions uniqueness = options(400);
  uniqueness.only = "A5.2";
  const VerifyResult result = verify(file, uniqueness);
  const ClaimResult& r = *result.find(file, "A5.2", Reading::printed);
  REQUIRE(r.verdict == Verdict::refuted);
  CHECK(reason(r) == Reason::extra);
  CHECK(r.counterexample->motions->motions.size() >= 2);
}

TEST_CASE(
    "uniqueness at b = b11: one motion alone, on a boundary for a half-line of forces, counts as the motion there is") {
  const ClaimsFile& file = test::shipped_paper();
  const std::size_t claim = test::index_of(file, "A5.2");
  const std::size_t setting = file.claims[claim].setting;
  const CompiledClaims compiled(file);
  // b11 = f (h + M1 R) = 3 with R = h = f = M2 = 1. In the order of the parameters: R h b M2 M3 f g sigma J.
  std::vector<Rational> values;
  for (const FreeParameter& parameter : file.settings[setting].parameters)
    values.emplace_back(parameter.symbol == "b" ? 3 : 1);
  auto sample = SolvedSample::make(compiled.settings[setting], values);
  REQUIRE(sample);
  const LoadCell& last = sample->cells().back();
  REQUIRE(!last.loads.upper());
  REQUIRE(last.motions.size() == 1);
  CHECK(last.motions.front().modes.empty());
  CHECK(judge(file, compiled, claim, Reading::repaired, *sample).outcome == Outcome::holds);
}

TEST_CASE("no value in its own region is undecided, never a success") {
  const auto undefined = judged("A1.1", [](ClaimBody& b) { b.forces = truth("0 < F*sigma < 1/(b - b)"); });
  CHECK(undefined.verdict == Verdict::undecided);
  const auto never = judged("A1.1", [](ClaimBody& b) { b.region = truth("b < 0"); });
  CHECK(never.verdict == Verdict::vacuous);
  CHECK(never.samples() == 0);
}

TEST_CASE("another paper needs another file, and no C++: massless wheels, and the pulled pedal") {
  const ClaimsFile file = read_claims(SLIPPROOF_SOURCE_DIR "/proofs/rear-drive/claims.toml");
  const VerifyResult result = verify(file, options(600 / sampled_less));
  for (const ClaimResult& claim : result.claims) {
    CAPTURE(file.claims[claim.claim].id);
    CHECK(as_expected(file, claim));
  }
  CHECK(result.find(file, "T1.2", Reading::printed)->proved);
}

TEST_CASE("equations, limits and identities that are false are refuted or not proved") {
  const auto equations = [](const char* text) { return [text](ClaimBody& b) { b.equations = {truth(text)}; }; };
  CHECK(judged("E4.12.1", [](ClaimBody&) {}).proved);
  CHECK(reason(judged("E4.12.1", equations("N2 = g*b + F*sigma*R"))) == Reason{"equation"});
  CHECK(judged("E4.12.1", equations("N2*N2 = 1")).verdict == Verdict::undecided);  // not linear
  CHECK(reason(judged("R3.3.1", [](ClaimBody& b) { b.holds = truth("b > b11"); })) == Reason{"limit"});
  CHECK(reason(judged("E4.10", [](ClaimBody& b) { b.holds = truth("F*sigma > f*N2_3"); })) == Reason::formula);
  const auto weaker = judged("E4.4", [](ClaimBody& b) { b.holds = truth("N2 > 0"); });
  CHECK(weaker.verdict == Verdict::holds);
  CHECK_FALSE(weaker.proved);
  CHECK(judged("R3.4", [](ClaimBody& b) { b.region = truth("b > b0"); }).verdict == Verdict::refuted);
}
