// True claims of the shipped papers, each made false in a thin window of one parameter or ratio, or on one surface:
// does `verify` notice? SLIPPROOF_PLANTED=200 plants so many of each kind; tests/CMakeLists.txt gives the soak test
// that.
#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <random>

#include "base/expression/parser.hpp"
#include "base/number/format.hpp"
#include "claims/mutation/claims_mutants.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/sampling/sampler.hpp"
#include "claims/verify/verify.hpp"
#include "support/how_many.hpp"
#include "support/papers/shipped.hpp"

using namespace slipproof;

namespace {

/// A window of this relative width; 0: a surface.
struct Kind {
  const char* name;
  Rational width;
};

/// A file with one claim, which is false at one bicycle at least.
struct Planted {
  ClaimsFile file;
  std::string text;
};

class Gardener {
 public:
  explicit Gardener(std::uint64_t seed) : engine_(seed) {
    for (const char* folder : {"rozenblat-yashin", "rear-drive"}) {
      const std::filesystem::path path = test::shipped_folder.parent_path() / folder / "claims.toml";
      const ClaimsFile& paper = papers_.emplace_back(as_read(read_claims(path), Reading::repaired));
      for (const Claim& claim : paper.claims) {
        const std::string_view kind = claim.kind().name();
        const bool plantable = kind == "formula" || kind == "interval" || kind == "equivalence";
        if (plantable) choice_.push_back(alone(paper, claim));
      }
    }
  }

  Planted plant(const Rational& width) {
    for (;;) {
      const ClaimsFile& file = choice_[die(choice_.size())];
      if (auto planted = plant(file, width)) return *planted;
    }
  }

 private:
  std::size_t die(std::size_t sides) { return static_cast<std::size_t>(engine_() % sides); }

  static ClaimsFile alone(const ClaimsFile& paper, const Claim& claim) {
    ClaimsFile file = paper;
    file.settings = {paper.settings[claim.setting]};
    file.claims = {claim};
    file.claims[0].setting = 0;
    return file;
  }

  /// In some bicycle of a sampler of another seed, one parameter moved to where no sampler goes.
  std::optional<Planted> plant(const ClaimsFile& file, const Rational& width) {
    const CompiledClaims compiled(file);
    std::vector<Rational> values = Sampler(compiled.settings[0], 77).at(die(100'000));
    if (values.empty()) return std::nullopt;
    const std::size_t p = die(values.size()), q = die(values.size());
    values[p] *= Rational(static_cast<int>(900 + die(220)), 1009);
    if (values[p].is_zero() || values[q].is_zero() || !in_domain(compiled.settings[0], values)) return std::nullopt;
    const auto symbol = [&](std::size_t k) { return file.settings[0].parameters[k].symbol; };
    const Rational value = p == q ? values[p] : Rational(values[p] / values[q]);
    const std::string what = p == q ? symbol(p) : symbol(p) + "/" + symbol(q);
    Planted planted{file, "not (" + bounds(what, value, width) + ")"};
    const Expression outside = parse_expression(planted.text, Sort::truth);
    ClaimBody& body = planted.file.claims[0].printed;
    Expression& where = file.claims[0].kind().name() == "interval" ? body.forces : body.holds;
    where = make(Operation::logical_and, {where, outside});
    planted.text = file.claims[0].id + ": " + planted.text;
    // It has to be true without, and false here.
    if (judged(file, values) != Outcome::holds || judged(planted.file, values) != Outcome::refuted) return std::nullopt;
    return planted;
  }

  std::string bounds(const std::string& what, const Rational& value, const Rational& width) {
    const auto text = [](const Rational& x) { return x.str(); };
    if (width.is_zero()) return what + " = " + text(value);
    const Rational low = value * (1 - width * Rational(static_cast<int>(1 + die(998)), 1000)), high = low * (1 + width);
    return text(low < high ? low : high) + " < " + what + " and " + what + " < " + text(low < high ? high : low);
  }

  static Outcome judged(const ClaimsFile& file, const std::vector<Rational>& values) {
    const CompiledClaims compiled(file);
    const auto sample = SolvedSample::make(compiled.settings[0], values);
    return sample ? judge(file, compiled, 0, Reading::printed, *sample).outcome : Outcome::outside;
  }

  std::mt19937_64 engine_;
  std::vector<ClaimsFile> papers_, choice_;
};

bool noticed(const ClaimsFile& file, std::uint64_t samples, std::uint64_t lines) {
  VerifyOptions options;
  options.samples = samples;
  options.lines = lines;
  options.simplify = false;
  return verify(file, options).claims.front().verdict == Verdict::refuted;
}

}  // namespace

TEST_CASE("planted errors: in thin windows of a parameter or ratio, and on surfaces that no file lists") {
  const int count = test::how_many("SLIPPROOF_PLANTED", test::quick(2, 1));
  const bool asked = std::getenv("SLIPPROOF_PLANTED") != nullptr;
  const std::uint64_t samples = test::how_many("SLIPPROOF_PLANTED_SAMPLES", asked ? VerifyOptions().samples : 300);
  const std::array<Kind, 4> kinds{{{"1 %", Rational(1, 100)},
                                   {"0.1 %", Rational(1, 1000)},
                                   {"0.01 %", Rational(1, 10'000)},
                                   {"surface", Rational(0)}}};
  for (const auto& [name, width] : kinds) {
    Gardener gardener(static_cast<std::uint64_t>(denominator(width).to_long()));
    int without = 0, with = 0;
    for (int i = 0; i < count; ++i) {
      const Planted planted = gardener.plant(width);
      const bool at_samples = noticed(planted.file, samples, 0);  // and then with lines, too
      without += at_samples ? 1 : 0;
      const bool found = at_samples || noticed(planted.file, samples, VerifyOptions().line_count());
      with += found ? 1 : 0;
      if (!found) std::printf("missed: %s\n", planted.text.c_str());
    }
    std::printf("planted %s: %d, found by samples alone %d, with lines %d\n", name, count, without, with);
    std::fflush(stdout);
    CHECK(with * 100 >= count * 97);
  }
}
