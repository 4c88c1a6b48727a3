// The judgements of unchanged claims at samples; their mutants are compared with these.
#pragma once

#include <memory>
#include <vector>

#include "claims/mutation/mutation.hpp"
#include "claims/paper/compiled.hpp"
#include "mechanics/family/solved_sample.hpp"

namespace slipproof {

using Samples = std::vector<std::unique_ptr<SolvedSample>>;

/// The judgement of an unchanged claim at a sample.
struct Baseline {
  Outcome outcome = Outcome::outside;
  bool speaks = false;  ///< it holds, and says something about some force
  std::vector<ForceInterval> reach;
};

class Baselines {
 public:
  /// All arguments must outlive it.
  Baselines(const ClaimsFile& file, const CompiledClaims& compiled, const MutationOptions& options)
      : file_(file),
        compiled_(compiled),
        options_(options),
        samples_(file.settings.size()),
        baselines_(file.claims.size()) {}

  /// Solves samples of a setting, up to a given number, and judges the given claims of the setting there.
  void solve(std::size_t s, std::uint64_t count, const std::vector<std::size_t>& claims);

  /// The samples of a setting; null: no bicycle was found.
  const Samples& samples(std::size_t setting) const { return samples_[setting]; }
  /// The indices of the samples that are bicycles, starting at `first`.
  std::vector<std::size_t> samples_from(std::size_t setting, std::size_t first) const;
  /// The baselines of a claim, by sample of its setting.
  const std::vector<Baseline>& of(std::size_t claim) const { return baselines_[claim]; }
  /// The first bicycles among the samples at which a claim says something about a force; if there are none, at which it
  /// holds.
  std::vector<std::vector<Rational>> speaks_at(std::size_t claim) const;

 private:
  Baseline baseline_of(std::size_t claim, SolvedSample& sample) const;

  const ClaimsFile& file_;
  const CompiledClaims& compiled_;
  const MutationOptions& options_;
  std::vector<Samples> samples_;                  ///< by setting
  std::vector<std::vector<Baseline>> baselines_;  ///< by claim and sample
};

}  // namespace slipproof
