// The kinetic energy before and after an impact.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mechanics/kernel/polyhedron.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

enum class EnergyBalance : std::uint8_t {
  not_judged,  ///< no impact, or bodies that no impulse changes move and may put energy in
  not_gained,
  undecided,  ///< the range of the energy after holds both
  gained
};
inline constexpr std::size_t energy_balances = 4;

/// At a point of a mechanism that is an impact.
class ImpactEnergy {
 public:
  /// The maker is only used here. Throws NoValue for a division by zero.
  ImpactEnergy(const Mechanism& mechanism, const ProblemMaker& maker, const MechanismValues& values,
               const std::optional<Rational>& load);

  const std::vector<Rational>& velocities() const { return velocities_; }  ///< before, of the unknown accelerations
  const Rational& before() const { return before_; }
  /// Of velocities, as many as those before; others may follow. Exact for points; otherwise a range that holds it.
  Range of(const std::vector<Range>& velocities) const;
  Rational of(const std::vector<Rational>& velocities) const;
  EnergyBalance balance(const Range& after) const;
  /// Whether bodies move that no impulse changes, and may put energy in.
  bool is_driven() const { return driven_; }

 private:
  std::vector<Rational> velocities_;
  std::vector<std::vector<Rational>> masses_;  ///< the matrix of the kinetic energy
  Rational before_;
  bool driven_ = false;
};

}  // namespace slipproof
