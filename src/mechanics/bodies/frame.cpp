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

SceneVector unplaced(const PlacedVector& placed) {
  return {unplaced(placed.x), unplaced(placed.y), unplaced(placed.z)};
}

Turn::Turn(const Body& body) {
  if (!body.rotation.empty()) {
    by_entries(body.rotation);
  } else if (body.quaternion[0]) {
    by_quaternion({unplaced(body.quaternion[0]), unplaced(body.quaternion[1]), unplaced(body.quaternion[2]),
                   unplaced(body.quaternion[3])});
  } else if (body.turn_axis) {
    about(unplaced(body.turn_axis), unplaced(body.cosine), unplaced(body.sine));
  } else {
    by_angle(body.cosine ? unplaced(body.cosine) : make_number(1), unplaced(body.sine));
  }
}

void Turn::by_entries(const std::vector<Expression>& rotation) {
  for (std::size_t i = 0; i < rotation.size(); ++i) entries_[i / 3][i % 3].value = rotation[i];
}

void Turn::by_angle(const Expression& cosine, const Expression& sine) {
  entries_[0][0].value = entries_[1][1].value = cosine;
  entries_[1][0].value = sine;
  entries_[0][1] = {sine, true};
  entries_[2][2].value = make_number(1);
}

/// Over the square of the quaternion's length, which may be any: so the entries are rational.
void Turn::by_quaternion(const std::array<Expression, 4>& q) {
  const SceneVector v{q[1], q[2], q[3]};
  const Expression two = make_number(2), square = dot(v, v), length = plus(times(q[0], q[0]), square);
  const Expression own = minus(times(q[0], q[0]), square);
  for (std::size_t i = 0; i < 3; ++i) {
    const SceneVector around = cross(v, axis(i));  // column i: (w^2 - v^2) e + 2 v (v.e) + 2 w v x e
    for (std::size_t j = 0; j < 3; ++j) {
      const Expression mixed = times(two, plus(times(v[j], v[i]), times(q[0], around[j])));
      entries_[j][i].value = folded(over(i == j ? plus(own, mixed) : mixed, length));
    }
  }
}

/// By Rodrigues.
void Turn::about(const SceneVector& about, const Expression& cosine, const Expression& sine) {
  const Expression rest = minus(make_number(1), cosine);
  for (std::size_t i = 0; i < 3; ++i) {
    const SceneVector column = cosine * axis(i) + times(rest, about[i]) * about + sine * cross(about, axis(i));
    for (std::size_t j = 0; j < 3; ++j) entries_[j][i].value = column[j];
  }
}

Expression Turn::entry(std::size_t row, std::size_t column) const {
  const Entry& entry = entries_[row][column];
  return entry.negated ? negative_of(entry.value) : entry.value;
}

namespace {

/// entries[k] * vector[k], those that are subtracted at last.
template <class EntryAt>
Expression turned(const SceneVector& vector, const EntryAt& entry) {
  Expression sum = zero_literal();
  for (std::size_t k = 0; k < 3; ++k) {
    if (!entry(k).negated) sum = plus(sum, times(vector[k], entry(k).value));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (entry(k).negated) sum = minus(sum, times(vector[k], entry(k).value));
  }
  return sum;
}

}  // namespace

SceneVector Turn::in_scene(const SceneVector& own) const {
  const auto row = [&](std::size_t i) {
    return turned(
        own, [&](std::size_t k) -> auto& { return entries_[i][k]; });
  };
  return {row(0), row(1), row(2)};
}

SceneVector Turn::in_body(const SceneVector& scene) const {
  const auto row = [&](std::size_t i) {
    return turned(
        scene, [&](std::size_t k) -> auto& { return entries_[k][i]; });
  };
  return {row(0), row(1), row(2)};
}

Frame::Frame(const Body& body)
    : at(unplaced(body.at)),
      turn(body),
      velocity(unplaced(body.velocity)),
      spin(unplaced(body.spin)),
      acceleration{acceleration_of(body.unknowns[0], body.acceleration.x),
                   acceleration_of(body.unknowns[1], body.acceleration.y),
                   acceleration_of(body.unknowns[2], body.acceleration.z)},
      turning{acceleration_of(body.unknowns[3], body.turning.x), acceleration_of(body.unknowns[4], body.turning.y),
              acceleration_of(body.unknowns[5], body.turning.z)} {}

SceneVector Frame::velocity_at(const SceneVector& arm) const {
  return velocity + cross(spin, arm);
}

/// With spin x (spin x arm) = spin (spin . arm) - spin^2 arm.
SceneVector Frame::acceleration_at(const SceneVector& arm) const {
  Expression square = zero_literal();
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_literal_zero(spin[i])) square = plus(square, make_power(spin[i], 2));
  }
  return acceleration + cross(turning, arm) - square * arm + dot(spin, arm) * spin;
}

std::vector<Frame> frames(const Bodies& bodies) {
  std::vector<Frame> result;
  for (const Body& body : bodies.bodies) result.emplace_back(body);
  return result;
}

MovingPoint::MovingPoint(const Frame& frame, const SceneVector& own) {
  const SceneVector arm = frame.in_scene(own);
  place = frame.at + arm;
  velocity = frame.velocity_at(arm);
  acceleration = frame.acceleration_at(arm);
}

/// Coriolis: what the observer sees changes by 2 (spin x the velocity that it sees) beside what its own points do.
RelativePoint::RelativePoint(const MovingPoint& point, const Frame& observer) {
  const SceneVector arm = point.place - observer.at;
  velocity = point.velocity - observer.velocity_at(arm);
  acceleration = point.acceleration - observer.acceleration_at(arm) - cross(make_number(2) * observer.spin, velocity);
}

}  // namespace slipproof::bodies_in_motion
