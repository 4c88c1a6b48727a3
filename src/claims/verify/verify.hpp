// The claims of a paper at sampled rational bicycles, and along lines through them, every force at once.
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
  /// For each claim that no sample refutes, but consequences and systems; by default one for 200 samples, and one at
  /// least; 0: none.
  std::optional<std::uint64_t> lines;
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: all cores
  std::string only;      ///< judge only the claims whose id begins with this
  bool simplify = true;  ///< search for simple counterexamples
  /// Those of the paper: what they prove enters the verdicts; null: none are looked at.
  std::shared_ptr<Certificates> certificates;
  /// Called now and then, from one thread at a time, with the number of samples and lines done and of all.
  std::function<void(std::uint64_t, std::uint64_t)> progress;

  std::uint64_t line_count() const { return lines ? *lines : samples < 200 ? 1 : samples / 200; }
};

/// Claims of equations, and identities of rational functions, are judged at one sample in so many: where one is false,
/// it is so nearly everywhere. Prime to the number of the sampler's kinds of samples.
inline constexpr std::uint64_t thinned_to = 17;

/// proofs/MEANING.md, Verdicts.
enum class Verdict : std::uint8_t { holds, refuted, undecided, vacuous };
std::string_view name(Verdict verdict);

/// A comparison that the claim makes and that is false at a counterexample, with its two sides.
struct BrokenComparison {
  Expression left, right;
  Relation relation;
  Rational left_value, right_value;
};

/// A sample at which a claim fails, with all that a person needs to check it.
struct Counterexample {
  std::vector<Rational> values;  ///< of the setting's parameters
  Judgement judgement;
  std::optional<Rational> force;         ///< a value of the force variable at which claim and truth differ
  MechanismScene scene;                  ///< with the load, if there is a force
  std::optional<MotionsAtLoad> motions;  ///< what is really there at the force
  bool minimal = false;                  ///< no simpler one exists: see simplify()
  /// Which conditions of Setting::realisable it does not meet: with none of them, it can be built.
  std::vector<std::string> unrealisable;
  /// What `holds` compares, and is false there. Empty where no single comparison is to blame.
  std::vector<BrokenComparison> broken;
};

/// One claim in one reading.
struct ClaimResult {
  std::size_t claim = 0;  ///< index in the file
  Reading reading = Reading::printed;
  Verdict verdict = Verdict::undecided;
  std::uint64_t held = 0, refuted = 0, undecided = 0;  ///< samples; those outside of its region do not count
  std::uint64_t unsure = 0;  ///< those of the undecided at which it may have a value, which was not found
  std::uint64_t lines = 0;   ///< along which it was judged; their points count as samples
  std::uint64_t cells = 0;   ///< parts of these lines in which the answer about it is the same throughout
  /// Bicycles at which it was judged, those included of which it says nothing.
  std::uint64_t tried = 0;
  /// The simplest that can be built; where none such was found, the simplest.
  std::optional<Counterexample> counterexample;
  /// The simplest of all, if it cannot be built and is much simpler: see much_simpler().
  std::optional<Counterexample> simplest;
  /// It is right, or says nothing, at every bicycle: an identity of rational functions that divides by nothing that
  /// vanishes, the existence of what a sample shows, or `certificates`.
  bool proved = false;
  /// Why it could not be judged to the end; empty: nothing went wrong. What no sample refutes is then undecided.
  std::string failure;
  /// An identity of rational functions wherever none of these expressions vanishes; that they do not was not shown.
  std::vector<std::string> unless_zero;
  /// What find_certificates() finds: names of the certificates that prove the claim, or its refutation; those that the
  /// checker rejects, and why; statements that are not the claim's.
  std::vector<std::string> certificates, rejections, outdated;
  /// Its statements whose certificates are undecided, missing or unreadable.
  std::vector<CheckedCertificate> unproved;

  /// How many statements or certificates that the claims file asks for are not there.
  std::size_t missing() const;
  std::uint64_t samples() const { return held + refuted + undecided; }
};

struct VerifyResult {
  std::uint64_t samples = 0;
  std::uint64_t lines = 0;
  std::uint64_t seed = 0;
  std::vector<ClaimResult> claims;                   ///< in the order of the file, printed before repaired
  std::optional<SecondChecker> second_checker = {};  ///< that of VerifyOptions::certificates

  const ClaimResult* find(const ClaimsFile& file, std::string_view id, Reading reading) const;
  std::size_t missing() const;  ///< of all claims
};

/// Of a claim that failed, what no sample refutes is undecided.
void yield_to_failure(ClaimResult& result);

/// Whether the verdict is the one that the file expects; a claim that expects nothing should hold.
bool as_expected(const ClaimsFile& file, const ClaimResult& result);

/// verify() in requests that any rank can answer.
class Verification {
 public:
  /// `paper` tells the requests of several papers apart, of which a crew does one after the other. What is given must
  /// outlive it.
  Verification(const ClaimsFile& file, const VerifyOptions& options, std::uint64_t paper = 0);
  ~Verification();

  /// The service of a crew, from many threads at once.
  std::string answer(std::string_view request);
  /// The paper that a request is about.
  static std::uint64_t paper_of(std::string_view request);

  /// By the crew, whose service is answer(), or by threads where there is none; once. The certificates are checked by
  /// rank 0.
  VerifyResult result(Crew* crew = nullptr);

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

/// The same result at any number of threads.
VerifyResult verify(const ClaimsFile& file, const VerifyOptions& options = {});

}  // namespace slipproof
