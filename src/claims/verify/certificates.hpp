// The certificates of a paper. Each is checked once; what they prove becomes part of the verdicts.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "claims/paper/claims_file.hpp"
#include "claims/reading/paper_folder.hpp"
#include "proofs/check/verdict.hpp"
#include "proofs/statement/refutation_text.hpp"

namespace slipproof {

struct VerifyResult;

/// Whether a statement has a proof that the checker accepts.
using CertificateState = check::Verdict;

/// A statement, and what the checker says about its certificate.
struct CheckedCertificate {
  std::string name;     ///< relative to the folder, without an extension: `claims.theorems/A1.1.always`
  std::string theorem;  ///< the name in the statement; empty if it cannot be read
  CertificateState state = CertificateState::missing;
  std::string message;  ///< why it is not accepted; files are relative to the folder
};

/// A second checker, and how many of the requested certificates both it and ours accept.
struct SecondChecker {
  std::string name;  ///< of its file
  std::size_t accepted = 0;
  std::size_t from_claims = 0;  ///< claims that it judges as we do, from the claim on (see find_judgements())
  std::vector<std::string> from_statements{};  ///< the other claims that are proved or refuted
};

/// The certificates of a claims file, and of statements written by hand in its folder and below. A certificate is
/// checked at its first request, and only once. May be used by several threads.
class Certificates {
 public:
  /// With a `second_checker` (see ask_second_checker()), a certificate that only our checker accepts is rejected.
  explicit Certificates(PaperFolder paper, std::string second_checker = "");
  explicit Certificates(const std::filesystem::path& folder, std::string second_checker = "");
  /// The same, with nothing checked yet, and without a second checker. Shares what was read.
  explicit Certificates(const Certificates& other);

  /// Checks the certificate of NAME.statement, whether or not it exists.
  const CheckedCertificate& check(const std::string& name);
  /// Takes over results of check_certificates(); those certificates then count as checked.
  void take(std::string_view checked);
  /// SHA-256 of all files with statements and certificates of the claims.
  std::string digest() const;
  /// The certificates that are checked so far.
  std::vector<CheckedCertificate> so_far();
  /// The certificates of all statements, by name.
  std::vector<CheckedCertificate> all();
  /// The bytes of NAME.statement; nothing if there is no such text.
  std::optional<std::string> statement(const std::string& name) const;
  /// The bytes of NAME.cert; nothing if there is no such text.
  std::optional<std::string> certificate(const std::string& name) const;
  const std::filesystem::path& folder() const { return paper_.folder; }
  /// The name for check() of a statement that is made from a claim.
  std::string of_claim(const std::string& statement) const { return generated_.filename().string() + "/" + statement; }
  /// The canonical claims with the statements; nothing if there are none.
  std::optional<std::string> canonical() const;
  /// What a second checker that judges claims says of one, `proved`, `refuted` or `open`, by the name that the claim's
  /// statements begin with; empty: nothing.
  std::string judgement(const std::string& claim);
  /// The counts so far; nothing without a second checker.
  std::optional<SecondChecker> second_checker();

 private:
  const CheckedCertificate& add(CheckedCertificate certificate);
  void ask_second_checker_about(CheckedCertificate& certificate);

  struct Sources;

  PaperFolder paper_;
  std::filesystem::path generated_;
  std::shared_ptr<Sources> sources_;
  std::string second_checker_;
  std::optional<std::map<std::filesystem::path, std::string>> second_verdicts_;  ///< after the second checker was asked
  std::mutex mutex_;
  std::map<std::string, CheckedCertificate> checked_;
};

/// Checks the certificates that find_certificates() needs for a claim, without a second checker. One rank does this for
/// Certificates::take() of another.
std::string check_certificates(const ClaimsFile& file, std::size_t claim, Reading reading, const Certificates& all);

/// The numbers at which statements of a claim are false; `prove` writes them in place of certificates.
std::vector<NamedValues> failing_numbers(const ClaimsFile& file, std::size_t claim, Reading reading,
                                         const Certificates& certificates);

/// Looks for the certificates of every claim in `result`. A claim becomes `proved` if it holds at every sample and all
/// its statements, with the same bytes as the claims file gives now, have accepted certificates; these are named. For a
/// refuted claim, names the certificate of its refutation. A claim that holds at every sample becomes refuted if the
/// certificate of its refutation is accepted. `unproved`, `rejections` and `outdated` say what its other statements
/// have instead, and report contradictions between samples and certificates. `missing` counts the statements that the
/// claims file asks for, in the form that `prove` writes, and that do not exist. A claim that failed, here or before,
/// becomes undecided unless it is refuted. verify() calls this function.
void find_certificates(const ClaimsFile& file, VerifyResult& result, Certificates& certificates);

/// Marks the claims in `result` that a second checker judges from the claim on, as slipproof-judge-verified does, with
/// the verdict that they have, and counts them, and names the others, in `result.second_checker`, if there is one. The
/// claims in the folder must be those of the file (canonical_claims()). A claim with the opposite verdict gets a
/// rejection. verify() calls this function.
void find_judgements(const ClaimsFile& file, VerifyResult& result, Certificates& certificates);

/// Whether certificates decide a claim that no sample decides.
bool settled_by_certificates(const ClaimsFile& file, std::size_t claim, Reading reading, Certificates& certificates);

}  // namespace slipproof
