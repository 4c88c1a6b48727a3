#include "claims/sampling/sampler.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <map>

#include "claims/reading/read_claims_file.hpp"
#include "support/papers/shipped.hpp"

using namespace slipproof;

TEST_CASE("samples are inside the domains, and depend on seed and index alone") {
  const ClaimsFile& file = test::shipped_paper();
  const CompiledClaims compiled(file);
  const CompiledSetting& setting = compiled.settings[test::section_3(file)];
  const Sampler one(setting, 5), same(setting, 5), other(setting, 6);
  int different = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const auto values = one.at(i);
    REQUIRE_FALSE(values.empty());
    CHECK(in_domain(setting, values));
    CHECK(values == same.at(i));
    different += values != other.at(i) ? 1 : 0;
  }
  CHECK(different > 450);
}

TEST_CASE("boundaries are hit exactly and from both sides, h has every sign, ratios are tiny and huge") {
  const ClaimsFile& file = test::shipped_paper();
  const std::size_t s = test::section_3(file);
  const CompiledClaims compiled(file);
  std::map<std::string, std::size_t> symbol;
  for (std::size_t k = 0; k < file.settings[s].parameters.size(); ++k)
    symbol[file.settings[s].parameters[k].symbol] = k;
  const Sampler sampler(compiled.settings[s], 1);
  std::map<std::string, std::array<int, 3>> around;  // just below, on, just above
  std::array<int, 3> sign_of_h{};
  int tiny = 0, huge = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const auto v = sampler.at(i);
    const auto at = [&](const char* name) { return v[symbol.at(name)]; };
    const Rational M1 = 1 + at("M2"), M0 = M1 + at("M3"), f = at("f"), h = at("h"), R = at("R"), b = at("b");
    const std::map<std::string, Rational> boundaries{{"b1", f * h / (2 * M1)},
                                                     {"b1 as printed", f * h * 2 * M1},
                                                     {"b11", f * (h + M1 * R)},
                                                     {"b0", f * (h + M0 * R)},
                                                     {"f h", f * h}};
    for (const auto& [name, value] : boundaries) {
      const Rational near = abs(value) / 8;
      if (b == value) ++around[name][1];
      if (b < value && b >= value - near) ++around[name][0];
      if (b > value && b <= value + near) ++around[name][2];
    }
    ++sign_of_h[static_cast<std::size_t>(sign(h) + 1)];
    for (const char* name : {"M2", "M3", "R", "J"}) {
      tiny += at(name) < Rational(Integer(1), Integer(1) << 20) ? 1 : 0;
      huge += at(name) > Rational(Integer(1) << 20) ? 1 : 0;
    }
  }
  CHECK(around.size() == 5);
  for (const auto& entry : around) {
    const std::string& name = entry.first;
    CAPTURE(name);
    for (const int count : entry.second) CHECK(count >= 20);
  }
  for (const int count : sign_of_h) CHECK(count >= 200);
  CHECK(tiny > 20);
  CHECK(huge > 20);
}

TEST_CASE("a parameter whose domain is one number is no hindrance to samples") {
  const ClaimsFile file = read_claims(std::filesystem::path(SLIPPROOF_SOURCE_DIR) / "proofs/rest-on-slope/claims.toml");
  const CompiledClaims compiled(file);
  int points = 0;
  for (std::size_t s = 0; s < file.settings.size(); ++s) {
    if (!file.settings[s].id.starts_with("point ")) continue;
    ++points;
    const Sampler sampler(compiled.settings[s], 1);
    int found = 0;
    for (std::uint64_t i = 0; i < 20; ++i) found += sampler.at(i).empty() ? 0 : 1;
    CHECK(found >= 15);  // integers do not meet 0 < k < 1
  }
  CHECK(points == 15);
}
