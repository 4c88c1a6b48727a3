#include "claims/verify/certificates.hpp"

#include <algorithm>
#include <optional>

#include "base/crew/bytes.hpp"
#include "base/os/sha256.hpp"
#include "base/parallel/failure.hpp"
#include "claims/canonical/canonical_claims.hpp"
#include "claims/statements/claim_statements.hpp"
#include "claims/verify/second_checker.hpp"
#include "claims/verify/verify.hpp"
#include "proofs/check/files.hpp"
#include "proofs/statement/refutation_text.hpp"
#include "proofs/statement/theorems.hpp"
#include "proofs/statement/undecided.hpp"

namespace slipproof {

namespace {

/// What a folder has for the statements that together express something.
struct Found {
  std::vector<CheckedCertificate> statements;
  std::vector<std::string> outdated;
  bool any = false;     ///< the folder has one of them
  bool proved = false;  ///< all of them
};

CheckedCertificate no_statement(const std::string& file, const std::string& theorem) {
  return {file, theorem, CertificateState::missing, "there is no such statement"};
}

Found find(const std::vector<NamedStatement>& statements, Certificates& certificates) {
  Found result;
  for (const NamedStatement& statement : statements) {
    const std::string file = certificates.of_claim(statement.name);
    const auto text = certificates.statement(file);
    result.any = result.any || text;
    if (text && *text != statement.text) {
      result.outdated.push_back(statement.name + ": its statement is not the claim's");
    } else if (text) {
      result.statements.push_back(certificates.check(file));
    } else {
      result.statements.push_back(no_statement(file, statement.name));
    }
  }
  result.proved = result.any && result.outdated.empty();
  for (const CheckedCertificate& s : result.statements) {
    result.proved = result.proved && s.state == CertificateState::accepted;
  }
  return result;
}

/// Looks for numbers at which a statement of the claim is false.
Found find_counterexample(const std::vector<NamedStatement>& statements, Certificates& certificates) {
  for (const NamedStatement& statement : statements) {
    if (!statement.refutes) continue;
    const auto met = certificates.statement(certificates.of_claim(statement.name + ".refuted.met"));
    const auto values = met ? refuting_values(statement, *met) : std::nullopt;
    if (!values) continue;
    Found found = find(refutation_at(statement, *values), certificates);
    if (found.proved) return found;
  }
  return {};
}

/// Adds the problems that were found, whatever the statements prove.
void add_problems(ClaimResult& claim, const Found& found) {
  claim.outdated.insert(claim.outdated.end(), found.outdated.begin(), found.outdated.end());
  for (const CheckedCertificate& statement : found.statements) {
    if (statement.state == CertificateState::accepted) continue;
    if (statement.state == CertificateState::rejected) claim.rejections.push_back(statement.message);
    if (statement.state != CertificateState::rejected) claim.unproved.push_back(statement);
  }
}

void name_certificates(ClaimResult& claim, const Found& found) {
  for (const CheckedCertificate& statement : found.statements) {
    claim.certificates.push_back(std::filesystem::path(statement.name).filename().string() + ".cert");
  }
}

void add_certificates(const ClaimsFile& file, ClaimResult& claim, Certificates& certificates) {
  const Claim& stated = file.claims[claim.claim];
  const std::vector<NamedStatement> statements = claim_statements(file, stated, claim.reading);
  const Found proof = find(statements, certificates);
  Found refutation = find(claim_refutation(file, stated, claim.reading), certificates);
  if (!refutation.proved) {
    Found counterexample = find_counterexample(statements, certificates);
    if (counterexample.proved) refutation = std::move(counterexample);
  }
  // For the direction that the file asks for, all statements count; for the other, only if the folder has some.
  const bool asks_for_refutation = stated.body(claim.reading).expect == Expectation::refuted;
  const bool asks = stated.body(claim.reading).expect != Expectation::undecided;
  if (proof.any || (asks && !asks_for_refutation && !refutation.proved)) add_problems(claim, proof);
  if (refutation.any || (asks_for_refutation && !proof.proved)) add_problems(claim, refutation);
  if (refutation.proved && proof.proved) {
    claim.rejections.push_back(stated.id + ": certificates of it and of its refutation are accepted");
    return;
  }
  // A refutation proves that a counterexample exists; samples may all miss it.
  if (refutation.proved && claim.verdict != Verdict::vacuous) claim.verdict = Verdict::refuted;
  if (refutation.proved && claim.verdict == Verdict::refuted) name_certificates(claim, refutation);
  if (!proof.proved) return;
  if (claim.refuted > 0) {
    claim.rejections.push_back(stated.id + ": refuted by a sample, yet its certificates are accepted");
    return;
  }
  // A proof about nothing proves nothing, so the claim must be right at some sample.
  if (claim.held == 0 && !stated.kind().traits().seeks) return;
  if (claim.undecided > 0) return;  // at these bicycles it has no value, and statements do not cover them
  claim.verdict = Verdict::holds;
  claim.proved = true;
  name_certificates(claim, proof);
}

void find_certificates(const ClaimsFile& file, ClaimResult& claim, Certificates& certificates) {
  const std::string failure = failure_of([&] { add_certificates(file, claim, certificates); });
  if (claim.failure.empty()) claim.failure = failure;
  yield_to_failure(claim);
}

/// The result for a claim about which only the certificates are known.
ClaimResult result_of_certificates(const ClaimsFile& file, std::size_t claim, Reading reading,
                                   Certificates& certificates) {
  ClaimResult result;
  result.claim = claim;
  result.reading = reading;
  find_certificates(file, result, certificates);
  return result;
}

CheckedCertificate checked_now(check::Checker& checker, const std::filesystem::path& folder, const std::string& name) {
  const check::FileResult found = checker.check(folder / (name + ".cert"));
  CheckedCertificate result{name, found.theorem, found.verdict, found.message};
  const std::string prefix = folder.string() + "/";
  if (result.message.starts_with(prefix)) result.message.erase(0, prefix.size());
  if (result.state == CertificateState::undecided) {
    result.message.erase(0, result.message.find("the search"));  // its place says which search it was, as the name does
  }
  return result;
}

}  // namespace

struct Certificates::Sources {
  TheoremTexts texts;
  check::Checker checker;
};

Certificates::Certificates(PaperFolder paper, std::string second_checker)
    : paper_(std::move(paper)),
      generated_(paper_.generated()),
      sources_(std::make_shared<Sources>()),
      second_checker_(std::move(second_checker)) {}

Certificates::Certificates(const std::filesystem::path& folder, std::string second_checker)
    : Certificates(PaperFolder{folder.empty() ? "." : folder}, std::move(second_checker)) {}

Certificates::Certificates(const Certificates& other)
    : paper_(other.paper_), generated_(other.generated_), sources_(other.sources_) {}

std::optional<std::string> Certificates::statement(const std::string& name) const {
  return sources_->texts.at(paper_.folder / (name + ".statement"));
}

std::optional<std::string> Certificates::certificate(const std::string& name) const {
  return sources_->texts.at(paper_.folder / (name + ".cert"));
}

std::optional<std::string> Certificates::canonical() const {
  return sources_->texts.at(generated_ / canonical_name);
}

const CheckedCertificate& Certificates::check(const std::string& name) {
  const std::scoped_lock lock(mutex_);
  const auto known = checked_.find(name);
  return known != checked_.end() ? known->second : add(checked_now(sources_->checker, paper_.folder, name));
}

const CheckedCertificate& Certificates::add(CheckedCertificate certificate) {
  if (!second_checker_.empty() && certificate.state == CertificateState::accepted) {
    ask_second_checker_about(certificate);
  }
  std::string name = certificate.name;
  return checked_.emplace(std::move(name), std::move(certificate)).first->second;
}

void Certificates::take(std::string_view checked) {
  const std::scoped_lock lock(mutex_);
  ByteReader bytes(checked);
  for (std::uint64_t left = bytes.number(); left > 0; --left) {
    CheckedCertificate certificate;
    certificate.name = bytes.text();
    certificate.theorem = bytes.text();
    certificate.state = static_cast<CertificateState>(bytes.number());
    certificate.message = bytes.text();
    if (!checked_.contains(certificate.name)) add(std::move(certificate));
  }
  bytes.end();
}

std::string Certificates::digest() const {
  TheoremTexts now;
  std::map<std::string, std::string> files;
  const auto add = [&](const std::filesystem::path& file) {
    if (const auto text = now.at(file)) files.emplace(file.string(), sha256(*text));
  };
  std::error_code error;
  if (is_theorem_file(generated_)) add(generated_);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(generated_, error)) add(entry.path());
  std::string all;
  for (const auto& [name, digest] : files) all += name + ' ' + digest + '\n';
  return sha256(all);
}

std::vector<CheckedCertificate> Certificates::so_far() {
  const std::scoped_lock lock(mutex_);
  std::vector<CheckedCertificate> result;
  for (const auto& [name, certificate] : checked_) result.push_back(certificate);
  return result;
}

std::vector<CheckedCertificate> Certificates::all() {
  std::vector<CheckedCertificate> result;
  for (const std::filesystem::path& file : check::certificates_in(paper_.folder)) {
    if (!paper_.owns(file)) continue;
    result.push_back(check(file.lexically_relative(paper_.folder).replace_extension().generic_string()));
  }
  return result;
}

std::optional<SecondChecker> Certificates::second_checker() {
  if (second_checker_.empty()) return std::nullopt;
  const std::scoped_lock lock(mutex_);
  const auto accepted = [](const auto& known) { return known.second.state == CertificateState::accepted; };
  return SecondChecker{std::filesystem::path(second_checker_).filename().string(),
                       static_cast<std::size_t>(std::count_if(checked_.begin(), checked_.end(), accepted))};
}

void Certificates::ask_second_checker_about(CheckedCertificate& certificate) {
  if (!second_verdicts_) second_verdicts_ = slipproof::ask_second_checker(second_checker_, paper_.folder);
  const auto found =
      second_verdicts_->find(check::printable((paper_.folder / (certificate.name + ".cert")).lexically_normal()));
  const std::string verdict = found == second_verdicts_->end() ? "not judged" : found->second;
  if (verdict == to_string(CertificateState::accepted)) return;
  certificate.state = CertificateState::rejected;
  certificate.message = certificate.name + ".cert: " + verdict + " by " + second_checker_;
}

std::string Certificates::judgement(const std::string& claim) {
  const std::scoped_lock lock(mutex_);
  if (!second_verdicts_) return "";
  const auto found = second_verdicts_->find(check::printable((generated_ / claim).lexically_normal()));
  return found == second_verdicts_->end() ? "" : found->second;
}

std::string check_certificates(const ClaimsFile& file, std::size_t claim, Reading reading, const Certificates& all) {
  Certificates certificates(all);
  result_of_certificates(file, claim, reading, certificates);
  const std::vector<CheckedCertificate> checked = certificates.so_far();
  ByteWriter bytes;
  bytes.number(checked.size());
  for (const auto& [name, theorem, state, message] : checked) {
    bytes.text(name).text(theorem).number(static_cast<std::uint64_t>(state)).text(message);
  }
  return bytes.take();
}

std::vector<NamedValues> failing_numbers(const ClaimsFile& file, std::size_t claim, Reading reading,
                                         const Certificates& certificates) {
  std::vector<NamedValues> all;
  for (const NamedStatement& statement : claim_statements(file, file.claims[claim], reading)) {
    const auto text = certificates.certificate(certificates.of_claim(statement.name));
    if (!text || !text->starts_with("slipproof-undecided ")) continue;
    if (auto numbers = numbers_of(*text)) all.push_back(*std::move(numbers));
  }
  return all;
}

void find_certificates(const ClaimsFile& file, VerifyResult& result, Certificates& certificates) {
  for (ClaimResult& claim : result.claims) find_certificates(file, claim, certificates);
}

void find_judgements(const ClaimsFile& file, VerifyResult& result, Certificates& certificates) {
  const auto stated = certificates.canonical();
  if (!result.second_checker || stated.value_or("") != canonical_claims(file)) return;
  for (ClaimResult& claim : result.claims) {
    const std::string name = file.claims[claim.claim].id + (claim.reading == Reading::repaired ? ".repaired" : "");
    const std::string judgement = certificates.judgement(name);
    const bool refuted = claim.verdict == Verdict::refuted;
    claim.from_the_claim_on = (claim.proved && judgement == "proved") || (refuted && judgement == "refuted");
    if (claim.from_the_claim_on) {
      ++result.second_checker->from_claims;
    } else if (claim.proved || refuted) {
      result.second_checker->from_statements.push_back(name);
    }
    if ((claim.proved && judgement == "refuted") || (refuted && judgement == "proved")) {
      claim.rejections.push_back(name + ": " + judgement + " from the claim on by the second checker");
    }
  }
}

bool settled_by_certificates(const ClaimsFile& file, std::size_t claim, Reading reading, Certificates& certificates) {
  return result_of_certificates(file, claim, reading, certificates).verdict != Verdict::undecided;
}

}  // namespace slipproof
