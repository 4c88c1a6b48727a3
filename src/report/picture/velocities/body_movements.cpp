#include "report/picture/velocities/body_movements.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/bodies/frame.hpp"
#include "report/picture/scene_numbers.hpp"

namespace slipproof {

namespace {

Point turned_by(double angle, Point p) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  return {p[0] * cosine - p[1] * sine, p[0] * sine + p[1] * cosine};
}

}  // namespace

Point BodyMovement::after(double time, Point point) const {
  const auto gone = [&](double rate, double growth) { return rate * time + growth * time * time / 2; };
  const Point arm = turned_by(gone(spin, turning), {point[0] - at[0], point[1] - at[1]});
  return {at[0] + gone(velocity[0], acceleration[0]) + arm[0], at[1] + gone(velocity[1], acceleration[1]) + arm[1]};
}

std::vector<BodyMovement> body_movements(const MechanismScene& scene, const MotionAtLoad& motion, double turned) {
  std::vector<BodyMovement> result;
  if (!scene.mechanism.bodies) return result;
  const auto names = acceleration_names(scene.mechanism);
  SceneNumbers numbers(scene);
  const auto acceleration = [&](const Body::Unknown& unknown, const PlacedExpression& prescribed) {
    if (unknown.symbol.empty()) return prescribed ? numbers.number(prescribed) : 0;
    const auto index = static_cast<std::size_t>(std::ranges::find(names, unknown.symbol) - names.begin());
    const double value = drawn_size(motion.accelerations[index]);
    return unknown.negated ? -value : value;
  };
  for (const Body& body : scene.mechanism.bodies->bodies) {
    const bodies_in_motion::Frame frame(body);
    const auto point = [&](const bodies_in_motion::SceneVector& v) {
      return turned_by(turned, {numbers.number(v.x), numbers.number(v.y)});
    };
    BodyMovement& moves = result.emplace_back();
    moves.at = point(frame.at);
    moves.velocity = point(frame.velocity);
    moves.spin = numbers.number(frame.spin.z);
    moves.acceleration = turned_by(turned, {acceleration(body.unknowns[0], body.acceleration.x),
                                            acceleration(body.unknowns[1], body.acceleration.y)});
    moves.turning = acceleration(body.unknowns[5], body.turning.z);
  }
  return result;
}

}  // namespace slipproof
