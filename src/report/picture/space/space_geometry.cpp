#include "report/picture/space/space_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/bodies/frame.hpp"

namespace slipproof {

namespace {

/// A body in numbers.
struct NumberFrame {
  Vec3 at{};
  std::array<Vec3, 3> axes{};  ///< of the body, in the scene

  Vec3 in_scene(const Vec3& own) const { return own[0] * axes[0] + own[1] * axes[1] + own[2] * axes[2]; }
  Vec3 place(const Vec3& own) const { return at + in_scene(own); }
};

class SpaceReader {
 public:
  explicit SpaceReader(const MechanismScene& scene)
      : scene_(scene), m_(scene.mechanism), bodies_(*m_.bodies), numbers_(scene) {}

  SpaceGeometry read() {
    if (bodies_.gravity) {
      const Vec3 down = vector(bodies_.gravity);
      if (length(down) > 0) result_.up = direction_of(-1 * down);
    }
    result_.is_impact = m_.impact.has_value();
    result_.has_units = std::ranges::any_of(m_.unknowns, [](const auto& unknown) { return !unknown.unit.empty(); });
    for (const Body& body : bodies_.bodies) frames_.push_back(frame(body));
    points_.resize(frames_.size());
    for (std::size_t i = 0; i < frames_.size(); ++i) add_body(i);
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) add_contact(i);
    for (const BodyContact& contact : bodies_.contacts) add_touched(contact);
    for (const BodyForce& force : bodies_.forces) add_force(force);
    for (const BodyTorque& torque : bodies_.torques) add_torque(torque);
    for (const BodyJoint& joint : bodies_.joints) add_joint(joint);
    for (std::size_t i = 1; i < frames_.size(); ++i) add_sticks(i);
    return std::move(result_);
  }

 private:
  double number(const PlacedExpression& placed) { return placed ? numbers_.number(placed) : 0; }
  Vec3 vector(const PlacedVector& v) { return {number(v.x), number(v.y), number(v.z)}; }
  Vec3 vector(const std::vector<PlacedExpression>& v) { return {number(v[0]), number(v[1]), number(v[2])}; }

  NumberFrame frame(const Body& body) {
    NumberFrame result;
    result.at = vector(body.at);
    const bodies_in_motion::Turn turn(body);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t row = 0; row < 3; ++row) result.axes[axis][row] = numbers_.number(turn.entry(row, axis));
    }
    return result;
  }

  void add_solid(std::size_t body, Solid solid) {
    for (Vec3& corner : solid.corners) corner = frames_[body].place(corner);
    for (Solid::Face& face : solid.faces) face.normal = frames_[body].in_scene(face.normal);
    result_.solids.push_back({body, std::move(solid)});
  }

  Solid solid(const BodyShape& shape) {
    using Kind = BodyShape::Kind;
    std::vector<Vec3> points;
    for (const PlacedVector& point : shape.points) points.push_back(vector(point));
    if (shape.kind == Kind::hull) return hull_solid(points);
    const Vec3 centre = points.empty() ? Vec3{} : points.front();
    if (shape.kind == Kind::box)
      return box_solid(centre, {number(shape.width), number(shape.depth), number(shape.height)});
    if (shape.kind == Kind::sphere) return sphere_solid(centre, std::abs(number(shape.radius)));
    return cylinder_solid(centre, shape.axis ? vector(shape.axis) : Vec3{0, 0, 1}, number(shape.radius),
                          number(shape.height), shape.kind == Kind::capsule);
  }

  void add_body(std::size_t index) {
    const Body& body = bodies_.bodies[index];
    for (const BodyShape& shape : body.shapes) add_solid(index, solid(shape));
    if (index == ground) return;
    SpaceGeometry::MovingBody moving{frames_[index].at, vector(body.velocity), vector(body.spin), body.name, {}, {}};
    const Vec3 straight = vector(body.acceleration), turning = vector(body.turning);
    for (std::size_t i = 0; i < 6; ++i) {
      moving.prescribed[i] = i < 3 ? straight[i] : turning[i - 3];
      const auto known = std::ranges::find(m_.unknowns, body.unknowns[i].symbol, &MechanismUnknown::symbol);
      if (body.unknowns[i].symbol.empty() || known == m_.unknowns.end()) continue;
      moving.unknowns[i] = {static_cast<std::size_t>(known - m_.unknowns.begin()), body.unknowns[i].negated ? -1 : 1};
    }
    result_.bodies.push_back(std::move(moving));
    const Vec3 weight = number(body.mass) * vector(bodies_.gravity);
    if (length(weight) > 0) result_.weights.push_back({frames_[index].at, weight, body.name});
  }

  void add_contact(std::size_t index) {
    const MechanismContact& given = m_.contacts[index];
    if (given.at.empty() || given.direction.empty()) return;
    SpaceGeometry::Contact contact;
    contact.index = index;
    contact.at = vector(given.at);
    contact.normal = direction_of(vector(given.direction));
    if (!given.slip_direction.empty()) contact.first = direction_of(vector(given.slip_direction));
    if (given.second && !given.second->direction.empty())
      contact.second = direction_of(vector(given.second->direction));
    contact.mu = number(given.kinetic_friction ? given.kinetic_friction : given.static_friction);
    result_.contacts.push_back(contact);
  }

  /// The plane that a contact of bodies touches, and spheres that no shape draws.
  void add_touched(const BodyContact& contact) {
    sphere_without_shape(contact.of, contact.point, contact.radius);
    sphere_without_shape(contact.on, contact.on_point, contact.on_radius);
    points_[contact.of].push_back(vector(contact.point));
    const auto drawn = std::ranges::find(result_.contacts, contact.contact, &SpaceGeometry::Contact::index);
    if (drawn == result_.contacts.end()) return;
    drawn->of = contact.of;
    if (!contact.normal) return;
    const Vec3 through = contact.through ? frames_[contact.on].place(vector(contact.through)) : drawn->at;
    const auto same = [&](const SpaceGeometry::Plane& plane) {
      return plane.on == contact.on && dot(plane.normal, drawn->normal) > 1 - 1e-9 &&
             std::abs(dot(plane.normal, plane.through - through)) < 1e-9 * (1 + length(plane.through - through));
    };
    const auto known = std::ranges::find_if(result_.planes, same);
    drawn->plane = static_cast<std::size_t>(known - result_.planes.begin());
    if (known == result_.planes.end()) result_.planes.push_back({contact.on, through, drawn->normal});
  }

  void sphere_without_shape(std::size_t body, const PlacedVector& centre, const PlacedExpression& radius) {
    if (!radius || !bodies_.bodies[body].shapes.empty()) return;
    const double size = std::abs(number(radius));
    if (size > 0) add_solid(body, sphere_solid(vector(centre), size));
  }

  void add_force(const BodyForce& force) {
    const Vec3 own = vector(force.at), is = vector(force.is);
    points_[force.on].push_back(own);
    if (!(length(is) > 0)) return;
    const auto [name, value] = numbers_.name_of(force.is);
    const Vec3 push = force.follows ? frames_[force.on].in_scene(is) : is, at = frames_[force.on].place(own);
    result_.pushes.push_back({at, push, false, name, value});
    if (force.back_on && *force.back_on != ground) result_.pushes.push_back({at, -1 * push, false, name, value});
  }

  void add_torque(const BodyTorque& torque) {
    const Vec3 is = vector(torque.is);
    if (!(length(is) > 0)) return;
    const auto [name, value] = numbers_.name_of(torque.is);
    const Vec3 push = torque.follows ? frames_[torque.on].in_scene(is) : is;
    result_.pushes.push_back({frames_[torque.on].at, push, true, name, value});
    if (torque.back_on && *torque.back_on != ground)
      result_.pushes.push_back({frames_[*torque.back_on].at, -1 * push, true, name, value});
  }

  void add_joint(const BodyJoint& joint) {
    using Kind = BodyJoint::Kind;
    if (joint.kind == Kind::gear) return;
    SpaceGeometry::Joint drawn{
        joint.kind, joint.contact ? "" : joint.name, frames_[joint.first].place(vector(joint.at)), {}, {}};
    const bool long_one = joint.kind == Kind::rod || joint.kind == Kind::rope || joint.kind == Kind::spring;
    drawn.to = joint.to ? frames_[joint.second].place(vector(joint.to)) : drawn.at;
    if (!long_one && !joint.to) drawn.to = drawn.at;
    if (joint.axis) drawn.axes.push_back(direction_of(frames_[joint.first].in_scene(vector(joint.axis))));
    if (joint.to_axis) drawn.axes.push_back(direction_of(frames_[joint.second].in_scene(vector(joint.to_axis))));
    for (const auto& [body, place] : {std::pair{joint.first, drawn.at}, std::pair{joint.second, drawn.to}}) {
      const Vec3 arm = place - frames_[body].at;
      points_[body].push_back(
          {dot(arm, frames_[body].axes[0]), dot(arm, frames_[body].axes[1]), dot(arm, frames_[body].axes[2])});
    }
    if (joint.kind == Kind::spring && joint.tension) add_tension(joint, drawn);
    result_.joints.push_back(std::move(drawn));
  }

  void add_tension(const BodyJoint& joint, const SpaceGeometry::Joint& spring) {
    const Vec3 pull = number(joint.tension) * direction_of(spring.to - spring.at);
    if (!(length(pull) > 0)) return;
    const auto [name, value] = numbers_.text_of(joint.tension);
    if (joint.first != ground) result_.pushes.push_back({spring.at, pull, false, name, value});
    if (joint.second != ground) result_.pushes.push_back({spring.to, -1 * pull, false, name, value});
  }

  void add_sticks(std::size_t body) {
    const bool drawn = std::ranges::any_of(result_.solids, [&](const auto& one) { return one.body == body; });
    if (drawn || bodies_.bodies[body].is_prescribed()) return;
    for (const Vec3& own : points_[body]) {
      if (length(own) > 0) result_.sticks.push_back({body, frames_[body].at, frames_[body].place(own)});
    }
    result_.sticks.push_back({body, frames_[body].at, frames_[body].at});
  }

  const MechanismScene& scene_;
  const Mechanism& m_;
  const Bodies& bodies_;
  SceneNumbers numbers_;
  std::vector<NumberFrame> frames_;
  std::vector<std::vector<Vec3>> points_;  ///< of each body, in its axes
  SpaceGeometry result_;
};

}  // namespace

SpaceGeometry space_geometry(const MechanismScene& scene) {
  return SpaceReader(scene).read();
}

}  // namespace slipproof
