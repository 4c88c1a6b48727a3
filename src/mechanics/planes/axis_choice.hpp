// The axes of a plane: what is asked for, and where nothing is, what shows the scene.
#pragma once

#include "mechanics/family/freed_scene.hpp"
#include "mechanics/planes/mechanism_plane.hpp"

namespace slipproof {

/// Chooses those ends of both axes that are not given. Throws std::invalid_argument, with a message for people. What it
/// is made of must outlive it.
class AxisChoice {
 public:
  AxisChoice(const FreedScene& freed, const MechanismScene& scene, const MechanismAxes& wanted)
      : freed_(freed), scene_(scene), wanted_(wanted) {}

  Axis across() const;

  /// The loads around the scene's at which something changes at one value of x, with a margin; loads that are many
  /// times larger are left out and listed.
  struct Up {
    Axis axis;
    std::vector<Rational> beyond;  ///< where something changes outside
  };
  Up up(const Axis& across) const;
  /// In space, where no problem has all loads: those that are wanted, or from 0 to twice the scene's.
  Axis up_in_space() const;

 private:
  using Ends = std::pair<Rational, Rational>;

  Rational end(const std::string& symbol, const Rational& given) const;

  /// The range in the domain around the scene's own angle; at most +-90 degrees unless that angle is larger.
  Ends angle_range() const;

  /// From zero to twice the scene's own value; on both sides of zero if the other sign is possible.
  Ends parameter_range(const std::string& symbol) const;

  /// Requires that some neighbouring values are in the domain.
  void expect_inside(const Axis& axis) const;

  /// The scene's own x if it is inside; otherwise the value in the domain that is nearest to the middle.
  Rational typical(const Axis& axis) const;

  std::vector<Rational> changes(const std::optional<FrictionProblem>& problem) const;
  /// How far from 0 the loads go that are shown.
  Rational reach(std::vector<Rational> changes) const;

  const FreedScene& freed_;
  const MechanismScene& scene_;
  const MechanismAxes& wanted_;
};

}  // namespace slipproof
