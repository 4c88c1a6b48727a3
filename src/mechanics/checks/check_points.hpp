// Inside the checks: points of the domain at which a mechanism is tried, and which of their values matter.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/points/problem.hpp"

namespace slipproof::mechanism_checks {

struct CheckPoint {
  MechanismValues values;
  FrictionProblem problem;
};

class CheckPoints {
 public:
  /// A check needs at least `needed` points; checks that solve equations use at most `enough`.
  static constexpr std::size_t needed = 4, enough = 8;

  /// The mechanism must outlive the points.
  explicit CheckPoints(const Mechanism& mechanism);

  const Mechanism& mechanism() const { return *mechanism_; }
  const ProblemMaker& maker() const { return maker_; }
  /// Up to 48 points at which all forms have values; the same for the same mechanism.
  const std::vector<CheckPoint>& all() const { return points_; }

  /// Something that is computed at a point; nothing where it has no value.
  using Quantity = std::function<std::optional<Rational>(const CheckPoint&)>;
  /// ", at m = 1, b = 1/2": the values on which the quantity depends there; empty if it depends on none.
  std::string where(const CheckPoint& point, const Quantity& quantity) const;

  /// The point with every push 0, if the domain allows it. A push is a parameter that occurs only in constants of the
  /// equations and motions, and is not gravity.
  CheckPoint without_pushes(const CheckPoint& point) const;
  /// Whether a push is not 0.
  bool is_pushed(const CheckPoint& point) const;

 private:
  std::optional<Rational> at(const MechanismValues& values, const Quantity& quantity) const;
  std::vector<std::size_t> find_pushes() const;

  const Mechanism* mechanism_;
  ProblemMaker maker_;
  std::vector<CheckPoint> points_;
  std::vector<std::size_t> pushes_;  ///< indices of parameters
};

/// A parameter g, or one in m/s^2 that is positive: what may be 0 is the acceleration of something that moves.
bool is_gravity(const Mechanism& mechanism, const MechanismParameter& parameter);
/// Whether a parameter is gravity, or bodies have one.
bool has_gravity(const Mechanism& mechanism);

}  // namespace slipproof::mechanism_checks
