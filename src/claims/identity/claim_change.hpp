// A claim before and after a change of the file, and what exact arguments say about the change.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "base/expression/logic.hpp"
#include "claims/identity/identity.hpp"
#include "claims/identity/lemmas.hpp"
#include "claims/paper/compiled.hpp"

namespace slipproof {

/// The effect of a change, and why.
struct Settlement {
  enum class Kind {
    equivalent,  ///< the claim says the same as before
    theorem,     ///< it says something else, which is true for all parameters
    vacuous      ///< it says nothing about the motion: the signs of the parameters alone make it true
  };
  Kind kind = Kind::equivalent;
  std::size_t claim = 0;  ///< the claim that the argument is about; the first if there are several
  std::string argument;   ///< in words
  Lemmas lemmas;          ///< that the argument uses
};

/// All arguments must outlive the change.
class ClaimChange {
 public:
  using Result = std::optional<Settlement>;

  ClaimChange(const ClaimsFile& file, const CompiledClaims& original, const CompiledClaims& changed,
              const Implications& logic, std::size_t claim, const ClaimBody& before, const ClaimBody& after)
      : file_(file),
        original_(original),
        changed_(changed),
        logic_(logic),
        claim_(claim),
        before_(before),
        after_(after) {}

  const ClaimBody& before() const { return before_; }
  const ClaimBody& after() const { return after_; }
  const Implications& in() const { return logic_; }
  std::size_t claim() const { return claim_; }
  const ClaimBody& other(std::size_t claim) const { return file_.claims[claim].printed; }

  Settlement made(Settlement::Kind kind, std::string argument, Lemmas lemmas = {}) const {
    return {kind, claim_, std::move(argument), std::move(lemmas)};
  }
  /// True also if the formula may divide by 0: at such samples it has no value, which is noticed.
  bool was_identity() const { return is_identity(original_); }
  bool is_identity() const { return is_identity(changed_); }
  bool where_differs() const { return !same(before_.region, after_.region) || !same(before_.forces, after_.forces); }
  bool holds_differs() const { return !same(before_.holds, after_.holds); }

 private:
  bool is_identity(const CompiledClaims& claims) const {
    return find_identity(file_, claims, claim_, Reading::printed, nullptr).has_value();
  }

  const ClaimsFile& file_;
  const CompiledClaims &original_, &changed_;
  const Implications& logic_;
  std::size_t claim_;
  const ClaimBody &before_, &after_;
};

/// Whether a formula about motions is true for all parameters and any motion.
inline bool is_true_of_any_motion(const Implications& logic, const ClaimBody& body, Lemmas& lemmas) {
  return body.kind->has("holds") && !body.modes.empty() && logic.implies({}, body.holds, lemmas);
}

}  // namespace slipproof
