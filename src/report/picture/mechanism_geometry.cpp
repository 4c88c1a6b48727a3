#include "report/picture/mechanism_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mechanics/bodies/frame.hpp"
#include "report/picture/scene_numbers.hpp"

namespace slipproof {

namespace {

Point unit(Point vector) {
  const double length = std::hypot(vector[0], vector[1]);
  return length > 0 ? Point{vector[0] / length, vector[1] / length} : Point{0, 0};
}
Point opposite(Point vector) {
  return {-vector[0], -vector[1]};
}
/// From one place to another, or back where the size is negative.
Point direction(double size, Point from, Point to) {
  const Point along = unit({to[0] - from[0], to[1] - from[1]});
  return size < 0 ? opposite(along) : along;
}

class GeometryReader {
 public:
  explicit GeometryReader(const MechanismScene& scene) : scene_(scene), numbers_(scene) {}

  MechanismGeometry read(bool still) {
    MechanismGeometry geometry;
    for (const MechanismShape& shape : scene_.mechanism.shapes) {
      if (still || !shape.still) this->shape(shape, geometry);
    }
    for (std::size_t i = 0; i < scene_.mechanism.contacts.size(); ++i) {
      if (!scene_.mechanism.contacts[i].at.empty()) geometry.contacts.push_back(contact(i));
    }
    const auto& load = scene_.mechanism.load;
    if (load && (load->unit.empty() || load->unit == "N")) take_load_arrows(geometry);
    if (scene_.mechanism.bodies) add_bodies(*scene_.mechanism.bodies, geometry);
    return geometry;
  }

 private:
  void shape(const MechanismShape& shape, MechanismGeometry& geometry) {
    std::vector<Point> points;
    for (const auto& point : shape.points) points.push_back(pair(point));
    if (shape.force || !shape.acceleration.empty()) {
      return shape.force ? add_push(shape, points[0], points[1], geometry)
                         : add_acceleration(shape, points[0], direction(1, points[0], points[1]), geometry);
    }
    double radius = shape.radius ? number(shape.radius) : 0;
    if (shape.kind == MechanismShape::Kind::circle) radius = std::abs(radius);
    geometry.outlines.push_back({shape.kind, std::move(points), radius, shape.text, shape.thin, bodies_of(shape)});
    place_before_ = shape.place;
  }

  /// What is derived from bodies has the place of what it is derived from.
  std::optional<std::array<std::size_t, 2>> bodies_of(const MechanismShape& shape) const {
    if (!scene_.mechanism.bodies) return std::nullopt;
    const Bodies& bodies = *scene_.mechanism.bodies;
    const auto has_place = [&](const auto& part) { return part.place == shape.place; };
    for (std::size_t i = 0; i < bodies.bodies.size(); ++i) {
      if (has_place(bodies.bodies[i]) || std::ranges::any_of(bodies.bodies[i].shapes, has_place)) return {{i, i}};
    }
    for (const BodyContact& contact : bodies.contacts) {
      if (!has_place(contact)) continue;
      const bool first = contact.radius && bodies.bodies[contact.of].shapes.empty() && place_before_ != shape.place;
      const std::size_t body = first ? contact.of : contact.on;
      return {{body, body}};
    }
    for (const BodyJoint& joint : bodies.joints) {
      if (!has_place(joint)) continue;
      return {{joint.kind == BodyJoint::Kind::pin ? joint.second : joint.first, joint.second}};
    }
    return std::nullopt;
  }

  void add_push(const MechanismShape& shape, Point at, Point to, MechanismGeometry& geometry) {
    const double size = number(shape.force);
    if (size == 0) return;
    const auto [name, value] = text_of(shape.force);
    geometry.pushes.push_back(
        {at, direction(size, at, to), std::abs(size), shape.text.empty() ? name : shape.text, value, true});
  }

  void add_acceleration(const MechanismShape& shape, Point at, Point along, MechanismGeometry& geometry) {
    const auto names = acceleration_names(scene_.mechanism);
    const auto index = static_cast<std::size_t>(std::ranges::find(names, shape.acceleration) - names.begin());
    geometry.accelerations.push_back({at, along, index, shape.text.empty() ? shape.acceleration : shape.text});
  }

  /// An arrow with the symbol of the load, a force, at one end shows the load, and acts at its other end.
  void take_load_arrows(MechanismGeometry& geometry) {
    using Kind = MechanismShape::Kind;
    auto& outlines = geometry.outlines;
    const double size = number(make_symbol(scene_.mechanism.load->symbol));
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      if (outlines[i].kind != Kind::arrow) continue;
      const Point from = outlines[i].points[0], to = outlines[i].points[1];
      const auto label = std::ranges::find_if(outlines, [&](const auto& other) {
        return other.kind == Kind::label && !other.points.empty() && other.text == scene_.mechanism.load->symbol &&
               (other.points[0] == from || other.points[0] == to);
      });
      if (label == outlines.end()) continue;
      const bool begins = label->points[0] == to;
      if (size != 0)
        geometry.pushes.push_back({begins ? from : to, direction(size, from, to), std::abs(size), label->text,
                                   numbers_.value_of(make_symbol(label->text)), begins});
      label->points.clear(), outlines[i].points.clear();
    }
    std::erase_if(outlines, [](const auto& outline) { return outline.points.empty(); });
  }

  void add_bodies(const Bodies& bodies, MechanismGeometry& geometry) {
    frames_ = bodies_in_motion::frames(bodies);
    for (const BodyForce& force : bodies.forces) add_force(force, geometry.pushes);
    for (const BodyTorque& torque : bodies.torques) {
      const double size = number(torque.is.z);
      if (size == 0) continue;
      const auto [name, value] = text_of(torque.is.z);
      geometry.pushes.push_back({point(frames_[torque.on].at), {0, 0}, size, name, value});
      if (torque.back_on && *torque.back_on != ground)
        geometry.pushes.push_back({point(frames_[*torque.back_on].at), {0, 0}, -size, name, value});
    }
    for (const BodyJoint& joint : bodies.joints) {
      if (joint.kind == BodyJoint::Kind::spring) add_spring(joint, geometry.pushes);
    }
    for (std::size_t i = ground + 1; i < frames_.size(); ++i) add_movement(bodies.bodies[i], frames_[i], geometry);
    if (bodies.gravity) add_weights(bodies, geometry);
  }

  void add_force(const BodyForce& force, std::vector<MechanismGeometry::Push>& pushes) {
    const bodies_in_motion::SceneVector is = bodies_in_motion::unplaced(force.is);
    const bodies_in_motion::Frame& on = frames_[force.on];
    const bodies_in_motion::SceneVector push = force.follows ? on.in_scene(is) : is;
    const Rational x = exact(push.x), y = exact(push.y), larger = std::max(abs(x), abs(y));
    if (larger.is_zero()) return;
    const Point place = point(on.at + on.in_scene(bodies_in_motion::unplaced(force.at))),
                along = unit({drawn_size(x / larger), drawn_size(y / larger)});
    const double size = std::hypot(drawn_size(x), drawn_size(y));
    const auto [name, value] = numbers_.name_of(force.is);
    pushes.push_back({place, along, size, name, value});
    if (force.back_on && *force.back_on != ground) pushes.push_back({place, opposite(along), size, name, value});
  }

  void add_spring(const BodyJoint& joint, std::vector<MechanismGeometry::Push>& pushes) {
    const auto end = [&](std::size_t body, const PlacedVector& own) {
      return point(frames_[body].at + frames_[body].in_scene(bodies_in_motion::unplaced(own)));
    };
    const Point first = end(joint.first, joint.at), second = end(joint.second, joint.to);
    const double tension = number(joint.tension);
    if (tension == 0) return;
    const Point pull = direction(tension, first, second);
    const auto [name, value] = text_of(joint.tension);
    if (joint.first != ground) pushes.push_back({first, pull, std::abs(tension), name, value, true});
    if (joint.second != ground) pushes.push_back({second, opposite(pull), std::abs(tension), name, value, true});
  }

  void add_movement(const Body& body, const bodies_in_motion::Frame& frame, MechanismGeometry& geometry) {
    const bool massless = body.mass && exact(body.mass).is_zero();  // others show how it moves along
    const Point velocity = massless ? Point{0, 0} : point(frame.velocity);
    const MechanismGeometry::Movement movement{point(frame.at), velocity, number(frame.spin.z), body.name};
    if (movement.velocity != Point{0, 0} || movement.spin != 0) geometry.movements.push_back(movement);
  }

  void add_weights(const Bodies& bodies, MechanismGeometry& geometry) {
    const bodies_in_motion::SceneVector gravity = bodies_in_motion::unplaced(bodies.gravity);
    const Rational gx = exact(gravity.x), gy = exact(gravity.y), square = gx * gx + gy * gy;
    if (square.is_zero()) return;
    const Point down = point(gravity);
    for (std::size_t i = ground + 1; i < frames_.size(); ++i) {
      const Expression mass = bodies_in_motion::unplaced(bodies.bodies[i].mass);
      const double size = number(mass) * std::hypot(down[0], down[1]);
      if (!(size > 0)) continue;
      const auto root = exact_root(square);
      const auto weight = root ? std::optional<Rational>(exact(mass) * *root) : std::nullopt;
      geometry.weights.push_back({point(frames_[i].at), size, weight, bodies.bodies[i].name});
    }
    if (gx.is_zero() && gy < 0) return;
    const Point to = unit(down);
    turn(geometry, -to[1], -to[0]);
  }

  /// Turns all, counterclockwise.
  static void turn(MechanismGeometry& geometry, double cosine, double sine) {
    const auto turn = [&](Point& p) { p = {p[0] * cosine - p[1] * sine, p[0] * sine + p[1] * cosine}; };
    for (auto& outline : geometry.outlines) {
      for (Point& p : outline.points) turn(p);
    }
    for (auto& contact : geometry.contacts) turn(contact.at), turn(contact.normal), turn(contact.along);
    for (auto& push : geometry.pushes) turn(push.at), turn(push.along);
    for (auto& acceleration : geometry.accelerations) turn(acceleration.at), turn(acceleration.along);
    for (auto& weight : geometry.weights) turn(weight.at);
    for (auto& movement : geometry.movements) turn(movement.at), turn(movement.velocity);
    geometry.turned = std::atan2(sine, cosine);
  }

  std::pair<std::string, std::string> text_of(const PlacedExpression& placed) { return numbers_.text_of(placed); }
  Rational exact(const PlacedExpression& placed) { return numbers_.exact(placed); }
  Rational exact(const Expression& expression) { return numbers_.exact(expression); }
  double number(const PlacedExpression& placed) { return numbers_.number(placed); }
  double number(const Expression& expression) { return numbers_.number(expression); }
  Point point(const bodies_in_motion::SceneVector& v) { return {number(v.x), number(v.y)}; }
  Point pair(const std::vector<PlacedExpression>& two) { return {number(two[0]), number(two[1])}; }

  MechanismGeometry::Contact contact(std::size_t index) {
    const MechanismContact& given = scene_.mechanism.contacts[index];
    MechanismGeometry::Contact contact{index, pair(given.at), {0, 0}, {0, 0}};
    if (!given.direction.empty()) contact.normal = unit(pair(given.direction));
    // Slip is positive to the right, or upwards, unless the file gives a direction.
    contact.along = {contact.normal[1], -contact.normal[0]};
    const bool left = contact.along[0] < 0, down = contact.along[0] == 0 && contact.along[1] < 0;
    if (left || down) contact.along = opposite(contact.along);
    if (!given.slip_direction.empty()) contact.along = unit(pair(given.slip_direction));
    return contact;
  }

  const MechanismScene& scene_;
  SceneNumbers numbers_;
  std::vector<bodies_in_motion::Frame> frames_;
  Place place_before_{};  ///< of the shape before: the two discs of a contact have one place
};

}  // namespace

MechanismGeometry geometry_of(const MechanismScene& scene, bool still) {
  return GeometryReader(scene).read(still);
}

double least_distance(const MechanismGeometry& geometry, double fused) {
  double least = std::numeric_limits<double>::infinity();
  for (const MechanismGeometry::Contact& one : geometry.contacts) {
    for (const MechanismGeometry::Contact& other : geometry.contacts) {
      const double apart = std::hypot(one.at[0] - other.at[0], one.at[1] - other.at[1]);
      if (apart > fused) least = std::min(least, apart);
    }
  }
  return least;
}

}  // namespace slipproof
