// Contacts that approach in a step of an engine: a law of impact beside the law of friction (LAWS.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof {

enum class ImpactLaw : std::uint8_t;  ///< mechanics/mechanism/mechanism.hpp
struct ProblemFile;

/// A law of impact with what it needs. Newton's and Moreau's: what contact problems of one phase can state.
struct StepImpact {
  ImpactLaw law{};
  std::vector<double> restitution;             ///< of each contact, from 0 to 1
  std::vector<double> tangential_restitution;  ///< the same; empty: 0
  /// Velocities before: of contacts, by component, in the local form; of bodies in the global one.
  std::vector<double> before;
};

/// The keys of a problem's file for it.
inline constexpr const char* velocities_before_key(bool global) {
  return global ? "v_before" : "u_before";
}

/// Both exactly, by component; of a problem with an impact, checked. Linear.
/// Velocities of contacts before: u_before, or H^T v_before + w.
std::vector<Rational> velocities_before(const ProblemFile& problem);
/// What the law of impact adds to u: e u_N before, by Newton's law where that approaches, and e_T u_T before.
std::vector<Rational> restored_velocities(const ProblemFile& problem);
/// By how much the constants of u change that they are added to in binary64; 0 without an impact.
double rounding_of_restored(const ProblemFile& problem);

}  // namespace slipproof
