// Judges the claims of a paper at sampled rational bicycles, and along lines through them, at every force at once.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "claims/judge/judge.hpp"
#include "claims/paper/claims_file.hpp"
#include "claims/verify/certificates.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

class Crew;

struct VerifyOptions {
  std::uint64_t samples = 10'000;  ///< of each setting
  /// For each claim that no sample refutes, except consequences and systems. By default one for 200 samples, at least
  /// one; 0: none.
  std::optional<std::uint64_t> lines;
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: all cores
  std::string only;      ///< judge only the claims whose id begins with this
  bool simplify = true;  ///< search for simple counterexamples
  /// The certificates of the paper; what they prove becomes part of the verdicts. Null: none are checked.
  std::shared_ptr<Certificates> certificates;
  /// Called repeatedly, from one thread at a time, with the number of samples and lines that are done, and of all.
  std::function<void(std::uint64_t, std::uint64_t)> progress;

  std::uint64_t line_count() const { return lines ? *lines : samples < 200 ? 1 : samples / 200; }
};

/// Claims of equations and identities of rational functions are judged at one sample in so many: if one is false, it is
/// false nearly everywhere. Prime to the number of kinds of samples.
inline constexpr std::uint64_t thinned_to = 17;

/// Defined in proofs/MEANING.md, Verdicts.
enum class Verdict : std::uint8_t { holds, refuted, undecided, vacuous };
std::string_view name(Verdict verdict);

/// A comparison of a claim that is false at a counterexample, with its two sides.
struct BrokenComparison {
  Expression left, right;
  Relation relation;
  Rational left_value, right_value;
};

/// A sample at which a claim fails, with everything that a person needs to check it.
struct Counterexample {
  std::vector<Rational> values;  ///< of the setting's parameters
  Judgement judgement;
  std::optional<Rational> force;         ///< a value of the force variable at which claim and truth differ
  MechanismScene scene;                  ///< with the load, if there is a force
  std::optional<MotionsAtLoad> motions;  ///< the motions that really exist at the force
  bool minimal = false;                  ///< no simpler one exists: see simplify()
  /// Conditions of Setting::realisable that it does not meet; if none, it can be built.
  std::vector<std::string> unrealisable;
  /// The comparisons in `holds` that are false there. Empty if no single comparison is to blame.
  std::vector<BrokenComparison> broken;
};

/// One claim in one reading.
struct ClaimResult {
  std::size_t claim = 0;  ///< index in the file
  Reading reading = Reading::printed;
  Verdict verdict = Verdict::undecided;
  std::uint64_t held = 0, refuted = 0, undecided = 0;  ///< numbers of samples; those outside its region do not count
  std::uint64_t unsure = 0;  ///< the undecided samples at which it may have a value that was not found
  std::uint64_t lines = 0;   ///< lines along which it was judged; their points count as samples
  std::uint64_t cells = 0;   ///< parts of these lines throughout which the answer is the same
  /// Points at which it was judged, including those about which it says nothing.
  std::uint64_t tried = 0;
  /// The simplest that can be built; if none was found, the simplest.
  std::optional<Counterexample> counterexample;
  /// The simplest of all, if it cannot be built and is much simpler: see much_simpler().
  std::optional<Counterexample> simplest;
  /// The claim is right, or says nothing, at every bicycle. The proof is an identity of rational functions without
  /// divisors that vanish, a sample for a claim of existence, or `certificates`.
  bool proved = false;
  /// A second checker gives it this verdict, too, from the claim on: see find_judgements().
  bool from_the_claim_on = false;
  /// Why it could not be judged completely; empty: nothing went wrong. A claim that no sample refutes is then
  /// undecided.
  std::string failure;
  /// If not empty, the claim is an identity of rational functions wherever none of these expressions vanishes; whether
  /// they vanish was not decided.
  std::vector<std::string> unless_zero;
  /// It is an identity, but whether the domain of the force is one interval at every bicycle was not decided.
  bool unless_interval = false;
  /// Results of find_certificates(): names of certificates that prove the claim or its refutation; certificates that
  /// the checker rejects, and why; statements that are not the claim's.
  std::vector<std::string> certificates, rejections, outdated;
  /// Its statements whose certificates are undecided, missing or unreadable.
  std::vector<CheckedCertificate> unproved;

  /// Where a claim that is not proved is an identity, in words; empty if nothing is known.
  std::string identity_where() const;
  /// The number of statements or certificates that the claims file asks for and that do not exist.
  std::size_t missing() const;
  std::uint64_t samples() const { return held + refuted + undecided; }
};

struct VerifyResult {
  std::uint64_t samples = 0;
  std::uint64_t lines = 0;
  std::uint64_t seed = 0;
  std::vector<ClaimResult> claims;                   ///< in the order of the file, printed before repaired
  std::optional<SecondChecker> second_checker = {};  ///< of VerifyOptions::certificates

  const ClaimResult* find(const ClaimsFile& file, std::string_view id, Reading reading) const;
  std::size_t missing() const;  ///< of all claims
};

/// Makes a failed claim undecided if no sample refutes it.
void yield_to_failure(ClaimResult& result);

/// Whether the file expects the verdict; a claim without an expectation should hold.
bool as_expected(const ClaimsFile& file, const ClaimResult& result);

/// verify(), divided into requests that any rank can answer.
class Verification {
 public:
  /// `paper` distinguishes the requests of several papers, which a crew judges one after another. All arguments must
  /// outlive it.
  Verification(const ClaimsFile& file, const VerifyOptions& options, std::uint64_t paper = 0);
  ~Verification();

  /// The service of a crew. May be called by many threads at once.
  std::string answer(std::string_view request);
  /// The paper that a request is about.
  static std::uint64_t paper_of(std::string_view request);

  /// Judges by the crew, whose service must be answer(), or by threads if there is no crew. Call once. Rank 0 checks
  /// the certificates.
  VerifyResult result(Crew* crew = nullptr);

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

/// Judges the claims. The result does not depend on the number of threads.
VerifyResult verify(const ClaimsFile& file, const VerifyOptions& options = {});

}  // namespace slipproof
