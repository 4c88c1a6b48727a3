#include "contact/exchange/view.hpp"

#include <algorithm>

namespace slipproof::imported {

namespace {

bool are_parallel(const Vector& a, const Vector& b) {
  return cross(a, b) == Vector{};
}

/// A rectangle about a centre, counterclockwise.
std::vector<Point> rectangle(const Point& centre, Point a, const Point& b) {
  if (cross(a, b).sign() < 0) a = Rational(-1) * a;
  return {centre - a - b, centre + a - b, centre + a + b, centre - a + b};
}

std::optional<Outline> box(const Shape& shape, const View& view) {
  const auto& axes = shape.pose.turn.axes;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!are_parallel(axes[i], view.toward)) continue;
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    Outline outline;
    outline.corners = rectangle(view(shape.pose.at), shape.half[j] * view(axes[j]), shape.half[k] * view(axes[k]));
    return outline;
  }
  return std::nullopt;
}

/// A cylinder or a capsule: from its end a disc, from its side a rectangle, with discs at the ends of a capsule.
std::optional<Outline> round(const Shape& shape, const View& view) {
  const Vector& axis = shape.pose.turn.axes[2];
  Outline outline;
  if (are_parallel(axis, view.toward)) {
    outline.centres = {view(shape.pose.at)};
    outline.radius = shape.radius;
    return outline;
  }
  if (!dot(axis, view.toward).is_zero()) return std::nullopt;
  const Point along = view(axis), across{-along.y, along.x};
  outline.corners = rectangle(view(shape.pose.at), shape.half_length * along, shape.radius * across);
  if (shape.kind == Shape::Kind::cylinder) return outline;
  outline.has_corners = false;
  outline.radius = shape.radius;
  outline.centres = {view(shape.pose.at) - shape.half_length * along, view(shape.pose.at) + shape.half_length * along};
  return outline;
}

}  // namespace

const std::vector<View>& views() {
  static const std::vector<View> all{{"xz", 0, 2, {0, -1, 0}}, {"yz", 1, 2, {1, 0, 0}}, {"xy", 0, 1, {0, 0, 1}}};
  return all;
}

std::optional<Outline> outline_of(const Shape& shape, const View& view, std::string& why) {
  std::optional<Outline> outline;
  switch (shape.kind) {
    case Shape::Kind::box:
      outline = box(shape, view);
      break;
    case Shape::Kind::sphere:
      outline.emplace();
      outline->centres = {view(shape.pose.at)};
      outline->radius = shape.radius;
      break;
    case Shape::Kind::cylinder:
    case Shape::Kind::capsule:
      outline = round(shape, view);
      break;
    case Shape::Kind::hull:
      break;
    case Shape::Kind::plane:
      if (const Vector& normal = shape.pose.turn.axes[2]; dot(normal, view.toward).is_zero()) {
        outline.emplace();
        outline->normal = view(normal);
        outline->through = view(shape.pose.at);
      }
      break;
  }
  if (!outline) why = "the " + std::string(name(shape.kind)) + " " + shape.name + " is seen askew";
  return outline;
}

std::vector<std::string> leaves(const Scene& scene, const View& view) {
  std::vector<std::string> why;
  const std::array<Vector, 3> axes = Turn().axes;
  if (!dot(*scene.gravity, view.toward).is_zero()) why.emplace_back("gravity points out of it");
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const Rational near = body.inertia.between(view.toward, view.toward) / 1'000'000'000;
    for (const std::size_t axis : {view.right, view.up}) {
      if (abs(body.inertia.between(view.toward, axes[axis])) > near) {
        why.push_back("the inertia of " + body.name + " is not symmetric to it");
        break;
      }
    }
  }
  for (const Joint& joint : scene.joints) {
    const bool fits = joint.kind == Joint::Kind::hinge ? are_parallel(joint.axis, view.toward)
                                                       : dot(joint.axis, view.toward).is_zero();
    if (!fits)
      why.push_back("the axis of " + joint.name + (joint.kind == Joint::Kind::hinge ? " lies" : " does not lie") +
                    " in it");
  }
  for (const Body& body : scene.bodies) {
    for (const Shape& shape : body.shapes) {
      std::string askew;
      if (!outline_of(shape, view, askew)) why.push_back(askew);
    }
  }
  return why;
}

}  // namespace slipproof::imported
