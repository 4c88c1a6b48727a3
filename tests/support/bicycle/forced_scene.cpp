#include "support/bicycle/forced_scene.hpp"

#include "base/number/binary64.hpp"

namespace slipproof {

ForcedScene<Rational> to_rational(const ForcedScene<double>& scene) {
  return convert<double, Rational>(scene, [](double x) { return to_rational(x); });
}

ForcedScene<double> nearest_binary64(const ForcedScene<Rational>& scene) {
  return convert<Rational, double>(scene, [](const Rational& x) { return nearest_binary64(x); });
}

}  // namespace slipproof
