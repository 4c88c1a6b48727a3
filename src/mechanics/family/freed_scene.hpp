// A scene in which a symbol is freed: its points one by one, and the family that they are.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mechanics/family/family.hpp"
#include "mechanics/points/domain_sampler.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// What is freed: a parameter, tan(angle/2), or a number that several parameters follow.
struct FreeSymbol {
  std::string symbol, unit;
  std::optional<std::size_t> angle;
  Rational own;                                                     ///< value of the parameter in the scene
  std::vector<std::pair<std::size_t, Affine<Rational>>> sets = {};  ///< the parameters as functions of it
};

/// A parameter, a combined parameter or an angle of the scene. Throws std::invalid_argument, with a message for people.
FreeSymbol find_symbol(const MechanismScene& scene, const std::string& symbol);
/// The same for a parameter that the scene must give.
FreeSymbol find_parameter(const MechanismScene& scene, const std::string& symbol);

class FreedScene {
 public:
  /// What other parameters do that an equation of the domain ties to the free symbol.
  enum class Tied : std::uint8_t {
    stay,   ///< as in the scene
    follow  ///< the last parameter in the equation does what it requires
  };
  FreedScene(const MechanismScene& scene, FreeSymbol free, Tied tied);
  FreedScene(const FreedScene&) = delete;
  FreedScene& operator=(const FreedScene&) = delete;

  const Mechanism& mechanism() const { return *mechanism_; }
  const FreeSymbol& free() const { return free_; }

  /// The scene's own value; nothing for a half turn.
  std::optional<Rational> own() const;
  /// The values at x, inside or outside the domain.
  MechanismValues values(const Rational& x) const;
  bool contains(const Rational& x) const { return sampler_.contains(values(x)); }
  /// Nothing outside the domain, and where a coefficient has no value.
  std::optional<FrictionProblem> problem(const Rational& x) const;
  /// A condition that does not hold at x; empty if all hold.
  std::string broken(const Rational& x) const;
  /// The parameters that differ from the scene's somewhere between two values of x.
  std::vector<std::string> followers(const Rational& from, const Rational& to) const;

  /// The family with a free parameter, under every load; tied parameters stay.
  Family family() const;

 private:
  const std::shared_ptr<const Mechanism> mechanism_;
  const MechanismValues values_;
  const FreeSymbol free_;
  const Tied tied_;
  const ProblemMaker maker_;
  const DomainSampler sampler_;
};

}  // namespace slipproof
