// The numbers of a scene as its pictures need them: coordinates, and the names and values of what pushes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mechanics/bodies/bodies.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// `= 3`; `≈ 2.236`.
std::string rounded_value(double x);

/// The length or size that a picture draws for `x`: at most 1e300, so that sums and quotients of sizes are finite.
double drawn_size(const Rational& x);

/// At the scene's load, or at 1 or -1 where it has none.
class SceneNumbers {
 public:
  explicit SceneNumbers(const MechanismScene& scene);

  /// Throw InputError at the place of what has no value.
  Rational exact(const PlacedExpression& placed);
  Rational exact(const Expression& expression) { return exact(PlacedExpression{expression, {}}); }
  double number(const PlacedExpression& placed);
  double number(const Expression& expression);

  /// Its name and value, without the sign, which the arrow shows. A product that has the size of the load has its name.
  std::pair<std::string, std::string> text_of(const PlacedExpression& placed);
  /// The same of a force: of its one coordinate that is not 0, or of the load if it is as large, or all coordinates.
  std::pair<std::string, std::string> name_of(const PlacedVector& force);
  /// Empty where it is a number, or the load has no value.
  std::string value_of(const Expression& named);

 private:
  std::pair<std::string, std::string> text_of_load();

  const MechanismScene& scene_;
  ProblemMaker maker_;
  Evaluator<Rational> at_;
};

}  // namespace slipproof
