// The claims files that proofs/CLAIMS.md shows to newcomers, the very text of the page.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "claims/reading/read_claims_file.hpp"
#include "claims/verify/verify.hpp"
#include "support/run_program.hpp"

using namespace slipproof;

namespace {

/// The TOML between fences.
std::vector<std::string> examples() {
  const std::string page = test::read_file(SLIPPROOF_SOURCE_DIR "/proofs/CLAIMS.md"), fence = "```toml\n";
  std::vector<std::string> result;
  for (std::size_t at = page.find(fence); at != page.npos; at = page.find(fence, at)) {
    at += fence.size();
    result.push_back(page.substr(at, page.find("```", at) - at));
  }
  return result;
}

VerifyResult judged_file(const ClaimsFile& file) {
  VerifyOptions options;
  options.samples = 200;
  return verify(file, options);
}

}  // namespace

TEST_CASE("the first claims file of the page has 40 lines and says what the page says of it") {
  const auto texts = examples();
  REQUIRE(texts.size() == 2);
  CHECK(std::count(texts[0].begin(), texts[0].end(), '\n') <= 40);
  const ClaimsFile file = parse_claims(texts[0], "first.toml");
  const VerifyResult result = judged_file(file);
  REQUIRE(result.claims.size() == 2);
  CHECK(result.claims[0].verdict == Verdict::refuted);
  REQUIRE(result.claims[0].counterexample);
  CHECK(result.claims[0].counterexample->unrealisable.empty());
  CHECK(result.claims[1].verdict == Verdict::holds);
  CHECK(result.claims[1].proved);
}

TEST_CASE("the mirrored vehicle of the page brakes at its front wheel") {
  const auto texts = examples();
  REQUIRE(texts.size() == 2);
  const ClaimsFile file = parse_claims(texts[0] + texts[1], "first.toml");
  const VerifyResult result = judged_file(file);
  REQUIRE(result.claims.size() == 3);
  CHECK(result.claims[2].verdict == Verdict::holds);
  CHECK(file.settings[2].scene.contains("J"));
}
