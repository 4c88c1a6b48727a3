// Every small change of a claims file is noticed, or shown to say the same.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "claims/mutation/mutation.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/sampling/sampler.hpp"
#include "proofs/check/files.hpp"
#include "support/how_many.hpp"
#include "support/papers/shipped.hpp"
#include "support/papers/small_claims.hpp"
#include "support/run_program.hpp"

using namespace slipproof;

namespace {

constexpr std::uint64_t quick_share = test::quick(400, 4'000), quick_samples = test::quick(400, 80);

MutationOptions some_of(std::uint64_t share) {
  MutationOptions options;
  options.samples = quick_samples;
  options.every = test::how_many("SLIPPROOF_MUTANTS_EVERY", share);
  return options;
}

std::string describe(const MutantResult& m) {
  return m.mutant.where + ": " + m.mutant.mutant.description;
}

/// Independent of the engine: the whole file with the change, compiled and solved again.
Outcome again(const MutationResult& result, const MutantResult& m, bool changed) {
  const ClaimsFile file = changed ? m.mutant.apply(result.file) : result.file;
  const CompiledClaims compiled(file);
  const auto sample = SolvedSample::make(compiled.settings[m.mutant.setting], m.sample);
  REQUIRE(sample);
  return judge(file, compiled, m.claim, Reading::printed, *sample).outcome;
}

void check_all(const MutationResult& result) {
  std::size_t index = 0;
  for (const MutantResult& m : result.mutants) {
    CAPTURE(describe(m));
    CHECK(m.end != MutantEnd::survivor);
    if (m.end == MutantEnd::survivor || index++ % 5 != 0) continue;
    if (m.end == MutantEnd::refuted || m.end == MutantEnd::no_value) {
      CHECK(again(result, m, true) == (m.end == MutantEnd::refuted ? Outcome::refuted : Outcome::undecided));
      const Outcome before = again(result, m, false);
      CHECK((before == Outcome::holds || before == Outcome::outside));
    } else if (m.end == MutantEnd::reach) {
      CHECK(m.force);
      CHECK(again(result, m, true) != Outcome::refuted);
    } else {
      CHECK_FALSE(m.argument.empty());
    }
  }
}

/// Every lemma is accepted by the checker, which shares no code with what found it.
std::size_t check_lemmas(const MutationResult& result) {
  const test::TemporaryFolder folder;
  std::set<std::string> seen;
  for (const MutantResult& m : result.mutants) {
    for (const Lemma& lemma : m.lemmas) {
      if (!seen.insert(lemma.statement).second) continue;
      const std::filesystem::path path = folder.path() / std::to_string(seen.size());
      std::ofstream(path.string() + ".statement") << lemma.statement;
      std::ofstream(path.string() + ".cert") << lemma.certificate;
      CAPTURE(describe(m));
      CHECK(check::check_file(path.string() + ".cert").message == "");
    }
  }
  return seen.size();
}

std::string with_claim(const std::string& holds, const std::string& kind = "formula") {
  return test::SmallClaims{.parameters = R"(b = { domain = "b > 0", meaning = "m" }
f = { domain = "f > 0", meaning = "m" }
)",
                           .force = "P",
                           .claims = R"([[claim]]
id = "C"
line = 1
statement = "c"
kind = ")" + kind + "\"\n" + holds + "\n"}
      .text();
}

std::map<std::string, MutantEnd> ends(const std::string& claim, const std::string& kind = "formula") {
  std::map<std::string, MutantEnd> result;
  const MutationResult judged = judge_mutants(parse_claims(with_claim(claim, kind), "t.toml"));
  for (const MutantResult& m : judged.mutants) result.emplace(to_string(m.mutant.mutant.expression), m.end);
  return result;
}

}  // namespace

TEST_CASE("mutants of the shipped paper and of the other one: none survives, every argument is checked") {
  const MutationResult paper = judge_mutants(test::shipped_paper(), some_of(quick_share));
  check_all(paper);
  CHECK(paper.vacuous.empty());
  const ClaimsFile other = read_claims(SLIPPROOF_SOURCE_DIR "/proofs/rear-drive/claims.toml");
  const MutationResult rear_drive = judge_mutants(other, some_of(quick_share / 20));
  check_all(rear_drive);
  CHECK(rear_drive.not_mutated.empty());
  const auto lemmas = check_lemmas(paper) + check_lemmas(rear_drive);
  if (quick_share < 1'000) CHECK(lemmas >= 5);  // few mutants may need none
  MESSAGE(paper.mutants.size() << " and " << rear_drive.mutants.size() << " mutants");
}

TEST_CASE("how mutants end") {
  const auto mutants = ends("mode = \"stick/stick\"\nholds = \"a > 0\"");
  CHECK(mutants.at("a < 0") == MutantEnd::refuted);
  CHECK(mutants.at("a > 1") == MutantEnd::refuted);
  CHECK(mutants.at("a > -1") == MutantEnd::theorem);
  CHECK(mutants.at("a >= 0") == MutantEnd::theorem);
  CHECK(mutants.at("2 * a > 0") == MutantEnd::equivalent);
  CHECK(mutants.at("b > 0") == MutantEnd::vacuous);
  CHECK(mutants.at("N2 > 0") == MutantEnd::theorem);
  const auto regions = ends("region = \"1/b < 2\"\nholds = \"b > 1/2\"");
  CHECK(regions.at("1 / b < 1") == MutantEnd::reach);
  CHECK(regions.at("1 / b <= 2") == MutantEnd::refuted);
  CHECK(regions.at("1 / (2 * b) < 2") == MutantEnd::refuted);
  CHECK(ends("mode = \"stick/stick\"\nregion = \"b > 0\"\nholds = \"a > 0\"").at("b >= 0") == MutantEnd::equivalent);
}

TEST_CASE("what no sample meets, a line does") {
  const ClaimsFile file = parse_claims(with_claim("holds = \"b != 1234567/1000 or f > 0\""), "t.toml");
  const auto end_with = [&](std::uint64_t lines) {
    MutationOptions options;
    options.more_samples = 0;
    options.lines = lines;
    for (const MutantResult& m : judge_mutants(file, options).mutants) {
      if (to_string(m.mutant.mutant.expression) == "b != 1234567 / 1000 or f < 0") return m;
    }
    return MutantResult{};
  };
  CHECK(end_with(0).end == MutantEnd::survivor);
  const MutantResult found = end_with(64);
  REQUIRE(found.end == MutantEnd::refuted);
  CHECK(found.sample.front() == Rational(1234567, 1000));
}

TEST_CASE("what one of several motions has to obey is no condition") {
  ClaimsFile brake = read_claims(SLIPPROOF_SOURCE_DIR "/proofs/short-shoe-brake/claims.toml");
  std::erase_if(brake.claims, [](const Claim& claim) { return claim.id != "U9"; });
  REQUIRE(brake.claims.size() == 1);
  MutationOptions options;
  options.samples = 200;
  options.more_samples = 0;
  options.lines = 0;
  const MutationResult judged = judge_mutants(brake, options);
  const auto dropped = std::find_if(judged.mutants.begin(), judged.mutants.end(), [](const MutantResult& m) {
    return m.mutant.mutant.description == "F = 0 dropped";
  });
  REQUIRE(dropped != judged.mutants.end());
  CHECK(dropped->end == MutantEnd::equivalent);  // a shoe that rubs at mu c = b bears no force
}

TEST_CASE("a limit's mutant is settled by leading coefficients") {
  const auto mutants = ends("parameter = \"f\"\nholds = \"b < f\"", "limit");
  CHECK(mutants.at("b <= f") == MutantEnd::theorem);
  CHECK(mutants.at("b < 2 * f") == MutantEnd::theorem);
  CHECK(mutants.at("b > f") == MutantEnd::refuted);
}

TEST_CASE("a claim that says nothing is reported") {
  const auto file = parse_claims(with_claim("mode = \"stick/stick\"\nholds = \"b + f > 0\""), "t.toml");
  CHECK(judge_mutants(file).vacuous == std::vector<std::size_t>{0});
}

TEST_CASE("the number of threads makes no difference") {
  const ClaimsFile file = read_claims(SLIPPROOF_SOURCE_DIR "/proofs/rear-drive/claims.toml");
  MutationOptions options = some_of(120);
  options.every = 120;
  options.samples = 40;
  options.threads = 1;
  const MutationResult one = judge_mutants(file, options);
  options.threads = 2;
  const MutationResult two = judge_mutants(file, options);
  REQUIRE(one.mutants.size() == two.mutants.size());
  for (std::size_t i = 0; i < one.mutants.size(); ++i) {
    CHECK(one.mutants[i].end == two.mutants[i].end);
    CHECK(one.mutants[i].sample == two.mutants[i].sample);
    CHECK(one.mutants[i].argument == two.mutants[i].argument);
  }
}
