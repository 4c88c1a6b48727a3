// Claims about mechanisms other than the bicycle, and the bicycle as one of them.
#include <doctest/doctest.h>

#include <string>

#include "base/algebra/real_roots.hpp"
#include "base/input/diagnostic.hpp"
#include "claims/judge/judge.hpp"
#include "claims/mutation/mutation.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/sampling/claim_parts.hpp"
#include "claims/sampling/sampler.hpp"
#include "claims/statements/claim_statements.hpp"
#include "claims/verify/verify.hpp"
#include "mechanics/lines/critical.hpp"
#include "mechanics/reading/shipped.hpp"
#include "report/papers/explain.hpp"
#include "report/papers/verify_report.hpp"
#include "support/papers/shipped.hpp"
#include "support/replaced.hpp"

using namespace slipproof;
using slipproof::test::replaced;

namespace {

/// A block on an incline with one coefficient: textbook sentences, two of them wrong.
const std::string incline = R"(
schema = "slipproof/claims/1"
paper = { title = "A block on an incline", authors = ["A. Newcomer"], source = "block.txt" }

[[setting]]
id = "rest"
mechanism = "block-on-incline"
motions = "closed"
boundaries = ["mu = s/c", "b = h*s/c", "b = mu*h"]
force = { symbol = "P", domain = "P = 0" }
scene = { mu_s = "mu", mu_k = "mu", F = "P" }
[setting.parameters]
m = { domain = "m > 0", meaning = "mass" }
b = { domain = "b > 0", meaning = "half of the base" }
h = { domain = "h > 0", meaning = "height of the centre" }
I = { domain = "I > 0", meaning = "inertia" }
mu = { domain = "mu >= 0", meaning = "friction" }
g = { domain = "g > 0", meaning = "gravity" }
[setting.angles]
theta = { cos = "c", sin = "s", domain = "c > 0 and s >= 0", meaning = "slope" }
)";

std::string claim(const std::string& id, const std::string& says) {
  return "[[claim]]\nid = \"" + id + "\"\nline = 1\nstatement = \"x\"\n" + says + "\n";
}

ClaimsFile block(const std::string& says) {
  return parse_claims(incline + claim("X", says), "block.toml");
}

ClaimResult result_of(const ClaimsFile& file, std::uint64_t samples = 300) {
  VerifyOptions options;
  options.samples = samples;
  return verify(file, options).claims.front();
}

Verdict verdict(const std::string& says) {
  return result_of(block(says)).verdict;
}

}  // namespace

TEST_CASE("a block rests, slides or tips: claims about a statically indeterminate body on a slope") {
  CHECK(verdict("kind = \"motions\"\nregion = \"s <= mu*c and s*h <= b*c\"\nmodes = [\"stick/stick\"]") ==
        Verdict::holds);
  CHECK(verdict("kind = \"motions\"\nregion = \"s > mu*c and mu*h < b\"\nmodes = [\"slip+/slip+\"]") == Verdict::holds);
  CHECK(
      verdict("kind = \"formula\"\nregion = \"s > mu*c and mu*h <= b\"\nmode = \"slip+/slip+\"\nholds = \"ax = g*(s - "
              "mu*c) and phi = 0\"") == Verdict::holds);
  CHECK(verdict("kind = \"impossible\"\nregion = \"mu < 1\"\nmodes = [\"lift/*\"]") == Verdict::refuted);
  CHECK(
      verdict("kind = \"interval\"\nregion = \"b*c < h*s and b < mu*h\"\nmode = \"lift/stick\"\nforces = \"P = 0\"") ==
      Verdict::refuted);
}

TEST_CASE("an identity in an angle of the paper's own is proved, where its half tangent has a value") {
  std::string own = replaced(incline, "F = \"P\"", "F = \"P\", theta = { cos = \"c\", sin = \"s\" }");
  own = replaced(own, "theta = { cos = \"c\", sin = \"s\", domain", "alpha = { cos = \"c\", sin = \"s\", domain");
  own += "turn = { cos = \"u\", sin = \"v\" }\n";
  const auto result = [&](const std::string& says) {
    return result_of(parse_claims(own + claim("X", says), "block.toml"), 100);
  };
  const ClaimResult slides = result(
      "kind = \"formula\"\nregion = \"s > mu*c and mu*h <= b\"\nmode = \"slip+/slip+\"\n"
      "holds = \"ax = g*(s - mu*c) and phi = 0\"");
  CHECK(slides.failure.empty());
  CHECK(slides.verdict == Verdict::holds);
  CHECK(slides.held > 0);
  // An angle of 180 degrees has no half tangent, and 1 + u is 0 there: no sample shows it.
  const ClaimResult turned = result("kind = \"formula\"\nholds = \"v/(1 + u) = v/(1 + u)\"");
  CHECK(turned.failure.empty());
  CHECK(turned.verdict == Verdict::holds);
  CHECK_FALSE(turned.proved);
  REQUIRE(turned.unless_zero.size() == 1);
  CHECK(turned.unless_zero.front() == "u + 1");
  CHECK(result("kind = \"formula\"\nholds = \"s/c = s/c and 1/(1 + c) = (1 - c)/(1 - c^2) or s = 0\"").failure.empty());
  CHECK(result("kind = \"formula\"\nholds = \"s/(1 + c) = s/(1 + c)\"").proved);
}

TEST_CASE("what goes wrong in one claim is undecided, with the reason, and no other claim's") {
  // The proof that there is no such bicycle would multiply out more terms than a statement may have.
  const std::string large = "kind = \"formula\"\nregion = \"(m + b + h + I + mu + g)^30 < 0\"\nholds = \"m > 0\"";
  const ClaimsFile file =
      parse_claims(incline + claim("X", large) + claim("Y", "kind = \"formula\"\nholds = \"m > 0\""), "block.toml");
  VerifyOptions options;
  options.samples = 30;
  options.lines = 0;
  const VerifyResult result = verify(file, options);
  CHECK(result.claims[0].verdict == Verdict::undecided);
  CHECK(result.claims[0].failure.find("more than 200000 terms") != std::string::npos);
  CHECK(explain(file, result.claims[0]) == "judging it failed: " + result.claims[0].failure);
  CHECK(result.claims[1].verdict == Verdict::holds);
  MutationOptions mutation;
  mutation.samples = 20;
  mutation.more_samples = 0;
  mutation.lines = 0;
  mutation.every = 7;
  CHECK(judge_mutants(file, mutation).not_mutated == std::vector<std::size_t>{0});
}

TEST_CASE("a comparison with irrational zeros over the forces is not called one without a value") {
  const std::string free = replaced(incline, "P = 0", "P >= 0");
  const ClaimsFile file =
      parse_claims(free + claim("X", "kind = \"formula\"\nforces = \"P^2 < 2\"\nholds = \"P < 3/2\"") +
                       claim("Y", "kind = \"formula\"\nforces = \"1/(P - 1) < 2\"\nholds = \"P < 3/2 or P > 1\""),
                   "block.toml");
  VerifyOptions options;
  options.samples = 30;
  const VerifyResult result = verify(file, options);
  CHECK(result.claims[0].verdict == Verdict::undecided);
  CHECK(explain(file, result.claims[0]).starts_with("it was not decided at any of "));
  CHECK(result.claims[1].verdict == Verdict::undecided);
  CHECK(explain(file, result.claims[1]).starts_with("it has no value at any of "));
}

TEST_CASE("a formula about undetermined forces has to hold for all of them") {
  const std::string at_rest =
      "kind = \"formula\"\nregion = \"s <= mu*c and s*h <= b*c\"\nmode = \"stick/stick\"\nholds = ";
  CHECK(verdict(at_rest + "\"N_upper + N_lower = m*g*c\"") == Verdict::holds);
  CHECK(verdict(at_rest + "\"S_upper + S_lower = -m*g*s and ax = 0\"") == Verdict::holds);
  CHECK(verdict(at_rest + "\"ax^2 + N_upper*0 >= 0\"") == Verdict::holds);
  CHECK(verdict(at_rest + "\"N_lower >= m*g*c/2\"") == Verdict::holds);  // the lower edge carries more
  // Normal forces follow from the moments; how friction is shared does not.
  CHECK(verdict(at_rest + "\"2*b*N_lower = m*g*(b*c + h*s)\"") == Verdict::holds);
  CHECK(verdict(at_rest + "\"S_upper = S_lower\"") == Verdict::refuted);
}

TEST_CASE("a claim whose statement would have more variables than one may have is given up") {
  const ClaimsFile few = block("kind = \"motions\"\nmodes = [\"*/stick\"]"),
                   many = block("kind = \"motions\"\nmodes = [\"*/stick\", \"*/slip+\", \"*/slip-\"]");
  CHECK_FALSE(claim_statements(few, few.claims.front(), Reading::printed).empty());
  CHECK(claim_statements(many, many.claims.front(), Reading::printed).empty());
}

TEST_CASE("a counterexample is a scene that reads back, with the motions that there are") {
  const ClaimsFile file = block("kind = \"impossible\"\nregion = \"mu < 1\"\nmodes = [\"lift/*\"]");
  const ClaimResult result = result_of(file);
  REQUIRE(result.counterexample);
  const Counterexample& example = *result.counterexample;
  const MechanismScene scene = parse_scene(scene_text(file.settings[0], example), "scene.toml");
  CHECK(scene.values.parameters == example.scene.values.parameters);
  CHECK(scene.load == example.scene.load);
  const MotionsAtLoad motions = motions_of(friction_problem(scene.mechanism, scene.values), scene.load);
  REQUIRE(example.motions);
  REQUIRE(motions.motions.size() == example.motions->motions.size());
  bool tips = false;
  for (const MotionAtLoad& motion : motions.motions) {
    for (const auto* modes : {&motion.modes, &motion.boundary_modes}) {
      for (const MechanismMode& mode : *modes) tips = tips || mode.front() == ElementState::lift;
    }
  }
  CHECK(tips);
  const auto place = place_of(file, result, example);
  const auto value = [&](const std::string& symbol) {
    return std::find_if(place.begin(), place.end(), [&](const auto& entry) { return entry.first == symbol; })->second;
  };
  CHECK(value("c") * value("c") + value("s") * value("s") == 1);
  CHECK(value("mu") < 1);
  CHECK(text_of(verify_document(file, {300, 1, 1, {result}})).find("points for each setting") != std::string::npos);
}

TEST_CASE("a mechanism without a load is judged where it is") {
  const std::string rod = R"(
schema = "slipproof/claims/1"
paper = { title = "A rod", authors = ["A. Newcomer"], source = "rod.txt" }
[[setting]]
id = "rod"
mechanism = "painleve-rod"
motions = "closed"
[setting.parameters]
)";
  const Mechanism mechanism = open_mechanism("painleve-rod");
  std::string text = rod;
  for (const MechanismParameter& p : mechanism.parameters) {
    text += p.symbol + " = { domain = \"" + (p.domain ? to_string(p.domain.expression) : "true") +
            "\", meaning = \"x\" }\n";
  }
  if (!mechanism.angles.empty()) text += "[setting.angles]\n";
  for (const MechanismAngle& a : mechanism.angles) {
    text += a.name + " = { cos = \"" + a.cosine + "\", sin = \"" + a.sine + "\", domain = \"" +
            to_string(a.domain.expression) + "\" }\n";
  }
  text += claim("both", "kind = \"exists\"\nmodes = [\"slip+\", \"lift\"]") +
          claim("one", "kind = \"motions\"\nregion = \"mu*s < c\"\nmodes = [\"*\"]");
  VerifyOptions options;
  options.samples = 200;
  const ClaimsFile file = parse_claims(text, "rod.toml");
  const VerifyResult result = verify(file, options);
  CHECK(result.claims[0].verdict == Verdict::holds);
  CHECK(result.claims[1].verdict == Verdict::refuted);
}

TEST_CASE("along lines of a mechanism the judgement changes at critical values only") {
  const ClaimsFile data = as_read(test::shipped_paper(), Reading::repaired);
  ClaimsFile file = block("kind = \"motions\"\nregion = \"s > mu*c\"\nmodes = [\"slip+/slip+\", \"lift/slip+\"]");
  int compared = 0;
  const auto compare = [&](const ClaimsFile& claims, std::size_t index, const Line& line) {
    const CompiledClaims compiled(claims);
    const CompiledSetting& setting = compiled.settings[claims.claims[index].setting];
    const auto outcome = [&](const Rational& t) {
      const auto values = line.at(t);
      const auto sample = in_domain(setting, values) ? SolvedSample::make(setting, values) : nullptr;
      return sample ? judge(claims, compiled, index, Reading::printed, *sample).outcome : Outcome::outside;
    };
    const LinePoints found = points_on(line, setting, parts_of(claims, compiled, index, Reading::printed));
    const auto points = cell_points(found.roots, found.part);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const auto low = i > 0 ? std::optional(found.roots[i - 1].upper) : found.part.lower;
      if (!low) continue;
      const Rational &high = found.roots[i].lower, expected_at = points[i];
      for (const Rational& share : {Rational(1, 1000), Rational(3, 7), Rational(999, 1000)}) {
        CAPTURE(claims.claims[index].id);
        CHECK(outcome(*low + (high - *low) * share) == outcome(expected_at));
        ++compared;
      }
    }
  };
  // All parameters 1 and tan(theta/2) = 1/3: m b h I mu g theta.
  const std::vector<Rational> blocks{1, 1, 1, 1, 1, 1, Rational(1, 3)};
  for (std::size_t parameter = 0; parameter < blocks.size(); ++parameter) {
    compare(file, 0, along_parameter(blocks, parameter));
  }
  compare(file, 0, through(blocks, {2, 1, 3, 1, Rational(1, 2), 1, Rational(1, 2)}));
  const std::vector<Rational> ones(9, Rational(1));
  for (const char* id : {"A1.1", "A2.2", "A3.1", "A5.2"}) {
    for (const std::size_t parameter : {1U, 2U}) {
      compare(data, test::index_of(data, id), along_parameter(ones, parameter));
    }
  }
  CHECK(compared > 100);
}

TEST_CASE("statements say that a motion is one of those listed by its accelerations, whatever its forces") {
  // At rest the forces may exhaust friction at one contact or not: the same motion.
  const auto statements = [](const ClaimsFile& file) {
    std::string all;
    for (const NamedStatement& s : claim_statements(file, file.claims.front(), Reading::printed)) all += s.text;
    return all;
  };
  const ClaimsFile rests =
      block("kind = \"motions\"\nmodes = [\"stick/stick\"]\nregion = \"s <= mu*c and h*s <= b*c\"");
  CHECK(result_of(rests).verdict == Verdict::holds);
  CHECK(statements(rests).find("show {ax = ax_2 and ay = ay_2 and phi = phi_2}") != std::string::npos);
}

TEST_CASE("a uniqueness that allows every mode has no refutation, and the others of its file have theirs") {
  const ClaimsFile file = block("kind = \"unique\"\nclaims = []\nmodes = [\"*/*\"]\nexpect = \"refuted\"");
  CHECK(claim_refutation(file, file.claims.front(), Reading::printed).empty());
}

TEST_CASE("two claims may not have a statement of one name") {
  const std::string rests = "kind = \"motions\"\nmodes = [\"stick/stick\"]\nregion = \"s <= mu*c and h*s <= b*c\"";
  const ClaimsFile file =
      parse_claims(incline + claim("V", rests) + claim("V.1", "kind = \"formula\"\nholds = \"m > 0\""), "block.toml");
  StatementNames names(file);
  const auto add = [&](const Claim& one) { names.add(one, expected_statements(file, one, Reading::printed)); };
  add(file.claims[0]);
  CHECK_THROWS_WITH_AS(add(file.claims[1]),
                       "block.toml: the claims V and V.1 both have a statement V.1, expected ids whose statements have "
                       "names of their own",
                       InputError);
}

TEST_CASE("mutants of what two settings inherit are judged in their own setting") {
  const std::string second = R"(
[[setting]]
id = "wide"
inherits = "rest"
[setting.parameters]
b = { domain = "b = 2*h", meaning = "half of the base" }
)";
  const ClaimsFile file =
      parse_claims(incline + "[[setting.definition]]\nsymbol = \"k\"\nline = 1\nprinted = \"b/h\"\n" + second +
                       claim("X", "setting = \"rest\"\nkind = \"formula\"\nholds = \"k*h = b\"") +
                       claim("Y", "setting = \"wide\"\nkind = \"formula\"\nholds = \"k = 2\""),
                   "block.toml");
  MutationOptions options;
  options.samples = 40;
  options.threads = 1;
  CHECK(judge_mutants(file, options).mutants.size() > 4);
}

TEST_CASE("mistakes in a setting of a mechanism have their places") {
  const auto mistakes = [](std::string from, const std::string& to) {
    std::string text = incline + claim("X", "kind = \"motions\"\nmodes = [\"stick/stick\"]");
    if (const std::size_t at = text.find(from); at != text.npos) text.replace(at, from.size(), to);
    try {
      parse_claims(text, "block.toml");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const auto says = [&](const std::string& from, const std::string& to, const std::string& message) {
    const std::string found = mistakes(from, to);
    CAPTURE(found);
    CHECK(found.find(message) != std::string::npos);
  };
  says("", "", "none");
  says("mechanism = \"block-on-incline\"", "mechanism = \"block-on-inclin\"", "block.toml:7:13: mechanism: ");
  says("mechanism = \"block-on-incline\"", "",
       "missing kind in [setting.force], expected \"internal\" or \"external\"");
  says("symbol = \"P\"", "symbol = \"P\", kind = \"internal\"", "kind: found beside `mechanism`");
  says("mu_s = \"mu\"", "mu_s = \"mu\", nu = \"1\"", "unknown key 'nu'");
  says("theta = { cos", "phi = { cos", "found 'phi', which is a quantity of every motion");
  says("theta = { cos", "eta = { cos", "missing theta in [setting.scene], expected an angle");
  says("cos = \"c\"", "cos = \"g\"", "found the symbol 'g' a second time");
  says("scene = {", "state = { upper = \"slips\" }\nscene = {", "upper: found 'slips'");
  says("scene = {", "state = { uper = \"rest\" }\nscene = {",
       "unknown contact or friction element 'uper', did you mean 'upper'?");
  says("scene = {", "along = \"h\"\nscene = {", "along");
  says("[\"stick/stick\"]", "[\"stick\"]", "modes: found 'stick', expected 2 states joined by /");
  says("[\"stick/stick\"]", "[\"stick/touch\"]", "unknown state of lower 'touch'");
  says("F = \"P\"", "F = \"P\", theta = { tan_half = \"t\" }", "unknown symbol 't'");
  says("F = \"P\"", "F = \"P\", theta = { tan = \"1\" }", "unknown key 'tan'");
}
