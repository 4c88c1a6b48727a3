#include "report/picture/velocities/motion_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"
#include "mechanics/bodies/frame.hpp"
#include "mechanics/bodies/parts.hpp"
#include "report/picture/scene_numbers.hpp"

namespace slipproof {

namespace {

PlacedExpression literal(double x) {
  return {make_number(to_rational(x)), {}};
}

/// The place of a body in the plane, and the first and second derivatives of its coordinates and angle.
struct Course {
  double x, y, cosine, sine;
  std::array<double, 3> velocity{}, acceleration{};

  std::array<double, 3> moved(double time) const {
    std::array<double, 3> by{};
    for (std::size_t i = 0; i < by.size(); ++i) by[i] = velocity[i] * time + acceleration[i] * time * time / 2;
    return by;
  }
};

class Ahead {
 public:
  Ahead(const MechanismScene& scene, const MotionAtLoad& motion) : scene_(scene) {
    SceneNumbers numbers(scene);
    const std::vector<std::string> names = acceleration_names(scene.mechanism);
    for (const Body& body : scene.mechanism.bodies->bodies) {
      const bodies_in_motion::Frame frame(body);
      const auto unknown = [&](std::size_t k, const PlacedExpression& prescribed) {
        const Body::Unknown& one = body.unknowns[k];
        if (one.symbol.empty()) return prescribed ? numbers.number(prescribed) : 0.0;
        const auto at = static_cast<std::size_t>(std::ranges::find(names, one.symbol) - names.begin());
        const double value = nearest_binary64(motion.accelerations[at]);
        return one.negated ? -value : value;
      };
      courses_.push_back(
          {numbers.number(frame.at.x),
           numbers.number(frame.at.y),
           numbers.number(frame.turn.entry(0, 0)),
           numbers.number(frame.turn.entry(1, 0)),
           {numbers.number(frame.velocity.x), numbers.number(frame.velocity.y), numbers.number(frame.spin.z)},
           {unknown(0, body.acceleration.x), unknown(1, body.acceleration.y), unknown(5, body.turning.z)}});
    }
  }

  std::vector<MechanismGeometry::Outline> at(double time) const {
    const auto bodies = std::make_shared<Bodies>(*scene_.mechanism.bodies);
    for (std::size_t i = ground + 1; i < courses_.size(); ++i) move(bodies->bodies[i], courses_[i], time);
    MechanismScene later = scene_;
    later.mechanism.bodies = bodies;
    later.mechanism.shapes.clear();
    Mistakes none(scene_.mechanism.file);
    bodies_in_motion::Derivation derivation(*bodies, later.mechanism, none);
    bodies_in_motion::draw_shapes(derivation);
    return geometry_of(later, false).outlines;
  }

 private:
  static void move(Body& body, const Course& course, double time) {
    const auto [x, y, turned] = course.moved(time);
    body.at.x = literal(course.x + x), body.at.y = literal(course.y + y);
    body.cosine = literal(course.cosine * std::cos(turned) - course.sine * std::sin(turned));
    body.sine = literal(course.sine * std::cos(turned) + course.cosine * std::sin(turned));
    body.rotation.clear();
    const std::size_t own = body.shapes.size();
    for (std::size_t i = 0; i < own; ++i) {
      const BodyShape shape = body.shapes[i];
      if (shape.kind == BodyShape::Kind::circle) body.shapes.push_back(spoke(shape));
    }
  }

  static BodyShape spoke(const BodyShape& circle) {
    PlacedVector from = circle.points.empty() ? PlacedVector{literal(0), literal(0), {}, {}} : circle.points[0];
    PlacedVector to = from;
    to.x = {make(Operation::add, {from.x.expression, circle.radius.expression}), {}};
    BodyShape line;
    line.kind = BodyShape::Kind::line;
    line.points = {std::move(from), std::move(to)};
    line.place = circle.place;
    return line;
  }

  const MechanismScene& scene_;
  std::vector<Course> courses_;
};

}  // namespace

std::vector<std::vector<MechanismGeometry::Outline>> outlines_ahead(const MechanismScene& scene,
                                                                    const MotionAtLoad& motion) {
  if (!scene.mechanism.bodies) {
    throw InputError({{scene.mechanism.file, 0, 0,
                       "found a mechanism by equations, which does not say how its shapes move, expected one of bodies "
                       "for --animate"}});
  }
  const Ahead ahead(scene, motion);
  std::vector<std::vector<MechanismGeometry::Outline>> frames;
  for (int i = 0; i <= frames_ahead; ++i) frames.push_back(ahead.at(seconds_ahead * i / frames_ahead));
  return frames;
}

}  // namespace slipproof
