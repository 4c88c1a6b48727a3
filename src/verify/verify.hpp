// The claims of a paper at sampled rational bicycles, every force at once.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "claims/claims_file.hpp"
#include "modes/motions.hpp"
#include "verify/judge.hpp"

namespace slipproof {

struct VerifyOptions {
  std::uint64_t samples = 10'000;  ///< of each setting
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: all cores
  std::string only;      ///< judge only the claims whose id begins with this
  bool simplify = true;  ///< search for simple counterexamples
  /// Called now and then, from one thread at a time, with the number of samples done and of all.
  std::function<void(std::uint64_t, std::uint64_t)> progress;
};

enum class Verdict : std::uint8_t { holds, refuted, undecided };
std::string_view name(Verdict verdict);

/// A sample at which a claim fails, with all that a person needs to check it.
struct Counterexample {
  std::vector<Rational> values;  ///< of the setting's parameters
  Judgement judgement;
  std::optional<Rational> force;           ///< a value of the force variable at which claim and truth differ
  Scene scene;                             ///< with the pedal force, if there is a force
  std::shared_ptr<const ModeTable> table;  ///< what `motions` points into
  std::optional<MotionsAtForce> motions;   ///< what is really there at the force
  bool minimal = false;                    ///< no simpler one exists: see simplify()
};

/// One claim in one reading.
struct ClaimResult {
  std::size_t claim = 0;  ///< index in the file
  Reading reading = Reading::printed;
  Verdict verdict = Verdict::undecided;
  std::uint64_t held = 0, refuted = 0, undecided = 0;  ///< samples; those outside of its region do not count
  std::optional<Counterexample> counterexample;
  /// It holds for all parameters: an identity of rational functions (wherever both sides have a value and, with a
  /// mode, its equations are regular), the existence of what a sample shows, or `certificates`.
  bool proved = false;
  /// What report/certificates.hpp finds beside the claims file: names of the certificates that prove the claim, or its
  /// refutation; those that the checker rejects, and why; statements that are not the claim's.
  std::vector<std::string> certificates, rejections, outdated;

  std::uint64_t samples() const { return held + refuted + undecided; }
};

struct VerifyResult {
  std::uint64_t samples = 0;
  std::uint64_t seed = 0;
  std::vector<ClaimResult> claims;  ///< in the order of the file, printed before repaired

  const ClaimResult* find(const ClaimsFile& file, std::string_view id, Reading reading) const;
};

/// Whether the verdict is the one that the file expects; a claim that expects nothing should hold.
bool as_expected(const ClaimsFile& file, const ClaimResult& result);

/// The same result at any number of threads.
VerifyResult verify(const ClaimsFile& file, const VerifyOptions& options = {});

}  // namespace slipproof
