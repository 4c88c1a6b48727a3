// The certificates of a paper: each is checked once, and what they prove enters the verdicts.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "claims/paper/claims_file.hpp"
#include "claims/paper/paper_folder.hpp"
#include "proofs/check/verdict.hpp"
#include "proofs/statement/refutation_text.hpp"

namespace slipproof {

struct VerifyResult;

/// Whether a statement has a proof that the checker accepts.
using CertificateState = check::Verdict;

/// A statement, and what the checker says of its certificate.
struct CheckedCertificate {
  std::string name;     ///< of the file, relative to the folder, without the ending: `certificates/A1.1.always`
  std::string theorem;  ///< as the statement has it; empty where that cannot be read
  CertificateState state = CertificateState::missing;
  std::string message;  ///< why it is not accepted; files are relative to the folder
};

/// A second checker, and how many certificates it and ours accept of those that were asked for.
struct SecondChecker {
  std::string name;  ///< of its file
  std::size_t accepted = 0;
};

/// The certificates in the folder of a claims file and below. A certificate is checked when it is first asked for, and
/// never again. May be used by several threads.
class Certificates {
 public:
  /// With a `second_checker` (see ask_second_checker()) a certificate that only ours accepts is rejected.
  explicit Certificates(PaperFolder paper, std::string second_checker = "")
      : paper_(std::move(paper)), second_checker_(std::move(second_checker)) {}
  explicit Certificates(const std::filesystem::path& folder, std::string second_checker = "")
      : Certificates(PaperFolder{folder.empty() ? "." : folder}, std::move(second_checker)) {}

  /// Of NAME.statement, there or not.
  const CheckedCertificate& check(const std::string& name);
  /// What check_certificates() found of some of them counts as checked here.
  void take(std::string_view checked);
  /// SHA-256 of all files of the claims' statements and certificates.
  std::string digest() const;
  /// Those that are checked.
  std::vector<CheckedCertificate> so_far();
  /// Those of all statements, in the order of their names.
  std::vector<CheckedCertificate> all();
  /// The bytes of NAME.statement; nothing if there is no such file.
  std::optional<std::string> statement(const std::string& name) const;
  /// The bytes of NAME.cert; nothing if there is no such file.
  std::optional<std::string> certificate(const std::string& name) const;
  const std::filesystem::path& folder() const { return paper_.folder; }
  const PaperFolder& paper() const { return paper_; }
  /// What check() wants for a statement that is made of a claim.
  std::string of_claim(const std::string& statement) const { return paper_.certificates + "/" + statement; }
  /// So far; nothing without a second checker.
  std::optional<SecondChecker> second_checker();

 private:
  const CheckedCertificate& add(CheckedCertificate certificate);
  void ask_second_checker_about(CheckedCertificate& certificate);

  PaperFolder paper_;
  std::string second_checker_;
  std::optional<std::map<std::filesystem::path, std::string>> second_verdicts_;  ///< once it was asked
  std::mutex mutex_;
  std::map<std::string, CheckedCertificate> checked_;
};

/// Checks the certificates that find_certificates() asks for of a claim, without a second checker: what a rank does for
/// Certificates::take() of another.
std::string check_certificates(const ClaimsFile& file, std::size_t claim, Reading reading, const PaperFolder& paper);

/// The numbers at which statements of a claim are false, as prove wrote them in place of certificates.
std::vector<NamedValues> failing_numbers(const ClaimsFile& file, std::size_t claim, Reading reading,
                                         const Certificates& certificates);

/// Looks for the certificates of every claim of `result`. A claim that holds at every sample and whose statements, the
/// same bytes as the claims file gives now, all have accepted certificates becomes `proved`, and its certificates are
/// named; of a refuted claim, that of its refutation; and a claim that holds at every sample is refuted, too, where
/// that is accepted. What the others of its statements have instead stands in `unproved`, `rejections` and `outdated`;
/// so does a contradiction of samples and certificates. Statements that the claims file asks for, as `prove` would
/// write them, and that are not there, are `missing`. A claim that failed, here or before, becomes undecided, unless it
/// is refuted. verify() calls it.
void find_certificates(const ClaimsFile& file, VerifyResult& result, Certificates& certificates);

/// Whether they decide a claim of which no sample says anything.
bool settled_by_certificates(const ClaimsFile& file, std::size_t claim, Reading reading, Certificates& certificates);

}  // namespace slipproof
