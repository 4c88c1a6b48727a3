// Modes and motions by their definition, each from its raw equations and conditions: what the kernel is compared with.
#pragma once

#include <map>
#include <set>
#include <string>

#include "mechanics/kernel/fourier_motzkin.hpp"
#include "mechanics/kernel/motions.hpp"

namespace slipproof::test {

struct NaiveMode {
  std::string name;  ///< states joined by `/`
  std::vector<AffineForm> equations, conditions;

  /// Its equations and those of the problem; with its conditions, strict or not; in the domain, or at a load.
  RawSystem equations_only(const FrictionProblem& problem, const std::optional<Rational>& load) const;
  RawSystem closed(const FrictionProblem& problem, const std::optional<Rational>& load) const;
  RawSystem strict(const FrictionProblem& problem, const std::optional<Rational>& load) const;
};

/// All modes, in the order of the mechanism; written from the table of states, not from
/// src/mechanics/elements/element.cpp.
std::vector<NaiveMode> naive_modes(const FrictionProblem& problem);

struct NaiveMotion {
  std::set<std::string> modes, boundary_modes, continua;
  std::vector<ForceInterval> forces;  ///< the least intervals that hold those of all of its modes
};

struct NaiveMotions {
  std::map<std::vector<Rational>, NaiveMotion> motions;  ///< by their accelerations
  /// The ranges of accelerations, then forces, and whether it is strict.
  std::map<std::string, std::pair<std::vector<ForceInterval>, bool>> continua;
  std::set<std::string> consistent, hysteresis;
};

/// At a load; nothing, of a problem without one.
NaiveMotions naive_motions(const FrictionProblem& problem, const std::vector<NaiveMode>& modes,
                           const std::optional<Rational>& load);

}  // namespace slipproof::test
