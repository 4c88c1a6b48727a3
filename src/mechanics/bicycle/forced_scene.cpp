#include "mechanics/bicycle/forced_scene.hpp"

#include "base/number/binary64.hpp"

namespace slipproof {

ForcedScene<Rational> to_rational(const ForcedScene<double>& scene) {
  return convert<double, Rational>(scene, [](double x) { return to_rational(x); });
}

}  // namespace slipproof
