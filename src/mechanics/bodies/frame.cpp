#include "mechanics/bodies/frame.hpp"

namespace slipproof::bodies_in_motion {

namespace {

Expression without_columns(const Expression& expression) {
  Node node = *expression;
  node.column = 0;
  for (Expression& operand : node.operands) operand = without_columns(operand);
  return std::make_shared<const Node>(std::move(node));
}

Expression acceleration_of(const Body::Unknown& unknown, const PlacedExpression& prescribed) {
  if (unknown.symbol.empty()) return unplaced(prescribed);
  const Expression symbol = make_symbol(unknown.symbol);
  return unknown.negated ? negative_of(symbol) : symbol;
}

}  // namespace

Expression unplaced(const PlacedExpression& placed) {
  return placed ? without_columns(placed.expression) : zero_literal();
}

PlanarVector unplaced(const PlacedPair& pair) {
  return {unplaced(pair.x), unplaced(pair.y)};
}

Frame::Frame(const Body& body)
    : at(unplaced(body.at)),
      cosine(body.cosine ? unplaced(body.cosine) : make_number(1)),
      sine(unplaced(body.sine)),
      velocity(unplaced(body.velocity)),
      spin(unplaced(body.spin)),
      acceleration{acceleration_of(body.ax, body.acceleration.x), acceleration_of(body.ay, body.acceleration.y)},
      turning(acceleration_of(body.alpha, body.turning)) {}

PlanarVector Frame::in_scene(const PlanarVector& own) const {
  return {minus(times(own.x, cosine), times(own.y, sine)), plus(times(own.x, sine), times(own.y, cosine))};
}

PlanarVector Frame::in_body(const PlanarVector& scene) const {
  return {plus(times(scene.x, cosine), times(scene.y, sine)), minus(times(scene.y, cosine), times(scene.x, sine))};
}

PlanarVector Frame::velocity_at(const PlanarVector& arm) const {
  return velocity + spin * turned(arm);
}

PlanarVector Frame::acceleration_at(const PlanarVector& arm) const {
  const Expression square = is_literal_zero(spin) ? spin : make_power(spin, 2);
  return acceleration + turning * turned(arm) - square * arm;
}

std::vector<Frame> frames(const Bodies& bodies) {
  std::vector<Frame> result;
  for (const Body& body : bodies.bodies) result.emplace_back(body);
  return result;
}

MovingPoint::MovingPoint(const Frame& frame, const PlanarVector& own) {
  const PlanarVector arm = frame.in_scene(own);
  place = frame.at + arm;
  velocity = frame.velocity_at(arm);
  acceleration = frame.acceleration_at(arm);
}

/// Coriolis: what the observer sees changes by 2 (spin x the velocity that it sees) beside what its own points do.
RelativePoint::RelativePoint(const MovingPoint& point, const Frame& observer) {
  const PlanarVector arm = point.place - observer.at;
  velocity = point.velocity - observer.velocity_at(arm);
  acceleration =
      point.acceleration - observer.acceleration_at(arm) - times(make_number(2), observer.spin) * turned(velocity);
}

}  // namespace slipproof::bodies_in_motion
