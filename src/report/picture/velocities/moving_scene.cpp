#include "report/picture/velocities/moving_scene.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "mechanics/bodies/bodies.hpp"

namespace slipproof {

MechanismScene moving_scene(MechanismScene scene, const std::vector<std::string>& unknowns,
                            const std::vector<Rational>& velocities) {
  if (!scene.mechanism.bodies) return scene;
  const auto bodies = std::make_shared<Bodies>(*scene.mechanism.bodies);
  for (Body& body : bodies->bodies) {
    std::array<PlacedExpression*, 6> parts{&body.velocity.x, &body.velocity.y, &body.velocity.z,
                                           &body.spin.x,     &body.spin.y,     &body.spin.z};
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const auto found = std::ranges::find(unknowns, body.unknowns[k].symbol);
      if (body.unknowns[k].symbol.empty() || found == unknowns.end()) continue;
      const Rational& velocity = velocities[static_cast<std::size_t>(found - unknowns.begin())];
      *parts[k] = {make_number(body.unknowns[k].negated ? Rational(-velocity) : velocity), {}};
    }
  }
  scene.mechanism.bodies = bodies;
  return scene;
}

}  // namespace slipproof
