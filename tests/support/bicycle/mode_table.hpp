// Every contact mode of a scene, solved exactly for every force at once.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "mechanics/elements/force_interval.hpp"
#include "support/bicycle/bicycle.hpp"
#include "support/bicycle/contact_mode.hpp"
#include "support/bicycle/continuum.hpp"
#include "support/bicycle/reduction.hpp"

namespace slipproof {

/// One contact mode over alpha + beta F.
class ModeSolution {
 public:
  enum class Kind {
    regular,   ///< one solution for each force
    none,      ///< singular, without a solution for any force
    continuum  ///< singular, with a continuum of solutions for all forces or for one
  };

  ContactMode mode() const { return mode_; }
  Kind kind() const { return kind_; }
  /// The forces for which the mode's conditions hold (non-strict), and those for which all hold strictly.
  const ForceInterval& closed() const { return closed_; }
  const ForceInterval& strict() const { return strict_; }

  /// Regular modes only: a quantity as a function of F.
  Affine<Rational> quantity(Quantity quantity) const;
  Motion<Affine<Rational>> motion() const;
  /// Of a continuum only.
  const Continuum& continuum() const { return *continuum_; }
  const std::shared_ptr<const Continuum>& shared_continuum() const { return continuum_; }

 private:
  friend class ModeTable;

  ContactMode mode_;
  Kind kind_ = Kind::none;
  ForceInterval closed_ = ForceInterval::nothing(), strict_ = ForceInterval::nothing();
  std::optional<ReducedMotion<Rational, Affine<Rational>>> reduced_;  ///< of a regular mode
  std::shared_ptr<const Continuum> continuum_;
};

/// All modes that the scene models: 9 with both wheels on the road, 16 with J. Immutable; safe to read from threads.
class ModeTable {
 public:
  ModeTable(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind);

  /// In the order of all_modes().
  const std::vector<ModeSolution>& solutions() const { return solutions_; }
  /// nullptr for a mode that is not modelled.
  const ModeSolution* find(ContactMode mode) const;

 private:
  using Dynamics = ReducedDynamics<Rational, Affine<Rational>>;
  ModeSolution solve(ContactMode mode, const std::function<const SingularModes&()>& singular) const;
  bool solve_regular(ModeSolution& solution) const;

  std::unique_ptr<const Dynamics> dynamics_;  ///< a stable address: the solutions point into it
  bool detachment_ = false;
  std::vector<ModeSolution> solutions_;
};

}  // namespace slipproof
