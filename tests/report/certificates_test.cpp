// Certificates beside a claims file: what they prove is named, and what is wrong with them is told.
#include "report/certificates.hpp"

#include <doctest/doctest.h>

#include <filesystem>

#include "report/errata.hpp"
#include "report/verify_report.hpp"
#include "support/run_program.hpp"
#include "support/shipped.hpp"

using namespace slipproof;
using test::read_file;

namespace {

VerifyResult sampled(const std::string& only) {
  VerifyOptions options;
  options.samples = 200;
  options.only = only;
  return verify(test::shipped_paper(), options);
}

/// A folder with the statements and certificates of A1.1.
class Folder : public test::TemporaryFolder {
 public:
  Folder() {
    for (const char* theorem : {"A1.1.only-then", "A1.1.always", "A1.1.defined"}) {
      for (const char* kind : {".statement", ".cert"}) copy(theorem, theorem, kind);
    }
  }
  void copy(const std::string& from, const std::string& to, const std::string& kind) const {
    write(to + kind, read_file(test::shipped_certificates / (from + kind)));
  }
  void replace(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = read_file(path() / file);
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    write(file, text.replace(at, from.size(), to));
  }
  ClaimResult judge() const {
    VerifyResult result = sampled("A1.1");
    REQUIRE(result.claims.size() == 2);  // A1.1 and A1.1a
    find_certificates(test::shipped_paper(), result, path());
    return result.claims.front();
  }
};

}  // namespace

TEST_CASE("a claim is proved by the certificates of all its statements, and by nothing less") {
  const Folder folder;
  const ClaimResult proved = folder.judge();
  CHECK(proved.verdict == Verdict::holds);
  CHECK(proved.proved);
  CHECK(proved.certificates ==
        std::vector<std::string>{"A1.1.only-then.cert", "A1.1.always.cert", "A1.1.defined.cert"});
  CHECK(proved.rejections.empty());
  CHECK(proved.outdated.empty());
  std::filesystem::remove(folder.path() / "A1.1.always.cert");
  const ClaimResult half = folder.judge();
  CHECK_FALSE(half.proved);
  CHECK(half.certificates.empty());
  CHECK(half.rejections.empty());
  std::filesystem::remove_all(folder.path() / "A1.1.always.statement");
  CHECK_FALSE(folder.judge().proved);
}

TEST_CASE("what a certificate refutes is refuted, also where all samples miss it") {
  VerifyOptions options;
  options.samples = 1;
  options.only = "A2.cover";
  VerifyResult result = verify(test::shipped_paper(), options);
  const ClaimResult before = result.claims.front();
  REQUIRE(before.verdict == Verdict::holds);
  find_certificates(test::shipped_paper(), result, test::shipped_certificates);
  const ClaimResult& after = result.claims.front();
  CHECK(after.verdict == Verdict::refuted);
  CHECK_FALSE(after.proved);
  CHECK(after.rejections.empty());
  CHECK(after.certificates == std::vector<std::string>{"A2.cover.refuted.cert"});
  CHECK(explain(test::shipped_paper(), after) == "proved to be false; no sample is a counterexample");
}

TEST_CASE("certificates that prove nothing are rejected, whatever is wrong with them") {
  const auto rejected = [](const Folder& folder) {
    const ClaimResult result = folder.judge();
    CHECK(result.verdict == Verdict::holds);
    CHECK_FALSE(result.proved);
    CHECK(result.certificates.empty());
    REQUIRE(result.rejections.size() == 1);
    CHECK(result.rejections.front().find("A1.1.always.cert") != std::string::npos);
  };
  SUBCASE("another coefficient") {
    const Folder folder;
    folder.replace("A1.1.always.cert", "\nterm 1 ", "\nterm 2 ");
    rejected(folder);
  }
  SUBCASE("the certificate of another statement") {
    const Folder folder;
    folder.copy("A1.2.always", "A1.1.always", ".cert");
    rejected(folder);
  }
  SUBCASE("an empty file") {
    const Folder folder;
    folder.write("A1.1.always.cert", "");
    rejected(folder);
  }
  SUBCASE("a folder in its place") {
    const Folder folder;
    std::filesystem::remove(folder.path() / "A1.1.always.cert");
    std::filesystem::create_directory(folder.path() / "A1.1.always.cert");
    rejected(folder);
  }
}

TEST_CASE("a statement that is not the claim's proves nothing of it, though its certificate is accepted") {
  const Folder folder;
  folder.copy("A1.2.always", "A1.1.always", ".cert");
  folder.copy("A1.2.always", "A1.1.always", ".statement");
  const ClaimResult other = folder.judge();
  CHECK_FALSE(other.proved);
  CHECK(other.rejections.empty());
  REQUIRE(other.outdated.size() == 1);
  CHECK(other.outdated.front().starts_with("A1.1.always:"));
}

TEST_CASE("a sample that refutes what certificates prove is a contradiction, and told") {
  const Folder folder;
  VerifyResult result = sampled("A1.1");
  result.claims.front().verdict = Verdict::refuted;
  result.claims.front().refuted = 1;
  find_certificates(test::shipped_paper(), result, folder.path());
  CHECK(result.claims.front().verdict == Verdict::refuted);
  CHECK_FALSE(result.claims.front().proved);
  CHECK(result.claims.front().rejections.size() == 1);
  CHECK(summary(test::shipped_paper(), result) == Summary::rejected);
}

TEST_CASE("no statement speaks of bicycles at which a claim has no value") {
  const Folder folder;
  VerifyResult result = sampled("A1.1");
  result.claims.front().verdict = Verdict::undecided;
  result.claims.front().undecided = 1;
  find_certificates(test::shipped_paper(), result, folder.path());
  CHECK(result.claims.front().verdict == Verdict::undecided);
  // Where no bicycle was found of which the claim says something, the proof may be about nothing.
  result.claims.front().held = result.claims.front().undecided = 0;
  find_certificates(test::shipped_paper(), result, folder.path());
  CHECK(result.claims.front().verdict == Verdict::undecided);
  CHECK_FALSE(result.claims.front().proved);
}

TEST_CASE("the errata name the certificates of a repair, or the number of its samples") {
  VerifyResult result = sampled("");
  const auto certainty = [&](const std::string& id) {
    for (const Finding& finding : errata(test::shipped_paper(), result)) {
      if (finding.id == id) return error_certainty(finding) + "; " + repair_certainty(finding);
    }
    return std::string("no such finding");
  };
  CHECK(certainty("R2.3.2").starts_with("sampled (200 samples)"));
  const std::string samples = std::to_string(result.find(test::shipped_paper(), "A2.4", Reading::repaired)->samples());
  CHECK(certainty("A2.4") == "exact; sampled (" + samples + " samples)");
  find_certificates(test::shipped_paper(), result, test::shipped_certificates);
  CHECK(certainty("A2.4") == "exact; proved for all parameters (certificate A2.4.repaired.cert)");
  CHECK(certainty("E4.1.2") ==
        "exact (certificate E4.1.2.refuted.cert); proved for all parameters (certificate E4.1.2.repaired.cert)");
  CHECK(certainty("R2.3.2").starts_with("exact (certificate R2.3.2.refuted.cert)"));  // that there is none
  const std::string text = errata_text(test::shipped_paper(), errata(test::shipped_paper(), result));
  CHECK(text.find("repair proved for all parameters (certificate A2.4.repaired.cert)") != std::string::npos);
}
