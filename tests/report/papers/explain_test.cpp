// What is said of a claim that fails: whole sentences, with the quantity and both of its values.
#include "report/papers/explain.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "claims/reading/read_claims_file.hpp"
#include "report/papers/verify_report.hpp"
#include "support/papers/small_claims.hpp"

using namespace slipproof;

namespace {

struct Verified {
  explicit Verified(const test::SmallClaims& small) : file(parse_claims(small.text(), "small.toml")) {
    VerifyOptions options;
    options.samples = 100;
    result = verify(file, options);
  }
  std::string explanation() const { return explain(file, result.claims.front()); }
  std::string text() const { return text_of(verify_document(file, result)); }

  ClaimsFile file;
  VerifyResult result;
};

test::SmallClaims claim(const std::string& keys, const std::string& in_setting = "") {
  test::SmallClaims small;
  small.parameters = "b = { domain = \"b > 0\", meaning = \"b\" }\nf = { domain = \"f > 0\", meaning = \"f\" }\n";
  small.in_setting = in_setting;
  small.claims = "[[claim]]\nid = \"X\"\nline = 7\nstatement = \"s\"\n" + keys;
  return small;
}

}  // namespace

TEST_CASE("a formula that fails names its quantities and gives both values; the force only where it matters") {
  CHECK(Verified(claim("kind = \"formula\"\nholds = \"b = 2*b\"\n")).explanation() ==
        "b = 2 * b is false: b = 1 and the right side is 2");
  const std::string of_motion =
      Verified(claim("kind = \"formula\"\nmode = \"stick/stick\"\nholds = \"N2 = 0\"\n")).explanation();
  CHECK(of_motion.starts_with("N2 = 0 is false: N2 = "));
  CHECK(of_motion.find(", in stick/stick, at F = ") != std::string::npos);
  // Only the operands that are false.
  CHECK(Verified(claim("kind = \"formula\"\nholds = \"b > 0 and (b < 0 or f < 0)\"\n")).explanation() ==
        "b < 0 is false: b = 1; f < 0 is false: f = 1");
}

TEST_CASE("an equation that does not follow is named") {
  CHECK(Verified(claim("kind = \"consequence\"\nequations = [\"N2 + N3 = 1\", \"N2 = 7\"]\n")).explanation() ==
        "N2 = 7 does not follow from the equations of motion");
}

TEST_CASE("an interval tells what is claimed and what is so") {
  const std::string text =
      Verified(claim("kind = \"interval\"\nmode = \"stick/stick\"\nforces = \"false\"\n")).explanation();
  CHECK(text.starts_with("the claim has motions in stick/stick for no F; in fact there are such motions for F in ("));
}

TEST_CASE("a mechanism without a load has no load in what is said") {
  const ClaimsFile kerb = read_claims(SLIPPROOF_SOURCE_DIR "/proofs/kerb/claims.toml");
  VerifyOptions options;
  options.samples = 60;
  const VerifyResult result = verify(kerb, options);
  std::size_t refuted = 0;
  for (const ClaimResult& claim : result.claims) {
    if (claim.verdict != Verdict::refuted || !kerb.settings[kerb.claims[claim.claim].setting].force.symbol.empty())
      continue;
    ++refuted;
    CHECK(explain(kerb, claim) == "there is a motion in stick/stick, and the claim says that there is none");
    for (const auto& [symbol, value] : place_of(kerb, claim, *claim.counterexample)) CHECK_FALSE(symbol.empty());
  }
  CHECK(refuted == 2);
}

TEST_CASE("where there is no motion that is said, and why, in place of an empty list") {
  // Without J no motion with a wheel off the road is modelled; at large forces there is none on it.
  const Verified none(claim("kind = \"interval\"\nmode = \"slip+/slip+\"\nforces = \"F > 1000*(1 + b)*(1 + f)\"\n"));
  REQUIRE(none.result.claims.front().verdict == Verdict::refuted);
  REQUIRE(none.result.claims.front().counterexample->motions);
  REQUIRE(none.result.claims.front().counterexample->motions->motions.empty());
  CHECK(none.text().find("the motions there:") == std::string::npos);
  CHECK(none.text().find("without J no other is modelled") != std::string::npos);
  // A formula about parameters has no use for motions, nor for a force.
  const std::string formula = Verified(claim("kind = \"formula\"\nholds = \"b < 0\"\n")).text();
  CHECK(formula.find("motion") == std::string::npos);
  CHECK(formula.find("F = ") == std::string::npos);
}

TEST_CASE("an undecided claim says at how many bicycles it has no value, or that none was found") {
  CHECK(Verified(claim("kind = \"formula\"\nholds = \"b/(f - f) = 1\"\n")).text().find("it has no value at ") !=
        std::string::npos);
}

TEST_CASE("how many of the bicycles met the region of a claim is told") {
  const Verified some(claim("kind = \"formula\"\nregion = \"b < 1\"\nholds = \"b < f + 1\"\n"));
  const ClaimResult& r = some.result.claims.front();
  CHECK(r.tried > r.samples());
  CHECK(some.text().find(std::to_string(r.samples()) + "  ") != std::string::npos);
  const auto json = nlohmann::json::parse(verify_json(some.file, some.result));
  CHECK(json["claims"][0]["tried"] == r.tried);
  CHECK(json["claims"][0]["samples"] == r.samples());
}

TEST_CASE("a run that judged nothing is not called verified") {
  const Verified some(claim("kind = \"formula\"\nholds = \"b > 0\"\n"));
  CHECK(summary(some.file, VerifyResult{}) == Summary::undecided);
  CHECK(text_of(verify_document(some.file, VerifyResult{})).ends_with("\ns UNDECIDED no claim was judged\n"));
}

TEST_CASE("the simplest counterexample that can be built comes first, a much simpler one second") {
  const std::string wrong = "kind = \"formula\"\nholds = \"b < 0\"\n";
  const auto with = [&](const std::string& realisable) {
    return Verified(claim(wrong, "realisable = { " + realisable + " }\n"));
  };
  const Verified unsaid(claim(wrong));
  CHECK(unsaid.result.claims.front().counterexample->unrealisable.empty());
  CHECK(realisability(unsaid.file, unsaid.result.claims.front()).empty());

  const Verified near = with("apart = \"b > 1\"");
  const ClaimResult& second = near.result.claims.front();
  REQUIRE(second.counterexample);
  CHECK(second.counterexample->values[0] == 2);
  CHECK(second.counterexample->minimal);
  CHECK(second.counterexample->unrealisable.empty());
  REQUIRE(second.simplest);  // 1 is half of 2
  CHECK(second.simplest->values[0] == 1);
  CHECK(second.simplest->unrealisable == std::vector<std::string>{"apart"});
  CHECK(realisability(near.file, second) == "this bicycle can be built");
  CHECK(near.text().find("simpler, but it cannot be built, for it breaks apart (b > 1):") != std::string::npos);
  const auto json = nlohmann::json::parse(verify_json(near.file, near.result))["claims"][0];
  CHECK(json["counterexample"]["realisable"] == true);
  CHECK(json["simplest"]["realisable"] == false);
  CHECK(json["simplest"]["unrealisable"] == nlohmann::json{"apart"});

  const Verified never = with("apart = \"b < 0\", wide = \"b > 0\"");
  const ClaimResult& none = never.result.claims.front();
  CHECK(none.counterexample->values[0] == 1);
  CHECK_FALSE(none.simplest);
  CHECK(none.counterexample->unrealisable == std::vector<std::string>{"apart"});
  CHECK(realisability(never.file, none).find("it breaks apart (b < 0); none that can was found") != std::string::npos);
  CHECK(never.text().find("cannot be built") != std::string::npos);
}

TEST_CASE("sentences begin with a capital where they begin with a word") {
  CHECK(sentence("there is none") == "There is none.");
  CHECK(sentence("proved: there is none.") == "Proved: there is none.");
  CHECK(sentence("xi1 = F0 is false") == "xi1 = F0 is false.");
  CHECK(sentence("eta != 0 is false") == "eta != 0 is false.");
  CHECK(sentence("a = 0") == "a = 0.");
  CHECK(sentence("").empty());
}
