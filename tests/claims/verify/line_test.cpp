#include "mechanics/lines/line.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

#include "base/expression/parser.hpp"
#include "claims/mutation/claims_mutants.hpp"
#include "claims/paper/claim_kind.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/sampling/claim_parts.hpp"
#include "claims/sampling/sampler.hpp"
#include "claims/verify/verify.hpp"
#include "mechanics/lines/critical.hpp"
#include "report/papers/verify_report.hpp"
#include "support/crew_ranks.hpp"
#include "support/how_many.hpp"
#include "support/papers/shipped.hpp"

using namespace slipproof;

namespace {

/// A file with one formula without a mode in the setting of section 3.
ClaimsFile formula(const char* region, const char* holds) {
  ClaimsFile file = as_read(test::shipped_paper(), Reading::repaired);
  Claim claim;
  claim.id = "X";
  claim.setting = test::section_3(file);
  claim.printed.region = parse_expression(region, Sort::truth);
  claim.printed.kind = claim_kind("formula");
  claim.printed.holds = parse_expression(holds, Sort::truth);
  file.claims = {claim};
  return file;
}

Verdict verdict(const ClaimsFile& file, std::uint64_t lines) {
  VerifyOptions options;
  options.samples = 200;
  options.lines = lines;
  options.simplify = false;
  return verify(file, options).claims.front().verdict;
}

/// Section 3 with all parameters 1: in their order R h b M2 M3 f g sigma J.
const std::vector<Rational> ones(9, Rational(1));

LinePoints points(const ClaimsFile& file, const Line& line) {
  const CompiledClaims compiled(file);
  const std::size_t setting = file.claims[0].setting;
  return points_on(line, compiled.settings[setting], parts_of(file, compiled, 0, Reading::printed));
}

bool any_between(const std::vector<Rational>& values, const Rational& lower, const Rational& upper) {
  return std::any_of(values.begin(), values.end(), [&](const Rational& x) { return lower < x && x < upper; });
}

bool has(const std::vector<Rational>& values, const Rational& x) {
  return std::find(values.begin(), values.end(), x) != values.end();
}

/// A claim of a paper, judged at single bicycles.
struct OneClaim {
  const ClaimsFile& file;
  const CompiledClaims& compiled;
  std::size_t claim;
  Reading reading;

  std::size_t setting() const { return file.claims[claim].setting; }
  const CompiledSetting& symbols() const { return compiled.settings[setting()]; }

  std::pair<Outcome, Reason> judged(const std::vector<Rational>& values) const {
    if (!in_domain(symbols(), values)) return {};
    const auto sample = SolvedSample::make(symbols(), values);
    if (!sample) return {};
    const Judgement j = judge(file, compiled, claim, reading, *sample);
    return {j.outcome, j.reason};
  }

  /// Bicycles of which it speaks, if they are soon found.
  std::vector<std::vector<Rational>> bases() const {
    const Sampler sampler(symbols(), 5);
    std::vector<std::vector<Rational>> speaking, any;
    for (std::uint64_t i = 0; i < 60; ++i) {
      const auto values = sampler.at(i);
      if (i % 8 == 5) continue;  // extreme ones
      any.push_back(values);
      if (judged(values).first != Outcome::outside) speaking.push_back(values);
    }
    return speaking.empty() ? any : speaking;
  }

  /// Compares the judgements near both ends and inside of each cell with that of its point; the number of comparisons.
  int compare(const Line& line) const {
    const LinePoints found = points_on(line, symbols(), parts_of(file, compiled, claim, reading));
    const auto points = cell_points(found.roots, found.part);
    int compared = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto lower = i > 0 ? std::optional(found.roots[i - 1].upper) : found.part.lower;
      const auto upper = i < found.roots.size() ? std::optional(found.roots[i].lower) : found.part.upper;
      const Rational low = lower ? *lower : Rational(points[i] - 1000),
                     high = upper ? *upper : Rational(points[i] + 1000);
      const auto expected = judged(line.at(points[i]));
      for (const Rational& share : {Rational(1, 1000), Rational(3, 7), Rational(999, 1000)}) {
        CAPTURE(file.claims[claim].id);
        CAPTURE(i);
        CHECK((judged(line.at(low + (high - low) * share)) == expected));
        ++compared;
      }
    }
    return compared;
  }
};

}  // namespace

TEST_CASE("what no sample shows, a line does: thin windows, ends of domains, surfaces that no file lists") {
  for (const auto& [region, holds] :
       std::vector<std::pair<const char*, const char*>>{{"true", "not (-R < h and h < -0.99*R)"},
                                                        {"true", "not (J = 13/3)"},
                                                        {"J = 13/3", "false"},
                                                        {"66/7 < J and J < 66.001/7", "false"},
                                                        {"true", "not (7.0011/5 < b/R and b/R < 7.0012/5)"},
                                                        {"b > b1", "not (f/M2 = 311/977)"},
                                                        {"true", "not (g > 10^30)"},
                                                        {"true", "abs(b - 311/977*R) > 10^(-9)*R"},
                                                        {"true", "max(b, 311/977*R) != min(b, 311/977*R)"},
                                                        {"true", "F*(311*b - 977*R) != 0"}}) {
    CAPTURE(region);
    CAPTURE(holds);
    CHECK(verdict(formula(region, holds), 0) != Verdict::refuted);
    CHECK(verdict(formula(region, holds), 50) == Verdict::refuted);
  }
}

TEST_CASE("every window of a list has a point, every rational critical value is one, and every cell has one") {
  std::string holds = "true";
  for (int i = 1; i <= 30; ++i) {
    const std::string low = std::to_string(1000 * i + 7) + "/977", high = std::to_string(100000 * i + 701) + "/97700";
    holds += " and not (" + low + " < b/R and b/R < " + high + ")";
  }
  const ClaimsFile file = formula("true", holds.c_str());
  const std::vector<Line> lines{along_parameter(ones, 0), along_parameter(ones, 2),
                                through(ones, {3, 2, 1, 1, 1, 1, 1, 1, 2})};
  for (const Line& line : lines) {
    const LinePoints found = points(file, line);
    CHECK(found.cells() > 40);
    CHECK(found.irrational() == 0);
    CHECK(found.values.size() > 2 * found.cells() - 2);
    CHECK(std::is_sorted(found.values.begin(), found.values.end()));
    for (int i = 1; i <= 30; ++i) {
      const Rational low(1000 * i + 7, 977), high(100000 * i + 701, 97700);
      std::vector<Rational> ratios;
      for (const Rational& t : found.values) {
        const auto values = line.at(t);
        if (values[0] > 0 && values[2] > 0) ratios.push_back(values[2] / values[0]);
      }
      CHECK(any_between(ratios, low, high));
      CHECK(has(ratios, low));
      CHECK(has(ratios, high));
    }
  }
}

TEST_CASE("irrational critical values are told, and both sides have a point") {
  const ClaimsFile file = formula("b^2 < 2*R^2 or b^3 > 5*R^3", "true");
  const LinePoints found = points(file, along_parameter(ones, 2));
  CHECK(found.irrational() == 2);
  CHECK(any_between(found.values, 0, Rational(1414, 1000)));
  CHECK(any_between(found.values, Rational(1415, 1000), Rational(1709, 1000)));
  CHECK(any_between(found.values, Rational(1710, 1000), Rational(100)));
  CHECK(any_between(found.values, 0, Rational(1, 1'000'000)));
  CHECK(found.values.back() > 1'000'000);
}

TEST_CASE("the ends of force intervals: where two of them meet, the answer changes") {
  const ClaimsFile file = formula("true", "F < 2*b or F < b^2 or F > 3");
  const LinePoints found = points(file, along_parameter(ones, 2));
  for (const Rational& meeting : {Rational(3, 2), Rational(2)}) CHECK(has(found.values, meeting));
  CHECK(found.irrational() == 1);  // b^2 = 3
}

TEST_CASE("a mode's conditions along a line: the bounds of the assertions are among the critical values") {
  // All ones but b: b1 = 1/4 and b11 = 3.
  ClaimsFile file = as_read(test::shipped_paper(), Reading::repaired);
  file.claims = {file.claims[test::index_of(file, "A2.2")]};
  const LinePoints found = points(file, along_parameter(ones, 2));
  for (const Rational& b : {Rational(1, 4), Rational(3)}) CHECK(has(found.values, b));
}

TEST_CASE("in a cell the judgement is the same throughout: every claim of the shipped papers along some lines") {
  constexpr std::size_t every = test::quick(1, 8);
  int compared = 0;
  for (const char* folder : {"rozenblat-yashin", "rear-drive"}) {
    const ClaimsFile file = read_claims(test::shipped_folder.parent_path() / folder / "claims.toml");
    const CompiledClaims compiled(file);
    for (std::size_t c = 0; c < file.claims.size(); c += every) {
      if (file.claims[c].kind().is_linear()) continue;
      for (const Reading reading : all_readings) {
        if (reading == Reading::repaired && !file.claims[c].repaired) continue;
        const OneClaim claim{file, compiled, c, reading};
        const auto bases = claim.bases();
        const std::vector<bool> all(bases.front().size(), true);
        for (std::uint64_t k = 0; k < 1; ++k) compared += claim.compare(line_number(5 * c + k, 1, bases, all));
      }
    }
  }
  CHECK(compared * every > 500);  // a line need not meet every claim's region
}

TEST_CASE("lines: the same bytes at any number of threads and ranks, and numbers that are told") {
  const ClaimsFile& file = test::shipped_paper();
  VerifyOptions options;
  options.samples = 60;
  options.lines = 3;
  options.threads = 2;
  options.only = "A";
  options.simplify = false;
  const VerifyResult one = verify(file, options);
  Verification verification(file, options);
  test::by_crew(
      3, [&](std::string_view request) { return verification.answer(request); },
      [&](Crew& crew) { CHECK(verify_json(file, verification.result(&crew)) == verify_json(file, one)); });
  CHECK(one.lines == 3);
  const ClaimResult* r = one.find(file, "A1.1", Reading::printed);
  CHECK(r->lines == 3);
  CHECK(r->cells > 3);
  CHECK(VerifyOptions().line_count() == 50);
}
