// Exact arguments for changes of a claims file that no sample tells apart: they say the same, or what is true, too.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "claims/identity/lemmas.hpp"
#include "claims/mutation/claims_mutants.hpp"

namespace slipproof {

/// What a change comes to, and why.
struct Settlement {
  enum class Kind {
    equivalent,  ///< it says the same
    theorem,     ///< it says something else, which is true for all parameters
    vacuous      ///< it says nothing about the motion: the signs of the parameters make it true
  };
  Kind kind = Kind::equivalent;
  std::size_t claim = 0;  ///< that the argument is about, the first of several
  std::string argument;   ///< in words
  Lemmas lemmas;          ///< what it rests on
};

/// Settles mutants of one claims file with one reading, with proofs from a book. Not shared between threads.
class Settler {
 public:
  /// What is given must outlive it.
  Settler(const ClaimsFile& file, const CompiledClaims& compiled, LemmaBook& book);
  ~Settler();
  Settler(const Settler&) = delete;
  Settler& operator=(const Settler&) = delete;

  /// `changed` is `compiled` with the mutant. Nothing: no argument was found.
  std::optional<Settlement> settle(const ClaimsMutant& mutant, const CompiledClaims& changed);

  /// A claim about motions, by its index, that is true of all parameters whatever the motion.
  bool is_vacuous(std::size_t claim);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slipproof
