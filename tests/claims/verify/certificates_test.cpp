// Certificates beside a claims file: what they prove is named, and what is wrong with them is told.
#include "claims/verify/certificates.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "base/input/diagnostic.hpp"
#include "claims/canonical/canonical_claims.hpp"
#include "proofs/statement/undecided.hpp"
#include "report/papers/errata.hpp"
#include "report/papers/verify_report.hpp"
#include "support/papers/shipped.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using test::read_file;

namespace {

VerifyResult sampled(const std::string& only, std::shared_ptr<Certificates> certificates = nullptr) {
  VerifyOptions options;
  options.certificates = std::move(certificates);
  options.samples = 200;
  options.only = only;
  options.lines = 0;
  return verify(test::shipped_paper(), options);
}

void find_in(const std::filesystem::path& folder, VerifyResult& result) {
  Certificates certificates(folder);
  find_certificates(test::shipped_paper(), result, certificates);
}

/// The folder of a paper, with the statements and certificates of A1.1.
class Folder : public test::TemporaryFolder {
 public:
  Folder() {
    std::filesystem::create_directory(path() / "certificates");
    for (const char* theorem : {"A1.1.only-then", "A1.1.always", "A1.1.defined"}) {
      for (const char* kind : {".statement", ".cert"}) copy(theorem, theorem, kind);
    }
  }
  void copy(const std::string& from, const std::string& to, const std::string& kind) const {
    write("certificates/" + to + kind, read_file(test::shipped_certificates / (from + kind)));
  }
  void replace(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = read_file(certificate(file));
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    write("certificates/" + file, text.replace(at, from.size(), to));
  }
  std::filesystem::path certificate(const std::string& file) const { return path() / "certificates" / file; }
  ClaimResult judge(const std::string& second_checker = "") const {
    VerifyResult result = sampled("A1.1", std::make_shared<Certificates>(path(), second_checker));
    REQUIRE(result.claims.size() == 2);  // A1.1 and A1.1a
    return result.claims.front();
  }
};

}  // namespace

TEST_CASE("what another rank has checked counts as checked here, until a file changes") {
  const Folder folder;
  const ClaimsFile& file = test::shipped_paper();
  const auto claim =
      std::find_if(file.claims.begin(), file.claims.end(), [](const Claim& c) { return c.id == "A1.1"; });
  const std::string checked = check_certificates(file, static_cast<std::size_t>(claim - file.claims.begin()),
                                                 Reading::printed, Certificates(folder.path()));
  Certificates here(folder.path());
  const std::string digest = here.digest();
  CHECK(digest == Certificates(folder.path()).digest());
  std::filesystem::remove(folder.certificate("A1.1.always.cert"));
  CHECK(here.digest() != digest);
  here.take(checked);
  for (const char* theorem : {"A1.1.only-then", "A1.1.always", "A1.1.defined"}) {
    const CheckedCertificate& found = here.check(std::string("certificates/") + theorem);
    CHECK(found.state == CertificateState::accepted);
    CHECK(found.theorem == theorem);
  }
  CHECK(Certificates(folder.path()).check("certificates/A1.1.always").state == CertificateState::missing);
  Certificates asking(folder.path(), "/bin/false");  // which is asked about what was checked elsewhere, too
  CHECK_THROWS_AS(asking.take(checked), InputError);
}

TEST_CASE("a claim is proved by the certificates of all its statements, and by nothing less") {
  const Folder folder;
  const ClaimResult proved = folder.judge();
  CHECK(proved.verdict == Verdict::holds);
  CHECK(proved.proved);
  CHECK(proved.certificates ==
        std::vector<std::string>{"A1.1.only-then.cert", "A1.1.always.cert", "A1.1.defined.cert"});
  CHECK(proved.rejections.empty());
  CHECK(proved.outdated.empty());
  std::filesystem::remove(folder.certificate("A1.1.always.cert"));
  const ClaimResult half = folder.judge();
  CHECK_FALSE(half.proved);
  CHECK(half.certificates.empty());
  CHECK(half.rejections.empty());
  REQUIRE(half.unproved.size() == 1);
  CHECK(half.unproved.front().theorem == "A1.1.always");
  CHECK(half.unproved.front().state == CertificateState::missing);
  std::filesystem::remove_all(folder.certificate("A1.1.always.statement"));
  CHECK_FALSE(folder.judge().proved);
}

TEST_CASE("what a certificate refutes is refuted, also where all samples miss it") {
  VerifyOptions options;
  options.samples = 1;
  options.only = "A2.cover";
  VerifyResult result = verify(test::shipped_paper(), options);
  const ClaimResult before = result.claims.front();
  REQUIRE(before.verdict == Verdict::holds);
  find_in(test::shipped_folder, result);
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
    folder.write("certificates/A1.1.always.cert", "");
    rejected(folder);
  }
  SUBCASE("a folder in its place") {
    const Folder folder;
    std::filesystem::remove(folder.certificate("A1.1.always.cert"));
    std::filesystem::create_directory(folder.certificate("A1.1.always.cert"));
    const ClaimResult result = folder.judge();
    CHECK_FALSE(result.proved);
    REQUIRE(result.unproved.size() == 1);
    CHECK(result.unproved.front().state == CertificateState::unreadable);
  }
}

TEST_CASE("a second checker has to accept what the first one accepts") {
  const Folder folder;
  const auto checker = [&](const std::string& commands) {
    folder.write("second", "#!/bin/sh\n" + commands);
    std::filesystem::permissions(folder.path() / "second", std::filesystem::perms::owner_all);
    return (folder.path() / "second").string();
  };
  const std::string agrees = R"(for s in "$1"/certificates/*.statement; do echo "accepted ${s%.statement}.cert"; done
)";
  const std::string summary = "echo 's ACCEPTED'\n";
  CHECK(folder.judge(checker(agrees + summary)).proved);

  Certificates asked(folder.path(), checker(agrees + summary));
  CHECK(asked.all().size() == 3);
  REQUIRE(asked.second_checker());
  CHECK(asked.second_checker()->name == "second");
  CHECK(asked.second_checker()->accepted == 3);
  CHECK_FALSE(Certificates(folder.path()).second_checker());

  const ClaimResult rejected =
      folder.judge(checker("{ " + agrees + "} | sed '/always/s/accepted/rejected/'\n" + summary + "exit 5\n"));
  CHECK_FALSE(rejected.proved);
  REQUIRE(rejected.rejections.size() == 1);
  CHECK(rejected.rejections.front().starts_with("certificates/A1.1.always.cert: rejected by "));
  CHECK(rejected.rejections.front().ends_with("/second"));
  const ClaimResult silent = folder.judge(checker("{ " + agrees + "} | sed '/always/d'\n" + summary));
  CHECK_FALSE(silent.proved);
  REQUIRE(silent.rejections.size() == 1);
  CHECK(silent.rejections.front().starts_with("certificates/A1.1.always.cert: not judged by "));

  CHECK(folder.judge(checker(agrees + "echo \"undecided $1/u.cert\"\n" + summary + "exit 4\n")).proved);

  // What is no checker, or did not get to its end, is refused.
  for (const std::string& commands : {agrees, agrees + summary + "exit 2\n", agrees + summary + "kill -9 $$\n",
                                      "echo nonsense\n" + summary, "echo accepted A1.1.always\n" + summary}) {
    CAPTURE(commands);
    CHECK_THROWS_AS(folder.judge(checker(commands)), InputError);
  }
  CHECK_THROWS_AS(folder.judge("/nowhere/second"), InputError);
}

TEST_CASE("a second checker that judges claims is told which of them it leaves to the statements") {
  const Folder folder;
  folder.write("certificates/claims.canonical", canonical_claims(test::shipped_paper()));
  const auto judged = [&](const std::string& verdict) {
    folder.write(
        "judge",
        "#!/bin/sh\nfor s in \"$1\"/certificates/*.statement; do echo \"accepted ${s%.statement}.cert\"; done\n"
        "echo \"" +
            verdict + " $1/certificates/A1.1\"\necho 's ACCEPTED'\n");
    std::filesystem::permissions(folder.path() / "judge", std::filesystem::perms::owner_all);
    return sampled("A1.1", std::make_shared<Certificates>(folder.path(), (folder.path() / "judge").string()));
  };
  const VerifyResult proved = judged("proved");
  REQUIRE(proved.second_checker);
  CHECK(proved.claims.front().from_the_claim_on);
  CHECK(proved.second_checker->from_claims == 1);
  CHECK(proved.second_checker->from_statements.empty());
  const VerifyResult open = judged("open");
  REQUIRE(open.claims.front().proved);
  CHECK_FALSE(open.claims.front().from_the_claim_on);
  CHECK(open.second_checker->from_claims == 0);
  CHECK(open.second_checker->from_statements == std::vector<std::string>{"A1.1"});
}

TEST_CASE("undecided, missing, unreadable, rejected and accepted are five things") {
  const Folder folder;
  folder.write("certificates/A1.1.always.cert",
               undecided_text("A1.1.always", {"no step left of 7", "left with x > 0"}));
  folder.write("certificates/A1.1.only-then.cert", "slipproof-certificate 1\nno proof\n");
  folder.write("certificates/none.statement", "this is no statement\n");
  folder.copy("A1.2.always", "A1.2.always", ".statement");
  Certificates certificates(folder.path());
  const auto state = [&](const char* name) {
    return std::string(to_string(certificates.check(std::string("certificates/") + name).state));
  };
  CHECK(state("A1.1.always") == "undecided");
  CHECK(certificates.check("certificates/A1.1.always").message ==
        "the search ended without a certificate: no step left of 7; left with x > 0");
  CHECK(state("A1.1.only-then") == "rejected");
  CHECK(certificates.check("certificates/A1.1.only-then").message.starts_with("certificates/A1.1.only-then.cert:2: "));
  CHECK(state("A1.1.defined") == "accepted");
  CHECK(state("A1.2.always") == "missing");
  CHECK(state("none") == "unreadable");
  CHECK(certificates.all().size() == 5);
  // What was checked is not checked again.
  std::filesystem::remove(folder.certificate("A1.1.defined.cert"));
  CHECK(state("A1.1.defined") == "accepted");
}

TEST_CASE("what prove left undecided is not called rejected") {
  const Folder folder;
  folder.write("certificates/A1.1.always.cert", undecided_text("A1.1.always", {"no step left of 7"}));
  VerifyResult result = sampled("A1.1", std::make_shared<Certificates>(folder.path()));
  const ClaimResult& claim = result.claims.front();
  CHECK(claim.verdict == Verdict::holds);
  CHECK_FALSE(claim.proved);
  CHECK(claim.rejections.empty());
  REQUIRE(claim.unproved.size() == 1);
  CHECK(claim.unproved.front().state == CertificateState::undecided);
  CHECK(summary(test::shipped_paper(), result) == Summary::as_expected);
  CHECK(text_of(verify_document(test::shipped_paper(), result))
            .find("undecided A1.1.always: the search ended without a certificate: no step left of 7\n") !=
        std::string::npos);
  CHECK(verify_json(test::shipped_paper(), result).find("\"state\": \"undecided\"") != std::string::npos);
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
  find_in(folder.path(), result);
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
  find_in(folder.path(), result);
  CHECK(result.claims.front().verdict == Verdict::undecided);
  // Where no bicycle was found of which the claim says something, the proof may be about nothing.
  result.claims.front().held = result.claims.front().undecided = 0;
  find_in(folder.path(), result);
  CHECK(result.claims.front().verdict == Verdict::undecided);
  CHECK_FALSE(result.claims.front().proved);
}

TEST_CASE("the errata name the certificates of a repair, or the number of its samples") {
  VerifyResult result = sampled("");
  const auto certainty = [&](const std::string& id) {
    const Errata all = errata(test::shipped_paper(), result);
    for (const Finding& finding : all.findings) {
      if (finding.id == id) return error_certainty(finding) + "; " + repair_certainty(finding);
    }
    return std::string("no such finding");
  };
  CHECK(certainty("R2.3.2").starts_with("sampled (200 samples)"));
  const std::string samples = std::to_string(result.find(test::shipped_paper(), "A2.4", Reading::repaired)->samples());
  CHECK(certainty("A2.4") == "exact; sampled (" + samples + " samples)");
  find_in(test::shipped_folder, result);
  CHECK(certainty("A2.4") == "exact; proved for all parameters (certificate A2.4.repaired.cert)");
  CHECK(certainty("E4.1.2") ==
        "exact (certificate E4.1.2.refuted.cert); proved for all parameters (certificate E4.1.2.repaired.cert)");
  CHECK(certainty("R2.3.2").starts_with("exact (certificate R2.3.2.refuted.cert)"));  // that there is none
  const std::string text = text_of(errata_document(test::shipped_paper(), errata(test::shipped_paper(), result)));
  CHECK(text.find("repair proved for all parameters (certificate A2.4.repaired.cert)") != std::string::npos);
}
