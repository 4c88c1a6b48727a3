// The points of a scene's mechanism along one variable.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mechanics/planes/phase_diagram.hpp"
#include "mechanics/points/domain_sampler.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The horizontal variable: tan(angle/2), a parameter, or several of these.
struct AcrossVariable {
  std::string symbol, unit;
  std::optional<std::size_t> angle;
  Rational own;                                                     ///< value of the parameter in the scene
  std::vector<std::pair<std::size_t, Affine<Rational>>> sets = {};  ///< the parameters as functions of the variable
};

/// A parameter, a combined parameter or an angle of the scene. Throws std::invalid_argument, with a message for people.
AcrossVariable find_across(const MechanismScene& scene, const std::string& x);

/// The points of a scene's mechanism across a plane, and the motions there.
class PlaneColumns {
 public:
  PlaneColumns(const MechanismScene& scene, AcrossVariable across)
      : mechanism_(scene.mechanism),
        values_(scene.values),
        across_(std::move(across)),
        maker_(mechanism_),
        sampler_(mechanism_, maker_) {}
  PlaneColumns(const PlaneColumns&) = delete;
  PlaneColumns& operator=(const PlaneColumns&) = delete;

  const Mechanism& mechanism() const { return mechanism_; }
  const AcrossVariable& across() const { return across_; }

  /// The scene's own value; nothing for a half turn.
  std::optional<Rational> own() const;

  /// The values at x, inside or outside the domain; parameters that are tied to x follow it.
  MechanismValues values(const Rational& x) const;

  bool contains(const Rational& x) const { return sampler_.contains(values(x)); }

  /// Nothing if there is no problem.
  std::optional<FrictionProblem> problem(const Rational& x) const;

  std::optional<PhaseColumn> column(const Rational& x) const;

  /// With the numbers of each motion.
  std::vector<LoadCell> numbers(const Rational& x) const;

  /// A condition that does not hold at x; empty if all hold.
  std::string broken(const Rational& x) const;

  /// The parameters that differ from the scene's somewhere between two values of x.
  std::vector<std::string> followers(const Rational& from, const Rational& to) const;

 private:
  const Mechanism mechanism_;
  const MechanismValues values_;
  const AcrossVariable across_;
  const ProblemMaker maker_;
  const DomainSampler sampler_;
};

}  // namespace slipproof
